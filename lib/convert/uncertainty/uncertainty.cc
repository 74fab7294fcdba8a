// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/uncertainty.h>

#include "../fitting/pixel_jacobian.h"
#include "sigma.h"

#include "../evaluation/lattice.h"

#include <fca/convert/sample.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace fca {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using internal::ParameterJacobian;
using internal::PixelJacobian;

/// True if the uncertainty is that of a camera of this model.
bool belongs_to(const Uncertainty& uncertainty, const CameraModel& model) {
  return uncertainty.model == model_info(model).id && uncertainty.sigmas.size() == parameter_values(model).size();
}

/// The standard deviation of a pixel [px]; without a covariance, its upper bound.
double sigma_at(const ParameterJacobian& jacobian, const Uncertainty& uncertainty) {
  if (uncertainty.has_covariance()) return internal::sigma_of_pixel(jacobian, internal::covariance_of(uncertainty));
  const std::vector<double>& sigmas = uncertainty.sigmas;
  return internal::sigma_bound_of_pixel(jacobian,
                                        Eigen::Map<const Eigen::VectorXd>(sigmas.data(), static_cast<Index>(sigmas.size())));
}

/// The columns of `all` with the indices `which`, in that order.
MatrixXd columns_of(const MatrixXd& all, std::span<const std::size_t> which) {
  MatrixXd some(all.rows(), static_cast<Index>(which.size()));
  for (std::size_t i = 0; i < which.size(); ++i) some.col(static_cast<Index>(i)) = all.col(static_cast<Index>(which[i]));
  return some;
}

/// The uncertainty of all parameters of `model`. `of_free`: the covariance of the parameters with the indices `free`. The
/// others are exactly known: their variances are 0.
Uncertainty with_held(const MatrixXd& of_free, std::span<const std::size_t> free, const CameraModel& model) {
  const auto count = static_cast<Index>(parameter_values(model).size());
  MatrixXd all = MatrixXd::Zero(count, count);
  for (std::size_t i = 0; i < free.size(); ++i) {
    for (std::size_t j = 0; j < free.size(); ++j)
      all(static_cast<Index>(free[i]), static_cast<Index>(free[j])) = of_free(static_cast<Index>(i), static_cast<Index>(j));
  }
  Uncertainty result;
  result.model = model_info(model).id;
  internal::set_covariance(all, result);
  return result;
}

/// A scored point of the image.
struct Place {
  Pixel pixel{};
  Ray ray{};
  double weight = 0.0;
  double error_px = 0.0;  ///< The error of the conversion; 0 if it is not known or the conversion is exact.
};

/// A sum of weighted squares, whose root() is the weighted rms.
struct MeanSquare {
  double squares = 0.0;
  double weights = 0.0;
  void add(double value, double weight) {
    squares += weight * value * value;
    weights += weight;
  }
  [[nodiscard]] double root() const { return weights > 0.0 ? std::sqrt(squares / weights) : 0.0; }
};

/// Summarises the uncertainty over the places. nullopt if there are no places, if the uncertainty is not that of `model`, or if
/// a place has no Jacobian.
std::optional<PixelUncertainty> summary_of(const CameraModel& model, const Uncertainty& uncertainty,
                                           std::span<const Place> places, std::span<const ErrorBand> bands) {
  if (places.empty() || !belongs_to(uncertainty, model)) return std::nullopt;
  std::vector<Correspondence> samples;
  samples.reserve(places.size());
  for (const Place& place : places) samples.push_back({place.ray, place.pixel, 1.0});
  const std::optional<PixelJacobian> jacobian = internal::jacobian_of(model, samples);
  if (!jacobian) return std::nullopt;
  PixelUncertainty result;
  result.is_limit = !uncertainty.has_covariance();
  result.source = uncertainty.where.file;
  MeanSquare all;
  std::vector<MeanSquare> in_band(bands.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Place& place = places[i];
    const double sigma = sigma_at(jacobian->of(static_cast<Index>(i)), uncertainty);
    all.add(sigma, place.weight);
    const double angle = angle_from_axis(place.ray) * 180.0 / std::numbers::pi;
    for (std::size_t band = 0; band < bands.size(); ++band) {
      if (angle >= bands[band].from_deg && angle <= bands[band].to_deg) in_band[band].add(sigma, place.weight);
    }
    if (place.error_px > 0.0) result.most_sigmas = std::max(result.most_sigmas, place.error_px / sigma);
    if (!(sigma > result.max_px)) continue;
    result.max_px = sigma;
    result.max_at = place.pixel;
  }
  result.rms_px = all.root();
  for (const MeanSquare& band : in_band) result.bands_px.push_back(band.root());
  return result;
}

/// The scored points of the lattice on which a conversion is evaluated, including points on the image's border.
std::vector<Place> lattice_of(const Camera& source, const CameraModel& target, const ConversionReport& report,
                              const FieldOfView& field_of_view) {
  const double max_angle_rad = report.angle_reduced ? report.scored_to_deg * std::numbers::pi / 180.0 : std::numbers::pi;
  const internal::Scorer scorer(source.model, &target, nullptr, field_of_view, max_angle_rad);
  std::vector<Place> places;
  for (const internal::Point& point : internal::score_lattice(scorer)) {
    const std::optional<Ray> ray = field_of_view.ray(source.model, point.pixel);
    if (point.verdict == internal::Verdict::kScored && ray)
      places.push_back({point.pixel, *ray, point.weight, report.exact ? 0.0 : point.error});
  }
  return places;
}

/// The entries of a table of rays, without errors.
std::vector<Place> places_of(std::span<const Correspondence> table) {
  std::vector<Place> places;
  places.reserve(table.size());
  for (const Correspondence& entry : table) places.push_back({entry.pixel, entry.ray, entry.weight, 0.0});
  return places;
}

/// The entries of the source's table to which the model was fitted: those in the image and inside the scored angle for which
/// the model has a pixel.
std::vector<Correspondence> fitted_entries(const Camera& source, const CameraModel& target, const ConversionReport& report) {
  constexpr double kRounding = 1e-9;  // rad
  const double max_angle_rad = report.scored_to_deg * std::numbers::pi / 180.0 + kRounding;
  std::vector<Correspondence> table;
  std::ranges::copy_if(source.rays, std::back_inserter(table), [&](const Correspondence& entry) {
    const bool is_in_image = !source.image_size || (entry.pixel[0] >= -0.5 && entry.pixel[1] >= -0.5 &&
                                                    entry.pixel[0] <= source.image_size->width - 0.5 &&
                                                    entry.pixel[1] <= source.image_size->height - 0.5);
    return is_in_image && angle_from_axis(entry.ray) <= max_angle_rad && project(target, entry.ray);
  });
  return table;
}

/// The uncertainty of a model that was fitted to a table of rays, from the residuals of the fit; nullopt if it is not known.
std::optional<PixelUncertainty> uncertainty_of_table(const Camera& source, const CameraModel& target,
                                                     const ConversionReport& report) {
  const std::vector<Correspondence> table = fitted_entries(source, target, report);
  const std::optional<Uncertainty> fitted = uncertainty_of_residuals(target, table, report.at_bound);
  if (!fitted) return std::nullopt;
  std::optional<PixelUncertainty> result = summary_of(target, *fitted, places_of(table), report.statistics.bands);
  if (!result) return std::nullopt;
  result->of_residuals = true;
  result->sigmas = fitted->sigmas;
  result->covariance = fitted->covariance;
  return result;
}

}  // namespace

std::optional<double> pixel_sigma(const CameraModel& model, const Uncertainty& uncertainty, const Ray& ray) {
  const std::optional<Pixel> pixel = project(model, ray);
  if (!pixel || !belongs_to(uncertainty, model)) return std::nullopt;
  const double length = std::hypot(ray[0], ray[1], ray[2]);
  const Correspondence sample{{ray[0] / length, ray[1] / length, ray[2] / length}, *pixel, 1.0};
  const std::optional<PixelJacobian> jacobian = internal::jacobian_of(model, std::span(&sample, 1));
  return jacobian ? std::optional(sigma_at(jacobian->of(0), uncertainty)) : std::nullopt;
}

std::optional<Uncertainty> uncertainty_of_fit(const CameraModel& source, const Uncertainty& uncertainty,
                                              const CameraModel& target, std::span<const std::string> held,
                                              const FieldOfView& field_of_view) {
  if (!uncertainty.has_covariance() || !belongs_to(uncertainty, source)) return std::nullopt;
  std::vector<Correspondence> samples = sample(source, field_of_view);
  std::erase_if(samples, [&target](const Correspondence& each) { return !project(target, each.ray); });
  const std::optional<PixelJacobian> of_source = internal::jacobian_of(source, samples);
  const std::optional<PixelJacobian> of_target = internal::jacobian_of(target, samples);
  const std::vector<std::size_t> free = internal::free_parameters(target, held);
  if (!of_source || !of_target || 2 * samples.size() < free.size()) return std::nullopt;
  const MatrixXd columns = columns_of(of_target->columns, free);
  // The derivatives of the target's free parameters with respect to the source's parameters (M in README.md).
  const MatrixXd derivative = columns.completeOrthogonalDecomposition().solve(of_source->columns);
  return with_held(derivative * internal::covariance_of(uncertainty) * derivative.transpose(), free, target);
}

std::optional<Uncertainty> uncertainty_of_residuals(const CameraModel& fitted, std::span<const Correspondence> table,
                                                    std::span<const std::string> held) {
  const auto differs = [&table](const Correspondence& entry) { return entry.weight != table.front().weight; };
  const std::vector<std::size_t> free = internal::free_parameters(fitted, held);
  if (2 * table.size() <= free.size() || std::ranges::any_of(table, differs)) return std::nullopt;
  std::vector<Correspondence> entries(table.begin(), table.end());
  for (Correspondence& entry : entries) entry.weight = 1.0;
  const std::optional<PixelJacobian> jacobian = internal::jacobian_of(fitted, entries);
  if (!jacobian) return std::nullopt;
  const Eigen::ColPivHouseholderQR<MatrixXd> factors(columns_of(jacobian->columns, free));
  if (factors.rank() < static_cast<Index>(free.size())) return std::nullopt;
  const auto degrees_of_freedom = static_cast<double>(2 * entries.size() - free.size());
  const double variance = jacobian->residuals.squaredNorm() / degrees_of_freedom;
  // With the pivoted factorisation J P = Q R, (J'J)^-1 is P (R'R)^-1 P'.
  const auto count = static_cast<Index>(free.size());
  const MatrixXd R = factors.matrixR().topLeftCorner(count, count).triangularView<Eigen::Upper>();
  const MatrixXd inverse = factors.colsPermutation() * R.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(count, count));
  return with_held(variance * (inverse * inverse.transpose()), free, fitted);
}

std::optional<PixelUncertainty> pixel_uncertainty(const Camera& source, const Camera& target, const ConversionReport& report,
                                                  const Uncertainty* stated, std::optional<double> max_angle_rad) {
  if (!target.rays.empty()) return std::nullopt;
  if (!source.rays.empty()) return uncertainty_of_table(source, target.model, report);
  if (stated == nullptr) return std::nullopt;
  Diagnostics reported_before;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(source, max_angle_rad, reported_before);
  if (!field_of_view) return std::nullopt;
  std::optional<PixelUncertainty> result =
      summary_of(source.model, *stated, lattice_of(source, target.model, report, *field_of_view), report.statistics.bands);
  if (!result || result->is_limit || source.model == target.model) return result;
  FieldOfView scored = *field_of_view;
  scored.max_angle_rad = std::min(scored.max_angle_rad, report.scored_to_deg * std::numbers::pi / 180.0);
  if (const auto fitted = uncertainty_of_fit(source.model, *stated, target.model, report.at_bound, scored)) {
    result->sigmas = fitted->sigmas;
    result->covariance = fitted->covariance;
  }
  return result;
}

double least_variance(const Uncertainty& uncertainty) {
  if (!uncertainty.has_covariance()) return 0.0;
  MatrixXd correlations = internal::covariance_of(uncertainty);
  for (Index i = 0; i < correlations.rows(); ++i) {
    const double sigma = uncertainty.sigmas[static_cast<std::size_t>(i)];
    const double unit = sigma > 0.0 ? sigma : 1.0;
    correlations.row(i) /= unit;
    correlations.col(i) /= unit;
  }
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(correlations, Eigen::EigenvaluesOnly).eigenvalues().minCoeff();
}

Uncertainty with_pixels(const Uncertainty& uncertainty, const CameraModel& model, const PixelMap& map) {
  Uncertainty result = uncertainty;
  result.values.clear();
  if (!belongs_to(uncertainty, model)) return result;
  // The parameters of the mapped model are affine functions of each parameter of the model: difference quotients are exact.
  const auto count = static_cast<Index>(uncertainty.sigmas.size());
  const auto mapped = [&map](const CameraModel& each) {
    const CameraModel changed = with_pixels(each, map);
    const std::span<const double> values = parameter_values(changed);
    return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Index>(values.size())));
  };
  MatrixXd derivative(count, count);
  for (Index i = 0; i < count; ++i) {
    CameraModel other = model;
    double& value = parameter_values(other)[static_cast<std::size_t>(i)];
    const double step = std::max(1.0, std::abs(value));
    value += step;
    derivative.col(i) = (mapped(other) - mapped(model)) / step;
  }
  if (uncertainty.has_covariance()) {
    internal::set_covariance(derivative * internal::covariance_of(uncertainty) * derivative.transpose(), result);
    return result;
  }
  const Eigen::Map<const Eigen::VectorXd> sigmas(uncertainty.sigmas.data(), count);
  Eigen::Map<Eigen::VectorXd>(result.sigmas.data(), count) = derivative.cwiseAbs() * sigmas;
  return result;
}

}  // namespace fca
