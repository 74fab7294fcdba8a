// SPDX-License-Identifier: BSD-3-Clause
#include "model_advice.h"

#include <fca/code.h>
#include <fca/convert/max_angle_table.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace fca {

namespace {

constexpr double kSameCoverage = 1e-3;  // of the image

}  // namespace

bool is_better(const ConversionReport& a, const ConversionReport& b) {
  const double more = b.statistics.coverage.unrepresentable - a.statistics.coverage.unrepresentable;
  if (std::abs(more) > kSameCoverage) return more > 0.0;
  return a.statistics.error.rms < b.statistics.error.rms;
}

namespace {

bool is_much_better(const ConversionReport& a, const ConversionReport& b) {
  constexpr double kMuchMore = 0.02;  // of the image
  constexpr double kMuchLess = 0.25;
  constexpr double kSeen = 0.1;  // px
  const double more = b.statistics.coverage.unrepresentable - a.statistics.coverage.unrepresentable;
  if (std::abs(more) > kMuchMore) return more > 0.0;
  return b.statistics.error.rms > kSeen && a.statistics.error.rms < kMuchLess * b.statistics.error.rms;
}

Message in_words(const ConversionReport& report) {
  if (report.exact) return {Code::kModelExact, {report.to_model}};
  const bool covers = report.statistics.coverage.unrepresentable <= kSameCoverage;
  return {covers ? Code::kModelRms : Code::kModelRmsUpTo, {report.to_model, report.statistics.error.rms, report.scored_to_deg}};
}

std::optional<ConversionReport> report_as(const StoredModel& stored, const Camera& camera, const ModelChoice& choice,
                                          Objective objective) {
  ConvertOptions options = options_for(stored, choice);
  options.objective = objective;
  options.every_pixel = false;
  options.bound = false;
  Diagnostics discarded;
  std::optional<Conversion> conversion = converted(camera, options, choice, discarded);
  return conversion ? std::optional(std::move(conversion->report)) : std::nullopt;
}

/// The conversions of the camera to `models` that are better than `than`, the best first.
std::vector<ConversionReport> better_ones(const Camera& camera, const ConversionReport& than, const ModelChoice& choice,
                                          const std::vector<StoredModel>& models) {
  constexpr double kOfUse = 2.0;  // px; with a larger error a file is not to be used
  std::vector<ConversionReport> result;
  for (const StoredModel& stored : models) {
    std::optional<ConversionReport> report = report_as(stored, camera, choice, Objective::kRms);
    if (report && is_better(*report, than) && report->statistics.error.rms <= kOfUse) result.push_back(*std::move(report));
  }
  std::ranges::stable_sort(result, is_better);
  return result;
}

/// The report of the camera that the model fits worst; nullopt if the fit of one camera fails.
std::optional<ConversionReport> worst_report(const StoredModel& stored, std::span<const Camera> cameras,
                                             const ModelChoice& choice) {
  std::optional<ConversionReport> worst;
  for (const Camera& camera : cameras) {
    std::optional<ConversionReport> report = report_as(stored, camera, choice, choice.request.objective);
    if (!report) return std::nullopt;
    if (!worst || is_better(*worst, *report)) worst = std::move(report);
  }
  return worst;
}

}  // namespace

std::optional<Message> best_of_every_version(std::span<const Camera> cameras, const Format& format, const ModelChoice& choice) {
  std::optional<ConversionReport> best;
  for (const StoredModel& stored : format.models) {
    if (!stored.stock || !stored.since.empty() || find_model(stored.model)->kept_only) continue;
    std::optional<ConversionReport> report = worst_report(stored, cameras, choice);
    if (report && (!best || is_better(*report, *best))) best = std::move(report);
  }
  if (!best) return std::nullopt;
  return Message{Code::kOlderVersionsRead, {best->to_model, best->statistics.error.rms, best->statistics.error.max}};
}

Message better_models(const Camera& camera, const ConversionReport& report, const Format& format, std::string_view program,
                      const ModelChoice& choice) {
  constexpr std::size_t kMost = 3;
  std::vector<StoredModel> read;
  std::vector<StoredModel> elsewhere;
  for (const ModelInfo& model : all_models()) {
    const StoredModel* stored = find_stored_model(format, model.id, true);
    // The camera's own model may always be suggested; a model that only files of one format have (kept_only) may not.
    if (model.id == report.to_model || (model.kept_only && model.id != report.from_model)) continue;
    const bool may_be_chosen = choice.among.empty() || std::ranges::find(choice.among, model.id) != choice.among.end();
    if (stored != nullptr && may_be_chosen) {
      read.push_back(*stored);
    } else if (!is_perspective(model.id)) {
      elsewhere.emplace_back().model = model.id;
    }
  }
  const std::vector<ConversionReport> better = better_ones(camera, report, choice, read);
  std::vector<Message> names;
  for (const ConversionReport& one : better) {
    if (names.size() < kMost) names.push_back(in_words(one));
  }
  const std::vector<ConversionReport> others = better_ones(camera, report, choice, elsewhere);
  std::vector<Message> still;
  if (!others.empty() && is_much_better(others.front(), better.empty() ? report : better.front()))
    still.push_back({Code::kBetterElsewhere, {in_words(others.front())}});
  if (names.empty()) return {Code::kNoBetterModel, {program, still}};
  return {Code::kBetterModels, {program, names, still}};
}

}  // namespace fca
