// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace fca::internal {

struct Node {
  double position;  ///< in (0, 1)
  double weight;    ///< the weights sum to 1
};

/// The n >= 1 Gauss-Legendre nodes on (0, 1). They are cached per thread, since every conversion needs the same few and
/// computing them takes as long as the pixels.
[[nodiscard]] const std::vector<Node>& gauss_legendre(int n);

}  // namespace fca::internal
