// SPDX-License-Identifier: BSD-3-Clause
// The image by whose grey the pixels of a fit count.
#pragma once

#include <fca/rig/rig.h>
#include <fca/toolkit/convert.h>

namespace fca {

/// Reads request.weight_image into request.density, where the request is for one: the mean of an image's colours. False with an
/// error where it is no image, not as large as the images of each of the rig's cameras, or black.
[[nodiscard]] bool read_weight_image(const Rig& rig, Files& files, ConvertRequest& request, Diagnostics& diagnostics);

}  // namespace fca
