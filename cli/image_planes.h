// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pictures/image.h"

#include <fca/rig/grey_image.h>

#include <vector>

namespace fca::cli {

/// An image's colours, each as an image of its own; opacity is none. What is no number counts as black.
[[nodiscard]] std::vector<GreyImage> planes(const Image& image);

}  // namespace fca::cli
