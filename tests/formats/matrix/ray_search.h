// SPDX-License-Identifier: BSD-3-Clause
// The ray of a pixel from nothing but the formula ray -> pixel: from the centre outwards in small steps, Newton at each.
#pragma once

#include "geometry.h"

namespace fca::matrix {

/// Angle from the optical axis, in radians.
inline double angle_of(const Ray& ray) { return std::atan2(std::hypot(ray[0], ray[1]), ray[2]); }

/// A direction as the angle from the axis times the unit vector of its azimuth: regular everywhere but straight behind.
using Direction = std::array<double, 2>;

inline Ray ray_of(const Direction& w) {
  const double angle = std::hypot(w[0], w[1]);
  if (angle == 0.0) return {0.0, 0.0, 1.0};
  return {std::sin(angle) * w[0] / angle, std::sin(angle) * w[1] / angle, std::cos(angle)};
}

/// d pixel / d direction, by central differences; nothing where a neighbour has no pixel.
inline std::optional<std::array<double, 4>> jacobian(const RayToPixel& formula, const Direction& w) {
  constexpr double kStep = 1e-6;
  std::array<double, 4> result{};
  for (std::size_t i = 0; i < 2; ++i) {
    Direction ahead = w;
    Direction behind = w;
    ahead[i] += kStep;
    behind[i] -= kStep;
    const std::optional<Pixel> a = formula(ray_of(ahead));
    const std::optional<Pixel> b = formula(ray_of(behind));
    if (!a || !b) return std::nullopt;
    result[i] = ((*a)[0] - (*b)[0]) / (2.0 * kStep);
    result[2 + i] = ((*a)[1] - (*b)[1]) / (2.0 * kStep);
  }
  return result;
}

inline double determinant(const std::array<double, 4>& J) { return J[0] * J[3] - J[1] * J[2]; }

/// From a start close by; nothing where it does not converge or the image folds.
inline std::optional<Direction> newton(const RayToPixel& formula, const Pixel& pixel, Direction w) {
  double last = INFINITY;
  for (int i = 0; i < 40; ++i) {
    const std::optional<Pixel> now = formula(ray_of(w));
    const std::optional<std::array<double, 4>> J = jacobian(formula, w);
    if (!now || !J || !(determinant(*J) > 0.0)) return std::nullopt;
    const double du = pixel[0] - (*now)[0];
    const double dv = pixel[1] - (*now)[1];
    const double residual = std::hypot(du, dv);
    if (residual < 1e-11 || (residual < 1e-9 && residual >= last)) return w;
    last = residual;
    const double d = determinant(*J);
    Direction step = {(J->at(3) * du - J->at(1) * dv) / d, (J->at(0) * dv - J->at(2) * du) / d};
    const double length = std::hypot(step[0], step[1]);
    const double most = 0.1;
    if (length > most) {
      for (double& part : step) part *= most / length;
    }
    w = {w[0] + step[0], w[1] + step[1]};
    if (std::hypot(w[0], w[1]) > 3.1) return std::nullopt;
  }
  return std::nullopt;
}

/// The ray of a pixel, on the branch of the formula that holds the axis; nothing where that branch does not reach it.
inline std::optional<Ray> search_ray(const RayToPixel& formula, const Pixel& pixel) {
  const std::optional<Pixel> centre = formula({0.0, 0.0, 1.0});
  if (!centre) return std::nullopt;
  const double distance = std::hypot(pixel[0] - (*centre)[0], pixel[1] - (*centre)[1]);
  const int steps = 12 + static_cast<int>(distance / 40.0);
  Direction w = {0.0, 0.0};
  for (int i = 1; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const Pixel next = {(*centre)[0] + t * (pixel[0] - (*centre)[0]), (*centre)[1] + t * (pixel[1] - (*centre)[1])};
    const std::optional<Direction> found = newton(formula, next, w);
    if (!found || std::hypot((*found)[0] - w[0], (*found)[1] - w[1]) > 0.5) return std::nullopt;
    w = *found;
  }
  return ray_of(w);
}

/// Whether the formula runs from the axis to the ray without a fold and without an end.
inline bool reaches(const RayToPixel& formula, const Ray& ray) {
  constexpr int kSteps = 64;
  const double angle = angle_of(ray);
  const double r = std::hypot(ray[0], ray[1]);
  if (r == 0.0) return true;
  for (int i = 0; i <= kSteps; ++i) {
    const double a = angle * i / kSteps;
    const std::optional<std::array<double, 4>> J = jacobian(formula, {a * ray[0] / r, a * ray[1] / r});
    if (!J || !(determinant(*J) > 0.0)) return false;
  }
  return true;
}

}  // namespace fca::matrix
