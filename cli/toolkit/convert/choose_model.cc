// SPDX-License-Identifier: BSD-3-Clause
#include "choose_model.h"

#include "parallel_for.h"

#include <fca/code.h>
#include <fca/convert/least_error.h>
#include <fca/convert/max_angle_table.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace fca {

bool layout_stores(const Format& to, std::string_view layout, std::string_view model) {
  return to.layout_stores == nullptr || to.layout_stores(layout, model);
}

std::vector<std::string> models_of_layout(const Format& to, std::string_view layout) {
  std::vector<std::string> stock;
  std::vector<std::string> all;
  for (const StoredModel& stored : to.models) {
    if (!layout_stores(to, layout, stored.model)) continue;
    all.emplace_back(stored.model);
    if (stored.stock) stock.emplace_back(stored.model);
  }
  return stock.empty() ? all : stock;
}

namespace {

/// The ranges of a model's parameters: what the format can store and the program reads.
std::vector<ParameterRange> ranges_of(const StoredModel& stored, const ModelChoice& choice) {
  std::vector<ParameterRange> ranges(stored.ranges.begin(), stored.ranges.end());
  for (const consumers::UnreadParameter& parameter : choice.unread) {
    const std::optional<ParameterId> id = ParameterId::find(parameter.parameter);
    if (parameter.model == stored.model && id) ranges.push_back({*id, parameter.taken_for, parameter.taken_for});
  }
  return ranges;
}

}  // namespace

ConvertOptions options_for(const StoredModel& stored, const ModelChoice& choice) {
  ConvertOptions options;
  options.model = stored.model;
  options.max_angle_rad = choice.request.inputs.max_angle_rad;
  options.every_pixel = choice.request.every_pixel;
  options.objective = choice.request.objective;
  options.weight = {choice.request.weight, choice.request.density};
  options.reduce_angle = choice.partial == Partial::kSmallerAngle;
  if (find_model(stored.model)->least_degree > 0) options.degree = choice.request.degree;
  options.ranges = ranges_of(stored, choice);
  options.fixed = choice.request.fixed;
  options.absorb_turn = choice.request.absorb_turn;
  return options;
}

std::optional<Conversion> converted(const Camera& camera, const ConvertOptions& options, const ModelChoice& choice,
                                    Diagnostics& diagnostics) {
  return choice.known != nullptr ? choice.known->convert(camera, options, diagnostics) : convert(camera, options, diagnostics);
}

namespace {

bool may_be_kept(const StoredModel& stored, const ModelChoice& choice) {
  if (choice.among.empty()) return stored.stock;
  return std::ranges::find(choice.among, stored.model) != choice.among.end();
}

}  // namespace

bool may_be_chosen(const StoredModel& stored, const ModelChoice& choice) {
  return may_be_kept(stored, choice) && !find_model(stored.model)->kept_only;
}

namespace {

/// True if the camera needs no fit: it has the model, within the ranges and with the parameters that the request fixes.
bool keeps(const Camera& camera, const StoredModel& stored, const ModelChoice& choice) {
  return camera.lens_id() == stored.model && within(camera.model, ranges_of(stored, choice)) &&
         is_as_fixed(camera.model, choice.request.fixed);
}

std::optional<ConvertedCamera> convert_one(const Camera& camera, const StoredModel& stored, const ModelChoice& choice,
                                           Diagnostics& diagnostics) {
  if (!camera.rays.empty() && stored.model == camera.lens_id()) return ConvertedCamera{camera, camera, std::nullopt};
  if (keeps(camera, stored, choice) && !camera.image_size && validate(camera.model).empty())
    return ConvertedCamera{camera, camera, std::nullopt};
  ConvertOptions options = options_for(stored, choice);
  options.errors_of_kept = choice.errors_of_kept;
  std::optional<Conversion> conversion = converted(camera, options, choice, diagnostics);
  if (!conversion) return std::nullopt;
  return ConvertedCamera{camera, std::move(conversion->camera), std::move(conversion->report)};
}

std::optional<std::vector<ConvertedCamera>> convert_all(const std::vector<Camera>& cameras, const StoredModel& stored,
                                                        const ModelChoice& choice, Diagnostics& diagnostics) {
  std::vector<Diagnostics> found(cameras.size());
  std::vector<std::optional<ConvertedCamera>> converted(cameras.size());
  parallel_for(cameras.size(), choice.request.jobs,
               [&](std::size_t i) { converted[i] = convert_one(cameras[i], stored, choice, found[i]); });
  std::vector<ConvertedCamera> outcomes;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    if (!converted[i]) {
      for (const Diagnostic& entry : found[i].entries()) diagnostics.add(entry);
      return std::nullopt;
    }
    outcomes.push_back(*std::move(converted[i]));
    outcomes.back().found = std::move(found[i]);
  }
  return outcomes;
}

/// How good the fits of all cameras are: the coverage counts first, then the error that the objective minimises.
struct Merit {
  double unrepresentable = 0.0;
  double square_sum = 0.0;
};

Merit merit_of(const std::vector<ConvertedCamera>& outcomes, Objective objective) {
  Merit merit;
  for (const ConvertedCamera& outcome : outcomes) {
    if (!outcome.report) continue;
    merit.unrepresentable += outcome.report->statistics.coverage.unrepresentable;
    const ErrorSummary& error = outcome.report->statistics.error;
    merit.square_sum += std::pow(objective == Objective::kMax ? error.max : outcome.report->fitted_rms_px(), 2);
  }
  return merit;
}

constexpr double kSameCoverage = 1e-3;  // a smaller share of the image than the lattice can resolve

bool better(const Merit& a, const Merit& b) {
  if (std::abs(a.unrepresentable - b.unrepresentable) > kSameCoverage) return a.unrepresentable < b.unrepresentable;
  // A smaller difference is invisible: the order of the format's table, its usual models first, decides.
  constexpr double kSameError = 0.96;       // within 2 %
  constexpr double kNoError = 1e-6 * 1e-6;  // px^2
  return a.square_sum < kSameError * b.square_sum && b.square_sum > kNoError;
}

std::vector<std::string> storable(const Format& format) {
  std::vector<std::string> names;
  for (const StoredModel& row : format.models) names.emplace_back(row.model);
  return names;
}

/// The row of the format's table with which a camera keeps its model: one that the stock program reads or, if the camera comes
/// from a file of the same format, any. nullopt if it must be fitted.
std::optional<StoredModel> kept_row(const Camera& camera, const Format& format, const ModelChoice& choice) {
  for (const StoredModel& stored : format.models) {
    if ((may_be_kept(stored, choice) || choice.same_format) && keeps(camera, stored, choice)) return stored;
  }
  const std::string_view model = camera.lens_id();
  if (!camera.rays.empty() && !choice.request.inputs.change.changes_nothing()) return std::nullopt;
  if (!choice.same_format || find_stored_model(format, model, false) != nullptr) return std::nullopt;
  StoredModel stored;
  stored.model = model;
  return stored;
}

/// The share of the image that lies 90 degrees or more from the axis, summed over the images.
double share_behind(const std::vector<ConvertedCamera>& outcomes) {
  constexpr double kAheadDeg = 90.0;
  double share = 0.0;
  for (const ConvertedCamera& outcome : outcomes) {
    if (!outcome.report) continue;
    for (const ErrorBand& band : outcome.report->statistics.bands) share += band.from_deg >= kAheadDeg ? band.share : 0.0;
  }
  return share;
}

/// True if every camera's whole lens is covered, with errors so small that no better model is needed.
bool is_good_everywhere(const std::vector<ConvertedCamera>& outcomes) {
  constexpr double kGoodRms = 0.25;  // px
  return std::ranges::all_of(outcomes, [](const ConvertedCamera& outcome) {
    const ErrorStatistics* statistics = outcome.report ? &outcome.report->statistics : nullptr;
    return statistics != nullptr && statistics->coverage.unrepresentable <= kSameCoverage && statistics->error.rms <= kGoodRms;
  });
}

/// True if a fit of the model to the whole lens is known to be worse than `outcomes`, which are of another model and good on
/// the whole image: no camera of that model comes as near (least_rms_px).
bool surely_loses(const std::vector<Camera>& cameras, const StoredModel& stored, const std::vector<ConvertedCamera>& outcomes,
                  const ModelChoice& choice) {
  constexpr double kClearly = 4.0;      // times: the limit is that of a few pixels
  constexpr double kNobodySees = 1e-5;  // px
  const ConvertRequest& request = choice.request;
  if (request.objective != Objective::kRms || request.weight != WeightKind::kPixel || request.absorb_turn) return false;
  const Merit merit = merit_of(outcomes, request.objective);
  if (merit.unrepresentable != 0.0 || !is_good_everywhere(outcomes)) return false;
  const double limit_px = std::max(kClearly * std::sqrt(merit.square_sum), kNobodySees);
  return std::ranges::any_of(cameras, [&](const Camera& camera) {
    const std::optional<double> least_px = least_rms_px(camera, stored.model, request.inputs.max_angle_rad);
    return least_px && *least_px > limit_px;
  });
}

/// Fits all cameras with the best model that may be chosen. A perspective model is not tried if another covers what is
/// behind, and not fitted up to a smaller angle if another is good everywhere: that fit is the slowest of all.
/// A model is not fitted at all if none of its cameras can be as good as a fit that is good everywhere.
std::optional<std::vector<ConvertedCamera>> best_model(const std::vector<Camera>& cameras, const Format& format,
                                                       const ModelChoice& choice, Diagnostics& diagnostics) {
  struct Candidate {
    const StoredModel* stored = nullptr;
    bool tried = false;
    std::optional<std::vector<ConvertedCamera>> outcomes = {};
    Diagnostics diagnostics = {};
  };
  std::vector<Candidate> candidates;
  for (const StoredModel& stored : format.models) {
    if (may_be_chosen(stored, choice)) candidates.push_back({&stored});
  }
  double uncovered = std::numeric_limits<double>::infinity();
  double behind = 0.0;
  ModelChoice next = choice;
  next.errors_of_kept = true;  // what candidates are told apart by
  const auto try_out = [&](Candidate& candidate) {
    candidate.tried = true;
    candidate.outcomes = convert_all(cameras, *candidate.stored, next, candidate.diagnostics);
    if (!candidate.outcomes) return;
    if (is_good_everywhere(*candidate.outcomes)) next.partial = Partial::kNothing;
    uncovered = std::min(uncovered, merit_of(*candidate.outcomes, choice.request.objective).unrepresentable);
    behind = std::max(behind, share_behind(*candidate.outcomes));
  };
  for (Candidate& candidate : candidates) {
    if (!is_perspective(candidate.stored->model)) try_out(candidate);
  }
  const auto is_hopeless = [&](const Candidate& candidate) {
    return next.partial == Partial::kNothing && std::ranges::any_of(candidates, [&](const Candidate& other) {
             return other.outcomes && surely_loses(cameras, *candidate.stored, *other.outcomes, choice);
           });
  };
  for (Candidate& candidate : candidates) {
    if (!candidate.tried && !(behind > uncovered + kSameCoverage) && !is_hopeless(candidate)) try_out(candidate);
  }
  const Candidate* best = nullptr;
  const Candidate* failed = nullptr;
  for (const Candidate& candidate : candidates) {
    if (!candidate.tried) continue;
    if (!candidate.outcomes) {
      failed = &candidate;
    } else if (best == nullptr || better(merit_of(*candidate.outcomes, choice.request.objective),
                                         merit_of(*best->outcomes, choice.request.objective))) {
      best = &candidate;
    }
  }
  if (best != nullptr) return best->outcomes;
  if (failed == nullptr) return std::nullopt;
  for (const Diagnostic& entry : failed->diagnostics.entries()) diagnostics.add(entry);
  return std::nullopt;
}

/// All cameras with one model: the one that they all have, if the stock program reads it, otherwise the best one that it reads.
std::optional<std::vector<ConvertedCamera>> common_model(const std::vector<Camera>& cameras, const Format& format,
                                                         const ModelChoice& choice, Diagnostics& diagnostics) {
  for (const StoredModel& stored : format.models) {
    // A model that is never chosen (kept_only) is kept for a single camera only: a pair may need another (stella_vslam does not
    // rectify division lenses).
    const bool may_stay = may_be_chosen(stored, choice) || (cameras.size() == 1 && may_be_kept(stored, choice));
    const bool all_keep =
        may_stay && std::ranges::all_of(cameras, [&](const Camera& camera) { return keeps(camera, stored, choice); });
    if (all_keep) return convert_all(cameras, stored, choice, diagnostics);
  }
  return best_model(cameras, format, choice, diagnostics);
}

std::optional<std::vector<ConvertedCamera>> all_cameras(const std::vector<Camera>& cameras, const Format& format,
                                                        const ModelChoice& choice, Diagnostics& diagnostics) {
  if (choice.request.model != nullptr) {
    const ModelInfo& model = *choice.request.model;
    const StoredModel* stored = find_stored_model(format, model.id, false);
    if (stored == nullptr) {
      diagnostics.add(Code::kModelNotStorable, {format.title, model.id, storable(format)});
      return std::nullopt;
    }
    const std::size_t used = std::min(cameras.size(), choice.most_cameras);
    std::optional<std::vector<ConvertedCamera>> outcomes =
        convert_all({cameras.begin(), cameras.begin() + static_cast<std::ptrdiff_t>(used)}, *stored, choice, diagnostics);
    // The writer drops the other cameras and lists them as losses.
    for (std::size_t i = used; outcomes && i < cameras.size(); ++i) outcomes->push_back({cameras[i], cameras[i], std::nullopt});
    return outcomes;
  }

  // If a program has one type for all cameras, one model is chosen for all. Otherwise each camera that can keeps its model, and
  // the others share one. Cameras that are tables of rays have no type.
  std::vector<Camera> to_fit;
  std::vector<bool> is_fitted(cameras.size());
  const std::span<const Camera> used = std::span(cameras).first(std::min(cameras.size(), choice.most_cameras));
  for (std::size_t i = 0; i < used.size(); ++i) {
    is_fitted[i] = (format.one_model && used[i].rays.empty()) || !kept_row(used[i], format, choice);
    if (is_fitted[i]) to_fit.push_back(used[i]);
  }
  std::optional<std::vector<ConvertedCamera>> fitted = std::vector<ConvertedCamera>();
  if (!to_fit.empty()) fitted = common_model(to_fit, format, choice, diagnostics);
  if (!fitted) return std::nullopt;
  std::vector<ConvertedCamera> outcomes;
  auto next = fitted->begin();
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const Camera& camera = cameras[i];
    if (i >= used.size()) {
      outcomes.push_back({camera, camera, std::nullopt});
    } else if (is_fitted[i]) {
      outcomes.push_back(*next++);
    } else {
      std::optional<std::vector<ConvertedCamera>> kept =
          convert_all({camera}, *kept_row(camera, format, choice), choice, diagnostics);
      if (!kept) return std::nullopt;
      outcomes.push_back(kept->front());
    }
  }
  return outcomes;
}

}  // namespace

std::optional<std::vector<ConvertedCamera>> convert_cameras(const std::vector<Camera>& cameras, const Format& format,
                                                            const ModelChoice& choice, Diagnostics& diagnostics) {
  std::optional<std::vector<ConvertedCamera>> outcomes = all_cameras(cameras, format, choice, diagnostics);
  if (!outcomes) return std::nullopt;
  for (const ConvertedCamera& camera : *outcomes) {
    for (const Diagnostic& entry : camera.found.entries()) diagnostics.add(entry);
  }
  return outcomes;
}

}  // namespace fca
