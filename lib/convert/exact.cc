// SPDX-License-Identifier: BSD-3-Clause
#include "exact.h"

#include <algorithm>
#include <span>

namespace fca::internal {

namespace {

bool all_zero(std::span<const double> values) {
  return std::ranges::all_of(values, [](double v) { return v == 0.0; });
}

/// The source as UCM, where it is one.
std::optional<Intrinsics<Ucm>> as_ucm(const CameraModel& source) {
  if (const auto* m = std::get_if<Intrinsics<Ucm>>(&source)) return *m;
  if (const auto* m = std::get_if<Intrinsics<Eucm>>(&source)) {
    const auto& [fx, fy, cx, cy, alpha, beta] = m->values;
    if (beta == 1.0) return Intrinsics<Ucm>{{fx, fy, cx, cy, alpha}};
  }
  if (const auto* m = std::get_if<Intrinsics<Ds>>(&source)) {
    const auto& [fx, fy, cx, cy, alpha, xi] = m->values;
    if (xi == 0.0) return Intrinsics<Ucm>{{fx, fy, cx, cy, alpha}};
  }
  if (const auto* m = std::get_if<Intrinsics<Mei>>(&source)) {
    const auto& [fx, fy, cx, cy, xi, k1, k2, p1, p2] = m->values;
    const double distortion[] = {k1, k2, p1, p2};
    // x / (z + xi d) = (x / (1 + xi)) / ((1 - alpha) z + alpha d) with alpha = xi / (1 + xi)
    if (all_zero(distortion)) return Intrinsics<Ucm>{{fx / (1.0 + xi), fy / (1.0 + xi), cx, cy, xi / (1.0 + xi)}};
  }
  return std::nullopt;
}

/// The source as pinhole, where it is one.
std::optional<Intrinsics<Pinhole>> as_pinhole(const CameraModel& source) {
  if (const auto* m = std::get_if<Intrinsics<Pinhole>>(&source)) return *m;
  if (const auto* m = std::get_if<Intrinsics<Radtan>>(&source)) {
    const std::span<const double> values(m->values);
    if (all_zero(values.subspan(4))) return Intrinsics<Pinhole>{{values[0], values[1], values[2], values[3]}};
  }
  if (const std::optional<Intrinsics<Ucm>> ucm = as_ucm(source)) {
    const auto& [fx, fy, cx, cy, alpha] = ucm->values;
    if (alpha == 0.0) return Intrinsics<Pinhole>{{fx, fy, cx, cy}};
  }
  return std::nullopt;
}

}  // namespace

std::optional<CameraModel> convert_exactly(const CameraModel& source, std::string_view target_id) {
  if (model_info(source).id == target_id) return source;
  std::optional<Intrinsics<Ucm>> ucm = as_ucm(source);
  if (const std::optional<Intrinsics<Pinhole>> pinhole = as_pinhole(source)) {
    const auto& [fx, fy, cx, cy] = pinhole->values;
    if (target_id == Pinhole::kId) return *pinhole;
    if (target_id == Radtan::kId) return Intrinsics<Radtan>{{fx, fy, cx, cy, 0, 0, 0, 0, 0}};
    ucm = Intrinsics<Ucm>{{fx, fy, cx, cy, 0.0}};
  }
  if (ucm) {
    const auto& [fx, fy, cx, cy, alpha] = ucm->values;
    if (target_id == Ucm::kId) return *ucm;
    if (target_id == Eucm::kId) return Intrinsics<Eucm>{{fx, fy, cx, cy, alpha, 1.0}};
    if (target_id == Ds::kId) return Intrinsics<Ds>{{fx, fy, cx, cy, alpha, 0.0}};
    if (target_id == Mei::kId && alpha < 1.0) {
      return Intrinsics<Mei>{{fx / (1.0 - alpha), fy / (1.0 - alpha), cx, cy, alpha / (1.0 - alpha), 0, 0, 0, 0}};
    }
  }
  return std::nullopt;
}

}  // namespace fca::internal
