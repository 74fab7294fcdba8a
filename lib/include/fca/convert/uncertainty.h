// SPDX-License-Identifier: BSD-3-Clause
// The calibration's own uncertainty carried to pixels and to a fitted model: lib/convert/uncertainty/README.md derives it.
// First order: right for standard deviations that move pixels by little.
#pragma once

#include <fca/convert/field_of_view.h>
#include <fca/convert/report.h>
#include <fca/rig/image_change.h>
#include <fca/rig/uncertainty.h>

#include <optional>
#include <span>

namespace fca {

/// One standard deviation, in pixels, of the pixel of a ray along the direction in which it is largest. Without a covariance
/// the largest that any correlations of the parameters allow. Nothing where the ray has no pixel, or `uncertainty` is not that
/// of a model such as `model`.
[[nodiscard]] std::optional<double> pixel_sigma(const CameraModel& model, const Uncertainty& uncertainty, const Ray& ray);

/// The covariance of the parameters of `target`, which was fitted to `source` over the field of view: how they follow from the
/// source's, to first order. `held` names parameters of the target that stay, as do those that are 0 and what a fit never
/// moves. Nothing without a covariance of the source.
[[nodiscard]] std::optional<Uncertainty> uncertainty_of_fit(const CameraModel& source, const Uncertainty& uncertainty,
                                                            const CameraModel& target, std::span<const std::string> held,
                                                            const FieldOfView& field_of_view);

/// The covariance of the parameters of a model that was fitted to measured rays, from the residuals: sigma^2 (J'J)^-1, where
/// sigma^2 is the sum of squares over the degrees of freedom. Right for independent errors of equal size in u and v; a model
/// that does not describe the lens leaves residuals that are neither. Nothing where the entries' weights differ (they are then
/// areas, no measurements) or do not determine the parameters.
[[nodiscard]] std::optional<Uncertainty> uncertainty_of_residuals(const CameraModel& fitted,
                                                                  std::span<const Correspondence> table,
                                                                  std::span<const std::string> held);

/// What a conversion's report says besides its error. `stated`: null where nothing specifies the source's uncertainty; that of
/// a table of rays is computed. `max_angle_rad` as in ConvertOptions.
[[nodiscard]] std::optional<PixelUncertainty> pixel_uncertainty(const Camera& source, const Camera& target,
                                                                const ConversionReport& report, const Uncertainty* stated,
                                                                std::optional<double> max_angle_rad);

/// The least variance of any combination of parameters, each in units of its standard deviation; below 0 a matrix is no
/// covariance. 0 without one.
[[nodiscard]] double least_variance(const Uncertainty& uncertainty);

/// That of the camera of changed images, `model` being that of the images as they were (with_pixels()).
[[nodiscard]] Uncertainty with_pixels(const Uncertainty& uncertainty, const CameraModel& model, const PixelMap& map);

}  // namespace fca
