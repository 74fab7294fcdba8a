// SPDX-License-Identifier: BSD-3-Clause
// Private: what OpenCV 4.6 computes for a point in front of (and behind) a camera, written from its documentation and source:
// calib3d's calibration.cpp (cvProjectPoints2) and distortion_model.hpp (tilt), fisheye.cpp, ccalib's omnidir.cpp. In double,
// as there. Header only, so that a test that links calib3d can hold it against the originals (tests/lib/consumers).
#pragma once

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

namespace fca::consumers::opencv {

using Pixel = std::array<double, 2>;
using Ray = std::array<double, 3>;
using Matrix3 = std::array<double, 9>;  ///< Row-major.

/// The five entries of a camera matrix that any of the three functions looks at. K(2, 2), too, is never read.
struct CameraMatrix {
  double fx = 1.0, fy = 1.0, cx = 0.0, cy = 0.0;
  double skew = 0.0;  ///< K(0, 1): only omnidir uses it.
};

/// k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4 tau_x tau_y; shorter vectors end in zeros.
using PinholeCoefficients = std::array<double, 14>;

/// distortion_model.hpp, computeTiltProjectionMatrix: rotate by tau_x, tau_y, then project back onto the sensor plane.
inline Matrix3 tilt_matrix(double tau_x, double tau_y) {
  const double cx = std::cos(tau_x);
  const double sx = std::sin(tau_x);
  const double cy = std::cos(tau_y);
  const double sy = std::sin(tau_y);
  // R = R_y R_x with R_x = [1 0 0; 0 cx sx; 0 -sx cx], R_y = [cy 0 -sy; 0 1 0; sy 0 cy].
  const Matrix3 R = {cy, sy * sx, -sy * cx, 0.0, cx, sx, sy, -cy * sx, cy * cx};
  Matrix3 tilt = R;
  for (std::size_t col = 0; col < 3; ++col) {
    tilt.at(col) = R[8] * R.at(col) - R[2] * R.at(6 + col);
    tilt.at(3 + col) = R[8] * R.at(3 + col) - R[5] * R.at(6 + col);
  }
  return tilt;
}

/// cv::projectPoints. A ray from behind gives the pixel of its mirror image without any error; z = 0 counts as 1.
inline Pixel project_points(const CameraMatrix& K, const PinholeCoefficients& k, const Ray& ray) {
  const double inverse_z = ray[2] != 0.0 ? 1.0 / ray[2] : 1.0;
  const double x = ray[0] * inverse_z;
  const double y = ray[1] * inverse_z;
  const double r2 = x * x + y * y;
  const double r4 = r2 * r2;
  const double r6 = r4 * r2;
  const double radial = (1.0 + k[0] * r2 + k[1] * r4 + k[4] * r6) / (1.0 + k[5] * r2 + k[6] * r4 + k[7] * r6);
  double xd = x * radial + 2.0 * k[2] * x * y + k[3] * (r2 + 2.0 * x * x) + k[8] * r2 + k[9] * r4;
  double yd = y * radial + k[2] * (r2 + 2.0 * y * y) + 2.0 * k[3] * x * y + k[10] * r2 + k[11] * r4;
  if (k[12] != 0.0 || k[13] != 0.0) {
    const Matrix3 tilt = tilt_matrix(k[12], k[13]);
    const double w = tilt[6] * xd + tilt[7] * yd + tilt[8];
    const double inverse_w = w != 0.0 ? 1.0 / w : 1.0;
    const double xt = (tilt[0] * xd + tilt[1] * yd + tilt[2]) * inverse_w;
    yd = (tilt[3] * xd + tilt[4] * yd + tilt[5]) * inverse_w;
    xd = xt;
  }
  return {xd * K.fx + K.cx, yd * K.fy + K.cy};
}

/// cv::undistortPoints without R and P (undistort.dispatch.cpp): the pixel's point at z = 1, by at most `steps` steps of a
/// fixed point iteration, of which nobody asks whether it converged; 5 is the default. Without tilt.
inline Pixel undistort_point(const CameraMatrix& K, const PinholeCoefficients& k, const Pixel& pixel, int steps = 5) {
  const double x0 = (pixel[0] - K.cx) / K.fx;
  const double y0 = (pixel[1] - K.cy) / K.fy;
  double x = x0;
  double y = y0;
  for (int step = 0; step < steps; ++step) {
    const double r2 = x * x + y * y;
    const double inverse = (1.0 + ((k[7] * r2 + k[6]) * r2 + k[5]) * r2) / (1.0 + ((k[4] * r2 + k[1]) * r2 + k[0]) * r2);
    if (inverse < 0.0) return {x0, y0};
    const double dx = 2.0 * k[2] * x * y + k[3] * (r2 + 2.0 * x * x) + k[8] * r2 + k[9] * r2 * r2;
    const double dy = k[2] * (r2 + 2.0 * y * y) + 2.0 * k[3] * x * y + k[10] * r2 + k[11] * r2 * r2;
    x = (x0 - dx) * inverse;
    y = (y0 - dy) * inverse;
  }
  return {x, y};
}

/// The rays of undistort_point(), for programs that call it.
inline std::function<std::optional<Ray>(const Pixel&)> undistorted_rays(const CameraMatrix& K, const PinholeCoefficients& k) {
  return [K, k](const Pixel& pixel) -> std::optional<Ray> {
    const Pixel point = undistort_point(K, k, pixel);
    return Ray{point[0], point[1], 1.0};
  };
}

/// cv::fisheye::projectPoints with alpha = 0, its default: a skew in K is not used. The angle is the arctangent of the pinhole
/// radius, so beyond 90 degrees the pixel is that of the mirrored ray, without any error.
inline Pixel fisheye_project_points(const CameraMatrix& K, const std::array<double, 4>& k, const Ray& ray) {
  const double z = std::abs(ray[2]) < DBL_MIN ? 1.0 : ray[2];
  const double x = ray[0] / z;
  const double y = ray[1] / z;
  const double r = std::sqrt(x * x + y * y);
  const double theta = std::atan(r);
  const double t2 = theta * theta;
  const double theta_d = theta * (1.0 + t2 * (k[0] + t2 * (k[1] + t2 * (k[2] + t2 * k[3]))));
  constexpr double kOnAxis = 1e-8;
  const double factor = r > kOnAxis ? theta_d / r : 1.0;
  return {x * factor * K.fx + K.cx, y * factor * K.fy + K.cy};
}

/// cv::fisheye::undistortPoints with its default criteria: the distorted angle is cut off at 90 degrees, and a pixel from where
/// ten Newton steps do not converge goes far away to one side.
inline Ray fisheye_undistort_points(const CameraMatrix& K, const std::array<double, 4>& k, const Pixel& pixel) {
  const double x = (pixel[0] - K.cx) / K.fx;
  const double y = (pixel[1] - K.cy) / K.fy;
  const double theta_d = std::min(std::hypot(x, y), std::numbers::pi / 2.0);
  constexpr double kEps = 1e-8;
  if (!(theta_d > kEps)) return {x, y, 1.0};
  constexpr int kSteps = 10;
  double theta = theta_d;
  for (int i = 0; i < kSteps; ++i) {
    const double t2 = theta * theta;
    const double value = theta * (1.0 + t2 * (k[0] + t2 * (k[1] + t2 * (k[2] + t2 * k[3])))) - theta_d;
    const double derivative = 1.0 + t2 * (3.0 * k[0] + t2 * (5.0 * k[1] + t2 * (7.0 * k[2] + t2 * 9.0 * k[3])));
    const double step = value / derivative;
    theta -= step;
    if (!(std::abs(step) < kEps)) continue;
    if (theta < 0.0) break;
    const double scale = std::tan(theta) / theta_d;
    return {x * scale, y * scale, 1.0};
  }
  constexpr double kNowhere = -1000000.0;
  return {kNowhere, kNowhere, 1.0};
}

/// cv::omnidir::projectPoints (Mei's model, k1 k2 p1 p2, with skew). Beyond the pole of the projection the pixel folds back.
inline Pixel omnidir_project_points(const CameraMatrix& K, double xi, const std::array<double, 4>& k, const Ray& ray) {
  const double norm = std::sqrt(ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2]);
  const double depth = ray[2] / norm + xi;
  const double x = ray[0] / norm / depth;
  const double y = ray[1] / norm / depth;
  const double r2 = x * x + y * y;
  const double radial = 1.0 + k[0] * r2 + k[1] * r2 * r2;
  const double xd = x * radial + 2.0 * k[2] * x * y + k[3] * (r2 + 2.0 * x * x);
  const double yd = y * radial + k[2] * (r2 + 2.0 * y * y) + 2.0 * k[3] * x * y;
  return {K.fx * xd + K.skew * yd + K.cx, K.fy * yd + K.cy};
}

/// cv::Rodrigues of a rotation vector.
inline Matrix3 rotation_of(const std::array<double, 3>& om) {
  const double angle = std::sqrt(om[0] * om[0] + om[1] * om[1] + om[2] * om[2]);
  if (angle < DBL_EPSILON) return {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const double x = om[0] / angle;
  const double y = om[1] / angle;
  const double z = om[2] / angle;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double t = 1.0 - c;
  return {c + t * x * x,     t * x * y - s * z, t * x * z + s * y, t * x * y + s * z, c + t * y * y,
          t * y * z - s * x, t * x * z - s * y, t * y * z + s * x, c + t * z * z};
}

/// The rotation nearest to a matrix: the mean of it and its inverse transposed, until that stays. Of one without an inverse
/// nan.
inline Matrix3 nearest_rotation(const Matrix3& matrix) {
  Matrix3 R = matrix;
  constexpr int kSteps = 60;  // each halves what is far off and squares what is near
  for (int step = 0; step < kSteps; ++step) {
    const Matrix3 cofactors = {R[4] * R[8] - R[5] * R[7], R[5] * R[6] - R[3] * R[8], R[3] * R[7] - R[4] * R[6],
                               R[2] * R[7] - R[1] * R[8], R[0] * R[8] - R[2] * R[6], R[1] * R[6] - R[0] * R[7],
                               R[1] * R[5] - R[2] * R[4], R[2] * R[3] - R[0] * R[5], R[0] * R[4] - R[1] * R[3]};
    const double determinant = R[0] * cofactors[0] + R[1] * cofactors[1] + R[2] * cofactors[2];
    for (std::size_t i = 0; i < R.size(); ++i) R.at(i) = 0.5 * (R.at(i) + cofactors.at(i) / determinant);
  }
  return R;
}

/// The sine of the angle below which cv::Rodrigues makes the vector 0 of a rotation.
inline constexpr double kNoRotation = 1e-5;

/// The matrix that two calls of cv::Rodrigues, to a vector and back, return: the nearest rotation, or the identity for a turn
/// below 1e-5 rad.
inline Matrix3 rotation_there_and_back(const Matrix3& matrix) {
  const Matrix3 R = nearest_rotation(matrix);
  const double sine = 0.5 * std::hypot(R[7] - R[5], R[2] - R[6], R[3] - R[1]);
  const double cosine = 0.5 * (R[0] + R[4] + R[8] - 1.0);
  if (sine < kNoRotation && cosine > 0.0) return {1, 0, 0, 0, 1, 0, 0, 0, 1};
  return R;
}

}  // namespace fca::consumers::opencv
