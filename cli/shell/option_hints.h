// SPDX-License-Identifier: BSD-3-Clause
// What the library leaves to its caller: which option of the command specifies the fact that is missing.
#pragma once

#include <fca/formats/text/message.h>

#include <string_view>

namespace fca::cli {

/// The command's sentences: those of its own few, with the same arguments, else the library's table.
[[nodiscard]] std::string_view with_options(Code code, text::Part part);

}  // namespace fca::cli
