// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/common_lens.h>

#include "../fitting/minimise.h"
#include "../fitting/normal_sums.h"
#include "../fitting/pixel_jacobian.h"
#include "../sampling/weights.h"

#include <fca/convert/field_of_view.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fca {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using internal::PixelJacobian;

/// The samples of each camera.
using Samples = std::vector<std::vector<Correspondence>>;

/// The index, among the unknowns of the fit, of a parameter of a camera. The unknowns are the lens parameters, which all
/// cameras share, followed by the other parameters of each camera.
Index unknown_of(std::span<const Parameter> parameters, std::size_t parameter, std::size_t camera) {
  Index lens = 0;
  Index own = 0;
  Index in_group = 0;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    Index& count = parameters[i].group == ParameterGroup::kLens ? lens : own;
    if (i == parameter) in_group = count;
    ++count;
  }
  const bool is_common = parameters[parameter].group == ParameterGroup::kLens;
  return is_common ? in_group : lens + static_cast<Index>(camera) * own + in_group;
}

/// The number of unknowns of the fit: the lens parameters once, the others once for each camera.
Index number_of_unknowns(std::span<const Parameter> parameters, std::size_t cameras) {
  const auto lens = std::ranges::count(parameters, ParameterGroup::kLens, &Parameter::group);
  const auto own = static_cast<Index>(parameters.size()) - lens;
  return lens + static_cast<Index>(cameras) * own;
}

/// Copies of the models `start` whose parameters are taken from `unknowns`.
std::vector<CameraModel> models_of(std::span<const CameraModel> start, const double* unknowns) {
  const std::span<const Parameter> parameters = model_info(start.front()).parameters;
  std::vector<CameraModel> models(start.begin(), start.end());
  for (std::size_t camera = 0; camera < models.size(); ++camera) {
    const std::span<double> values = parameter_values(models[camera]);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = unknowns[unknown_of(parameters, i, camera)];
  }
  return models;
}

/// The unknowns of models that already share their lens parameters.
std::vector<double> unknowns_of(std::span<const CameraModel> models) {
  const std::span<const Parameter> parameters = model_info(models.front()).parameters;
  std::vector<double> unknowns(static_cast<std::size_t>(number_of_unknowns(parameters, models.size())));
  for (std::size_t camera = 0; camera < models.size(); ++camera) {
    const std::span<const double> values = parameter_values(models[camera]);
    for (std::size_t i = 0; i < values.size(); ++i)
      unknowns[static_cast<std::size_t>(unknown_of(parameters, i, camera))] = values[i];
  }
  return unknowns;
}

/// Adds up the normal equations of all cameras. False if a model is not valid or a ray has no pixel.
bool sum_up(std::span<const CameraModel> models, const Samples& samples, internal::NormalEquations& sums) {
  const std::span<const Parameter> parameters = model_info(models.front()).parameters;
  const Index count = number_of_unknowns(parameters, models.size());
  internal::NormalSums normal(count);
  for (std::size_t camera = 0; camera < models.size(); ++camera) {
    if (!validate(models[camera]).empty()) return false;
    const std::optional<PixelJacobian> jacobian = internal::jacobian_of(models[camera], samples[camera]);
    if (!jacobian) return false;
    MatrixXd columns = MatrixXd::Zero(jacobian->columns.rows(), count);
    for (std::size_t i = 0; i < parameters.size(); ++i)
      columns.col(unknown_of(parameters, i, camera)) = jacobian->columns.col(static_cast<Index>(i));
    normal.add(columns, jacobian->residuals);
  }
  normal.put_into(sums);
  return true;
}

/// The result of one fit.
struct Found {
  std::vector<CameraModel> models;
  double cost = std::numeric_limits<double>::infinity();
};

/// Fits all cameras, from models that already share their lens parameters. nullopt if a sample has no pixel in these models.
std::optional<Found> minimised(std::span<const CameraModel> start, const Samples& samples) {
  std::vector<double> unknowns = unknowns_of(start);
  const internal::Minimum minimum = internal::minimise(
      [&](const double* at, internal::NormalEquations& sums) { return sum_up(models_of(start, at), samples, sums); },
      internal::Effort(), unknowns);
  if (!minimum.usable) return std::nullopt;
  return Found{models_of(start, unknowns.data()), minimum.cost};
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
                                                        std::optional<double> max_angle_rad, Diagnostics& diagnostics,
                                                        const FitWeight& weight) {
  Samples samples;
  const FitWeight counted = internal::has_equal_weights(weight) ? FitWeight() : weight;
  for (const Camera& source : sources) {
    const std::optional<FieldOfView> field_of_view = field_of_view_of(source, max_angle_rad, diagnostics);
    if (!field_of_view) return std::nullopt;
    constexpr int kSamples = 800;
    samples.push_back(internal::weighted_samples(counted, source.model, *field_of_view, kSamples).samples);
  }
  // One fit starts from each camera's lens parameters.
  std::optional<Found> best;
  for (std::size_t i = 0; i < start.size(); ++i) {
    std::vector<CameraModel> models(start.begin(), start.end());
    std::swap(models.front(), models[i]);
    models = with_lens_of_first(models);
    std::swap(models.front(), models[i]);
    std::optional<Found> found = minimised(models, samples);
    if (found && (!best || found->cost < best->cost)) best = std::move(found);
  }
  return best ? std::optional(std::move(best->models)) : std::nullopt;
}

}  // namespace fca
