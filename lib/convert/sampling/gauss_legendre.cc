// SPDX-License-Identifier: BSD-3-Clause
#include "gauss_legendre.h"

#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>

namespace fca::internal {

namespace {

/// Computes the nodes: the roots of the Legendre polynomial P_n, by Newton's method from Tricomi's starting values. Only half
/// of them are computed, because the other half is symmetric to these.
std::vector<Node> compute_gauss_legendre(int n) {
  std::vector<Node> nodes(static_cast<std::size_t>(n));
  for (int i = 0; i < (n + 1) / 2; ++i) {
    double x = (1.0 - (n - 1.0) / (8.0 * n * n * n)) * std::cos(std::numbers::pi * (4.0 * i + 3.0) / (4.0 * n + 2.0));
    double derivative = 1.0;
    constexpr int kMostSteps = 8;
    for (int iteration = 0; iteration < kMostSteps; ++iteration) {
      double p = 1.0;
      double previous = 0.0;
      for (int k = 0; k < n; ++k) {
        const double next = ((2.0 * k + 1.0) * x * p - k * previous) / (k + 1.0);
        previous = p;
        p = next;
      }
      derivative = n * (x * p - previous) / (x * x - 1.0);
      x -= p / derivative;
      if (std::abs(p / derivative) < 1e-15) break;
    }
    const double weight = 1.0 / ((1.0 - x * x) * derivative * derivative);
    nodes[static_cast<std::size_t>(i)] = {0.5 * (1.0 - x), weight};
    nodes[static_cast<std::size_t>(n - 1 - i)] = {0.5 * (1.0 + x), weight};
  }
  return nodes;
}

}  // namespace

const std::vector<Node>& gauss_legendre(int n) {
  thread_local std::vector<std::unique_ptr<const std::vector<Node>>> known;
  const auto index = static_cast<std::size_t>(n);
  if (known.size() <= index) known.resize(index + 1);
  std::unique_ptr<const std::vector<Node>>& nodes = known[index];
  if (!nodes) nodes = std::make_unique<const std::vector<Node>>(compute_gauss_legendre(n));
  return *nodes;
}

}  // namespace fca::internal
