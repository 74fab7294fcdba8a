// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace fca {

/// The last "cam1" (`prefix`: "cam") in a text that is no part of a longer word; empty if there is none.
[[nodiscard]] std::string indexed_name(std::string_view text, std::string_view prefix);

/// What the name of a file, else that of its folder, calls a sensor so; empty where neither does.
[[nodiscard]] std::string name_by_path(std::string_view path, std::string_view prefix);

}  // namespace fca
