// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/pair_fit.h>

#include "../../rig/eigen_rotation.h"
#include "../evaluation/turned.h"
#include "../fitting/minimise.h"
#include "../fitting/normal_sums.h"
#include "../fitting/pixel_jacobian.h"
#include "../fitting/turned_samples.h"
#include "matches.h"

#include <fca/convert/evaluate.h>
#include <fca/convert/field_of_view.h>
#include <fca/convert/sample.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace fca {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using internal::CameraOfPair;
using internal::Matches;
using internal::PixelJacobian;

/// The weight of a row difference of 1 px in the fit, relative to a pixel error of 1 px in one camera.
constexpr double kWeightOfRows = 3.0;

/// The unknowns of one camera: first the parameters that the fit may change, then rotation angles.
struct Unknowns {
  std::vector<Index> parameters;  ///< The indices of these parameters in the model.
  Index angles = 0;               ///< The number of rotation angles.
  Index first = 0;                ///< The index of the camera's first unknown among those of both cameras.

  [[nodiscard]] Index count() const { return static_cast<Index>(parameters.size()) + angles; }
};

/// A camera during the fit.
struct State {
  CameraModel model;
  Eigen::Vector3d angles = Eigen::Vector3d::Zero();  ///< Rotation vector [rad].

  /// T_target_source: a rotation that takes rays of the source to rays of the fitted camera.
  [[nodiscard]] Transform turn() const { return internal::transform_of(internal::rotation_by(angles)); }
};

/// The fit of both cameras: the pixel errors of each and the row differences between them, as least squares. `turns`: the fit
/// also rotates the cameras.
class Problem {
 public:
  Problem(const std::array<SeparateFit, 2>& fits, const std::array<CameraOfPair, 2>& cameras, const Matches& matches,
          bool turns)
      : fits_(fits), cameras_(cameras), matches_(matches) {
    for (std::size_t i = 0; i < 2; ++i) {
      const Conversion& conversion = fits.at(i).conversion;
      Unknowns& unknowns = unknowns_.at(i);
      unknowns = {internal::free_columns(conversion.camera.model, conversion.report.at_bound, fits.at(i).options.ranges),
                  turns ? internal::angle_count(conversion.camera.model) : 0, i == 0 ? 0 : unknowns_[0].count()};
    }
  }

  /// Minimises the sum of squares, starting at `start`. nullopt if a sample has no pixel in the models of `start`.
  [[nodiscard]] std::optional<std::array<State, 2>> solve(const std::array<State, 2>& start) const {
    std::vector<double> unknowns = unknowns_of(start);
    const internal::Minimum minimum = internal::minimise(
        [&](const double* at, internal::NormalEquations& sums) { return sum_up(states_of(start, at), sums); },
        internal::Effort(), unknowns);
    if (!minimum.usable) return std::nullopt;
    return states_of(start, unknowns.data());
  }

 private:
  [[nodiscard]] Index count() const { return unknowns_[0].count() + unknowns_[1].count(); }

  /// The unknowns of both cameras as one list.
  [[nodiscard]] std::vector<double> unknowns_of(const std::array<State, 2>& states) const {
    std::vector<double> values;
    for (std::size_t i = 0; i < 2; ++i) {
      const std::span<const double> parameters = parameter_values(states.at(i).model);
      for (const Index each : unknowns_.at(i).parameters) values.push_back(parameters[static_cast<std::size_t>(each)]);
      const Eigen::Vector3d& angles = states.at(i).angles;
      values.insert(values.end(), angles.begin(), angles.begin() + unknowns_.at(i).angles);
    }
    return values;
  }

  /// Copies of the states `start` with the unknowns taken from `at`.
  [[nodiscard]] std::array<State, 2> states_of(const std::array<State, 2>& start, const double* at) const {
    std::array<State, 2> states = start;
    for (std::size_t i = 0; i < 2; ++i) {
      const std::span<double> parameters = parameter_values(states.at(i).model);
      for (const Index each : unknowns_.at(i).parameters) parameters[static_cast<std::size_t>(each)] = *at++;
      for (Index axis = 0; axis < unknowns_.at(i).angles; ++axis) states.at(i).angles[axis] = *at++;
    }
    return states;
  }

  /// The residuals of one camera's samples, and their derivatives with respect to this camera's unknowns. nullopt if a sample
  /// has no pixel.
  [[nodiscard]] std::optional<PixelJacobian> derivatives(std::size_t i, const State& state,
                                                         std::span<const Correspondence> samples) const {
    const Unknowns& unknowns = unknowns_.at(i);
    std::optional<PixelJacobian> all =
        internal::jacobian_of(state.model, internal::rotated_samples(samples, internal::rotation_by(state.angles)));
    if (!all) return std::nullopt;
    PixelJacobian own{MatrixXd(all->columns.rows(), unknowns.count()), std::move(all->residuals)};
    own.columns.leftCols(static_cast<Index>(unknowns.parameters.size())) = all->columns(Eigen::all, unknowns.parameters);
    if (!internal::write_angle_derivatives(state.model, samples, state.angles, own.columns.rightCols(unknowns.angles)))
      return std::nullopt;
    return own;
  }

  /// Converts one camera's pixel residuals for the matches, or columns of their Jacobian, to changes of the row differences.
  [[nodiscard]] MatrixXd rows_of(std::size_t i, const Eigen::Ref<const MatrixXd>& numbers) const {
    const auto count = static_cast<Index>(matches_.derivatives.at(i).size());
    MatrixXd rows(count, numbers.cols());
    for (Index k = 0; k < count; ++k) {
      const Eigen::RowVector2d& derivative = matches_.derivatives.at(i)[static_cast<std::size_t>(k)];
      rows.row(k) = derivative[0] * numbers.row(k) + derivative[1] * numbers.row(count + k);
    }
    return rows;
  }

  /// Adds up the normal equations. False if a model is not valid or outside its ranges, or if a ray has no pixel.
  [[nodiscard]] bool sum_up(const std::array<State, 2>& states, internal::NormalEquations& sums) const {
    for (std::size_t i = 0; i < 2; ++i) {
      if (!validate(states.at(i).model).empty() || !within(states.at(i).model, fits_.at(i).options.ranges)) return false;
    }
    internal::NormalSums normal(count());
    MatrixXd rows(static_cast<Index>(matches_.seen[0].size()), count());
    VectorXd differences = VectorXd::Zero(rows.rows());
    for (std::size_t i = 0; i < 2; ++i) {
      const std::optional<PixelJacobian> own = derivatives(i, states.at(i), cameras_.at(i).samples);
      const std::optional<PixelJacobian> matched = derivatives(i, states.at(i), matches_.seen.at(i));
      if (!own || !matched) return false;
      normal.add(own->columns, own->residuals, unknowns_.at(i).first);
      rows.middleCols(unknowns_.at(i).first, unknowns_.at(i).count()) = kWeightOfRows * rows_of(i, matched->columns);
      differences += kWeightOfRows * rows_of(i, matched->residuals);
    }
    normal.add(rows, differences);
    normal.put_into(sums);
    return true;
  }

  const std::array<SeparateFit, 2>& fits_;
  const std::array<CameraOfPair, 2>& cameras_;
  const Matches& matches_;
  std::array<Unknowns, 2> unknowns_;
};

/// A camera of the pair with its field of view, which is limited to the angles up to which its separate fit was scored. nullopt
/// if the camera has no field of view.
std::optional<CameraOfPair> of_pair(const SeparateFit& fit) {
  constexpr int kSamples = 400;
  Diagnostics discarded;
  std::optional<FieldOfView> field_of_view = field_of_view_of(fit.source, fit.options.max_angle_rad, discarded);
  if (!field_of_view) return std::nullopt;
  const double max_angle_rad = fit.conversion.report.scored_to_deg * std::numbers::pi / 180.0;
  field_of_view->max_angle_rad = std::min(field_of_view->max_angle_rad, max_angle_rad);
  CameraOfPair camera{&fit.source, &fit.conversion.camera.model, *field_of_view,
                      sample(fit.source.model, *field_of_view, kSamples)};
  std::erase_if(camera.samples,
                [&camera](const Correspondence& each) { return !(each.weight > 0.0) || !project(*camera.start, each.ray); });
  return camera;
}

/// The error of the pair with these states instead of the separate fits (vertical_disparity.h); nullopt if it cannot be
/// rectified.
std::optional<PairError> error_of(const std::array<SeparateFit, 2>& fits, const std::array<State, 2>& states,
                                  const Transform& T_second_first) {
  const std::optional<Transform> T_source_target = inverse(states[0].turn());
  if (!T_source_target) return std::nullopt;
  // The pose between the cameras that are rotated in the fit.
  const Transform T_turned = states[1].turn() * T_second_first * *T_source_target;
  return pair_error({fits[0].source, states[0].model}, {fits[1].source, states[1].model}, T_second_first, T_turned);
}

/// The separate conversion `fit` with its model replaced by that of `state`, evaluated with the same options. nullopt if the
/// new model covers less of the image.
std::optional<Conversion> conversion_to(const SeparateFit& fit, const State& state) {
  Diagnostics discarded;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(fit.source, fit.options.max_angle_rad, discarded);
  if (!field_of_view) return std::nullopt;
  const Transform T_target_source = state.turn();
  const bool is_turned = !state.angles.isZero();
  Conversion result = fit.conversion;
  ConversionReport& report = result.report;
  const double max_angle_rad = report.scored_to_deg * std::numbers::pi / 180.0;
  ErrorStatistics statistics = is_turned ? internal::evaluate_turned(fit.source.model, state.model, T_target_source,
                                                                     *field_of_view, max_angle_rad, fit.options.every_pixel)
                                         : evaluate(fit.source.model, state.model, *field_of_view,
                                                    {fit.options.every_pixel, fit.options.bound, max_angle_rad});
  if (!internal::covers_as_much(report.statistics, statistics)) return std::nullopt;
  if (is_turned) report.turn = AbsorbedTurn{T_target_source, report.statistics.error.rms, report.statistics.error.max};
  report.statistics = std::move(statistics);
  report.turn_offer.reset();
  result.camera.model = state.model;
  return result;
}

}  // namespace

std::optional<PairFit> fit_pair(const std::array<SeparateFit, 2>& cameras, const Transform& T_second_first, bool may_turn) {
  if (std::ranges::any_of(cameras, [](const SeparateFit& each) { return each.conversion.report.exact; })) return std::nullopt;
  const std::array<State, 2> start = {State{cameras[0].conversion.camera.model}, State{cameras[1].conversion.camera.model}};
  const std::optional<PairError> before = error_of(cameras, start, T_second_first);
  std::optional<CameraOfPair> first = of_pair(cameras[0]);
  std::optional<CameraOfPair> second = of_pair(cameras[1]);
  if (!before || !first || !second) return std::nullopt;
  const std::array<CameraOfPair, 2> pair = {*std::move(first), *std::move(second)};
  const Matches matches = internal::matches_of(pair, T_second_first);
  if (matches.seen[0].empty()) return std::nullopt;

  struct Candidate {
    std::array<State, 2> states;
    PairError error;
  };
  Candidate best{start, *before};
  // A rotation is tried if the error without one is visible, and kept if it makes the error at least 10 % smaller.
  constexpr double kLargestRatioWithTurn = 0.9;
  constexpr double kVisiblePx = 0.02;
  for (const bool turns : {false, true}) {
    if (turns && (!may_turn || best.error.rms_px() < kVisiblePx)) continue;
    const std::optional<std::array<State, 2>> found = Problem(cameras, pair, matches, turns).solve(best.states);
    const std::optional<PairError> error = found ? error_of(cameras, *found, T_second_first) : std::nullopt;
    const double enough = (turns ? kLargestRatioWithTurn : 1.0) * best.error.rms_px();
    if (error && error->rms_px() < enough) best = {*found, *error};
  }
  if (!(best.error.rms_px() < before->rms_px())) return std::nullopt;
  std::optional<Conversion> left = conversion_to(cameras[0], best.states[0]);
  std::optional<Conversion> right = conversion_to(cameras[1], best.states[1]);
  if (!left || !right) return std::nullopt;
  return PairFit{{*std::move(left), *std::move(right)}, *before, best.error};
}

}  // namespace fca
