// SPDX-License-Identifier: BSD-3-Clause
#include "pixel_jacobian.h"

#include "fit_model.h"

#include <algorithm>
#include <cmath>

namespace fca::internal {

std::optional<PixelJacobian> jacobian_of(const CameraModel& model, std::span<const Correspondence> samples) {
  const std::unique_ptr<FitTarget> target = fit_target_of(model);
  const std::size_t count = target->parameters().size();
  ParameterValues values{};
  std::ranges::copy(parameter_values(model), values.begin());
  std::vector<double> roots;
  roots.reserve(samples.size());
  for (const Correspondence& sample : samples) roots.push_back(std::sqrt(sample.weight));
  Eigen::MatrixXd numbers(static_cast<Eigen::Index>(2 * samples.size()), static_cast<Eigen::Index>(count + 1));
  if (!target->compute_jacobian(values.data(), samples, {roots, numbers.data()}) || !numbers.allFinite()) return std::nullopt;
  return PixelJacobian{numbers.leftCols(static_cast<Eigen::Index>(count)), numbers.rightCols<1>()};
}

std::optional<Eigen::VectorXd> residuals_of(const CameraModel& model, std::span<const Correspondence> samples) {
  std::vector<std::array<double, 2>> pixels(samples.size());
  if (!fit_target_of(model)->pixels(parameter_values(model).data(), samples, pixels.data())) return std::nullopt;
  const auto count = static_cast<Eigen::Index>(samples.size());
  Eigen::VectorXd residuals(2 * count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Correspondence& sample = samples[static_cast<std::size_t>(k)];
    const std::array<double, 2>& pixel = pixels[static_cast<std::size_t>(k)];
    residuals[k] = std::sqrt(sample.weight) * (pixel[0] - sample.pixel[0]);
    residuals[count + k] = std::sqrt(sample.weight) * (pixel[1] - sample.pixel[1]);
  }
  return residuals;
}

std::vector<std::size_t> free_parameters(const CameraModel& model, std::span<const std::string> held) {
  const std::unique_ptr<FitTarget> target = fit_target_of(model);
  const std::span<const Parameter> parameters = target->parameters();
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const bool is_zero = parameters[i].group == ParameterGroup::kLens && parameter_values(model)[i] == 0.0;
    const bool is_held = std::ranges::find(held, parameters[i].name) != held.end();
    if (!is_zero && !is_held && !target->held(i)) free.push_back(i);
  }
  return free;
}

}  // namespace fca::internal
