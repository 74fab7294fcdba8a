// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory_error.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>

namespace flight {

namespace {

Eigen::Vector3d middle_of(const std::vector<Pose>& poses) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Pose& pose : poses) sum += pose.p_world_imu;
  return sum / static_cast<double>(poses.size());
}

}  // namespace

TrajectoryError error_of(const std::vector<Pose>& estimate, const std::vector<Pose>& truth) {
  const Eigen::Vector3d middle = middle_of(estimate);
  const Eigen::Vector3d true_middle = middle_of(truth);
  double sine = 0.0;
  double cosine = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Eigen::Vector3d a = estimate[i].p_world_imu - middle;
    const Eigen::Vector3d b = truth[i].p_world_imu - true_middle;
    sine += a.x() * b.y() - a.y() * b.x();
    cosine += a.x() * b.x() + a.y() * b.y();
  }
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(std::atan2(sine, cosine), Eigen::Vector3d::UnitZ()).toRotationMatrix();

  double metres = 0.0;
  double radians = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    metres += (turn * (estimate[i].p_world_imu - middle) + true_middle - truth[i].p_world_imu).squaredNorm();
    const double angle = Eigen::AngleAxisd(truth[i].R_world_imu.transpose() * turn * estimate[i].R_world_imu).angle();
    radians += angle * angle;
  }
  constexpr double kDegrees = 180.0 / 3.14159265358979323846;
  const double count = static_cast<double>(truth.size());
  return {std::sqrt(metres / count), std::sqrt(radians / count) * kDegrees};
}

}  // namespace flight
