// SPDX-License-Identifier: BSD-3-Clause
#include "best_rotation.h"

#include "../rig/eigen_rotation.h"

#include <fca/convert/sample.h>

#include <cmath>
#include <vector>

#include <Eigen/Dense>

namespace fca::internal {

namespace {

Eigen::Vector3d vector_of(const Ray& ray) { return {ray[0], ray[1], ray[2]}; }

/// A pixel that both see.
struct Pair {
  Eigen::Vector3d reference;
  Eigen::Vector3d other;
  Eigen::Vector2d pixel;
  double weight = 0.0;
};

std::vector<Pair> pairs_of(const Lens& reference, const CameraModel& other, const Domain& domain) {
  constexpr int kSamples = 400;
  std::vector<Pair> pairs;
  for (const Correspondence& sample : fca::sample(reference, domain, kSamples)) {
    const std::optional<Ray> ray = unproject(other, sample.pixel);
    if (ray) pairs.push_back({vector_of(sample.ray), vector_of(*ray), {sample.pixel[0], sample.pixel[1]}, sample.weight});
  }
  return pairs;
}

/// Minimises the weighted squares of |other - R reference|.
Eigen::Matrix3d wahba(const std::vector<Pair>& pairs) {
  Eigen::Matrix3d B = Eigen::Matrix3d::Zero();
  for (const Pair& pair : pairs) B += pair.weight * pair.other * pair.reference.transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(B, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double handedness = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  return svd.matrixU() * Eigen::Vector3d(1.0, 1.0, handedness < 0.0 ? -1.0 : 1.0).asDiagonal() * svd.matrixV().transpose();
}

std::optional<Eigen::Vector2d> error_of(const CameraModel& other, const Pair& pair, const Eigen::Matrix3d& R) {
  const Eigen::Vector3d ray = R * pair.reference;
  const std::optional<Pixel> pixel = project(other, {ray[0], ray[1], ray[2]});
  if (!pixel) return std::nullopt;
  return Eigen::Vector2d((*pixel)[0], (*pixel)[1]) - pair.pixel;
}

/// The sum of the weighted squares; infinite where a ray has no pixel.
double cost_of(const CameraModel& other, const std::vector<Pair>& pairs, const Eigen::Matrix3d& R) {
  double cost = 0.0;
  for (const Pair& pair : pairs) {
    const std::optional<Eigen::Vector2d> error = error_of(other, pair, R);
    cost += error ? pair.weight * error->squaredNorm() : std::numeric_limits<double>::infinity();
  }
  return cost;
}

/// The step of Gauss and Newton, as a rotation vector; derivatives are differences.
Eigen::Vector3d step_from(const CameraModel& other, const std::vector<Pair>& pairs, const Eigen::Matrix3d& R) {
  constexpr double kStep = 1e-6;
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Pair& pair : pairs) {
    const std::optional<Eigen::Vector2d> error = error_of(other, pair, R);
    if (!error) continue;
    Eigen::Matrix<double, 2, 3> slopes;
    bool all = true;
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d along = kStep * Eigen::Vector3d::Unit(axis);
      const std::optional<Eigen::Vector2d> after = error_of(other, pair, rotation_by(along) * R);
      const std::optional<Eigen::Vector2d> before = error_of(other, pair, rotation_by(-along) * R);
      all = all && after && before;
      if (all) slopes.col(axis) = (*after - *before) / (2.0 * kStep);
    }
    if (!all) continue;
    normal += pair.weight * slopes.transpose() * slopes;
    right -= pair.weight * slopes.transpose() * *error;
  }
  return normal.ldlt().solve(right);
}

Eigen::Matrix3d polished(const CameraModel& other, std::vector<Pair> pairs, Eigen::Matrix3d R) {
  std::erase_if(pairs, [&](const Pair& pair) { return !error_of(other, pair, R); });
  double cost = cost_of(other, pairs, R);
  constexpr int kSteps = 20;
  for (int i = 0; i < kSteps; ++i) {
    const Eigen::Vector3d step = step_from(other, pairs, R);
    if (!step.allFinite()) break;
    const Eigen::Matrix3d next = rotation_by(step) * R;
    const double next_cost = cost_of(other, pairs, next);
    if (!(next_cost < cost)) break;
    R = next;
    cost = next_cost;
  }
  return R;
}

}  // namespace

std::optional<Transform> best_rotation(const Lens& reference, const CameraModel& other, const Domain& domain) {
  const std::vector<Pair> pairs = pairs_of(reference, other, domain);
  constexpr std::size_t kFewest = 3;
  if (pairs.size() < kFewest) return std::nullopt;
  const Eigen::Matrix3d R = polished(other, pairs, wahba(pairs));
  if (!R.allFinite()) return std::nullopt;
  return transform_of(R);
}

}  // namespace fca::internal
