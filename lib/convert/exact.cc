// SPDX-License-Identifier: BSD-3-Clause
#include "exact.h"

#include <fca/convert/containment.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace fca::internal {

namespace {

bool all_zero(std::span<const double> values) {
  return std::ranges::all_of(values, [](double v) { return v == 0.0; });
}

/// The source as rational, where it is that or opencv14 without prism and tilt.
std::optional<Intrinsics<Rational>> as_rational(const CameraModel& source) {
  if (const auto* m = std::get_if<Intrinsics<Rational>>(&source)) return *m;
  if (const auto* m = std::get_if<Intrinsics<Opencv14>>(&source)) {
    Intrinsics<Rational> rational;
    std::copy_n(m->values.begin(), rational.values.size(), rational.values.begin());
    if (all_zero(std::span(m->values).subspan(rational.values.size()))) return rational;
  }
  return std::nullopt;
}

/// The source as radtan, where it is one.
std::optional<Intrinsics<Radtan>> as_radtan(const CameraModel& source) {
  if (const auto* m = std::get_if<Intrinsics<Radtan>>(&source)) return *m;
  if (const std::optional<Intrinsics<Rational>> m = as_rational(source)) {
    const auto& [fx, fy, cx, cy, k1, k2, p1, p2, k3, k4, k5, k6] = m->values;
    const double denominator[] = {k4, k5, k6};
    if (all_zero(denominator)) return Intrinsics<Radtan>{{fx, fy, cx, cy, k1, k2, p1, p2, k3}};
  }
  if (const auto* m = std::get_if<Intrinsics<Mei>>(&source)) {
    const auto& [fx, fy, cx, cy, xi, k1, k2, p1, p2] = m->values;
    if (xi == 0.0) return Intrinsics<Radtan>{{fx, fy, cx, cy, k1, k2, p1, p2, 0.0}};
  }
  return std::nullopt;
}

/// x / (z + xi d) = (x / (1 + xi)) / ((1 - alpha) z + alpha d) with alpha = xi / (1 + xi), d the ray's length.
Intrinsics<Ucm> unified(const Intrinsics<Pinhole>& focal, double xi) {
  const auto& [fx, fy, cx, cy] = focal.values;
  return {{fx / (1.0 + xi), fy / (1.0 + xi), cx, cy, xi / (1.0 + xi)}};
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
    if (alpha == 0.0 && xi > 0.0) return unified({fx, fy, cx, cy}, xi);
  }
  if (const auto* m = std::get_if<Intrinsics<Mei>>(&source)) {
    const auto& [fx, fy, cx, cy, xi, k1, k2, p1, p2] = m->values;
    const double distortion[] = {k1, k2, p1, p2};
    if (all_zero(distortion)) return unified({fx, fy, cx, cy}, xi);
  }
  return std::nullopt;
}

/// The source as pinhole, where it is one.
std::optional<Intrinsics<Pinhole>> as_pinhole(const CameraModel& source) {
  if (const auto* m = std::get_if<Intrinsics<Pinhole>>(&source)) return *m;
  if (const std::optional<Intrinsics<Radtan>> radtan = as_radtan(source)) {
    const std::span<const double> values(radtan->values);
    if (all_zero(values.subspan(4))) return Intrinsics<Pinhole>{{values[0], values[1], values[2], values[3]}};
  }
  if (const std::optional<Intrinsics<Ucm>> ucm = as_ucm(source)) {
    const auto& [fx, fy, cx, cy, alpha] = ucm->values;
    if (alpha == 0.0) return Intrinsics<Pinhole>{{fx, fy, cx, cy}};
  }
  if (const auto* m = std::get_if<Intrinsics<Eucm>>(&source)) {
    const auto& [fx, fy, cx, cy, alpha, beta] = m->values;
    if (alpha == 0.0) return Intrinsics<Pinhole>{{fx, fy, cx, cy}};
  }
  if (const auto* m = std::get_if<Intrinsics<Ocamcalib>>(&source)) {
    const auto& [cx, cy, c, d, e, a0, a1, a2, a3, a4, a5, a6, a7, a8] = m->values;
    const double others[] = {d, e, a1, a2, a3, a4, a5, a6, a7, a8};
    // A ray ahead is at the height -a0 over the image, whatever its radius.
    if (all_zero(others)) return Intrinsics<Pinhole>{{-a0, -a0 * c, cx, cy}};
  }
  return std::nullopt;
}

/// fov's w at which atan2(2 r tan(w / 2), z) is the angle itself.
double equidistant_w() { return 2.0 * std::atan(0.5); }

/// The source as kb4, where its radius is f angle + f k angle^3: kb4's without k2, k3, k4, woodscape's without k2, k4, and,
/// with k = 0, that of the fov of an equidistant lens.
std::optional<Intrinsics<Kb4>> as_cubic(const CameraModel& source) {
  if (const auto* m = std::get_if<Intrinsics<Kb4>>(&source)) {
    const double others[] = {m->values[5], m->values[6], m->values[7]};
    if (all_zero(others)) return *m;
  }
  if (const auto* m = std::get_if<Intrinsics<Woodscape>>(&source)) {
    const auto& [k1, k2, k3, k4, aspect, cx, cy] = m->values;
    if (k2 == 0.0 && k4 == 0.0) return Intrinsics<Kb4>{{k1, k1 * aspect, cx, cy, k3 / k1, 0.0, 0.0, 0.0}};
  }
  if (const auto* m = std::get_if<Intrinsics<Fov>>(&source)) {
    const auto& [fx, fy, cx, cy, w] = m->values;
    if (std::abs(w - equidistant_w()) <= std::numeric_limits<double>::epsilon())
      return Intrinsics<Kb4>{{fx / w, fy / w, cx, cy, 0.0, 0.0, 0.0, 0.0}};
  }
  return std::nullopt;
}

}  // namespace

std::string_view id_without_skew(std::string_view id) {
  ModelList::for_each([&id]<class M>() {
    if constexpr (kIsSkewed<M>) {
      if (M::kId == id) id = M::Straight::kId;
    }
  });
  return id;
}

std::optional<CameraModel> convert_exactly(const CameraModel& source, std::string_view target_id) {
  if (model_info(source).id == target_id) return source;
  const auto [straight, skew_px] = without_skew(source);
  if (const std::string_view straight_id = id_without_skew(target_id); straight_id != target_id) {
    const std::optional<CameraModel> converted = convert_exactly(straight, straight_id);
    return converted ? with_skew(*converted, skew_px) : std::nullopt;
  }
  if (skew_px != 0.0) return std::nullopt;
  if (straight != source) return convert_exactly(straight, target_id);
  std::optional<Intrinsics<Radtan>> radtan = as_radtan(source);
  std::optional<Intrinsics<Ucm>> ucm = as_ucm(source);
  if (const std::optional<Intrinsics<Pinhole>> pinhole = as_pinhole(source)) {
    const auto& [fx, fy, cx, cy] = pinhole->values;
    if (target_id == Pinhole::kId) return *pinhole;
    if (target_id == Ocamcalib::kId) return Intrinsics<Ocamcalib>{{cx, cy, fy / fx, 0, 0, -fx, 0, 0, 0, 0, 0, 0, 0, 0}};
    radtan = Intrinsics<Radtan>{{fx, fy, cx, cy, 0, 0, 0, 0, 0}};
    ucm = Intrinsics<Ucm>{{fx, fy, cx, cy, 0.0}};
  }
  if (radtan) {
    const auto& [fx, fy, cx, cy, k1, k2, p1, p2, k3] = radtan->values;
    if (target_id == Radtan::kId) return *radtan;
    if (target_id == Rational::kId) return Intrinsics<Rational>{{fx, fy, cx, cy, k1, k2, p1, p2, k3, 0, 0, 0}};
    if (target_id == Opencv14::kId) return Intrinsics<Opencv14>{{fx, fy, cx, cy, k1, k2, p1, p2, k3}};
    if (target_id == Mei::kId && k3 == 0.0) return Intrinsics<Mei>{{fx, fy, cx, cy, 0.0, k1, k2, p1, p2}};
  }
  if (const std::optional<Intrinsics<Rational>> rational = as_rational(source)) {
    if (target_id == Rational::kId) return *rational;
    if (target_id == Opencv14::kId) {
      Intrinsics<Opencv14> outer{};
      std::ranges::copy(rational->values, outer.values.begin());
      return outer;
    }
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
  if (ucm && target_id == Ocamcalib::kId && ucm->values[4] == 0.5) {
    // Stereographic, r = 2 f tan(angle / 2): the ray's height over the radius is f - r^2 / (4 f).
    const auto& [fx, fy, cx, cy, alpha] = ucm->values;
    return Intrinsics<Ocamcalib>{{cx, cy, fy / fx, 0, 0, -fx, 0, 0.25 / fx, 0, 0, 0, 0, 0, 0}};
  }
  if (const std::optional<Intrinsics<Kb4>> cubic = as_cubic(source)) {
    const auto& [fx, fy, cx, cy, k, k2, k3, k4] = cubic->values;
    const double w = equidistant_w();
    if (target_id == Kb4::kId) return *cubic;
    if (target_id == Woodscape::kId) return Intrinsics<Woodscape>{{fx, 0.0, fx * k, 0.0, fy / fx, cx, cy}};
    if (target_id == Fov::kId && k == 0.0) return Intrinsics<Fov>{{fx * w, fy * w, cx, cy, w}};
  }
  return std::nullopt;
}

std::optional<CameraModel> convert_nearly(const CameraModel& inner, std::string_view outer_id) {
  const std::optional<Intrinsics<Ucm>> ucm = outer_id == Mei::kId ? as_ucm(inner) : std::nullopt;
  if (!ucm) return convert_exactly(inner, outer_id);
  const auto& [fx, fy, cx, cy, alpha] = ucm->values;
  const double xi = alpha < 1.0 ? std::min(alpha / (1.0 - alpha), Mei::kFurthestXi) : Mei::kFurthestXi;
  return Intrinsics<Mei>{{fx * (1.0 + xi), fy * (1.0 + xi), cx, cy, xi, 0.0, 0.0, 0.0, 0.0}};
}

std::string_view contained_model(std::string_view id) {
  struct Containment {
    std::string_view outer;
    std::string_view inner;
  };
  static constexpr Containment kContainments[] = {
      {Radtan::kId, Pinhole::kId},
      {Rational::kId, Radtan::kId},
      {Ucm::kId, Pinhole::kId},
      {Eucm::kId, Ucm::kId},
      {Ds::kId, Ucm::kId},
      {Mei::kId, Ucm::kId},
      {Ocamcalib::kId, Pinhole::kId},
      {Opencv14::kId, Rational::kId},
      {Skewed<Radtan>::kId, Radtan::kId},
      {Skewed<Rational>::kId, Rational::kId},
      {Skewed<Opencv14>::kId, Opencv14::kId},
      {Skewed<Kb4>::kId, Kb4::kId},
      {Skewed<Mei>::kId, Mei::kId},
  };
  for (const Containment& c : kContainments) {
    if (c.outer == id) return c.inner;
  }
  return {};
}

}  // namespace fca::internal

namespace fca {

bool contains(std::string_view outer, std::string_view inner) {
  for (; !outer.empty(); outer = internal::contained_model(outer)) {
    if (outer == inner) return true;
  }
  return false;
}

}  // namespace fca
