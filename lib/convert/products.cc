// SPDX-License-Identifier: BSD-3-Clause
#include "products.h"

#include <algorithm>
#include <cstring>

namespace fca::internal {

namespace {

/// Two doubles: what every x86-64 (and ARMv8) adds and multiplies at once.
using Pair __attribute__((vector_size(16))) = double;

Pair load(const double* p) {
  Pair pair;
  std::memcpy(&pair, p, sizeof pair);
  return pair;
}

double dot(const double* a, const double* b, std::size_t count) {
  // Four sums at a time hide the latency of an addition.
  Pair sums[4] = {};
  std::size_t k = 0;
  for (; k + 8 <= count; k += 8) {
    sums[0] += load(a + k) * load(b + k);
    sums[1] += load(a + k + 2) * load(b + k + 2);
    sums[2] += load(a + k + 4) * load(b + k + 4);
    sums[3] += load(a + k + 6) * load(b + k + 6);
  }
  const Pair sum = (sums[0] + sums[1]) + (sums[2] + sums[3]);
  double result = sum[0] + sum[1];
  for (; k < count; ++k) result += a[k] * b[k];
  return result;
}

double dot(const Column& a, const Column& b) {
  const std::size_t begin = std::max(a.begin, b.begin);
  const std::size_t end = std::min(a.end, b.end);
  return begin < end ? dot(a.data + begin, b.data + begin, end - begin) : 0.0;
}

}  // namespace

void products(std::span<const Column> columns, double* matrix) {
  for (std::size_t i = 0; i < columns.size(); ++i) products(columns.subspan(i), columns[i], matrix + i * columns.size() + i);
}

void products(std::span<const Column> columns, const Column& other, double* vector) {
  std::ranges::transform(columns, vector, [&other](const Column& column) { return dot(column, other); });
}

}  // namespace fca::internal
