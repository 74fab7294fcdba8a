// SPDX-License-Identifier: BSD-3-Clause
#include "normal_equations.h"

#include "../../models/kernels/multiversioned.h"

#include <algorithm>
#include <cstring>

namespace fca::internal {

namespace {

/// Four doubles. A processor adds or multiplies all four in one instruction, or two at a time; the result is the same.
using Four __attribute__((vector_size(32))) = double;
constexpr std::size_t kFour = 4;

/// The dot product of two arrays of `count` numbers.
double dot(const double* a, const double* b, std::size_t count) {
  // With four independent sums, an addition need not wait for the result of the one before.
  Four sums[4] = {};
  std::size_t k = 0;
  const auto add = [&](Four& sum) {
    Four x;
    Four y;
    std::memcpy(&x, a + k, sizeof x);
    std::memcpy(&y, b + k, sizeof y);
    sum += x * y;
    k += kFour;
  };
  while (k + 4 * kFour <= count) {
    add(sums[0]);
    add(sums[1]);
    add(sums[2]);
    add(sums[3]);
  }
  while (k + kFour <= count) add(sums[0]);
  const Four sum = (sums[0] + sums[1]) + (sums[2] + sums[3]);
  double result = (sum[0] + sum[1]) + (sum[2] + sum[3]);
  for (; k < count; ++k) result += a[k] * b[k];
  return result;
}

/// The dot product of two columns, over the rows at which both may differ from 0.
double dot(const Column& a, const Column& b) {
  const std::size_t begin = std::max(a.begin, b.begin);
  const std::size_t end = std::min(a.end, b.end);
  return begin < end ? dot(a.data + begin, b.data + begin, end - begin) : 0.0;
}

}  // namespace

FCA_MULTIVERSIONED void dot_products(std::span<const Column> columns, double* matrix) {
  const std::size_t count = columns.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i; j < count; ++j) matrix[i * count + j] = dot(columns[i], columns[j]);
  }
}

FCA_MULTIVERSIONED void dot_products(std::span<const Column> columns, const Column& other, double* vector) {
  for (const Column& column : columns) *vector++ = dot(column, other);
}

}  // namespace fca::internal
