// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gauss_legendre.h"

#include <vector>

namespace fca::internal {

/// Places among a row of pixels, in [0, pixels - 1], whose weighted mean is that over all pixels of the row, exactly for a
/// polynomial of degree 2 n - 1 (Gauss quadrature of the discrete measure). Gauss-Legendre nodes stand for the way from the
/// first pixel to the last and so count those two by half: where the error is largest in the image's corners, that is another
/// mean. n >= 1, pixels >= 1; no more places than pixels. Remembered.
[[nodiscard]] const std::vector<Node>& gauss_pixels(int n, int pixels);

}  // namespace fca::internal
