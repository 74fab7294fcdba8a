// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/image.h>

#include <fca/rig/grey_image.h>

#include <vector>

namespace fca {

/// Separates an image into one plane per colour, without the opacity channel. Samples that are NaN or infinite become 0
/// (black). The full scale of 16-bit images is that of the smallest of 10, 12, 14 and 16 bits that can represent all samples.
[[nodiscard]] std::vector<GreyImage> planes(const Image& image);

}  // namespace fca
