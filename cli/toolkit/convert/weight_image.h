// SPDX-License-Identifier: BSD-3-Clause
// The image whose grey values weight the pixels of a fit.
#pragma once

#include <fca/rig/rig.h>
#include <fca/toolkit/convert.h>

namespace fca {

/// If the fits are weighted by an image (WeightKind::kImage), reads request.weight_image and stores the mean of its colours in
/// request.density. Does nothing if request.density is already set. Returns false, with an error, if the file is no image, if
/// all its pixels are black, or if its size differs from the image size of a camera.
[[nodiscard]] bool read_weight_image(const Rig& rig, Files& files, ConvertRequest& request, Diagnostics& diagnostics);

}  // namespace fca
