// SPDX-License-Identifier: BSD-3-Clause
// Seeded random numbers and lenses.
#pragma once

#include "known_cameras.h"

#include <fca/convert/field_of_view.h>

#include <optional>
#include <random>

namespace fca::test {

class Random {
 public:
  explicit Random(unsigned seed) : generator_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(generator_); }

 private:
  std::mt19937 generator_;
};

/// A lens whose image ends between 69 and 89.5 degrees: what sees ahead only bends there as fast as it can.
inline Camera wide_camera(Random& random) {
  for (;;) {
    const double fx = random.between(150.0, 700.0);
    const double fy = fx * random.between(0.97, 1.03);
    const double cx = random.between(290.0, 350.0);
    const double cy = random.between(210.0, 270.0);
    const auto model = [&]() -> CameraModel {
      switch (random.below(4)) {
        case 0:
          return Intrinsics<Kb4>{{fx, fy, cx, cy, random.between(-0.1, 0.1), random.between(-0.03, 0.03),
                                  random.between(-0.01, 0.01), random.between(-0.002, 0.002)}};
        case 1: {
          const double xi = random.between(-0.6, 0.3);
          return Intrinsics<Ds>{{fx * (1.0 + xi), fy * (1.0 + xi), cx, cy, random.between(0.5, 0.8), xi}};
        }
        case 2:
          return Intrinsics<Eucm>{{fx, fy, cx, cy, random.between(0.05, 0.8), random.between(0.5, 2.0)}};
        default:
          return Intrinsics<Ucm>{{fx, fy, cx, cy, random.between(0.1, 0.9)}};
      }
    };
    const Camera camera = make_camera(model(), {640, 480});
    Diagnostics diagnostics;
    const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, {}, diagnostics);
    if (!field_of_view) continue;
    const double angle_deg = field_of_view->max_angle_rad / kRadians;
    if (angle_deg > 69.0 && angle_deg < 89.5) return camera;
  }
}

}  // namespace fca::test
