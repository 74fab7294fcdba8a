// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/rig/rig.h>

#include <string_view>

namespace fca {

/// Takes a frame (a camera that nobody asked for) out of the rig's poses. How the others sit to each other by way of it is then
/// stated between them.
void remove_frame(std::string_view frame, Rig& rig);

}  // namespace fca
