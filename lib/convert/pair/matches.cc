// SPDX-License-Identifier: BSD-3-Clause
#include "matches.h"

#include "../../rig/eigen_rotation.h"

#include <fca/rectify/rectify.h>
#include <fca/rectify/vertical_disparity.h>
#include <fca/rig/rotation.h>

#include <Eigen/Geometry>

#include <cmath>

namespace fca::internal {

namespace {

using Eigen::Vector3d;

Vector3d vector_of(const std::array<double, 3>& ray) { return {ray[0], ray[1], ray[2]}; }

/// The camera's pixel of a unit ray; nullopt if the ray is not in its field of view, or if the model with which the fit starts
/// has no pixel for it.
std::optional<Pixel> usable_pixel(const CameraOfPair& of_pair, const Vector3d& ray) {
  if (std::atan2(std::hypot(ray[0], ray[1]), ray[2]) > of_pair.field_of_view.max_angle_rad) return std::nullopt;
  const Ray direction = {ray[0], ray[1], ray[2]};
  if (!project(*of_pair.start, direction)) return std::nullopt;
  const std::optional<Pixel> pixel = project(of_pair.camera->model, direction);
  return pixel && of_pair.field_of_view.size.holds(*pixel) && of_pair.field_of_view.is_lit(*pixel) ? pixel : std::nullopt;
}

/// The derivatives with respect to u and v [1/px] of the component along `normal` of a pixel's unit ray; nullopt if a point
/// next to the pixel has no ray.
std::optional<Eigen::RowVector2d> derivative_along(const CameraModel& model, const Pixel& pixel, const Vector3d& normal) {
  constexpr double kStep = 0.25;  // px
  Eigen::RowVector2d derivative;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    Pixel before = pixel;
    Pixel after = pixel;
    before.at(axis) -= kStep;
    after.at(axis) += kStep;
    const std::optional<Ray> ray_before = unproject(model, before);
    const std::optional<Ray> ray_after = unproject(model, after);
    if (!ray_before || !ray_after) return std::nullopt;
    derivative[static_cast<Eigen::Index>(axis)] = normal.dot(vector_of(*ray_after) - vector_of(*ray_before)) / (2.0 * kStep);
  }
  return derivative;
}

/// Computes rows in a pair of rectified images [px], or columns if one camera is above the other. The focal length is the mean
/// of the cameras' focal lengths at their axes.
class Rows {
 public:
  Rows(const std::array<CameraOfPair, 2>& cameras, const RectifyingRotations& rotations)
      : across_(rotations.is_vertical ? 0 : 1),
        R_rectified_camera_{matrix_of(rotations.T_rectified_camera[0]), matrix_of(rotations.T_rectified_camera[1])} {
    for (const CameraOfPair& each : cameras)
      focal_length_ += 0.5 * central_focal_lengths(each.camera->model).at(static_cast<std::size_t>(across_));
  }

  /// The derivative of the row with respect to a camera's unit ray [px]; nullopt if the ray is too far from the rectified axis.
  [[nodiscard]] std::optional<Vector3d> derivative(std::size_t camera, const Vector3d& ray) const {
    const Vector3d rectified = R_rectified_camera_.at(camera) * ray;
    const double depth = rectified[2];
    if (!(depth >= std::cos(0.5 * kWidestRectifiedView))) return std::nullopt;
    const Vector3d derivative = Vector3d::Unit(across_) / depth - rectified[across_] / (depth * depth) * Vector3d::UnitZ();
    return focal_length_ * (R_rectified_camera_.at(camera).transpose() * derivative);
  }

 private:
  int across_;
  std::array<Eigen::Matrix3d, 2> R_rectified_camera_;
  double focal_length_ = 0.0;
};

/// Adds to `matches` a point with the entry `first` of the first camera and the unit ray `seen` of the second, unless a camera
/// cannot use it.
void add_match(const std::array<CameraOfPair, 2>& cameras, const Rows& rows, const Correspondence& first, const Vector3d& seen,
               Matches& matches) {
  const std::optional<Pixel> pixel = usable_pixel(cameras[1], seen);
  const std::optional<Vector3d> first_derivative = rows.derivative(0, vector_of(first.ray));
  const std::optional<Vector3d> second_derivative = rows.derivative(1, seen);
  if (!pixel || !first_derivative || !second_derivative) return;
  const std::optional<Eigen::RowVector2d> here = derivative_along(cameras[0].camera->model, first.pixel, *first_derivative);
  const std::optional<Eigen::RowVector2d> there = derivative_along(cameras[1].camera->model, *pixel, *second_derivative);
  if (!here || !there) return;
  matches.seen[0].push_back(first);
  matches.seen[1].push_back({{seen[0], seen[1], seen[2]}, *pixel, first.weight});
  matches.derivatives[0].push_back(-*here);
  matches.derivatives[1].push_back(*there);
}

}  // namespace

Matches matches_of(const std::array<CameraOfPair, 2>& cameras, const Transform& T_second_first) {
  Matches matches;
  const std::optional<RectifyingRotations> rotations = rectifying_rotations(T_second_first);
  if (!rotations) return matches;
  const Rows rows(cameras, *rotations);
  const Eigen::Matrix3d R = matrix_of(T_second_first);
  const Vector3d shift = vector_of(translation_of(T_second_first)).normalized() / kNearPoints;
  for (const Correspondence& first : cameras[0].samples) {
    const Vector3d far_away = R * vector_of(first.ray);
    for (const Vector3d& seen : {far_away, Vector3d((far_away + shift).normalized())})
      add_match(cameras, rows, first, seen, matches);
  }
  double sum = 0.0;
  for (const Correspondence& each : matches.seen[0]) sum += each.weight;
  for (std::vector<Correspondence>& seen : matches.seen) {
    for (Correspondence& each : seen) each.weight /= sum;
  }
  return matches;
}

}  // namespace fca::internal
