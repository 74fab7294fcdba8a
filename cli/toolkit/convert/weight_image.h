// SPDX-License-Identifier: BSD-3-Clause
// The image whose grey values weight the pixels of a fit.
#pragma once

#include <fca/rig/rig.h>
#include <fca/toolkit/convert.h>

namespace fca {

/// If the request weights by an image, reads request.weight_image into request.density, as the mean of the colours. False, with
/// an error, if it is not an image, is black, or has not the size of each camera's images.
[[nodiscard]] bool read_weight_image(const Rig& rig, Files& files, ConvertRequest& request, Diagnostics& diagnostics);

}  // namespace fca
