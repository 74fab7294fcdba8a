// SPDX-License-Identifier: BSD-3-Clause
#include "radial_borders.h"

#include "../bound/polar.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace fca::internal {

namespace {

/// True if the azimuth of a pixel about the principal point depends only on the azimuth of its ray, not on the ray's angle from
/// the axis. False for models without a polar form, for which this is not known.
bool is_radial(const CameraModel& model) {
  return std::visit(
      []<class M>(const Intrinsics<M>& m) {
        if constexpr (HasPolarForm<M>) {
          PolarSeries form;
          M::polar_form(m.values.data(), angle_series({0.1, 0.0}), form);
          // True if the curves have no common centre, as with thin prism distortion.
          const auto moves = [](const Series& centre) {
            return std::ranges::any_of(centre.c.begin() + 1, centre.c.end(), [](const Ball& c) { return c.mid != 0.0; });
          };
          constexpr std::size_t kFirstOfTwice = 3;  // cos 2phi, sin 2phi: tangential distortion (bound/polar.h)
          for (std::size_t i = 0; i < 2; ++i) {
            if (form.used[i][kFirstOfTwice] || form.used[i][kFirstOfTwice + 1] || moves(form.of[i][0])) return false;
          }
          return !is_tilted(m);
        } else {
          return false;
        }
      },
      model);
}

/// The pixel of the ray with this angle from the axis [rad] and this azimuth [rad].
std::optional<Pixel> pixel_at(const CameraModel& model, double angle, double azimuth) {
  return project(model, {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)});
}

}  // namespace

LineAmongCircles::LineAmongCircles(const std::array<double, 2>& start, const std::array<double, 2>& direction)
    : inverse_square_(1.0 / (direction[0] * direction[0] + direction[1] * direction[1])),
      nearest_(-(direction[0] * start[0] + direction[1] * start[1]) * inverse_square_) {
  const double across = (direction[0] * start[1] - direction[1] * start[0]) * inverse_square_;
  across_ = across * across;
}

LineSpan LineAmongCircles::inside(double radius) const {
  const double square = radius * radius * inverse_square_ - across_;
  if (!(square > 0.0)) return {};
  const double half = std::sqrt(square);
  return {nearest_ - half, nearest_ + half};
}

std::optional<RadialBorders> RadialBorders::of(const Lens& source, std::span<const double> angles) {
  const CameraModel* model = source.model();
  if (model == nullptr || !is_radial(*model)) return std::nullopt;
  // An angle [rad] at which the model has pixels.
  const double last = max_angle(*model);
  const double unit = std::min(0.5, 0.5 * last);
  const std::optional<Pixel> right = pixel_at(*model, unit, 0.0);
  const std::optional<Pixel> down = pixel_at(*model, unit, 0.5 * std::numbers::pi);
  if (!right || !down) return std::nullopt;
  RadialBorders result;
  result.centre_ = principal_point(*model);
  const std::array<double, 4> from_plane = {(*right)[0] - result.centre_[0], (*down)[0] - result.centre_[0],
                                            (*right)[1] - result.centre_[1], (*down)[1] - result.centre_[1]};
  const double inverse = 1.0 / (from_plane[0] * from_plane[3] - from_plane[1] * from_plane[2]);
  if (!std::isfinite(inverse)) return std::nullopt;
  result.to_plane_ = {from_plane[3] * inverse, -from_plane[1] * inverse, -from_plane[2] * inverse, from_plane[0] * inverse};
  constexpr double kInside = 1.0 - 1e-9;  // at the largest angle itself there may be no pixel
  for (const double angle : angles) {
    const std::optional<Pixel> pixel = pixel_at(*model, std::min(angle, last * kInside), 0.0);
    if (!pixel) return std::nullopt;
    const auto [x, y] = result.in_plane((*pixel)[0] - result.centre_[0], (*pixel)[1] - result.centre_[1]);
    result.radii_.push_back(std::sqrt(x * x + y * y));
  }
  return result;
}

std::array<double, 2> RadialBorders::in_plane(double right, double down) const {
  return {to_plane_[0] * right + to_plane_[1] * down, to_plane_[2] * right + to_plane_[3] * down};
}

LineAmongCircles RadialBorders::among_circles(const Line& line) const {
  return {in_plane(line.from[0] - centre_[0], line.from[1] - centre_[1]),
          in_plane(line.to[0] - line.from[0], line.to[1] - line.from[1])};
}

}  // namespace fca::internal
