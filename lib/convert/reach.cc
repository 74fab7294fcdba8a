// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/reach.h>

#include <fca/convert/domain.h>

#include <numbers>

namespace fca {

namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

std::optional<ReachRow> reach_row(const Camera& camera, ConvertOptions options, double angle_rad) {
  options.max_angle_rad = angle_rad;
  options.reach = false;
  options.bound = false;
  options.every_pixel = false;
  Diagnostics unheard;
  const std::optional<Conversion> conversion = convert(camera, options, unheard);
  if (!conversion) return std::nullopt;
  const Judgement& judgement = conversion->report.judgement;
  return ReachRow{angle_rad / kRadiansPerDegree, judgement.coverage.scored, judgement.coverage.unrepresentable,
                  judgement.error.rms, judgement.error.max};
}

}  // namespace

std::vector<ReachRow> reach_table(const Camera& camera, const ConvertOptions& options, Diagnostics& diagnostics) {
  constexpr double kFirstDeg = 90.0;
  constexpr double kStepDeg = 5.0;
  if (options.max_angle_rad) return {};
  const std::optional<Domain> domain = domain_of(camera, std::nullopt, diagnostics);
  if (!domain || domain->max_angle_rad <= kFirstDeg * kRadiansPerDegree) return {};
  std::vector<ReachRow> table;
  const auto add = [&](double angle_rad) {
    if (const std::optional<ReachRow> row = reach_row(camera, options, angle_rad)) table.push_back(*row);
  };
  for (int i = 0; (kFirstDeg + i * kStepDeg) * kRadiansPerDegree < domain->max_angle_rad; ++i)
    add((kFirstDeg + i * kStepDeg) * kRadiansPerDegree);
  add(domain->max_angle_rad);
  return table;
}

}  // namespace fca
