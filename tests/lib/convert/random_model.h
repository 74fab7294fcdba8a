// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/models/camera_model.h>

#include <rapidcheck.h>

#include <array>

namespace fca::test {

/// A model of the list with plausible parameters for 640 x 480 pixels: a camera of the table's kinds, each lens parameter
/// moved. To be called inside a RapidCheck property.
inline CameraModel random_model(std::size_t kind) {
  const auto uniform = [](double low, double high) { return low + (high - low) * (*rc::gen::inRange(0, 1'000'001)) * 1e-6; };
  const double f = uniform(150.0, 500.0);
  const double g = f * uniform(0.95, 1.05);
  const double cx = uniform(200.0, 440.0);
  const double cy = uniform(180.0, 300.0);
  switch (kind) {
    case 0:
      return Intrinsics<Pinhole>{{f, g, cx, cy}};
    case 1:
      return Intrinsics<Radtan>{{f, g, cx, cy, uniform(-0.35, 0.1), uniform(-0.05, 0.12), uniform(-0.004, 0.004),
                                 uniform(-0.004, 0.004), uniform(-0.02, 0.02)}};
    case 2:
      return Intrinsics<Rational>{{f, g, cx, cy, uniform(0.0, 0.6), uniform(-0.1, 0.1), uniform(-0.004, 0.004),
                                   uniform(-0.004, 0.004), uniform(-0.01, 0.01), uniform(0.2, 0.9), uniform(0.0, 0.2),
                                   uniform(0.0, 0.05)}};
    case 3:
      return Intrinsics<Kb4>{
          {f, g, cx, cy, uniform(-0.1, 0.1), uniform(-0.05, 0.05), uniform(-0.03, 0.03), uniform(-0.01, 0.01)}};
    case 4:
      return Intrinsics<Ucm>{{f, g, cx, cy, uniform(0.0, 1.0)}};
    case 5:
      return Intrinsics<Eucm>{{f, g, cx, cy, uniform(0.0, 1.0), uniform(0.3, 3.0)}};
    case 6:
      return Intrinsics<Ds>{{f, g, cx, cy, uniform(0.0, 1.0), uniform(-0.9, 0.9)}};
    case 7:
      return Intrinsics<Mei>{{2.0 * f, 2.0 * g, cx, cy, uniform(0.0, 2.0), uniform(-0.3, 0.1), uniform(-0.1, 0.3),
                              uniform(-0.004, 0.004), uniform(-0.004, 0.004)}};
    case 8:
      return Intrinsics<Fov>{{f, g, cx, cy, uniform(0.3, 2.5)}};
    case 9:
      return Intrinsics<Ocamcalib>{{cx, cy, uniform(0.98, 1.02), uniform(-0.01, 0.01), uniform(-0.01, 0.01), -f, 0.0,
                                    uniform(0.2, 0.6) / f, uniform(-0.2, 0.2) / (f * f), uniform(-0.2, 0.2) / (f * f * f), 0, 0,
                                    0, 0}};
    case 11: {
      Intrinsics<Opencv14> model{{f, g, cx, cy, uniform(0.0, 0.6), uniform(-0.1, 0.1), uniform(-0.004, 0.004),
                                  uniform(-0.004, 0.004), uniform(-0.01, 0.01), uniform(0.2, 0.9), uniform(0.0, 0.2),
                                  uniform(0.0, 0.05), uniform(-0.005, 0.005), uniform(-0.002, 0.002), uniform(-0.005, 0.005),
                                  uniform(-0.002, 0.002)}};
      // Half of them are tilted.
      if (uniform(0.0, 1.0) < 0.5) return model;
      model.values[16] = uniform(-0.03, 0.03);
      model.values[17] = uniform(-0.03, 0.03);
      return model;
    }
    case 12:
      return Intrinsics<Division>{{f, g, cx, cy, uniform(-0.6, 0.1)}};
    case 13: {
      Intrinsics<ThinPrismFisheye> model{{f, g, cx, cy, uniform(-0.1, 0.1), uniform(-0.05, 0.05), uniform(-0.004, 0.004),
                                          uniform(-0.004, 0.004), uniform(-0.03, 0.03), uniform(-0.01, 0.01),
                                          uniform(-0.004, 0.004), uniform(-0.004, 0.004)}};
      // Half of them have a prism alone.
      if (uniform(0.0, 1.0) < 0.5) model.values[6] = model.values[7] = 0.0;
      return model;
    }
    case 14: {
      Intrinsics<Fisheye624> model{{f, g, cx, cy, uniform(-0.1, 0.1), uniform(-0.05, 0.05), uniform(-0.03, 0.03),
                                    uniform(-0.01, 0.01), uniform(-0.003, 0.003), uniform(-0.001, 0.001),
                                    uniform(-0.004, 0.004), uniform(-0.004, 0.004), uniform(-0.004, 0.004),
                                    uniform(-0.002, 0.002), uniform(-0.004, 0.004), uniform(-0.002, 0.002)}};
      if (uniform(0.0, 1.0) < 0.5) model.values[10] = model.values[11] = 0.0;
      return model;
    }
    case 15:
      return Intrinsics<Ftheta>{{f, uniform(-0.1, 0.1) * f, uniform(-0.1, 0.1) * f, uniform(-0.03, 0.03) * f,
                                 uniform(-0.01, 0.01) * f, g / f, uniform(-0.01, 0.01), uniform(-0.01, 0.01), cx, cy}};
    case 16:
    case 17:
    case 18:
    case 19: {
      constexpr std::array<std::size_t, 4> kStraight = {1, 2, 3, 7};
      return with_skew(random_model(kStraight.at(kind - 16)), uniform(-4.0, 4.0)).value();
    }
    default:
      return Intrinsics<Woodscape>{
          {f, uniform(-0.1, 0.1) * f, uniform(-0.1, 0.1) * f, uniform(-0.03, 0.03) * f, uniform(0.95, 1.05), cx, cy}};
  }
}

}  // namespace fca::test
