// SPDX-License-Identifier: BSD-3-Clause
#include "pinhole_kernel.h"

#include "../models/kernels/multiversioned.h"
#include "../models/kernels/with_kernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fca::internal {

namespace {

struct Row {
  Matrix3 to_source;
  double least_square;
  double first;
  double v;
};

/// Kernels and rows are copied: the compiler then knows that writing the map does not change them.
template <class Kernel>
std::size_t write_row(const Kernel kernel, const Row row, std::size_t count, float* uv) {
  constexpr float kLargest = std::numeric_limits<float>::max();
  const Matrix3& m = row.to_source;
  const double x0 = m[1] * row.v + m[2];
  const double y0 = m[4] * row.v + m[5];
  const double z0 = m[7] * row.v + m[8];
  // Two loops: in one the compiler takes as many pixels at a time as there are floats in a register, and spills the doubles.
  std::array<double, Batch::kSize> us;
  std::array<double, Batch::kSize> vs;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const double u = row.first + i;
    const double x = m[0] * u + x0;
    const double y = m[3] * u + y0;
    const double z = m[6] * u + z0;
    const PixelOfRay pixel = kernel(x, y, z);
    const double inside = ask_unless(z * z > row.least_square * (x * x + y * y + z * z));
    us[static_cast<std::size_t>(i)] = pixel.u + inside;
    vs[static_cast<std::size_t>(i)] = pixel.v + inside;
  }
  int doubts = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto to_u = static_cast<float>(us[i]);
    const auto to_v = static_cast<float>(vs[i]);
    doubts += std::abs(to_u) <= kLargest ? 0 : 1;
    doubts += std::abs(to_v) <= kLargest ? 0 : 1;
    uv[2 * i] = to_u;
    uv[2 * i + 1] = to_v;
  }
  return static_cast<std::size_t>(doubts);
}

FCA_MULTIVERSIONED std::size_t any_row(const AnyPinholeKernel& kernels, const Row& row, std::size_t count, float* uv) {
  std::size_t doubts = 0;
  with_kernel(kernels, [&](const auto& kernel) { doubts = write_row(kernel, row, count, uv); });
  return doubts;
}

}  // namespace

std::optional<PinholePixels> PinholePixels::of(const CameraModel& source, const Matrix3& to_source, double surely_seen) {
  return std::visit(
      [&]<class M>(const Intrinsics<M>& m) -> std::optional<PinholePixels> {
        if constexpr (requires { sizeof(PinholeKernel<M>); }) {
          return PinholePixels(PinholeKernel<M>(m.values.data()), to_source, surely_seen);
        } else {
          return std::nullopt;
        }
      },
      source);
}

PinholePixels::PinholePixels(const AnyPinholeKernel& kernel, const Matrix3& to_source, double surely_seen)
    : kernel_(kernel), to_source_(to_source), least_square_(surely_seen > 0.0 ? surely_seen * surely_seen : 0.0) {}

bool PinholePixels::covers(double first, double v, std::size_t count) const {
  // Shorter rays than this are no longer right to all digits.
  constexpr double kLeast = 1e-6;
  const auto z = [&](double u) { return to_source_[6] * u + to_source_[7] * v + to_source_[8]; };
  return std::min(z(first), z(first + static_cast<double>(count - 1))) > kLeast;
}

std::size_t PinholePixels::operator()(double first, double v, std::size_t count, float* uv) const {
  return any_row(kernel_, {to_source_, least_square_, first, v}, count, uv);
}

}  // namespace fca::internal
