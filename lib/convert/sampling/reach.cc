// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/reach.h>

#include "../evaluation/stages.h"
#include "../fitting/fit_model.h"

#include <fca/convert/domain.h>

#include <numbers>

namespace fca {

namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
constexpr double kFirstDeg = 90.0;
constexpr double kStepDeg = 5.0;
constexpr double kHair = 1e-9;  // rad; angles that differ by less are equal

/// The camera's domain if it ends beyond 90 degrees and neither the options nor a lens circle limit it; otherwise nullopt:
/// there is no smaller angle to try.
std::optional<Domain> wide_domain(const Camera& camera, const ConvertOptions& options, Diagnostics& diagnostics) {
  if (options.max_angle_rad || camera.lens_circle) return std::nullopt;
  std::optional<Domain> domain = domain_of(camera, std::nullopt, diagnostics);
  if (!domain || domain->max_angle_rad <= kFirstDeg * kRadiansPerDegree) return std::nullopt;
  return domain;
}

ReachRow row_of(double angle_rad, const ConversionReport& report) {
  const ErrorStatistics& statistics = report.statistics;
  return {angle_rad / kRadiansPerDegree,       report.scored_to_deg, statistics.coverage.scored,
          statistics.coverage.unrepresentable, statistics.error.rms, statistics.error.max};
}

std::optional<ReachRow> fitted_row(const Camera& camera, ConvertOptions options, double angle_rad) {
  options.max_angle_rad = angle_rad;
  options.reach = false;
  options.bound = false;
  options.every_pixel = false;
  Diagnostics discarded;
  const std::optional<Conversion> conversion = convert(camera, options, discarded);
  if (!conversion) return std::nullopt;
  return row_of(angle_rad, conversion->report);
}

/// The row for `angle_rad`, if the fit to a cone that ends before that angle would be the same. Only the share of the lens that
/// it cannot describe grows with the angle and is measured again.
ReachRow row_beyond(const Camera& camera, Domain domain, double angle_rad, const ConversionReport& report) {
  domain.max_angle_rad = angle_rad;
  const internal::Scorer lens(camera.model, &camera.model, nullptr, domain, std::numbers::pi);
  ReachRow row = row_of(angle_rad, report);
  row.unrepresentable = internal::score_on_lattice(lens).statistics.coverage.scored - row.scored;
  return row;
}

/// The rows of the table. `whole`: the report on the whole lens, whose fit some rows share; null if that conversion failed.
std::vector<ReachRow> rows(const Camera& camera, const ConvertOptions& options, const Domain& domain,
                           const ConversionReport* whole) {
  // A pinhole-like model is fitted to a cone inside 90 degrees, and any other to the largest cone that it describes. If that
  // cone ends before the angle, the fit does not depend on the angle, and need not be made again.
  const auto is_same_fit = [&](double angle_rad) {
    if (whole == nullptr || whole->exact) return false;
    if (internal::sees_ahead_only(whole->to_model)) return true;
    return whole->fitted_to_cone && angle_rad > whole->scored_to_deg * kRadiansPerDegree + kHair;
  };
  std::vector<ReachRow> table;
  for (int i = 0; (kFirstDeg + i * kStepDeg) * kRadiansPerDegree < domain.max_angle_rad; ++i) {
    const double angle_rad = (kFirstDeg + i * kStepDeg) * kRadiansPerDegree;
    if (is_same_fit(angle_rad)) {
      table.push_back(row_beyond(camera, domain, angle_rad, *whole));
    } else if (const std::optional<ReachRow> row = fitted_row(camera, options, angle_rad)) {
      table.push_back(*row);
    }
  }
  if (whole != nullptr) table.push_back(row_of(domain.max_angle_rad, *whole));
  return table;
}

}  // namespace

bool sees_ahead_only(std::string_view model_id) { return internal::sees_ahead_only(model_id); }

std::vector<ReachRow> reach_table(const Camera& camera, const ConvertOptions& options, Diagnostics& diagnostics) {
  const std::optional<Domain> domain = wide_domain(camera, options, diagnostics);
  if (!domain) return {};
  ConvertOptions for_whole = options;
  for_whole.reach = false;
  for_whole.bound = false;
  for_whole.every_pixel = false;
  Diagnostics discarded;
  const std::optional<Conversion> whole = convert(camera, for_whole, discarded);
  return rows(camera, options, *domain, whole ? &whole->report : nullptr);
}

std::vector<ReachRow> reach_table(const Camera& camera, const ConvertOptions& options, const ConversionReport& report,
                                  Diagnostics& diagnostics) {
  // The whole lens was scored, and it ends within 90 degrees: there is no smaller angle to try.
  if (report.statistics.coverage.unrepresentable == 0.0 && report.scored_to_deg <= kFirstDeg) return {};
  const std::optional<Domain> domain = wide_domain(camera, options, diagnostics);
  return domain ? rows(camera, options, *domain, &report) : std::vector<ReachRow>();
}

}  // namespace fca
