// SPDX-License-Identifier: BSD-3-Clause
// What the readers of EuRoC's and Kimera's files share: lenses in OpenCV's formulas, those of equidistant ones past 90 deg,
// too.
#pragma once

#include "geometry.h"

namespace fca::matrix {

/// k1 k2 p1 p2 k3 k4 k5 k6, or k1 .. k4 of an equidistant lens. `k`: fx fy cx cy.
inline RayToPixel sensor_lens(const std::vector<double>& k, std::vector<double> d, bool equidistant) {
  d.resize(8, 0.0);
  return [k, d, equidistant](const Ray& ray) -> std::optional<Pixel> {
    if (equidistant) {
      const double r = std::hypot(ray[0], ray[1]);
      if (r == 0.0) return ray[2] > 0.0 ? std::optional(Pixel{k[2], k[3]}) : std::nullopt;
      const double t = std::atan2(r, ray[2]);
      const double bent = t + d[0] * std::pow(t, 3) + d[1] * std::pow(t, 5) + d[2] * std::pow(t, 7) + d[3] * std::pow(t, 9);
      return Pixel{k[0] * bent * ray[0] / r + k[2], k[1] * bent * ray[1] / r + k[3]};
    }
    if (!(ray[2] > 0.0)) return std::nullopt;
    const double x = ray[0] / ray[2];
    const double y = ray[1] / ray[2];
    const double s = x * x + y * y;
    const double up = 1.0 + s * (d[0] + s * (d[1] + s * d[4]));
    const double down = 1.0 + s * (d[5] + s * (d[6] + s * d[7]));
    return Pixel{k[0] * (x * up / down + 2.0 * d[2] * x * y + d[3] * (s + 2.0 * x * x)) + k[2],
                 k[1] * (y * up / down + d[2] * (s + 2.0 * y * y) + 2.0 * d[3] * x * y) + k[3]};
  };
}

/// T_second_first of the first two files that specify a camera in the body.
inline std::vector<Pose> second_in_first(const std::vector<std::string>& files,
                                         std::optional<Pose> (*pose_in_body)(const std::string& bytes)) {
  std::vector<Pose> poses;
  for (const std::string& bytes : files) {
    if (const std::optional<Pose> pose = pose_in_body(bytes)) poses.push_back(*pose);
  }
  if (poses.size() < 2) return {};
  return {inverse(poses[1]) * poses[0]};
}

}  // namespace fca::matrix
