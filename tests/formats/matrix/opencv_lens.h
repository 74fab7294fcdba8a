// SPDX-License-Identifier: BSD-3-Clause
// OpenCV's two lenses on the image plane of focal length 1, by the formulas of its documentation (docs.opencv.org, calib3d).
#pragma once

#include "geometry.h"

#include <cmath>
#include <optional>
#include <vector>

namespace fca::matrix {

/// [R33 0 -R13; 0 R33 -R23; 0 0 1] R(tx, ty) on (x, y, 1), then divided.
inline Pixel tilted(const Pixel& m, double tx, double ty) {
  const double cx = std::cos(tx);
  const double sx = std::sin(tx);
  const double cy = std::cos(ty);
  const double sy = std::sin(ty);
  // R = [cy 0 -sy; 0 1 0; sy 0 cy] [1 0 0; 0 cx sx; 0 -sx cx]
  const double R[3][3] = {{cy, sy * sx, -sy * cx}, {0.0, cx, sx}, {sy, -cy * sx, cy * cx}};
  double q[3];
  for (int i = 0; i < 3; ++i) q[i] = R[i][0] * m[0] + R[i][1] * m[1] + R[i][2];
  return {(R[2][2] * q[0] - R[0][2] * q[2]) / q[2], (R[2][2] * q[1] - R[1][2] * q[2]) / q[2]};
}

inline RayToPixel pinhole(std::vector<double> d) {
  d.resize(14, 0.0);
  return [d](const Ray& p) -> std::optional<Pixel> {
    if (p[2] <= 0.0) return std::nullopt;
    const double x = p[0] / p[2];
    const double y = p[1] / p[2];
    const double r2 = x * x + y * y;
    const double r4 = r2 * r2;
    const double r6 = r4 * r2;
    const double below = 1.0 + d[5] * r2 + d[6] * r4 + d[7] * r6;
    const double radial = (1.0 + d[0] * r2 + d[1] * r4 + d[4] * r6) / below;
    const Pixel m = {x * radial + 2.0 * d[2] * x * y + d[3] * (r2 + 2.0 * x * x) + d[8] * r2 + d[9] * r4,
                     y * radial + d[2] * (r2 + 2.0 * y * y) + 2.0 * d[3] * x * y + d[10] * r2 + d[11] * r4};
    return d[12] == 0.0 && d[13] == 0.0 ? m : tilted(m, d[12], d[13]);
  };
}

inline RayToPixel fisheye(std::vector<double> k) {
  k.resize(4, 0.0);
  return [k](const Ray& p) -> std::optional<Pixel> {
    const double r = std::sqrt(p[0] * p[0] + p[1] * p[1]);
    if (r == 0.0) return p[2] > 0.0 ? std::optional(Pixel{0.0, 0.0}) : std::nullopt;
    const double theta = std::atan2(r, p[2]);
    const double theta2 = theta * theta;
    const double theta4 = theta2 * theta2;
    const double theta_d = theta * (1.0 + k[0] * theta2 + k[1] * theta4 + k[2] * theta4 * theta2 + k[3] * theta4 * theta4);
    return Pixel{theta_d * p[0] / r, theta_d * p[1] / r};
  };
}

/// The same in the image of a camera matrix.
inline RayToPixel in_image(RayToPixel lens, double fx, double fy, double cx, double cy) {
  return [lens = std::move(lens), fx, fy, cx, cy](const Ray& ray) -> std::optional<Pixel> {
    const std::optional<Pixel> m = lens(ray);
    if (!m) return std::nullopt;
    return Pixel{fx * (*m)[0] + cx, fy * (*m)[1] + cy};
  };
}

}  // namespace fca::matrix
