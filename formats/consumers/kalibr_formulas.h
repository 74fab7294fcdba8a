// SPDX-License-Identifier: BSD-3-Clause
// Private: what Kalibr (ethz-asl/kalibr@1f60227, aslam_cameras) computes for a point before a camera.
//
// A ray gives nothing where Kalibr's own return value says "invalid": the pinhole family for z <= 0 (it still fills in a
// mirrored pixel, which the oracle tables print), omni, eucm and ds outside their cones. Pixels next to the image are returned.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

namespace fca::consumers::kalibr {

using Pixel = std::array<double, 2>;
using Ray = std::array<double, 3>;
using Projection = std::function<std::optional<Pixel>(const Ray&)>;

struct Intrinsics {
  double fu = 0.0, fv = 0.0, pu = 0.0, pv = 0.0;
};

/// A camera block after all checks. `model[0..1]` are the numbers before fu: xi | alpha beta | xi alpha.
struct KalibrCamera {
  std::string camera_model;
  std::string distortion_model;
  std::array<double, 2> model{};
  Intrinsics intrinsics;
  std::array<double, 4> coeffs{};
  std::optional<double> time_offset_s;
  int width = 0;
  int height = 0;
};

/// The camera's own projection.
[[nodiscard]] Projection make_projection(const KalibrCamera& camera);

/// By how much that is off from the formula that it stands for, in pixels: Kalibr's fov near the axis.
[[nodiscard]] double approximation_px(const KalibrCamera& camera);

}  // namespace fca::consumers::kalibr
