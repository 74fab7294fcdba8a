// SPDX-License-Identifier: BSD-3-Clause
#include "choose_model.h"

#include "words.h"

#include <algorithm>
#include <cmath>

namespace fca::cli {

namespace {

ConvertOptions options_for(const StoredModel& stored, const ModelChoice& choice) {
  ConvertOptions options;
  options.model = stored.model;
  options.max_angle_rad = choice.max_angle_rad;
  options.ranges.assign(stored.ranges.begin(), stored.ranges.end());
  return options;
}

bool keeps(const Camera& camera, const StoredModel& stored) {
  return model_info(camera.model).id == stored.model && within(camera.model, stored.ranges);
}

/// Converts the first `most` cameras; a format that uses no more drops the others, and says so.
std::optional<std::vector<CameraOutcome>> convert_all(const std::vector<Camera>& cameras, std::size_t most,
                                                      const StoredModel& stored, const ModelChoice& choice,
                                                      Diagnostics& diagnostics) {
  std::vector<CameraOutcome> outcomes;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const Camera& camera = cameras[i];
    if (i >= most) {
      outcomes.push_back({camera, camera, std::nullopt});
      continue;
    }
    if (keeps(camera, stored) && !camera.image_size && validate(camera.model).empty()) {
      outcomes.push_back({camera, camera, std::nullopt});
      continue;
    }
    std::optional<Conversion> conversion = convert(camera, options_for(stored, choice), diagnostics);
    if (!conversion) return std::nullopt;
    outcomes.push_back({camera, std::move(conversion->camera), std::move(conversion->report)});
  }
  return outcomes;
}

/// Coverage first, then rms, both over all cameras.
struct Merit {
  double unrepresentable = 0.0;
  double square_sum = 0.0;
};

Merit merit_of(const std::vector<CameraOutcome>& outcomes) {
  Merit merit;
  for (const CameraOutcome& outcome : outcomes) {
    if (!outcome.report) continue;
    merit.unrepresentable += outcome.report->judgement.coverage.unrepresentable;
    merit.square_sum += std::pow(outcome.report->judgement.error.rms, 2);
  }
  return merit;
}

bool better(const Merit& a, const Merit& b) {
  constexpr double kSameCoverage = 1e-3;  // a share of the image finer than the lattice can tell
  if (std::abs(a.unrepresentable - b.unrepresentable) > kSameCoverage) return a.unrepresentable < b.unrepresentable;
  // Nobody sees such a difference: then the order of the format's table, its usual models first, decides.
  constexpr double kSameError = 0.96;       // rms within 2 %
  constexpr double kNoError = 1e-6 * 1e-6;  // px^2
  return a.square_sum < kSameError * b.square_sum && b.square_sum > kNoError;
}

std::vector<std::string> storable(const Format& format) {
  std::vector<std::string> names;
  for (const StoredModel& row : format.models) names.emplace_back(row.model);
  return names;
}

}  // namespace

std::optional<std::vector<CameraOutcome>> convert_cameras(const std::vector<Camera>& cameras, const Format& format,
                                                          const ModelChoice& choice, Diagnostics& diagnostics) {
  if (!choice.model.empty()) {
    const ModelInfo& model = *find_model(choice.model);
    const StoredModel* stored = find_stored_model(format, model.id, false);
    if (stored == nullptr) {
      diagnostics.error("model-not-storable", std::string(format.title) + " cannot hold " + std::string(model.id) +
                                                  "; it holds " + enumerated(storable(format)));
      return std::nullopt;
    }
    return convert_all(cameras, format.most_cameras, *stored, choice, diagnostics);
  }

  const std::span<const Camera> used = std::span(cameras).first(std::min(cameras.size(), format.most_cameras));
  for (const StoredModel& stored : format.models) {
    const bool all_keep =
        stored.stock && std::ranges::all_of(used, [&stored](const Camera& camera) { return keeps(camera, stored); });
    if (all_keep) return convert_all(cameras, format.most_cameras, stored, choice, diagnostics);
  }
  std::optional<std::vector<CameraOutcome>> best;
  Diagnostics best_diagnostics;
  Diagnostics last_diagnostics;
  for (const StoredModel& stored : format.models) {
    if (!stored.stock) continue;
    Diagnostics found;
    std::optional<std::vector<CameraOutcome>> candidate = convert_all(cameras, format.most_cameras, stored, choice, found);
    if (!candidate) {
      last_diagnostics = found;
      continue;
    }
    if (!best || better(merit_of(*candidate), merit_of(*best))) {
      best = std::move(candidate);
      best_diagnostics = std::move(found);
    }
  }
  for (const Diagnostic& entry : (best ? best_diagnostics : last_diagnostics).entries()) diagnostics.add(entry);
  return best;
}

}  // namespace fca::cli
