// SPDX-License-Identifier: BSD-3-Clause
#include "fitter.h"

#include "aspect_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fca::internal {

namespace {

/// Effort of a fit to all samples: it ends when a step reduces the cost, a mean square, by less than this fraction. The last
/// steps of a model with many parameters follow flat valleys in which the rms hardly changes, so that they end earlier.
constexpr Effort kFull{200, 1e-9};
constexpr Effort kFullOfMany{200, 1e-6};

/// The number of samples on which a start is polished, and the effort. With as many parameters as rational has, it shows late,
/// and only on many samples, which minimum is lower.
struct Coarse {
  Effort effort;
  std::size_t samples;
};
constexpr Coarse kCoarse{{30, 1e-4}, 32};
constexpr Coarse kCoarseOfMany{{60, 1e-6}, 100};

const Coarse& coarse_for(const FitTarget& target) { return has_many_parameters(target) ? kCoarseOfMany : kCoarse; }

constexpr double kKnown = 1e-8;  // A minimum whose cost is below this fraction of another's counts as exact.

/// True if `a` is the better fit. One that reaches all samples may have up to kWorth times the rms of one that does not.
bool is_better(const FoundFit& a, const FoundFit& b) {
  constexpr double kWorth = 4.0;
  if (a.reaches_all == b.reaches_all) return a.rms_px < b.rms_px;
  return a.reaches_all ? a.rms_px <= kWorth * b.rms_px : kWorth * a.rms_px < b.rms_px;
}

void keep_better(std::optional<FoundFit> fit, std::optional<FoundFit>& best) {
  if (fit && (!best || is_better(*fit, *best))) best = std::move(fit);
}

/// True if a ray is more than 120 degrees from the axis. The image radius of such lenses hardly grows at the edge, and a model
/// with a fold then has a minimum on either side of it, whatever the error.
bool are_wide(std::span<const Correspondence> samples) {
  constexpr double kWideCosine = -0.5;
  return std::ranges::any_of(samples, [](const Correspondence& s) { return s.ray[2] < kWideCosine; });
}

/// True if no other start would lead to a better fit. One may if a parameter ended at a bound, because the minimum then lies
/// outside. It may also if the cost is small but not 0: then another minimum is probably exact, and looked no better on few
/// samples.
bool settled(const FoundFit& fit) {
  const double cost = fit.rms_px * fit.rms_px;
  return fit.at_bound.empty() && fit.reaches_all && !(cost > kExactCost && cost < kSmallCost);
}

}  // namespace

std::vector<Correspondence> spread(std::span<const Correspondence> samples, std::size_t count) {
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
      count_(target.parameters().size()),
      full_(has_many_parameters(target) ? kFullOfMany : kFull),
      samples_(samples),
      polisher_(target, ranges) {}

std::optional<FoundFit> Fitter::fit_from(const ParameterValues& start) {
  Candidate candidate;
  candidate.values = start;
  polisher_.hold_fixed(candidate);
  if (!polisher_.polish(candidate, samples_, full_)) return std::nullopt;
  polisher_.respect_bounds(candidate, samples_, full_);
  return polisher_.finish(candidate, samples_);
}

std::optional<FoundFit> Fitter::as_it_is(const ParameterValues& values) const {
  Candidate candidate;
  candidate.values = values;
  candidate.on_all = false;  // there is no cost yet
  polisher_.hold_fixed(candidate);
  if (candidate.values != values) return std::nullopt;
  const FitLimits& limits = polisher_.limits();
  for (std::size_t i = 0; i < count_; ++i)
    candidate.fixed[i] = candidate.fixed[i] || values[i] == limits.lower[i] || values[i] == limits.upper[i];
  return polisher_.finish(candidate, samples_);
}

std::optional<FoundFit> Fitter::refit(const ParameterValues& start, const LensCentre& centre) {
  if (std::optional<FoundFit> solved = solve(centre)) return solved;
  return fit_from(start);
}

/// Solves a linear model without a start; nullopt if the model is not linear.
std::optional<FoundFit> Fitter::solve(const LensCentre& centre) const {
  if (target_.terms() == 0 || !target_.shapes().empty()) return std::nullopt;
  const std::optional<Candidate> candidate = fit_terms(samples_, centre, 0.0);
  return candidate ? polisher_.finish(*candidate, samples_) : std::nullopt;
}

std::optional<FoundFit> Fitter::fit(const LensCentre& centre) {
  if (std::optional<FoundFit> solved = solve(centre)) return solved;
  std::optional<FoundFit> best = fit_starts(centre);
  // Longer and shorter focal lengths are tried as starts in two cases: the radius of the best camera turns back before the edge
  // of the lens, or the model has many parameters, and with them many minima.
  constexpr double kNobodySees = 1e-3;  // px
  const bool may_be_beaten = has_many_parameters(target_) && best && best->rms_px > kNobodySees;
  if (best && best->reaches_all && !may_be_beaten) return best;
  hopeless_ = std::numeric_limits<double>::infinity();
  // Where the radius turns back, each start may lead to another camera whose radius just does not. Then all scales are tried,
  // otherwise the first kFew.
  static constexpr std::array kScales = {0.8, 0.9, 1.1, 1.25, 0.85, 0.95, 1.05, 1.15, 1.2};
  constexpr std::size_t kFew = 4;
  const bool folds = !best || !best->reaches_all;
  for (const double scale : std::span(kScales).first(folds ? kScales.size() : kFew)) {
    const LensCentre other = {{scale * centre.focal[0], scale * centre.focal[1]}, centre.point};
    const std::size_t tried = tried_.size();
    keep_better(fit_starts(other), best);
    if (tried_.size() == tried) break;
  }
  return best;
}

/// The best fit from the starts for that centre; nullopt if none leads to a camera.
std::optional<FoundFit> Fitter::fit_starts(const LensCentre& centre) {
  std::optional<FoundFit> best;
  std::vector<Candidate> candidates = search_shapes(centre);
  if (candidates.empty()) candidates = coarse_fits(centre);
  if (candidates.empty()) return std::nullopt;
  polish_all(candidates, best);
  const std::optional<std::size_t> folded = target_.folded();
  if (folded && best && best->at_bound.empty() && (!settled(*best) || are_wide(samples_))) {
    // Close to the fold a few samples do not show which side is better.
    Candidate found = candidates.front();
    found.values = best->parameters;
    found.cost = best->rms_px * best->rms_px;
    std::vector<Candidate> beyond = {found};
    look_beyond_fold(*folded, beyond, full_);
    std::ranges::sort(beyond, {}, &Candidate::cost);
    for (Candidate& candidate : beyond) candidate.is_rival = true;
    polish_all(beyond, best);
  }
  return best;
}

/// Fits to all samples from the candidates, until no other candidate can be better.
void Fitter::polish_all(std::vector<Candidate>& candidates, std::optional<FoundFit>& best) {
  std::vector<Candidate> polished;
  for (Candidate& candidate : candidates) {
    if (best && settled(*best) && !candidate.is_rival && !is_across_fold(candidate, polished)) continue;
    const Candidate coarse = candidate;
    if (!polisher_.polish(candidate, samples_, full_)) continue;
    polisher_.respect_bounds(candidate, samples_, full_);
    keep_better(polisher_.finish(candidate, samples_), best);
    polished.push_back(coarse);
    polished.push_back(candidate);
    if (move_inside(candidate) && polisher_.polish(candidate, samples_, full_)) {
      polisher_.respect_bounds(candidate, samples_, full_);
      keep_better(polisher_.finish(candidate, samples_), best);
    }
  }
}

/// True if the candidate is about as good as the first one and lies on another side of the fold than all polished ones, before
/// and after their polish.
bool Fitter::is_across_fold(const Candidate& candidate, const std::vector<Candidate>& polished) const {
  constexpr double kAboutAsGood = 1.5;
  constexpr double kFarAway = 0.3;
  const std::optional<std::size_t> folded = target_.folded();
  if (!folded || candidate.cost >= kAboutAsGood * polished.front().cost) return false;
  return std::ranges::all_of(
      polished, [&](const Candidate& other) { return std::abs(other.values[*folded] - candidate.values[*folded]) > kFarAway; });
}

/// Moves parameters that ended at a bound a little inside, where there may be another minimum. False if none is at a bound.
bool Fitter::move_inside(Candidate& candidate) const {
  constexpr double kALittle = 0.05;
  bool moved = false;
  for (std::size_t i = 0; i < count_; ++i) {
    if (!candidate.fixed[i] || polisher_.limits().fixed(i)) continue;
    double& value = candidate.values[i];
    const double inside = value + (value == polisher_.limits().lower[i] ? kALittle : -kALittle);
    value = std::clamp(inside, polisher_.limits().lower[i], polisher_.limits().upper[i]);
    candidate.fixed[i] = false;
    moved = true;
  }
  return moved;
}

/// The model's starts, polished on a few samples, the best first.
std::vector<Candidate> Fitter::coarse_fits(const LensCentre& centre) {
  const Coarse& coarse = coarse_for(target_);
  const std::span<const Correspondence> all = samples_;
  const std::vector<Correspondence> few = spread(all, coarse.samples);
  samples_ = few;
  std::vector<Candidate> starts;
  for (int i = 0; i < target_.starts(); ++i) {
    Candidate& start = starts.emplace_back();
    target_.initialise(few, centre, i, start.values.data());
    polisher_.hold_fixed(start);
    start.cost = cost_of_start(start.values);
    if (is_known(start.cost)) starts.pop_back();
  }
  if (starts.empty()) {
    samples_ = all;
    return {};
  }
  std::ranges::sort(starts, {}, &Candidate::cost);
  std::vector<Candidate> polished;
  const double first_cost = starts.front().cost;
  if (has_many_parameters(target_) && (starts.size() == 1 || starts[1].cost > hopeless_ * first_cost)) {
    // Only one start is promising. A polish on so many samples takes half as long as the fit, so that it is omitted.
    for (const Candidate& start : std::span(starts).subspan(1)) std::erase(tried_, start.cost);
    starts.resize(1);
    samples_ = all;
    return starts;
  }
  for (Candidate& start : starts) {
    // A start on one side of a fold may look hopeless compared to one on the other side.
    const std::size_t fewest = target_.folded() ? 2 : 1;
    if (polished.size() >= fewest && start.cost > hopeless_ * first_cost) break;
    if (!polisher_.polish(start, samples_, coarse.effort)) continue;
    polished.push_back(start);
    if (start.on_all && start.cost < kExactCost) break;
  }
  std::ranges::sort(polished, {}, &Candidate::cost);
  if (const std::optional<std::size_t> folded = target_.folded(); folded && !polished.empty()) {
    look_beyond_fold(*folded, polished, coarse.effort);
    std::ranges::sort(polished, {}, &Candidate::cost);
  }
  samples_ = all;
  return polished;
}

/// True if a start of that cost has been tried; otherwise remembers it. The starts of some models do not depend on the focal
/// length, and would be tried again for each scale.
bool Fitter::is_known(double cost) {
  constexpr double kSame = 1e-6;
  const auto same = [cost](double other) { return std::abs(cost - other) <= kSame * other; };
  if (std::ranges::any_of(tried_, same)) return true;
  tried_.push_back(cost);
  return false;
}

/// A model with a fold has a minimum on each side of it, with nearly the same cost. To cross over, the folded parameter is
/// changed by a step and held while the others are fitted, then all are fitted.
void Fitter::look_beyond_fold(std::size_t folded, std::vector<Candidate>& polished, const Effort& effort) {
  constexpr double kNearlyExact = 1e-3;  // px^2; above it the samples are not from a lens of this model
  // The steps that most often succeed come first. The others are tried only where the cost is so small that the samples seem to
  // be from a lens of this model.
  constexpr std::array kSteps = {0.15, -0.15, 0.4, -0.4, 0.06, -0.06, 0.02, -0.02, 0.1, -0.1, 0.03, -0.03, 0.7, -0.7};
  constexpr std::size_t kLikely = 2;
  const Candidate from = polished.front();
  if (!from.on_all || (from.cost > kNearlyExact && !are_wide(samples_))) return;
  const double exact = std::max(kExactCost, kKnown * from.cost);
  for (std::size_t i = 0; i < kSteps.size(); ++i) {
    if (polished.back().cost <= exact || from.cost <= kExactCost) return;
    if (i >= kLikely && from.cost > kSmallCost) return;
    Candidate candidate = from;
    if (candidate.fixed[folded] || !(candidate.values[folded] + kSteps[i] > polisher_.limits().lower[folded])) continue;
    candidate.values[folded] += kSteps[i];
    candidate.fixed[folded] = true;
    const bool followed = polisher_.polish(candidate, samples_, effort);
    candidate.fixed[folded] = false;
    if (followed && polisher_.polish(candidate, samples_, effort)) polished.push_back(candidate);
  }
}

/// Mean squared distance [px^2]. A sample without a pixel, or more than 1,000 px away, counts as 1,000 px.
double Fitter::cost_of_start(const ParameterValues& values) {
  constexpr double kMissed = 1e6;  // px^2
  pixels_.resize(samples_.size());
  target_.pixels(values.data(), samples_, pixels_.data());
  double cost = 0.0;
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    const double du = pixels_[k][0] - samples_[k].pixel[0];
    const double dv = pixels_[k][1] - samples_[k].pixel[1];
    const double squared = du * du + dv * dv;
    cost += samples_[k].weight * (squared < kMissed ? squared : kMissed);
  }
  return cost;
}

/// Solves for all parameters but the shape, without a start; nullopt if a parameter is held or ends outside its range, or the
/// solution fails.
std::optional<Candidate> Fitter::fit_terms(std::span<const Correspondence> samples, const LensCentre& centre,
                                           double shape) const {
  if (std::any_of(polisher_.limits().held.begin(), polisher_.limits().held.begin() + static_cast<std::ptrdiff_t>(count_),
                  [](bool h) { return h; }))
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
  for (std::size_t i = 0; i < count_; ++i) {
    if (!(candidate.values[i] >= polisher_.limits().lower[i] && candidate.values[i] <= polisher_.limits().upper[i]))
      return std::nullopt;
  }
  candidate.cost = solution->cost;
  candidate.iterations = solution->iterations;
  return candidate;
}

/// A shape, and the best camera with that shape on a few samples; nullopt if there is none.
struct Fitter::Trial {
  double shape = 0.0;
  std::optional<Candidate> candidate;

  [[nodiscard]] double cost() const { return candidate ? candidate->cost : std::numeric_limits<double>::infinity(); }
};

/// Tries the model's shapes, and further ones between neighbours of low cost, since two minima may lie between neighbours.
std::vector<Fitter::Trial> Fitter::try_shapes(std::span<const Correspondence> few, const LensCentre& centre) const {
  constexpr int kHalvings = 2;
  constexpr double kLow = 30.0;  // times the lowest cost
  std::vector<Trial> trials;
  for (const double shape : target_.shapes()) trials.push_back({shape, fit_terms(few, centre, shape)});
  for (int halving = 0; halving < kHalvings; ++halving) {
    const double low = kLow * std::ranges::min_element(trials, {}, &Trial::cost)->cost();
    std::vector<Trial> finer;
    for (const Trial& trial : trials) {
      if (!finer.empty() && std::min(finer.back().cost(), trial.cost()) < low) {
        const double between = 0.5 * (finer.back().shape + trial.shape);
        finer.push_back({between, fit_terms(few, centre, between)});
      }
      finer.push_back(trial);
    }
    trials = std::move(finer);
  }
  return trials;
}

/// The minimum between a trial's neighbours, by golden-section search: each step divides the longer side.
Fitter::Trial Fitter::refine_minimum(std::span<const Trial> trials, std::size_t at_trial, std::span<const Correspondence> few,
                                     const LensCentre& centre) const {
  constexpr int kSections = 10;
  constexpr double kGolden = 0.381966011250105;
  Trial best = trials[at_trial];
  double low = trials[at_trial > 0 ? at_trial - 1 : at_trial].shape;
  double high = trials[std::min(at_trial + 1, trials.size() - 1)].shape;
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

/// The minima of the cost as a function of the shape, with the best other parameters for each shape (variable projection: Golub
/// & Pereyra 1973), on a few samples, the best first. A descent in all parameters finds them only after many steps through a
/// narrow valley. Empty if the model has no shape.
std::vector<Candidate> Fitter::search_shapes(const LensCentre& centre) {
  constexpr std::size_t kSamples = 48;
  constexpr std::size_t kMostMinima = 3;
  if (target_.shapes().empty()) return {};
  const std::vector<Correspondence> few = spread(samples_, kSamples);
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
    polisher_.hold_fixed(*trial.candidate);
    // The costs of two minima may differ by less than the search leaves of each.
    if (minima.size() > 1) polisher_.polish(*trial.candidate, few, kCoarse.effort);
  }
  std::ranges::sort(found, {}, &Trial::cost);
  rank_rivals(centre, found);
  std::vector<Candidate> candidates;
  candidates.reserve(found.size());
  for (const Trial& trial : found) candidates.push_back(*trial.candidate);
  return candidates;
}

/// Ranks minima of nearly the same cost by their cost on all samples. Errors change fastest at the lens's edge, where the few
/// samples are too sparse.
void Fitter::rank_rivals(const LensCentre& centre, std::vector<Trial>& found) const {
  constexpr double kAboutAsDeep = 4.0;
  const auto is_rival = [&found](const Trial& trial) { return trial.cost() < kAboutAsDeep * found.front().cost(); };
  const auto others = std::ranges::find_if_not(found, is_rival);
  const std::span<Trial> rivals(found.begin(), others);
  if (rivals.size() < 2 || !(found.front().cost() > kSmallCost)) return;
  for (Trial& trial : rivals) {
    const std::optional<Candidate> on_all = fit_terms(samples_, centre, trial.shape);
    if (!on_all) return;
    trial.candidate = on_all;
  }
  std::ranges::sort(rivals, {}, &Trial::cost);
  constexpr double kTooCloseToTell = 1.3;
  for (Trial& trial : rivals.subspan(1)) trial.candidate->is_rival = trial.cost() < kTooCloseToTell * rivals.front().cost();
}

std::optional<FoundFit> fit_target(const FitTarget& target, std::span<const Correspondence> samples, const LensCentre& centre,
                                   std::span<const ParameterRange> ranges) {
  return Fitter(target, samples, ranges).fit(centre);
}

}  // namespace fca::internal
