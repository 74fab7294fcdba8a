// SPDX-License-Identifier: BSD-3-Clause
// Finds the image circles of cameras in sample images. The image circle is the part of an image to which the lens projects
// light.
#pragma once

#include <fca/diagnostics.h>
#include <fca/rig/image_change.h>
#include <fca/rig/rig.h>
#include <fca/toolkit/inputs.h>

#include <vector>

namespace fca {

/// Sets the image circles of the rig's cameras from sample images. The images of a camera are evaluated together. `change`: the
/// change of images that the caller will apply to the rig; a sample image may have the size before or after the change.
///
/// False, with an error, if an image cannot be read, does not have its camera's size, or belongs to no known camera. Adds a
/// warning if the images show no dark border (the camera then has no circle), if the circle is small or its centre is far from
/// the principal point, if less than half of its rim is visible, or if an image shows another circle than the others.
[[nodiscard]] bool add_lens_circles(const std::vector<CameraImage>& images, const ImageChange& change, Files& files, Rig& rig,
                                    Diagnostics& diagnostics);

}  // namespace fca
