// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/common_lens.h>

#include "../uncertainty/jacobian.h"

#include <fca/convert/domain.h>
#include <fca/convert/sample.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fca {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using internal::PixelJacobian;

using Samples = std::vector<std::vector<Correspondence>>;

/// Where a parameter of a model stands among those of all: lens parameters first, then each camera's own.
Index place_of(std::span<const Parameter> parameters, std::size_t parameter, std::size_t camera) {
  Index lens = 0;
  Index own = 0;
  Index place = 0;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    Index& count = parameters[i].group == ParameterGroup::kLens ? lens : own;
    if (i == parameter) place = count;
    ++count;
  }
  const bool is_common = parameters[parameter].group == ParameterGroup::kLens;
  return is_common ? place : lens + static_cast<Index>(camera) * own + place;
}

Index number_of_unknowns(std::span<const Parameter> parameters, std::size_t cameras) {
  const auto lens = std::ranges::count(parameters, ParameterGroup::kLens, &Parameter::group);
  const auto own = static_cast<Index>(parameters.size()) - lens;
  return lens + static_cast<Index>(cameras) * own;
}

/// Normal equations of all cameras; nothing where a ray has no pixel.
struct Normal {
  MatrixXd matrix;
  VectorXd right;
  double cost = 0.0;
};

std::optional<Normal> normal_equations(std::span<const CameraModel> models, const Samples& samples) {
  const std::span<const Parameter> parameters = model_info(models.front()).parameters;
  const Index count = number_of_unknowns(parameters, models.size());
  Normal sums{MatrixXd::Zero(count, count), VectorXd::Zero(count), 0.0};
  for (std::size_t camera = 0; camera < models.size(); ++camera) {
    const std::optional<PixelJacobian> jacobian = internal::jacobian_of(models[camera], samples[camera]);
    if (!jacobian) return std::nullopt;
    MatrixXd columns = MatrixXd::Zero(jacobian->columns.rows(), count);
    for (std::size_t i = 0; i < parameters.size(); ++i)
      columns.col(place_of(parameters, i, camera)) = jacobian->columns.col(static_cast<Index>(i));
    sums.matrix += columns.transpose() * columns;
    sums.right -= columns.transpose() * jacobian->residuals;
    sums.cost += jacobian->residuals.squaredNorm();
  }
  return sums;
}

std::vector<CameraModel> moved(std::span<const CameraModel> models, const VectorXd& step) {
  const std::span<const Parameter> parameters = model_info(models.front()).parameters;
  std::vector<CameraModel> result(models.begin(), models.end());
  for (std::size_t camera = 0; camera < result.size(); ++camera) {
    const std::span<double> values = parameter_values(result[camera]);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += step[place_of(parameters, i, camera)];
  }
  return result;
}

bool are_cameras(std::span<const CameraModel> models) {
  return std::ranges::all_of(models, [](const CameraModel& model) { return validate(model).empty(); });
}

/// Levenberg-Marquardt from models that share their lens parameters. Nothing where they do not reach all samples.
struct Found {
  std::vector<CameraModel> models;
  double cost = std::numeric_limits<double>::infinity();
};
std::optional<Found> minimised(std::vector<CameraModel> models, const Samples& samples) {
  constexpr int kMostSteps = 100;
  constexpr double kSmallest = 1e-12;
  constexpr double kMostDamped = 1e12;
  std::optional<Normal> sums = normal_equations(models, samples);
  if (!sums || !are_cameras(models)) return std::nullopt;
  double damping = 1e-4;
  for (int i = 0; i < kMostSteps && damping < kMostDamped; ++i) {
    MatrixXd damped = sums->matrix;
    damped.diagonal() *= 1.0 + damping;
    std::vector<CameraModel> next = moved(models, damped.ldlt().solve(sums->right));
    std::optional<Normal> there = are_cameras(next) ? normal_equations(next, samples) : std::nullopt;
    if (!there || !(there->cost < sums->cost)) {
      damping *= 10.0;
      continue;
    }
    const bool is_done = sums->cost - there->cost <= kSmallest * sums->cost;
    models = std::move(next);
    sums = std::move(there);
    damping *= 0.1;
    if (is_done) break;
  }
  return Found{std::move(models), sums->cost};
}

}  // namespace

std::vector<CameraModel> with_lens_of_first(std::span<const CameraModel> models) {
  std::vector<CameraModel> result(models.begin(), models.end());
  for (CameraModel& model : result) {
    const std::span<const Parameter> parameters = model_info(model).parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (parameters[i].group == ParameterGroup::kLens) parameter_values(model)[i] = parameter_values(models.front())[i];
    }
  }
  return result;
}

std::optional<std::vector<CameraModel>> fit_common_lens(std::span<const Camera> sources, std::span<const CameraModel> start,
                                                        std::optional<double> max_angle_rad, Diagnostics& diagnostics) {
  Samples samples;
  for (const Camera& source : sources) {
    const std::optional<Domain> domain = domain_of(source, max_angle_rad, diagnostics);
    if (!domain) return std::nullopt;
    constexpr int kSamples = 800;
    samples.push_back(sample(source.model, *domain, kSamples));
  }
  // From each camera's lens.
  std::optional<Found> best;
  for (std::size_t i = 0; i < start.size(); ++i) {
    std::vector<CameraModel> models(start.begin(), start.end());
    std::swap(models.front(), models[i]);
    models = with_lens_of_first(models);
    std::swap(models.front(), models[i]);
    std::optional<Found> found = minimised(std::move(models), samples);
    if (found && (!best || found->cost < best->cost)) best = std::move(found);
  }
  return best ? std::optional(std::move(best->models)) : std::nullopt;
}

}  // namespace fca
