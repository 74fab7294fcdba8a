// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace fca {

/// Does the model `outer` describe every camera of the model `inner`, in closed form (radtan every pinhole, mei every ucm)?
/// Every model contains itself. By ids.
[[nodiscard]] bool contains(std::string_view outer, std::string_view inner);

}  // namespace fca
