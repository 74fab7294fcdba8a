// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gauss_legendre.h"

#include <vector>

namespace fca::internal {

/// Positions in a row of pixels, in [0, pixels - 1], whose weighted mean equals the mean over all pixels of the row, exactly
/// for a polynomial of degree 2 n - 1 (Gauss quadrature of the discrete measure). Gauss-Legendre nodes would integrate from the
/// first pixel to the last and so count these two by half, which matters because errors are largest in the image's corners. n
/// >= 1, pixels >= 1; returns at most `pixels` positions. Cached per thread.
[[nodiscard]] const std::vector<Node>& gauss_pixels(int n, int pixels);

}  // namespace fca::internal
