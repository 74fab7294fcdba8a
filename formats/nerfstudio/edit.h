// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/formats/text/document.h>
#include <fca/rig/rig.h>

namespace fca::nerfstudio {

/// The base, which specifies the cameras of `old`, with the numbers of `rig` in place of theirs; the cameras are the same ones,
/// and all of them are fisheyes or none. A number at the top that is no longer that of all cameras goes to the frames of each.
/// Frames, poses and all else keep their bytes.
[[nodiscard]] text::Document edited(const text::Document& base, const Rig& old, const Rig& rig);

}  // namespace fca::nerfstudio
