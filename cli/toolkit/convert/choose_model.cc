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

/// The ranges of a model's parameters: those that the format's program requires. The range of a parameter that the program does
/// not read is the single value that it uses instead.
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

/// True if a camera that has the model may keep it.
bool may_be_kept(const StoredModel& stored, const ModelChoice& choice) {
  if (choice.among.empty()) return stored.stock;
  return std::ranges::find(choice.among, stored.model) != choice.among.end();
}

}  // namespace

bool may_be_chosen(const StoredModel& stored, const ModelChoice& choice) {
  return may_be_kept(stored, choice) && !find_model(stored.model)->kept_only;
}

namespace {

/// True if the camera needs no fit: it has the model, its parameters are within the ranges, and the parameters that the request
/// fixes have their fixed values.
bool keeps(const Camera& camera, const StoredModel& stored, const ModelChoice& choice) {
  return camera.lens_id() == stored.model && within(camera.model, ranges_of(stored, choice)) &&
         is_as_fixed(camera.model, choice.request.fixed);
}

/// Converts one camera to the model; nullopt, with errors, if that fails. Two kinds of cameras are copied without a report: a
/// table of rays that is stored as such a table, and a camera that keeps its model and has no image size.
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

/// Converts all cameras to one model, several at the same time. nullopt, with the errors of the first camera that fails, if one
/// fails. The diagnostics of the others are in ConvertedCamera::found.
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

/// How good the fits of all cameras are. The coverage is compared first, then the error that the objective minimises.
struct Merit {
  double unrepresentable = 0.0;  ///< Sum, over the cameras, of the share of the image that the model does not cover.
  double square_sum = 0.0;       ///< Sum, over the cameras, of the squared error [px^2]: the rms or the maximum.
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

// The evaluation lattice cannot resolve a smaller share of the image.
constexpr double kCoverageTolerance = 1e-3;

/// True if the fits with merit `a` are to be chosen instead of those with merit `b`, which the format lists earlier.
bool is_better_merit(const Merit& a, const Merit& b) {
  if (std::abs(a.unrepresentable - b.unrepresentable) > kCoverageTolerance) return a.unrepresentable < b.unrepresentable;
  // A smaller difference is invisible. Then the order of the format's table decides, in which its usual models come first.
  constexpr double kVisibleRatio = 0.96;             // of the squares: the errors differ by 2 %
  constexpr double kNegligibleSquare = 1e-6 * 1e-6;  // px^2
  return a.square_sum < kVisibleRatio * b.square_sum && b.square_sum > kNegligibleSquare;
}

/// Ids of all models that the format stores.
std::vector<std::string> ids_of_models(const Format& format) {
  std::vector<std::string> names;
  for (const StoredModel& row : format.models) names.emplace_back(row.model);
  return names;
}

/// The row of the format's model table for a camera that keeps its model; nullopt if the camera must be fitted. A camera from a
/// file of the same format may keep any model. Other cameras may keep only a model that the format's own program reads.
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

/// The share of the image that lies 90 degrees or more from the axis, summed over the cameras.
double share_behind(const std::vector<ConvertedCamera>& outcomes) {
  constexpr double kSideDeg = 90.0;
  double share = 0.0;
  for (const ConvertedCamera& outcome : outcomes) {
    if (!outcome.report) continue;
    for (const ErrorBand& band : outcome.report->statistics.bands) share += band.from_deg >= kSideDeg ? band.share : 0.0;
  }
  return share;
}

/// True if the model covers the whole lens of every camera, with errors so small that no better model is needed.
bool is_good_everywhere(const std::vector<ConvertedCamera>& outcomes) {
  constexpr double kGoodRmsPx = 0.25;
  return std::ranges::all_of(outcomes, [](const ConvertedCamera& outcome) {
    const ErrorStatistics* statistics = outcome.report ? &outcome.report->statistics : nullptr;
    return statistics != nullptr && statistics->coverage.unrepresentable <= kCoverageTolerance &&
           statistics->error.rms <= kGoodRmsPx;
  });
}

/// True if a fit of the model `stored` to the whole lens is known to be worse than `outcomes`, the good fits of another model:
/// for some camera, least_rms_px() shows that no parameters of `stored` give an error as small. False if it is not known.
bool cannot_win(const std::vector<Camera>& cameras, const StoredModel& stored, const std::vector<ConvertedCamera>& outcomes,
                const ModelChoice& choice) {
  constexpr double kSafetyFactor = 4.0;  // least_rms_px() uses a grid of a few pixels only
  constexpr double kInvisiblePx = 1e-5;
  const ConvertRequest& request = choice.request;
  if (request.objective != Objective::kRms || request.weight != WeightKind::kPixel || request.absorb_turn) return false;
  const Merit merit = merit_of(outcomes, request.objective);
  if (merit.unrepresentable != 0.0 || !is_good_everywhere(outcomes)) return false;
  const double limit_px = std::max(kSafetyFactor * std::sqrt(merit.square_sum), kInvisiblePx);
  return std::ranges::any_of(cameras, [&](const Camera& camera) {
    const std::optional<double> least_px = least_rms_px(camera, stored.model, request.inputs.max_angle_rad);
    return least_px && *least_px > limit_px;
  });
}

/// Fits all cameras with the best model that may be chosen; nullopt, with errors, if every fit fails. To save time:
/// - A perspective model is not tried if another model covers the rays at 90 degrees and more from the axis.
/// - After a model that is good everywhere, no model is fitted up to a smaller angle: such fits are the slowest.
/// - A perspective model is not tried if it is known to be worse than a model that is good everywhere (cannot_win).
std::optional<std::vector<ConvertedCamera>> best_model(const std::vector<Camera>& cameras, const Format& format,
                                                       const ModelChoice& choice, Diagnostics& diagnostics) {
  struct Candidate {
    const StoredModel* stored = nullptr;
    bool is_tried = false;
    std::optional<std::vector<ConvertedCamera>> outcomes = {};
    Diagnostics diagnostics = {};
  };
  std::vector<Candidate> candidates;
  for (const StoredModel& stored : format.models) {
    if (may_be_chosen(stored, choice)) candidates.push_back({&stored});
  }
  double uncovered = std::numeric_limits<double>::infinity();  // smallest share that a tried model does not cover
  double behind = 0.0;                                         // largest share_behind() of a tried model
  ModelChoice attempt = choice;
  attempt.errors_of_kept = true;  // the candidates are compared by their errors
  const auto try_out = [&](Candidate& candidate) {
    candidate.is_tried = true;
    candidate.outcomes = convert_all(cameras, *candidate.stored, attempt, candidate.diagnostics);
    if (!candidate.outcomes) return;
    if (is_good_everywhere(*candidate.outcomes)) attempt.partial = Partial::kNothing;
    uncovered = std::min(uncovered, merit_of(*candidate.outcomes, choice.request.objective).unrepresentable);
    behind = std::max(behind, share_behind(*candidate.outcomes));
  };
  for (Candidate& candidate : candidates) {
    if (!is_perspective(candidate.stored->model)) try_out(candidate);
  }
  const auto is_hopeless = [&](const Candidate& candidate) {
    return attempt.partial == Partial::kNothing && std::ranges::any_of(candidates, [&](const Candidate& other) {
             return other.outcomes && cannot_win(cameras, *candidate.stored, *other.outcomes, choice);
           });
  };
  for (Candidate& candidate : candidates) {
    if (!candidate.is_tried && !(behind > uncovered + kCoverageTolerance) && !is_hopeless(candidate)) try_out(candidate);
  }
  const Candidate* best = nullptr;
  const Candidate* failed = nullptr;
  for (const Candidate& candidate : candidates) {
    if (!candidate.is_tried) continue;
    if (!candidate.outcomes) {
      failed = &candidate;
    } else if (best == nullptr || is_better_merit(merit_of(*candidate.outcomes, choice.request.objective),
                                                  merit_of(*best->outcomes, choice.request.objective))) {
      best = &candidate;
    }
  }
  if (best != nullptr) return best->outcomes;
  if (failed == nullptr) return std::nullopt;
  for (const Diagnostic& entry : failed->diagnostics.entries()) diagnostics.add(entry);
  return std::nullopt;
}

/// Converts all cameras to one model: the one that they all have, if they may keep it, otherwise the best model that may be
/// chosen.
std::optional<std::vector<ConvertedCamera>> common_model(const std::vector<Camera>& cameras, const Format& format,
                                                         const ModelChoice& choice, Diagnostics& diagnostics) {
  for (const StoredModel& stored : format.models) {
    // A single camera may also keep a model that is never chosen (kept_only). A pair may not: for example, stella_vslam does
    // not rectify pairs of division lenses.
    const bool may_stay = may_be_chosen(stored, choice) || (cameras.size() == 1 && may_be_kept(stored, choice));
    const bool all_keep =
        may_stay && std::ranges::all_of(cameras, [&](const Camera& camera) { return keeps(camera, stored, choice); });
    if (all_keep) return convert_all(cameras, stored, choice, diagnostics);
  }
  return best_model(cameras, format, choice, diagnostics);
}

/// Converts the first choice.most_cameras cameras as convert_cameras() describes, and copies the others without a report. The
/// diagnostics of the fits stay in ConvertedCamera::found.
std::optional<std::vector<ConvertedCamera>> convert_first_cameras(const std::vector<Camera>& cameras, const Format& format,
                                                                  const ModelChoice& choice, Diagnostics& diagnostics) {
  if (choice.request.model != nullptr) {
    const ModelInfo& model = *choice.request.model;
    const StoredModel* stored = find_stored_model(format, model.id, false);
    if (stored == nullptr) {
      diagnostics.add(Code::kModelNotStorable, {format.title, model.id, ids_of_models(format)});
      return std::nullopt;
    }
    const std::size_t used = std::min(cameras.size(), choice.most_cameras);
    std::optional<std::vector<ConvertedCamera>> outcomes =
        convert_all({cameras.begin(), cameras.begin() + static_cast<std::ptrdiff_t>(used)}, *stored, choice, diagnostics);
    // The writer drops the other cameras and lists them as losses.
    for (std::size_t i = used; outcomes && i < cameras.size(); ++i) outcomes->push_back({cameras[i], cameras[i], std::nullopt});
    return outcomes;
  }

  // If the format has one model for all cameras, all cameras are fitted together. Otherwise each camera keeps its model if it
  // may, and the others get one common model. A table of rays has no model.
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
  auto next_fitted = fitted->begin();
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const Camera& camera = cameras[i];
    if (i >= used.size()) {
      outcomes.push_back({camera, camera, std::nullopt});
    } else if (is_fitted[i]) {
      outcomes.push_back(*next_fitted++);
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
  std::optional<std::vector<ConvertedCamera>> outcomes = convert_first_cameras(cameras, format, choice, diagnostics);
  if (!outcomes) return std::nullopt;
  for (const ConvertedCamera& camera : *outcomes) {
    for (const Diagnostic& entry : camera.found.entries()) diagnostics.add(entry);
  }
  return outcomes;
}

}  // namespace fca
