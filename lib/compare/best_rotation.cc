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

std::vector<Pair> pairs_of(const Lens& reference, const CameraModel& other, const FieldOfView& field_of_view) {
  constexpr int kSamples = 400;
  std::vector<Pair> pairs;
  for (const Correspondence& sample : fca::sample(reference, field_of_view, kSamples)) {
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

/// From unit rays of the reference to rays of the other.
struct Move {
  Eigen::Matrix3d R;
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();  ///< A translation in units of the points' distance.
};

/// The unknowns of a step: a rotation vector, and with six the shift behind it.
template <int kUnknowns>
using StepOf = Eigen::Matrix<double, kUnknowns, 1>;
constexpr int kOfRotation = 3;
constexpr int kOfTranslation = 6;

template <int kUnknowns>
Move moved(const Move& move, const StepOf<kUnknowns>& step) {
  Move result = {rotation_by(step.template head<3>()) * move.R, move.shift};
  if constexpr (kUnknowns == kOfTranslation) result.shift += step.template tail<3>();
  return result;
}

std::optional<Eigen::Vector2d> error_of(const CameraModel& other, const Pair& pair, const Move& move) {
  const Eigen::Vector3d ray = move.R * pair.reference + move.shift;
  const std::optional<Pixel> pixel = project(other, {ray[0], ray[1], ray[2]});
  if (!pixel) return std::nullopt;
  return Eigen::Vector2d((*pixel)[0], (*pixel)[1]) - pair.pixel;
}

/// The sum of the weighted squares; infinite where a ray has no pixel.
double cost_of(const CameraModel& other, const std::vector<Pair>& pairs, const Move& move) {
  double cost = 0.0;
  for (const Pair& pair : pairs) {
    const std::optional<Eigen::Vector2d> error = error_of(other, pair, move);
    cost += error ? pair.weight * error->squaredNorm() : std::numeric_limits<double>::infinity();
  }
  return cost;
}

/// The step of Gauss and Newton; derivatives are differences.
template <int kUnknowns>
StepOf<kUnknowns> step_from(const CameraModel& other, const std::vector<Pair>& pairs, const Move& move) {
  constexpr double kStep = 1e-6;
  Eigen::Matrix<double, kUnknowns, kUnknowns> normal = Eigen::Matrix<double, kUnknowns, kUnknowns>::Zero();
  StepOf<kUnknowns> right = StepOf<kUnknowns>::Zero();
  for (const Pair& pair : pairs) {
    const std::optional<Eigen::Vector2d> error = error_of(other, pair, move);
    if (!error) continue;
    Eigen::Matrix<double, 2, kUnknowns> derivatives;
    bool all = true;
    for (int unknown = 0; unknown < kUnknowns; ++unknown) {
      const StepOf<kUnknowns> along = kStep * StepOf<kUnknowns>::Unit(unknown);
      const std::optional<Eigen::Vector2d> after = error_of(other, pair, moved<kUnknowns>(move, along));
      const std::optional<Eigen::Vector2d> before = error_of(other, pair, moved<kUnknowns>(move, -along));
      all = all && after && before;
      if (all) derivatives.col(unknown) = (*after - *before) / (2.0 * kStep);
    }
    if (!all) continue;
    normal += pair.weight * derivatives.transpose() * derivatives;
    right -= pair.weight * derivatives.transpose() * *error;
  }
  return normal.ldlt().solve(right);
}

/// Steps that make the cost smaller are taken. Of a translation, which a narrow lens hardly tells from a turn, they may be
/// too long: they are halved.
template <int kUnknowns>
Move polished(const CameraModel& other, std::vector<Pair> pairs, Move move) {
  std::erase_if(pairs, [&](const Pair& pair) { return !error_of(other, pair, move); });
  double cost = cost_of(other, pairs, move);
  constexpr int kSteps = 20;
  constexpr int kTries = kUnknowns == kOfTranslation ? 10 : 1;
  for (int i = 0; i < kSteps; ++i) {
    StepOf<kUnknowns> step = step_from<kUnknowns>(other, pairs, move);
    if (!step.allFinite()) break;
    bool is_better = false;
    for (int attempt = 0; attempt < kTries && !is_better; ++attempt, step *= 0.5) {
      const Move next = moved<kUnknowns>(move, step);
      const double next_cost = cost_of(other, pairs, next);
      is_better = next_cost < cost;
      if (!is_better) continue;
      move = next;
      cost = next_cost;
    }
    if (!is_better) break;
  }
  return move;
}

}  // namespace

std::optional<Transform> best_rotation(const Lens& reference, const CameraModel& other, const FieldOfView& field_of_view,
                                       std::optional<double> distance_m) {
  const std::vector<Pair> pairs = pairs_of(reference, other, field_of_view);
  constexpr std::size_t kFewest = 3;  // two numbers each, for six unknowns
  if (pairs.size() < kFewest) return std::nullopt;
  const Move start = {wahba(pairs)};
  const Move move = distance_m ? polished<kOfTranslation>(other, pairs, start) : polished<kOfRotation>(other, pairs, start);
  if (!move.R.allFinite() || !move.shift.allFinite()) return std::nullopt;
  Transform result = transform_of(move.R);
  for (int i = 0; i < 3 && distance_m; ++i) result(i, 3) = *distance_m * move.shift[i];
  return result;
}

}  // namespace fca::internal
