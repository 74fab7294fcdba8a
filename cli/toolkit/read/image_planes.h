// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/image.h>

#include <fca/rig/grey_image.h>

#include <vector>

namespace fca {

/// An image's colours, each as an image of its own; opacity is none. What is no number counts as black. The full scale of
/// 16-bit samples is that of the least of 10, 12, 14 and 16 bits which holds them all.
[[nodiscard]] std::vector<GreyImage> planes(const Image& image);

}  // namespace fca
