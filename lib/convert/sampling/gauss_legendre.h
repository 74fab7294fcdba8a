// SPDX-License-Identifier: BSD-3-Clause
// Gauss-Legendre quadrature.
#pragma once

#include <vector>

namespace fca::internal {

/// A node of a quadrature: the mean of a function is the sum of weight * value at the position, over all nodes.
struct Node {
  double position;  ///< In (0, 1); in gauss_pixels.h a pixel of a row.
  double weight;    ///< The weights of all nodes sum to 1.
};

/// The n >= 1 Gauss-Legendre nodes on (0, 1). They are cached per thread, since all conversions need the same few and computing
/// them takes as long as evaluating the pixels.
[[nodiscard]] const std::vector<Node>& gauss_legendre(int n);

}  // namespace fca::internal
