// SPDX-License-Identifier: BSD-3-Clause
#include "own_lens.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fca::mrcal {

namespace {

constexpr std::size_t kCore = 4;  // fx fy cx cy

using Plane = std::array<double, 2>;

Pixel in_pixels(std::span<const double> numbers, const Plane& point) {
  return {numbers[0] * point[0] + numbers[2], numbers[1] * point[1] + numbers[3]};
}

double length_of(const Ray& ray) { return std::hypot(ray[0], ray[1], ray[2]); }

/// Where the ray meets the plane of a stereographic projection: twice the tangent of half its angle.
std::optional<Plane> stereographic(const Ray& ray) {
  const double below = length_of(ray) + ray[2];
  if (!(below > 0.0)) return std::nullopt;
  return Plane{2.0 * ray[0] / below, 2.0 * ray[1] / below};
}

std::optional<Plane> longitude_and_latitude(const Ray& ray) {
  return Plane{std::atan2(ray[0], ray[2]), std::asin(ray[1] / length_of(ray))};
}

std::optional<Plane> latitude_and_longitude(const Ray& ray) {
  return Plane{std::asin(ray[0] / length_of(ray)), std::atan2(ray[1], ray[2])};
}

/// alpha, beta: where the optical axis O points; r0 r1 r2: p' = p + mu (p - (p O) O), mu = r0 + r1 tau + r2 tau^2, where tau is
/// the squared tangent of the angle between p and O.
std::optional<Plane> cahvor(std::span<const double> lens, const Ray& ray) {
  const double alpha = lens[0];
  const double beta = lens[1];
  const Ray axis = {std::sin(alpha) * std::cos(beta), std::sin(beta), std::cos(alpha) * std::cos(beta)};
  const double along = ray[0] * axis[0] + ray[1] * axis[1] + ray[2] * axis[2];
  if (!(along > 0.0)) return std::nullopt;
  const double length = length_of(ray);
  const double tau = length * length / (along * along) - 1.0;
  const double mu = lens[2] + tau * (lens[3] + tau * lens[4]);
  Ray bent{};
  for (std::size_t i = 0; i < bent.size(); ++i) bent.at(i) = ray.at(i) + mu * (ray.at(i) - along * axis.at(i));
  if (!(bent[2] > 0.0)) return std::nullopt;
  return Plane{bent[0] / bent[2], bent[1] / bent[2]};
}

/// What "LENSMODEL_SPLINED_STEREOGRAPHIC_order=3_Nx=30_Ny=20_fov_x_deg=170" says: uniform B-splines over the stereographic
/// plane, whose knots say, row by row, by how much a point is moved along u and v.
struct Spline {
  static constexpr std::string_view kName = "LENSMODEL_SPLINED_STEREOGRAPHIC_";

  int order = 0;
  int columns = 0;
  int rows = 0;
  double fov_x_deg = 0.0;

  [[nodiscard]] static std::optional<Spline> find(std::string_view name) {
    if (!name.starts_with(kName)) return std::nullopt;
    const auto number = [name](std::string_view key) {
      const std::size_t at = name.find(key);
      if (at == std::string_view::npos) return 0;
      const std::string_view digits = name.substr(at + key.size());
      return text::parse_int(digits.substr(0, digits.find('_'))).value_or(0);
    };
    const Spline spline = {number("order="), number("Nx="), number("Ny="), static_cast<double>(number("fov_x_deg="))};
    constexpr int kMostKnots = 1000;
    const bool has_order = spline.order == 2 || spline.order == 3;
    const int fewest = spline.order + 1;
    const bool has_knots =
        std::min(spline.columns, spline.rows) >= fewest && std::max(spline.columns, spline.rows) <= kMostKnots;
    const bool has_view = spline.fov_x_deg > 0.0 && spline.fov_x_deg < 360.0;
    return has_order && has_knots && has_view ? std::optional(spline) : std::nullopt;
  }

  [[nodiscard]] std::size_t numbers() const {
    return kCore + 2 * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }

  /// Outside its knots it would be a guess.
  [[nodiscard]] std::optional<Plane> at(std::span<const double> knots, const Plane& u) const {
    const double edge = 2.0 * std::tan(fov_x_deg * std::numbers::pi / 720.0);
    const double knots_per_unit = (columns - order) / (2.0 * edge);
    const double across = u[0] * knots_per_unit + (columns - 1) / 2.0;
    const double down = u[1] * knots_per_unit + (rows - 1) / 2.0;
    const std::optional<Segment> x = segment_at(across, columns);
    const std::optional<Segment> y = segment_at(down, rows);
    if (!x || !y) return std::nullopt;
    Plane moved = u;
    for (int j = 0; j <= order; ++j) {
      for (int i = 0; i <= order; ++i) {
        const double weight = x->weights.at(static_cast<std::size_t>(i)) * y->weights.at(static_cast<std::size_t>(j));
        const auto knot = 2 * static_cast<std::size_t>((y->first + j) * columns + x->first + i);
        moved[0] += weight * knots[knot];
        moved[1] += weight * knots[knot + 1];
      }
    }
    return moved;
  }

 private:
  /// Its first knot, and how much each counts.
  struct Segment {
    int first = 0;
    std::array<double, 4> weights{};
  };

  [[nodiscard]] std::optional<Segment> segment_at(double place, int count) const {
    const int knot = static_cast<int>(std::floor(order == 3 ? place : place + 0.5));
    const int last = order == 3 ? count - 3 : count - 2;
    const bool is_last_edge = knot == last + 1 && place - knot <= 0.0;
    if (knot < 1 || (knot > last && !is_last_edge)) return std::nullopt;
    const int inner = std::min(knot, last);
    const double t = place - inner;
    if (order == 3) {
      const double s = 1.0 - t;
      return Segment{inner - 1,
                     {s * s * s / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
                      (-3.0 * t * t * t + 3.0 * t * t + 3.0 * t + 1.0) / 6.0, t * t * t / 6.0}};
    }
    return Segment{inner - 1, {0.5 * (0.5 - t) * (0.5 - t), 0.75 - t * t, 0.5 * (0.5 + t) * (0.5 + t), 0.0}};
  }
};

/// A lens without a spline.
struct OwnLens {
  std::string_view name;
  std::size_t coefficients = 0;
  std::optional<Plane> (*at)(std::span<const double> lens, const Ray& ray);
};

constexpr std::array kOwnLenses = {
    OwnLens{"LENSMODEL_STEREOGRAPHIC", 0, [](std::span<const double>, const Ray& ray) { return stereographic(ray); }},
    OwnLens{"LENSMODEL_LONLAT", 0, [](std::span<const double>, const Ray& ray) { return longitude_and_latitude(ray); }},
    OwnLens{"LENSMODEL_LATLON", 0, [](std::span<const double>, const Ray& ray) { return latitude_and_longitude(ray); }},
    OwnLens{"LENSMODEL_CAHVOR", 5, cahvor},
};

const OwnLens* find_own_lens(std::string_view name) {
  const auto* const found = std::ranges::find(kOwnLenses, name, &OwnLens::name);
  return found == kOwnLenses.end() ? nullptr : &*found;
}

}  // namespace

std::optional<std::size_t> numbers_of_own_lens(std::string_view name) {
  if (const OwnLens* lens = find_own_lens(name)) return kCore + lens->coefficients;
  const std::optional<Spline> spline = Spline::find(name);
  return spline ? std::optional(spline->numbers()) : std::nullopt;
}

Projection projection_of_own_lens(std::string_view name, std::span<const double> numbers) {
  const std::span<const double> lens = numbers.subspan(kCore);
  if (const OwnLens* own = find_own_lens(name)) {
    return [own, numbers, lens](const Ray& ray) -> std::optional<Pixel> {
      const std::optional<Plane> point = own->at(lens, ray);
      return point ? std::optional(in_pixels(numbers, *point)) : std::nullopt;
    };
  }
  const Spline spline = Spline::find(name).value();
  return [spline, numbers, lens](const Ray& ray) -> std::optional<Pixel> {
    const std::optional<Plane> point = stereographic(ray);
    const std::optional<Plane> moved = point ? spline.at(lens, *point) : std::nullopt;
    return moved ? std::optional(in_pixels(numbers, *moved)) : std::nullopt;
  };
}

}  // namespace fca::mrcal
