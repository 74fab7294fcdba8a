// SPDX-License-Identifier: BSD-3-Clause
// The image circle: what of a camera's image is lens, as its own images show it.
#pragma once

#include <fca/diagnostics.h>
#include <fca/rig/image_change.h>
#include <fca/rig/rig.h>
#include <fca/toolkit/inputs.h>

#include <vector>

namespace fca {

/// Gives the rig's cameras the circles that these images show. Several images of one camera are looked at together. `change` is
/// what is going to be done to the rig's images: the images given show it, or not yet. False with an error where an image
/// cannot be read, is not of its camera's size, or it is not said whose it is. A warning where images show no dark border (all
/// of them is lens then), where the circle's centre is far from the principal point, where little of its rim is seen, and where
/// one image shows another circle than the others.
[[nodiscard]] bool add_lens_circles(const std::vector<CameraImage>& images, const ImageChange& change, Files& files, Rig& rig,
                                    Diagnostics& diagnostics);

}  // namespace fca
