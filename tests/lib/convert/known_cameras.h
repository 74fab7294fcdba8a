// SPDX-License-Identifier: BSD-3-Clause
// Cameras with published parameters.
#pragma once

#include <fca/code.h>
#include <fca/rig/rig.h>

#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace fca::test {

inline constexpr double kRadians = std::numbers::pi / 180.0;

inline Camera make_camera(const CameraModel& model, ImageSize size) {
  Camera camera;
  camera.name = "cam0";
  camera.model = model;
  camera.image_size = size;
  return camera;
}

/// The camera, whose image is lit in a circle only.
inline Camera with_image_circle(Camera camera, const Pixel& centre, double radius_px) {
  camera.lens_circle = LensCircle{centre, radius_px, 1.0, 0.0, {Code::kOnlyThing, {"a circle of the test"}}};
  return camera;
}

/// The factory calibration of an OAK-D-Pro's left camera: 14 coefficients, a tilt of 0.2 degrees.
inline Camera oak_tilted() {
  return make_camera(Intrinsics<Opencv14>{{799.3952026367188, 799.3013916015625, 642.171875, 384.5967102050781,
                                           27.344240188598633, -47.42519760131836, 0.000490090693347156, 0.00024394151114393026,
                                           24.723031997680664, 26.633960723876953, -45.357730865478516, 23.19692611694336, 0.0,
                                           0.0, 0.0, 0.0, -0.0032038954086601734, 0.0018769855378195643}},
                     {1280, 800});
}

/// As cv::omnidir calibrates by default, with skew.
inline Camera skewed_omnidir() {
  return make_camera(
      Intrinsics<Skewed<Mei>>{{738.5, 738.125, 512.25, 511.75, 0.957, -0.0225, 0.0017, 0.00018, 0.00044, 0.6975}},
      {1024, 1024});
}

/// A skew on purpose.
inline Camera skewed_fisheye() {
  return make_camera(Intrinsics<Skewed<Kb4>>{{380.5, 379.9, 640.2, 478.8, -0.012, 0.004, -0.003, 0.0006, -15.0}}, {1280, 960});
}

/// Tilted on purpose, with a prism.
inline Camera scheimpflug() {
  return make_camera(Intrinsics<Opencv14>{{700.0, 705.0, 640.0, 360.0, -0.15, 0.03, 5e-4, -2e-4, 0.0, 0.0, 0.0, 0.0, 1e-3, 0.0,
                                           -5e-4, 0.0, 0.05, -0.03}},
                     {1280, 720});
}

/// Kalibr's sample data set, calibrated with ds (Kalibr's authors).
inline Camera kalibr_ds() {
  return make_camera(Intrinsics<Ds>{{348.112754378549, 347.1109973814674, 365.8121721753254, 249.3555778487899,
                                     0.5657413673629862, -0.24425190195168348}},
                     {752, 480});
}
/// The same with eucm.
inline Camera kalibr_eucm() {
  return make_camera(Intrinsics<Eucm>{{460.92588889854693, 459.59327980206865, 365.81762690405503, 248.93674967920276,
                                       0.5864679700626143, 1.139248617863534}},
                     {752, 480});
}
/// The same with kb4.
inline Camera kalibr_kb4() {
  return make_camera(Intrinsics<Kb4>{{461.58688085556616, 460.2811732644195, 366.28603126815506, 249.08026891791644,
                                      -0.012523386218579752, 0.057836801948828065, -0.08495347810986263, 0.04362766880887814}},
                     {752, 480});
}
/// The same with radtan.
inline Camera kalibr_radtan() {
  return make_camera(
      Intrinsics<Radtan>{{459.2595646276051, 457.7579979599497, 366.021259576013, 248.29906707021513, -0.2895683327836746,
                          0.07964702146041833, 0.00033877669379945766, -2.1638533618181003e-05, 0.0}},
      {752, 480});
}
/// EuRoC MAV data set, cam0 (Burri et al. 2016).
inline Camera euroc() {
  return make_camera(
      Intrinsics<Radtan>{{458.654, 457.296, 367.215, 248.375, -0.28340811, 0.07395907, 0.00019359, 1.76187114e-05, 0.0}},
      {752, 480});
}
/// TUM-VI, cam0, 512 x 512 (Schubert et al. 2018); the lens reaches 97.5 degrees from the axis.
inline Camera tumvi() {
  return make_camera(
      Intrinsics<Kb4>{{190.97847715128717, 190.9733070521226, 254.93170605935475, 256.8974428996504, 0.0034823894022493434,
                       0.0007150348452162257, -0.0020532361418706202, 0.00020293673591811182}},
      {512, 512});
}
/// The same camera as Double Sphere (Basalt's published calibration).
inline Camera tumvi_ds() {
  return make_camera(Intrinsics<Ds>{{158.28600034966976, 158.2743455478755, 254.96116578191652, 256.8894394501779,
                                     0.5931177593944744, -0.17213086034353242}},
                     {512, 512});
}
/// Like an Intel T265's, not a real one.
inline Camera t265_like() {
  return make_camera(Intrinsics<Kb4>{{286.3, 286.3, 417.2, 399.1, -0.00604, 0.0452, -0.0425, 0.00776}}, {848, 800});
}
/// A 220-degree lens, not a real one.
inline Camera lens_220() {
  return make_camera(Intrinsics<Kb4>{{265.1, 264.9, 513.3, 509.7, -0.012, 0.004, -0.0015, 0.0002}}, {1024, 1024});
}

/// The sample data of OCamCalib, from the published (u, v) form: c = 1 / c', d = e' c, e = d' c, a_k = -a'_k c^(k - 1)
/// (ERRATA).
inline Camera ocamcalib_sample() {
  return make_camera(Intrinsics<Ocamcalib>{{359.829671, 243.611488, 1.0011312783445292, 0.00011012444061789821,
                                            -0.00016919118604022542, -209.06718681900003, 0.0, 0.002218682110785187,
                                            -5.134154633670041e-06, 2.157249816212779e-08, 0.0, 0.0, 0.0, 0.0}},
                     {752, 480});
}
/// WoodScape data set, front camera; the lens reaches 95 degrees from the axis.
inline Camera woodscape_front() {
  return make_camera(Intrinsics<Woodscape>{{339.749, -31.988, 48.275, -7.201, 1.0, 639.5 + 3.942, 482.5 - 3.093}}, {1280, 966});
}
/// A depth camera's rational lens, not a real one.
inline Camera rational_lens() {
  return make_camera(Intrinsics<Rational>{{605.286, 605.699, 637.01, 366.758, 0.5220, -2.6951, 0.000899, -0.000228, 1.5296,
                                           0.4012, -2.5146, 1.4555}},
                     {1280, 720});
}

}  // namespace fca::test
