// SPDX-License-Identifier: BSD-3-Clause
#include "turn_rays.h"

#include "../models/kernels/multiversioned.h"

#include <cmath>
#include <limits>

namespace fca::internal {

FCA_MULTIVERSIONED void turn_rays(const Matrix3& rotation, Batch& batch, std::size_t count) {
  const Matrix3 r = rotation;  // a copy: the compiler then knows that writing to the batch does not change it
  for (std::size_t i = 0; i < count; ++i) {
    const double x = batch.x[i];
    const double y = batch.y[i];
    const double z = batch.z[i];
    batch.x[i] = r[0] * x + r[1] * y + r[2] * z;
    batch.y[i] = r[3] * x + r[4] * y + r[5] * z;
    batch.z[i] = r[6] * x + r[7] * y + r[8] * z;
  }
}

FCA_MULTIVERSIONED std::size_t count_unknown_rays(const Batch& batch, std::size_t count) {
  long long unknown = 0;
  for (std::size_t i = 0; i < count; ++i) unknown += std::abs(batch.z[i]) <= std::numeric_limits<double>::max() ? 0 : 1;
  return static_cast<std::size_t>(unknown);
}

FCA_MULTIVERSIONED std::size_t write_pixels(const Batch& batch, std::size_t count, double surely_seen, float* uv) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  long long doubts = 0;
  for (std::size_t i = 0; i < count; ++i) {
    doubts += batch.z[i] > surely_seen ? 0 : 1;
    doubts += std::abs(batch.u[i]) <= kLargest ? 0 : 1;
    doubts += std::abs(batch.v[i]) <= kLargest ? 0 : 1;
    uv[2 * i] = static_cast<float>(batch.u[i]);
    uv[2 * i + 1] = static_cast<float>(batch.v[i]);
  }
  return static_cast<std::size_t>(doubts);
}

}  // namespace fca::internal
