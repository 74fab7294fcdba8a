// SPDX-License-Identifier: BSD-3-Clause
// The image circle: the part of an image that the lens lights, found in sample images.
#pragma once

#include <fca/diagnostics.h>
#include <fca/rig/image_change.h>
#include <fca/rig/rig.h>
#include <fca/toolkit/inputs.h>

#include <vector>

namespace fca {

/// Sets the image circles of the rig's cameras from these sample images. All images of one camera are used together. `change`:
/// the change that will be made to the rig's images; the samples may be from before or after it. False, with an error, if an
/// image cannot be read, does not have its camera's size, or has no known camera. Adds warnings if images show no dark border
/// (then all of the image is lens), if the circle's centre is far from the principal point, if little of its rim is visible,
/// and if an image shows another circle than the others.
[[nodiscard]] bool add_lens_circles(const std::vector<CameraImage>& images, const ImageChange& change, Files& files, Rig& rig,
                                    Diagnostics& diagnostics);

}  // namespace fca
