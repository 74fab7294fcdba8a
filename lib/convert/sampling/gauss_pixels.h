// SPDX-License-Identifier: BSD-3-Clause
// Gauss quadrature over the pixels of a row.
#pragma once

#include "gauss_legendre.h"

#include <vector>

namespace fca::internal {

/// n positions in a row of pixels, in [0, pixels - 1]. For a polynomial of degree up to 2 n - 1, its weighted mean at these
/// positions is exactly its mean over all pixels of the row (Gauss quadrature of the discrete measure). Gauss-Legendre nodes
/// would integrate from the first pixel to the last, with only half of the weight of these two pixels. This would matter
/// because errors are largest in the image's corners. n >= 1, pixels >= 1; at most `pixels` positions. Cached per thread.
[[nodiscard]] const std::vector<Node>& gauss_pixels(int n, int pixels);

}  // namespace fca::internal
