// SPDX-License-Identifier: BSD-3-Clause
#include "model_advice.h"

#include "best_first.h"

#include <fca/code.h>
#include <fca/convert/max_angle_table.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace fca {

namespace {

/// Coverages that differ by at most this share of the image count as equal.
constexpr double kSameCoverage = 1e-3;

}  // namespace

bool is_better(const ConversionReport& a, const ConversionReport& b) {
  // The share of the image that `a` covers in addition.
  const double extra_coverage = b.statistics.coverage.unrepresentable - a.statistics.coverage.unrepresentable;
  if (std::abs(extra_coverage) > kSameCoverage) return extra_coverage > 0.0;
  return a.statistics.error.rms < b.statistics.error.rms;
}

namespace {

/// True if `a` covers much more of the image than `b`. If the coverages are similar: true if the error of `b` is visible and
/// that of `a` is much smaller.
bool is_much_better(const ConversionReport& a, const ConversionReport& b) {
  constexpr double kMuchMoreCoverage = 0.02;  // share of the image
  constexpr double kMuchSmallerRatio = 0.25;
  constexpr double kVisibleError = 0.1;  // px rms
  const double extra_coverage = b.statistics.coverage.unrepresentable - a.statistics.coverage.unrepresentable;
  if (std::abs(extra_coverage) > kMuchMoreCoverage) return extra_coverage > 0.0;
  return b.statistics.error.rms > kVisibleError && a.statistics.error.rms < kMuchSmallerRatio * b.statistics.error.rms;
}

/// Names the model of a conversion with its error: "kb4 (exact)" or "rational (up to 88 deg, rms 0.218 px)".
Message in_words(const ConversionReport& report) {
  if (report.exact) return {Code::kModelExact, {report.to_model}};
  const bool covers = report.statistics.coverage.unrepresentable <= kSameCoverage;
  return {covers ? Code::kModelRms : Code::kModelRmsUpTo, {report.to_model, report.statistics.error.rms, report.scored_to_deg}};
}

/// Converts the camera to the model `stored` and returns the report without the proven bound of the error, which takes long and
/// is not used here. nullopt if the conversion fails.
std::optional<ConversionReport> report_of_conversion_to(const StoredModel& stored, const Camera& camera,
                                                        const ModelChoice& choice, Objective objective) {
  ConvertOptions options = options_for(stored, choice);
  options.objective = objective;
  options.every_pixel = false;
  options.bound = false;
  Diagnostics discarded;
  std::optional<Conversion> conversion = converted(camera, options, choice, discarded);
  return conversion ? std::optional(std::move(conversion->report)) : std::nullopt;
}

/// The conversions of the camera to `models` that are better than `reference`, the best first.
std::vector<ConversionReport> better_conversions(const Camera& camera, const ConversionReport& reference,
                                                 const ModelChoice& choice, const std::vector<StoredModel>& models) {
  constexpr double kUsableError = 2.0;  // px rms; a file with a larger error is of no use
  std::vector<ConversionReport> result;
  for (const StoredModel& stored : models) {
    std::optional<ConversionReport> report = report_of_conversion_to(stored, camera, choice, Objective::kRms);
    if (report && is_better(*report, reference) && report->statistics.error.rms <= kUsableError)
      result.push_back(*std::move(report));
  }
  put_best_first(result, is_better);
  return result;
}

/// The report of the camera that the model fits worst. nullopt if the conversion of one of the cameras fails.
std::optional<ConversionReport> worst_report(const StoredModel& stored, std::span<const Camera> cameras,
                                             const ModelChoice& choice) {
  std::optional<ConversionReport> worst;
  for (const Camera& camera : cameras) {
    std::optional<ConversionReport> report = report_of_conversion_to(stored, camera, choice, choice.request.objective);
    if (!report) return std::nullopt;
    if (!worst || is_better(*worst, *report)) worst = std::move(report);
  }
  return worst;
}

}  // namespace

std::optional<Message> best_model_readable_by_all_versions(std::span<const Camera> cameras, const Format& format,
                                                           const ModelChoice& choice) {
  std::optional<ConversionReport> best;
  for (const StoredModel& stored : format.models) {
    // Skip a model that only a modified program or only newer versions read.
    if (!stored.stock || !stored.since.empty() || find_model(stored.model)->kept_only) continue;
    std::optional<ConversionReport> report = worst_report(stored, cameras, choice);
    if (report && (!best || is_better(*report, *best))) best = std::move(report);
  }
  if (!best) return std::nullopt;
  return Message{Code::kOlderVersionsRead, {best->to_model, best->statistics.error.rms, best->statistics.error.max}};
}

Message better_models(const Camera& camera, const ConversionReport& report, const Format& format, std::string_view program,
                      const ModelChoice& choice) {
  constexpr std::size_t kMaxSuggestions = 3;
  // Models that the format's own program reads and the request allows, and all others that describe wide lenses: a perspective
  // model would only describe a part of the lens.
  std::vector<StoredModel> models_of_program;
  std::vector<StoredModel> other_models;
  for (const ModelInfo& model : all_models()) {
    const StoredModel* stored = find_stored_model(format, model.id, /*stock_only=*/true);
    // Skip the model to which the camera was converted. Skip a kept_only model (one that only files of one format have), unless
    // it is the model of the camera itself.
    if (model.id == report.to_model || (model.kept_only && model.id != report.from_model)) continue;
    const bool may_be_chosen = choice.among.empty() || std::ranges::find(choice.among, model.id) != choice.among.end();
    if (stored != nullptr && may_be_chosen) {
      models_of_program.push_back(*stored);
    } else if (!is_perspective(model.id)) {
      other_models.emplace_back().model = model.id;
    }
  }
  const std::vector<ConversionReport> better = better_conversions(camera, report, choice, models_of_program);
  std::vector<Message> names;
  for (const ConversionReport& conversion : better) {
    if (names.size() < kMaxSuggestions) names.push_back(in_words(conversion));
  }
  const std::vector<ConversionReport> others = better_conversions(camera, report, choice, other_models);
  std::vector<Message> hint_at_other_model;
  if (!others.empty() && is_much_better(others.front(), better.empty() ? report : better.front()))
    hint_at_other_model.push_back({Code::kBetterElsewhere, {in_words(others.front())}});
  if (names.empty()) return {Code::kNoBetterModel, {program, hint_at_other_model}};
  return {Code::kBetterModels, {program, names, hint_at_other_model}};
}

}  // namespace fca
