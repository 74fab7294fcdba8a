// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/image.h>

#include <fca/rig/grey_image.h>

#include <vector>

namespace fca {

/// An image's colours as separate images, without an opacity channel. NaN and infinite samples become black. The full scale of
/// 16-bit samples is the smallest of 10, 12, 14 and 16 bits that holds them all.
[[nodiscard]] std::vector<GreyImage> planes(const Image& image);

}  // namespace fca
