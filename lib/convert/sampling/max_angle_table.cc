// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/max_angle_table.h>

#include "../evaluation/stages.h"
#include "../fitting/fit_model.h"

#include <fca/convert/field_of_view.h>

#include <numbers>

namespace fca {

namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
constexpr double kFirstDeg = 90.0;   ///< The angle of the first row.
constexpr double kStepDeg = 5.0;     ///< The difference between the angles of two rows.
constexpr double kSameAngle = 1e-9;  // rad; angles that differ by less are equal

/// The camera's field of view if it reaches further than 90 degrees from the axis and neither the options nor a lens circle
/// limit it. Otherwise nullopt: there is no table.
std::optional<FieldOfView> wide_field_of_view(const Camera& camera, const ConvertOptions& options, Diagnostics& diagnostics) {
  if (options.max_angle_rad || camera.lens_circle) return std::nullopt;
  std::optional<FieldOfView> field_of_view = field_of_view_of(camera, std::nullopt, diagnostics);
  if (!field_of_view || field_of_view->max_angle_rad <= kFirstDeg * kRadiansPerDegree) return std::nullopt;
  return field_of_view;
}

/// The row of a conversion up to this angle.
MaxAngleRow row_of(double angle_rad, const ConversionReport& report) {
  const ErrorStatistics& statistics = report.statistics;
  return {angle_rad / kRadiansPerDegree,       report.scored_to_deg, statistics.coverage.scored,
          statistics.coverage.unrepresentable, statistics.error.rms, statistics.error.max};
}

/// The row of a new conversion up to this angle; nullopt if the conversion fails.
std::optional<MaxAngleRow> fitted_row(const Camera& camera, ConvertOptions options, double angle_rad) {
  options.max_angle_rad = angle_rad;
  options.max_angle_table = false;
  options.bound = false;
  options.every_pixel = false;
  Diagnostics discarded;
  const std::optional<Conversion> conversion = convert(camera, options, discarded);
  if (!conversion) return std::nullopt;
  return row_of(angle_rad, conversion->report);
}

/// The row for `angle_rad` if the fit of `report` ends at a smaller angle, so that the fit would be the same. Only the share of
/// the image that the fit does not describe depends on the angle and is computed again.
MaxAngleRow row_of_same_fit(const Camera& camera, FieldOfView field_of_view, double angle_rad, const ConversionReport& report) {
  field_of_view.max_angle_rad = angle_rad;
  const internal::Scorer same_camera(camera.model, &camera.model, nullptr, field_of_view, std::numbers::pi);
  MaxAngleRow row = row_of(angle_rad, report);
  row.unrepresentable = internal::score_on_lattice(same_camera).statistics.coverage.scored - row.scored;
  return row;
}

/// The rows of the table. `whole`: the report of the conversion on the whole field of view, whose fit some rows share; null if
/// that conversion failed.
std::vector<MaxAngleRow> rows(const Camera& camera, const ConvertOptions& options, const FieldOfView& field_of_view,
                              const ConversionReport* whole) {
  // A perspective model is fitted up to less than 90 degrees from the axis, and any other model up to the largest angle that it
  // describes. If that angle is smaller than angle_rad, a fit up to angle_rad is the same.
  const auto is_same_fit = [&](double angle_rad) {
    if (whole == nullptr || whole->exact) return false;
    if (internal::is_perspective(whole->to_model)) return true;
    return whole->angle_reduced && angle_rad > whole->scored_to_deg * kRadiansPerDegree + kSameAngle;
  };
  std::vector<MaxAngleRow> table;
  for (int i = 0; (kFirstDeg + i * kStepDeg) * kRadiansPerDegree < field_of_view.max_angle_rad; ++i) {
    const double angle_rad = (kFirstDeg + i * kStepDeg) * kRadiansPerDegree;
    if (is_same_fit(angle_rad)) {
      table.push_back(row_of_same_fit(camera, field_of_view, angle_rad, *whole));
    } else if (const std::optional<MaxAngleRow> row = fitted_row(camera, options, angle_rad)) {
      table.push_back(*row);
    }
  }
  if (whole != nullptr) table.push_back(row_of(field_of_view.max_angle_rad, *whole));
  return table;
}

}  // namespace

bool is_perspective(std::string_view model_id) { return internal::is_perspective(model_id); }

std::vector<MaxAngleRow> max_angle_table(const Camera& camera, const ConvertOptions& options, Diagnostics& diagnostics) {
  const std::optional<FieldOfView> field_of_view = wide_field_of_view(camera, options, diagnostics);
  if (!field_of_view) return {};
  ConvertOptions for_whole = options;
  for_whole.max_angle_table = false;
  for_whole.bound = false;
  for_whole.every_pixel = false;
  Diagnostics discarded;
  const std::optional<Conversion> whole = convert(camera, for_whole, discarded);
  return rows(camera, options, *field_of_view, whole ? &whole->report : nullptr);
}

std::vector<MaxAngleRow> max_angle_table(const Camera& camera, const ConvertOptions& options, const ConversionReport& report,
                                         Diagnostics& diagnostics) {
  // The whole field of view was scored and reaches at most 90 degrees from the axis: there is no table.
  if (report.statistics.coverage.unrepresentable == 0.0 && report.scored_to_deg <= kFirstDeg) return {};
  const std::optional<FieldOfView> field_of_view = wide_field_of_view(camera, options, diagnostics);
  return field_of_view ? rows(camera, options, *field_of_view, &report) : std::vector<MaxAngleRow>();
}

}  // namespace fca
