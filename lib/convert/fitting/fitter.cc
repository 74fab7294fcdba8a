// SPDX-License-Identifier: BSD-3-Clause
#include "fitter.h"

#include "aspect_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fca::internal {

namespace {

/// Whoever looks at a thousandth of the error looks at a millionth of its square. The last steps of a model with many
/// parameters lead along valleys in which nobody sees a difference.
constexpr Effort kFull{200, 1e-9};
constexpr Effort kFullOfMany{200, 1e-6};

/// How many of the samples a start is polished on, and how far. Which basin is deeper shows late, and only on many points,
/// where parameters are as many as rational's.
struct Coarse {
  Effort effort;
  std::size_t samples;
};
constexpr Coarse kCoarse{{30, 1e-4}, 32};
constexpr Coarse kCoarseOfMany{{60, 1e-6}, 100};

const Coarse& coarse_for(const FitTarget& target) { return has_many_parameters(target) ? kCoarseOfMany : kCoarse; }

constexpr double kKnown = 1e-8;  // Of another bottom's cost: this one is the lens.

/// To reach all of the lens is worth some pixels, but not a useless camera.
bool is_better(const FoundFit& a, const FoundFit& b) {
  constexpr double kWorth = 4.0;
  if (a.reaches_all == b.reaches_all) return a.rms_px < b.rms_px;
  return a.reaches_all ? a.rms_px <= kWorth * b.rms_px : kWorth * a.rms_px < b.rms_px;
}

void keep_better(std::optional<FoundFit> fit, std::optional<FoundFit>& best) {
  if (fit && (!best || is_better(*fit, *best))) best = std::move(fit);
}

/// Beyond this angle, lenses whose radius all but stops growing, a fold has a bottom on either side, whatever the error there.
bool are_wide(std::span<const Correspondence> samples) {
  constexpr double kWideCosine = -0.5;
  return std::ranges::any_of(samples, [](const Correspondence& s) { return s.ray[2] < kWideCosine; });
}

/// Would no other start be better? One may be where a parameter ends at a bound, as the basin's bottom lies beyond it; and
/// where next to nothing is left, but not nothing: then another basin holds the very lens, and looked as good on few samples.
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

/// Nothing if the model is not linear.
std::optional<FoundFit> Fitter::solve(const LensCentre& centre) const {
  if (target_.terms() == 0 || !target_.shapes().empty()) return std::nullopt;
  const std::optional<Candidate> candidate = fit_terms(samples_, centre, 0.0);
  return candidate ? polisher_.finish(*candidate, samples_) : std::nullopt;
}

std::optional<FoundFit> Fitter::fit(const LensCentre& centre) {
  if (std::optional<FoundFit> solved = solve(centre)) return solved;
  std::optional<FoundFit> best = fit_starts(centre);
  // Two more reasons to begin from longer and shorter lenses: the optimum's radius may turn back before the edge of this one,
  // and many parameters have many bottoms.
  constexpr double kNobodySees = 1e-3;  // px
  const bool may_be_beaten = has_many_parameters(target_) && best && best->rms_px > kNobodySees;
  if (best && best->reaches_all && !may_be_beaten) return best;
  hopeless_ = std::numeric_limits<double>::infinity();
  // Where the radius turns back, a fit ends wherever it just does not: closer to each other.
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

/// The best fit from the starts with that centre.
std::optional<FoundFit> Fitter::fit_starts(const LensCentre& centre) {
  std::optional<FoundFit> best;
  std::vector<Candidate> candidates = search_shapes(centre);
  if (candidates.empty()) candidates = coarse_fits(centre);
  if (candidates.empty()) return std::nullopt;
  polish_all(candidates, best);
  const std::optional<std::size_t> folded = target_.folded();
  if (folded && best && best->at_bound.empty() && (!settled(*best) || are_wide(samples_))) {
    // Close to the fold a few samples do not tell its sides apart.
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

/// Fits from the candidates until no other can be better.
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

/// Is it about as good as the first one and on another side of the fold than all that were polished, before or after?
bool Fitter::is_across_fold(const Candidate& candidate, const std::vector<Candidate>& polished) const {
  constexpr double kAboutAsGood = 1.5;
  constexpr double kFarAway = 0.3;
  const std::optional<std::size_t> folded = target_.folded();
  if (!folded || candidate.cost >= kAboutAsGood * polished.front().cost) return false;
  return std::ranges::all_of(
      polished, [&](const Candidate& other) { return std::abs(other.values[*folded] - candidate.values[*folded]) > kFarAway; });
}

/// From a bound that holds parameters a little way back inside, where they may find a bottom of their own. False if none is
/// held.
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

/// The model's starts, polished on a few of the samples, best first.
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
    // Nothing to choose from, and a polish on so many samples is half of the fit.
    for (const Candidate& start : std::span(starts).subspan(1)) std::erase(tried_, start.cost);
    starts.resize(1);
    samples_ = all;
    return starts;
  }
  for (Candidate& start : starts) {
    // On one side of a fold a start may look hopeless beside one on the other.
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

/// Has a start of that cost been tried? Not every model's starts depend on the focal length of the centre.
bool Fitter::is_known(double cost) {
  constexpr double kSame = 1e-6;
  const auto same = [cost](double other) { return std::abs(cost - other) <= kSame * other; };
  if (std::ranges::any_of(tried_, same)) return true;
  tried_.push_back(cost);
  return false;
}

/// A model with a fold has two bottoms that differ by little, one on each side of it. Along the valley, where the folded
/// parameter is set and the others follow, the way leads across.
void Fitter::look_beyond_fold(std::size_t folded, std::vector<Candidate>& polished, const Effort& effort) {
  constexpr double kNearlyExact = 1e-3;  // px^2: worse, and no lens of this model is behind the samples
  // The most likely ones first; the others where a lens of this model seems to be.
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

/// Mean squared distance, one that is missed counting as much as a wide image.
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

/// Without a start, where the model is linear enough and no range of a parameter gets in the way.
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

/// The best of all other parameters for a shape.
struct Fitter::Trial {
  double shape = 0.0;
  std::optional<Candidate> candidate;

  [[nodiscard]] double cost() const { return candidate ? candidate->cost : std::numeric_limits<double>::infinity(); }
};

/// The model's shapes, closer to each other where the cost is low: two bottoms may lie between neighbours.
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

/// The bottom next to a trial, between its neighbours: by the golden section, the longer side of what is left is divided.
Fitter::Trial Fitter::bottom_near(std::span<const Trial> trials, std::size_t at_trial, std::span<const Correspondence> few,
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

/// The bottoms along the shape, with the best of all other parameters for each (variable projection: Golub & Pereyra 1973), on
/// a few of the samples, best first: what a descent in all parameters finds only by a long way through a narrow valley.
std::vector<Candidate> Fitter::search_shapes(const LensCentre& centre) {
  constexpr std::size_t kSamples = 48;
  constexpr std::size_t kMostBottoms = 3;
  if (target_.shapes().empty()) return {};
  const std::vector<Correspondence> few = spread(samples_, kSamples);
  const std::vector<Trial> trials = try_shapes(few, centre);
  std::vector<std::size_t> bottoms;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const bool falls = i == 0 || trials[i].cost() < trials[i - 1].cost();
    const bool rises = i + 1 == trials.size() || trials[i].cost() <= trials[i + 1].cost();
    if (trials[i].candidate && falls && rises) bottoms.push_back(i);
  }
  std::ranges::sort(bottoms, {}, [&](std::size_t i) { return trials[i].cost(); });
  bottoms.resize(std::min(bottoms.size(), kMostBottoms));
  std::vector<Trial> found;
  for (const std::size_t bottom : bottoms) {
    Trial& trial = found.emplace_back(bottom_near(trials, bottom, few, centre));
    polisher_.hold_fixed(*trial.candidate);
    // Bottoms differ by less than what the search leaves of each.
    if (bottoms.size() > 1) polisher_.polish(*trial.candidate, few, kCoarse.effort);
  }
  std::ranges::sort(found, {}, &Trial::cost);
  rank_rivals(centre, found);
  std::vector<Candidate> candidates;
  candidates.reserve(found.size());
  for (const Trial& trial : found) candidates.push_back(*trial.candidate);
  return candidates;
}

/// Of bottoms that are about as deep on a few samples all tell which is the deepest: where errors bend, at the lens's edge,
/// there are few of the few.
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
