// SPDX-License-Identifier: BSD-3-Clause
#include "fitter.h"

#include "aspect_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fca::internal {

namespace {

/// The effort of a fit to all samples. Models with many parameters have flat valleys, in which the last steps hardly change the
/// rms. Their fits therefore end at a larger relative gain.
constexpr Effort kFull{200, 1e-9};
constexpr Effort kFullManyParameters{200, 1e-6};

/// The effort with which a start is polished, and the number of samples. A model with many parameters (rational) needs more of
/// both: a fit shows which minimum is the lowest only after many steps and on many samples.
struct CoarseSettings {
  Effort effort;
  std::size_t samples;
};
constexpr CoarseSettings kCoarse{{30, 1e-4}, 32};
constexpr CoarseSettings kCoarseManyParameters{{60, 1e-6}, 100};

const CoarseSettings& coarse_settings_for(const FitTarget& target) {
  return has_many_parameters(target) ? kCoarseManyParameters : kCoarse;
}

/// True if `a` is the better fit. A fit with a pixel for every sample is better than one without, unless its rms is more than 4
/// times as large.
bool is_better(const FoundFit& a, const FoundFit& b) {
  constexpr double kMaxRmsRatio = 4.0;
  if (a.reaches_all == b.reaches_all) return a.rms_px < b.rms_px;
  return a.reaches_all ? a.rms_px <= kMaxRmsRatio * b.rms_px : kMaxRmsRatio * a.rms_px < b.rms_px;
}

/// Replaces `best` by `fit` if that is better.
void keep_better(std::optional<FoundFit> fit, std::optional<FoundFit>& best) {
  if (fit && (!best || is_better(*fit, *best))) best = std::move(fit);
}

/// True if a ray is more than 120 degrees from the axis. The image radius of such a lens hardly grows at the edge. A model with
/// a fold then has a minimum on each side of the fold, even if no camera of the model is nearly exact.
bool have_wide_rays(std::span<const Correspondence> samples) {
  constexpr double kWideCosine = -0.5;
  return std::ranges::any_of(samples, [](const Correspondence& s) { return s.ray[2] < kWideCosine; });
}

/// True if the fit from another start is probably not better. False in three cases:
/// - A sample has no pixel.
/// - A parameter is at a bound: the minimum is then outside the range, and another may be inside.
/// - The cost is small but not 0: another minimum is then probably exact, and the few samples did not show that.
bool is_final(const FoundFit& fit) {
  const double cost = fit.rms_px * fit.rms_px;
  return fit.at_bound.empty() && fit.reaches_all && !(cost > kExactCost && cost < kSmallCost);
}

}  // namespace

std::vector<Correspondence> choose_evenly(std::span<const Correspondence> samples, std::size_t count) {
  if (count >= samples.size()) return {samples.begin(), samples.end()};
  constexpr double kGoldenRatio = 0.6180339887498949;
  std::vector<Correspondence> chosen;
  chosen.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double turn = static_cast<double>(i) * kGoldenRatio;
    chosen.push_back(samples[static_cast<std::size_t>((turn - std::floor(turn)) * static_cast<double>(samples.size()))]);
  }
  return chosen;
}

Fitter::Fitter(const FitTarget& target, std::span<const Correspondence> samples, std::span<const ParameterRange> ranges)
    : target_(target),
      parameter_count_(target.parameters().size()),
      full_effort_(has_many_parameters(target) ? kFullManyParameters : kFull),
      samples_(samples),
      polisher_(target, ranges) {}

std::optional<FoundFit> Fitter::fit_from(const ParameterValues& start) {
  Candidate candidate;
  candidate.values = start;
  polisher_.apply_ranges(candidate);
  if (!polisher_.polish(candidate, samples_, full_effort_)) return std::nullopt;
  polisher_.respect_bounds(candidate, samples_, full_effort_);
  return polisher_.finish(candidate, samples_);
}

std::optional<FoundFit> Fitter::evaluate_camera(const ParameterValues& values) const {
  Candidate candidate;
  candidate.values = values;
  candidate.cost_is_complete = false;  // there is no cost yet
  polisher_.apply_ranges(candidate);
  if (candidate.values != values) return std::nullopt;
  const FitLimits& limits = polisher_.limits();
  for (std::size_t i = 0; i < parameter_count_; ++i)
    candidate.fixed[i] = candidate.fixed[i] || values[i] == limits.lower[i] || values[i] == limits.upper[i];
  return polisher_.finish(candidate, samples_);
}

std::optional<FoundFit> Fitter::refit(const ParameterValues& start, const LensCentre& centre) {
  if (std::optional<FoundFit> solved = solve(centre)) return solved;
  return fit_from(start);
}

/// Solves a linear model without a start. nullopt if the model is not linear, or fit_terms() fails.
std::optional<FoundFit> Fitter::solve(const LensCentre& centre) const {
  if (target_.terms() == 0 || !target_.shapes().empty()) return std::nullopt;
  const std::optional<Candidate> candidate = fit_terms(samples_, centre, 0.0);
  return candidate ? polisher_.finish(*candidate, samples_) : std::nullopt;
}

std::optional<FoundFit> Fitter::fit(const LensCentre& centre) {
  if (std::optional<FoundFit> solved = solve(centre)) return solved;
  std::optional<FoundFit> best = fit_starts(centre);
  // Starts with longer and shorter focal lengths are tried in two cases:
  // - The best camera has no pixel for some samples: its radius stops growing before the edge of the lens.
  // - The model has many parameters, thus many minima, and its best camera is not exact.
  constexpr double kNegligiblePx = 1e-3;
  const bool may_be_beaten = has_many_parameters(target_) && best && best->rms_px > kNegligiblePx;
  if (best && best->reaches_all && !may_be_beaten) return best;
  max_start_cost_ratio_ = std::numeric_limits<double>::infinity();
  // In the first case each start may lead to a different camera whose radius just grows far enough, so that all scales of the
  // focal lengths are tried; in the second case only the first few.
  static constexpr std::array kScales = {0.8, 0.9, 1.1, 1.25, 0.85, 0.95, 1.05, 1.15, 1.2};
  constexpr std::size_t kFewScales = 4;
  const bool misses_samples = !best || !best->reaches_all;
  for (const double scale : std::span(kScales).first(misses_samples ? kScales.size() : kFewScales)) {
    const LensCentre scaled = {{scale * centre.focal[0], scale * centre.focal[1]}, centre.point};
    const std::size_t tried_before = tried_costs_.size();
    keep_better(fit_starts(scaled), best);
    if (tried_costs_.size() == tried_before) break;  // the starts do not depend on the focal lengths
  }
  return best;
}

/// Returns the best fit from the model's starts for the given centre. nullopt if no start leads to a camera.
std::optional<FoundFit> Fitter::fit_starts(const LensCentre& centre) {
  std::optional<FoundFit> best;
  std::vector<Candidate> candidates = search_shapes(centre);
  if (candidates.empty()) candidates = coarse_fits(centre);
  if (candidates.empty()) return std::nullopt;
  polish_all(candidates, best);
  const std::optional<std::size_t> folded = target_.folded();
  if (folded && best && best->at_bound.empty() && (!is_final(*best) || have_wide_rays(samples_))) {
    // Close to the fold a few samples do not show which side is better: both sides are compared on all samples.
    Candidate start = candidates.front();
    start.values = best->parameters;
    start.cost = best->rms_px * best->rms_px;
    std::vector<Candidate> on_both_sides = {start};
    search_across_fold(*folded, on_both_sides, full_effort_);
    std::ranges::sort(on_both_sides, {}, &Candidate::cost);
    for (Candidate& candidate : on_both_sides) candidate.is_rival = true;
    polish_all(on_both_sides, best);
  }
  return best;
}

/// Polishes the candidates on all samples, in their order, and keeps the best fit. Once a fit is_final(), polishes only rivals
/// and candidates on another side of the fold.
void Fitter::polish_all(std::vector<Candidate>& candidates, std::optional<FoundFit>& best) {
  std::vector<Candidate> polished;
  for (Candidate& candidate : candidates) {
    if (best && is_final(*best) && !candidate.is_rival && !is_across_fold(candidate, polished)) continue;
    const Candidate coarse = candidate;
    if (!polisher_.polish(candidate, samples_, full_effort_)) continue;
    polisher_.respect_bounds(candidate, samples_, full_effort_);
    keep_better(polisher_.finish(candidate, samples_), best);
    polished.push_back(coarse);
    polished.push_back(candidate);
    if (move_inside(candidate) && polisher_.polish(candidate, samples_, full_effort_)) {
      polisher_.respect_bounds(candidate, samples_, full_effort_);
      keep_better(polisher_.finish(candidate, samples_), best);
    }
  }
}

/// True if the candidate may be a minimum on another side of the fold. Its cost is then less than 1.5 times that of the first
/// of `polished`, and its folded parameter differs by more than 0.3 from that of all of `polished`. `polished` holds each
/// earlier candidate twice: before and after its polish on all samples.
bool Fitter::is_across_fold(const Candidate& candidate, const std::vector<Candidate>& polished) const {
  constexpr double kComparableCostRatio = 1.5;
  constexpr double kFarApart = 0.3;
  const std::optional<std::size_t> folded = target_.folded();
  if (!folded || candidate.cost >= kComparableCostRatio * polished.front().cost) return false;
  return std::ranges::all_of(polished, [&](const Candidate& other) {
    return std::abs(other.values[*folded] - candidate.values[*folded]) > kFarApart;
  });
}

/// Moves each parameter that ended at a bound by 0.05 into its range, where another minimum may be, and frees it. False if no
/// parameter ended at a bound.
bool Fitter::move_inside(Candidate& candidate) const {
  constexpr double kInwards = 0.05;
  bool moved = false;
  for (std::size_t i = 0; i < parameter_count_; ++i) {
    if (!candidate.fixed[i] || polisher_.limits().fixed(i)) continue;
    double& value = candidate.values[i];
    const double inside = value + (value == polisher_.limits().lower[i] ? kInwards : -kInwards);
    value = std::clamp(inside, polisher_.limits().lower[i], polisher_.limits().upper[i]);
    candidate.fixed[i] = false;
    moved = true;
  }
  return moved;
}

/// Polishes the model's starts on a few samples and returns them, the lowest cost first. Returns a single start unpolished if
/// the model has many parameters and the other starts are far worse.
std::vector<Candidate> Fitter::coarse_fits(const LensCentre& centre) {
  const CoarseSettings& coarse = coarse_settings_for(target_);
  const std::span<const Correspondence> all = samples_;
  const std::vector<Correspondence> few = choose_evenly(all, coarse.samples);
  samples_ = few;
  std::vector<Candidate> starts;
  for (int i = 0; i < target_.starts(); ++i) {
    Candidate& start = starts.emplace_back();
    target_.initialise(few, centre, i, start.values.data());
    polisher_.apply_ranges(start);
    start.cost = cost_of_start(start.values);
    if (was_tried(start.cost)) starts.pop_back();
  }
  if (starts.empty()) {
    samples_ = all;
    return {};
  }
  std::ranges::sort(starts, {}, &Candidate::cost);
  std::vector<Candidate> polished;
  const double first_cost = starts.front().cost;
  if (has_many_parameters(target_) && (starts.size() == 1 || starts[1].cost > max_start_cost_ratio_ * first_cost)) {
    // Only one start is promising. It needs no comparison on a few samples, which would take half as long as the fit.
    for (const Candidate& start : std::span(starts).subspan(1)) std::erase(tried_costs_, start.cost);
    starts.resize(1);
    samples_ = all;
    return starts;
  }
  for (Candidate& start : starts) {
    // A start on one side of a fold may have a far higher cost than one on the other side, and still lead to a lower minimum.
    const std::size_t fewest = target_.folded() ? 2 : 1;
    if (polished.size() >= fewest && start.cost > max_start_cost_ratio_ * first_cost) break;
    if (!polisher_.polish(start, samples_, coarse.effort)) continue;
    polished.push_back(start);
    if (start.cost_is_complete && start.cost < kExactCost) break;
  }
  std::ranges::sort(polished, {}, &Candidate::cost);
  if (const std::optional<std::size_t> folded = target_.folded(); folded && !polished.empty()) {
    search_across_fold(*folded, polished, coarse.effort);
    std::ranges::sort(polished, {}, &Candidate::cost);
  }
  samples_ = all;
  return polished;
}

/// True if a start of the same cost has been tried already; otherwise adds the cost to tried_costs_. The starts of some models
/// do not depend on the focal length and would otherwise be tried again for each scale.
bool Fitter::was_tried(double cost) {
  constexpr double kSame = 1e-6;  // relative difference
  const auto same = [cost](double other) { return std::abs(cost - other) <= kSame * other; };
  if (std::ranges::any_of(tried_costs_, same)) return true;
  tried_costs_.push_back(cost);
  return false;
}

/// Searches for minima across the fold, starting from the first of `polished`, and appends the results to `polished`. A model
/// with a fold has a minimum on each side of it, with nearly the same cost. Each attempt changes the folded parameter by a
/// step, fits the other parameters while that one is fixed, then fits all. Ends when a result is exact.
void Fitter::search_across_fold(std::size_t folded, std::vector<Candidate>& polished, const Effort& effort) {
  constexpr double kNearlyExactCost = 1e-3;  // px^2; with a larger cost the samples are not from a lens of this model
  // The steps that succeed most often are the first. The others are tried only if the cost is at most kSmallCost, so that the
  // samples seem to be from a lens of this model.
  constexpr std::array kSteps = {0.15, -0.15, 0.4, -0.4, 0.06, -0.06, 0.02, -0.02, 0.1, -0.1, 0.03, -0.03, 0.7, -0.7};
  constexpr std::size_t kLikelySteps = 2;
  constexpr double kExactCostRatio = 1e-8;  // a minimum whose cost is below this fraction of the start's is exact
  const Candidate from = polished.front();
  if (!from.cost_is_complete || (from.cost > kNearlyExactCost && !have_wide_rays(samples_))) return;
  const double exact = std::max(kExactCost, kExactCostRatio * from.cost);
  for (std::size_t i = 0; i < kSteps.size(); ++i) {
    if (polished.back().cost <= exact || from.cost <= kExactCost) return;
    if (i >= kLikelySteps && from.cost > kSmallCost) return;
    Candidate candidate = from;
    if (candidate.fixed[folded] || !(candidate.values[folded] + kSteps[i] > polisher_.limits().lower[folded])) continue;
    candidate.values[folded] += kSteps[i];
    candidate.fixed[folded] = true;
    const bool others_fitted = polisher_.polish(candidate, samples_, effort);
    candidate.fixed[folded] = false;
    if (others_fitted && polisher_.polish(candidate, samples_, effort)) polished.push_back(candidate);
  }
}

/// The weighted sum [px^2] of the squared distances between the samples' pixels and those of a camera. A distance above
/// 1,000 px, and that of a sample without a pixel, is taken as 1,000 px.
double Fitter::cost_of_start(const ParameterValues& values) {
  constexpr double kLargestSquare = 1e6;  // px^2
  pixels_.resize(samples_.size());
  target_.pixels(values.data(), samples_, pixels_.data());
  double cost = 0.0;
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    const double du = pixels_[k][0] - samples_[k].pixel[0];
    const double dv = pixels_[k][1] - samples_[k].pixel[1];
    const double squared = du * du + dv * dv;
    cost += samples_[k].weight * (squared < kLargestSquare ? squared : kLargestSquare);
  }
  return cost;
}

/// Solves for all parameters except the shape, without a start. nullopt if a fit of the model holds a parameter, the solution
/// fails, or a parameter of the solution is outside its range.
std::optional<Candidate> Fitter::fit_terms(std::span<const Correspondence> samples, const LensCentre& centre,
                                           double shape) const {
  if (std::any_of(polisher_.limits().held.begin(),
                  polisher_.limits().held.begin() + static_cast<std::ptrdiff_t>(parameter_count_), [](bool h) { return h; }))
    return std::nullopt;
  AspectFit fit(target_.terms(), samples.size());
  std::size_t points = 0;
  for (const Correspondence& s : samples) {
    double along_u[kMostTerms];
    double along_v[kMostTerms];
    if (!target_.terms(shape, s.ray.data(), along_u, along_v)) return std::nullopt;
    fit.set(points++, along_u, along_v, {s.pixel[0] - centre.point[0], s.pixel[1] - centre.point[1]}, s.weight);
  }
  const std::optional<AspectFit::Solution> solution = fit.solve(centre.focal[1] / centre.focal[0]);
  if (!solution) return std::nullopt;
  const std::array<double, 2> point = {centre.point[0] + solution->point[0], centre.point[1] + solution->point[1]};
  Candidate candidate;
  target_.from_terms(shape, solution->coefficients.data(), solution->aspect, point, candidate.values.data());
  for (std::size_t i = 0; i < parameter_count_; ++i) {
    if (!(candidate.values[i] >= polisher_.limits().lower[i] && candidate.values[i] <= polisher_.limits().upper[i]))
      return std::nullopt;
  }
  candidate.cost = solution->cost;
  candidate.iterations = solution->iterations;
  return candidate;
}

/// A value of the model's shape, and the best camera with that shape.
struct Fitter::Trial {
  double shape = 0.0;
  std::optional<Candidate> candidate;  ///< nullopt if fit_terms() fails for the shape.

  [[nodiscard]] double cost() const { return candidate ? candidate->cost : std::numeric_limits<double>::infinity(); }
};

/// Fits the model with each of its shapes (FitTarget::shapes), then with shapes half-way between neighbours of low cost, since
/// there may be two minima between neighbours. Returns the trials in ascending order of the shape.
std::vector<Fitter::Trial> Fitter::try_shapes(std::span<const Correspondence> few, const LensCentre& centre) const {
  constexpr int kHalvings = 2;
  constexpr double kLowCostRatio = 30.0;  // to the lowest cost
  std::vector<Trial> trials;
  for (const double shape : target_.shapes()) trials.push_back({shape, fit_terms(few, centre, shape)});
  for (int halving = 0; halving < kHalvings; ++halving) {
    const double low_cost = kLowCostRatio * std::ranges::min_element(trials, {}, &Trial::cost)->cost();
    std::vector<Trial> finer;
    for (const Trial& trial : trials) {
      if (!finer.empty() && std::min(finer.back().cost(), trial.cost()) < low_cost) {
        const double between = 0.5 * (finer.back().shape + trial.shape);
        finer.push_back({between, fit_terms(few, centre, between)});
      }
      finer.push_back(trial);
    }
    trials = std::move(finer);
  }
  return trials;
}

/// Finds the minimum between the neighbours of a trial by golden-section search. Each step tries a shape in the longer of the
/// two intervals beside the best shape.
Fitter::Trial Fitter::refine_minimum(std::span<const Trial> trials, std::size_t index, std::span<const Correspondence> few,
                                     const LensCentre& centre) const {
  constexpr int kSections = 10;
  constexpr double kGolden = 0.381966011250105;
  Trial best = trials[index];
  double low = trials[index > 0 ? index - 1 : index].shape;
  double high = trials[std::min(index + 1, trials.size() - 1)].shape;
  for (int i = 0; i < kSections; ++i) {
    const double at = best.shape;
    const double next = high - at > at - low ? at + kGolden * (high - at) : at - kGolden * (at - low);
    Trial trial{next, fit_terms(few, centre, next)};
    if (trial.cost() < best.cost()) {
      (next > at ? low : high) = at;
      best = trial;
    } else {
      (next > at ? high : low) = next;
    }
  }
  return best;
}

/// Finds minima of the cost on a few samples as a function of the shape alone: the other parameters are the best ones for each
/// shape (variable projection: Golub & Pereyra 1973). A descent in all parameters would need many steps through a narrow valley
/// to these minima. Returns at most 3 of them, the lowest first; empty if the model has no shape.
std::vector<Candidate> Fitter::search_shapes(const LensCentre& centre) {
  constexpr std::size_t kFewSamples = 48;
  constexpr std::size_t kMostMinima = 3;
  if (target_.shapes().empty()) return {};
  const std::vector<Correspondence> few = choose_evenly(samples_, kFewSamples);
  const std::vector<Trial> trials = try_shapes(few, centre);
  std::vector<std::size_t> minima;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const bool falls = i == 0 || trials[i].cost() < trials[i - 1].cost();
    const bool rises = i + 1 == trials.size() || trials[i].cost() <= trials[i + 1].cost();
    if (trials[i].candidate && falls && rises) minima.push_back(i);
  }
  std::ranges::sort(minima, {}, [&](std::size_t i) { return trials[i].cost(); });
  minima.resize(std::min(minima.size(), kMostMinima));
  std::vector<Trial> found;
  for (const std::size_t minimum : minima) {
    Trial& trial = found.emplace_back(refine_minimum(trials, minimum, few, centre));
    polisher_.apply_ranges(*trial.candidate);
    // The costs of two minima may differ by less than the search's remaining error.
    if (minima.size() > 1) polisher_.polish(*trial.candidate, few, kCoarse.effort);
  }
  std::ranges::sort(found, {}, &Trial::cost);
  rank_rivals(centre, found);
  std::vector<Candidate> candidates;
  candidates.reserve(found.size());
  for (const Trial& trial : found) candidates.push_back(*trial.candidate);
  return candidates;
}

/// Sorts the minima with less than 4 times the lowest cost by their cost on all samples, and marks those within 1.3 times the
/// lowest as rivals. Errors change fastest at the lens's edge, where the few samples are too sparse. Does nothing if the lowest
/// cost is at most kSmallCost.
void Fitter::rank_rivals(const LensCentre& centre, std::vector<Trial>& found) const {
  constexpr double kComparableCostRatio = 4.0;
  const auto is_comparable = [&found](const Trial& trial) {
    return trial.cost() < kComparableCostRatio * found.front().cost();
  };
  const std::span<Trial> rivals(found.begin(), std::ranges::find_if_not(found, is_comparable));
  if (rivals.size() < 2 || !(found.front().cost() > kSmallCost)) return;
  for (Trial& trial : rivals) {
    const std::optional<Candidate> refitted = fit_terms(samples_, centre, trial.shape);
    if (!refitted) return;
    trial.candidate = refitted;
  }
  std::ranges::sort(rivals, {}, &Trial::cost);
  constexpr double kRivalCostRatio = 1.3;
  for (Trial& trial : rivals.subspan(1)) trial.candidate->is_rival = trial.cost() < kRivalCostRatio * rivals.front().cost();
}

std::optional<FoundFit> fit_target(const FitTarget& target, std::span<const Correspondence> samples, const LensCentre& centre,
                                   std::span<const ParameterRange> ranges) {
  return Fitter(target, samples, ranges).fit(centre);
}

}  // namespace fca::internal
