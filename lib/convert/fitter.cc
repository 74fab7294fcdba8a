// SPDX-License-Identifier: BSD-3-Clause
#include "fitter.h"

#include "aspect_fit.h"
#include "products.h"

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
constexpr std::size_t kManyParameters = 11;

bool has_many_parameters(const FitTarget& target) { return target.parameters().size() >= kManyParameters; }

const Coarse& coarse_for(const FitTarget& target) { return has_many_parameters(target) ? kCoarseOfMany : kCoarse; }

/// Below this, in px^2, what is left is worth a second look; below that, there is nothing.
constexpr double kSmallCost = 1e-6;
constexpr double kExactCost = 1e-22;
constexpr double kKnown = 1e-8;  // Of another bottom's cost: this one is the lens.
constexpr double kWorthwhile = 0.9;

/// To reach all of the lens is worth some pixels, but not a useless camera.
bool is_better(const FoundFit& a, const FoundFit& b) {
  constexpr double kWorth = 4.0;
  if (a.reaches_all == b.reaches_all) return a.rms_px < b.rms_px;
  return a.reaches_all ? a.rms_px <= kWorth * b.rms_px : kWorth * a.rms_px < b.rms_px;
}

void keep_better(FoundFit fit, std::optional<FoundFit>& best) {
  if (!best || is_better(fit, *best)) best = std::move(fit);
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
      linearised_(target),
      limits_(target, ranges) {}

std::optional<FoundFit> Fitter::fit_from(const ParameterValues& start) {
  Candidate candidate;
  candidate.values = start;
  hold_fixed(candidate);
  if (!polish(candidate, full_)) return std::nullopt;
  respect_bounds(candidate);
  return finish(candidate);
}

std::optional<FoundFit> Fitter::as_it_is(const ParameterValues& values) const {
  Candidate candidate;
  candidate.values = values;
  candidate.on_all = false;  // there is no cost yet
  hold_fixed(candidate);
  if (candidate.values != values) return std::nullopt;
  return finish(candidate);
}

std::optional<FoundFit> Fitter::fit(const LensCentre& centre) {
  if (target_.terms() > 0 && target_.shapes().empty()) {
    if (const std::optional<Candidate> candidate = fit_terms(samples_, centre, 0.0)) return finish(*candidate);
  }
  std::optional<FoundFit> best = fit_starts(centre);
  // Two more reasons to begin from longer and shorter lenses: the optimum's radius may turn back before the edge of this one,
  // and many parameters have many bottoms.
  constexpr double kNobodySees = 1e-3;  // px
  const bool may_be_beaten = has_many_parameters(target_) && best && best->rms_px > kNobodySees;
  if (best && best->reaches_all && !may_be_beaten) return best;
  for (const double scale : {0.8, 0.9, 1.1, 1.25}) {
    const LensCentre other = {{scale * centre.focal[0], scale * centre.focal[1]}, centre.point};
    const std::size_t tried = tried_.size();
    if (std::optional<FoundFit> fit = fit_starts(other)) keep_better(*std::move(fit), best);
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
  if (folded && best && !settled(*best) && best->at_bound.empty()) {
    // Close to the fold a few samples do not tell its sides apart.
    Candidate found = candidates.front();
    found.values = best->parameters;
    found.cost = best->rms_px * best->rms_px;
    std::vector<Candidate> beyond = {found};
    look_beyond_fold(*folded, beyond, full_);
    std::ranges::sort(beyond, {}, &Candidate::cost);
    polish_all(beyond, best);
  }
  return best;
}

void Fitter::hold_fixed(Candidate& candidate) const {
  for (std::size_t i = 0; i < count_; ++i) {
    candidate.fixed[i] = limits_.fixed(i);
    candidate.values[i] = std::clamp(candidate.values[i], limits_.lower[i], limits_.upper[i]);
  }
}

/// Fits from the candidates until no other can be better.
void Fitter::polish_all(std::vector<Candidate>& candidates, std::optional<FoundFit>& best) {
  std::vector<Candidate> polished;
  for (Candidate& candidate : candidates) {
    if (best && settled(*best) && !is_rival(candidate, polished)) continue;
    const Candidate coarse = candidate;
    if (!polish(candidate, full_)) continue;
    respect_bounds(candidate);
    keep_better(finish(candidate), best);
    polished.push_back(coarse);
    polished.push_back(candidate);
    if (move_inside(candidate) && polish(candidate, full_)) {
      respect_bounds(candidate);
      keep_better(finish(candidate), best);
    }
  }
}

/// Is it about as good as the first one and on another side of the fold than all that were polished, before or after?
bool Fitter::is_rival(const Candidate& candidate, const std::vector<Candidate>& polished) const {
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
    if (!candidate.fixed[i] || limits_.fixed(i)) continue;
    double& value = candidate.values[i];
    const double inside = value + (value == limits_.lower[i] ? kALittle : -kALittle);
    value = std::clamp(inside, limits_.lower[i], limits_.upper[i]);
    candidate.fixed[i] = false;
    moved = true;
  }
  return moved;
}

/// The model's starts, polished on a few of the samples, best first.
std::vector<Fitter::Candidate> Fitter::coarse_fits(const LensCentre& centre) {
  const Coarse& coarse = coarse_for(target_);
  const std::span<const Correspondence> all = samples_;
  const std::vector<Correspondence> few = spread(all, coarse.samples);
  samples_ = few;
  std::vector<Candidate> starts;
  for (int i = 0; i < target_.starts(); ++i) {
    Candidate& start = starts.emplace_back();
    target_.initialise(few, centre, i, start.values.data());
    hold_fixed(start);
    start.cost = cost_of_start(start.values);
    if (is_known(start.cost)) starts.pop_back();
  }
  if (starts.empty()) {
    samples_ = all;
    return {};
  }
  std::ranges::sort(starts, {}, &Candidate::cost);
  std::vector<Candidate> polished;
  // Far worse than the best start: not even the right basin's edge.
  constexpr double kHopeless = 400.0;
  const double first_cost = starts.front().cost;
  if (has_many_parameters(target_) && (starts.size() == 1 || starts[1].cost > kHopeless * first_cost)) {
    // Nothing to choose from, and a polish on so many samples is half of the fit.
    starts.resize(1);
    samples_ = all;
    return starts;
  }
  for (Candidate& start : starts) {
    // On one side of a fold a start may look hopeless beside one on the other.
    const std::size_t fewest = target_.folded() ? 2 : 1;
    if (polished.size() >= fewest && start.cost > kHopeless * first_cost) break;
    if (!polish(start, coarse.effort)) continue;
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
  if (!from.on_all || from.cost > kNearlyExact) return;
  const double exact = std::max(kExactCost, kKnown * from.cost);
  for (std::size_t i = 0; i < kSteps.size(); ++i) {
    if (polished.back().cost <= exact || from.cost <= kExactCost) return;
    if (i >= kLikely && from.cost > kSmallCost) return;
    Candidate candidate = from;
    if (candidate.fixed[folded] || !(candidate.values[folded] + kSteps[i] > limits_.lower[folded])) continue;
    candidate.values[folded] += kSteps[i];
    candidate.fixed[folded] = true;
    const bool followed = polish(candidate, effort);
    candidate.fixed[folded] = false;
    if (followed && polish(candidate, effort)) polished.push_back(candidate);
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
std::optional<Fitter::Candidate> Fitter::fit_terms(std::span<const Correspondence> samples, const LensCentre& centre,
                                                   double shape) const {
  if (std::any_of(limits_.held.begin(), limits_.held.begin() + static_cast<std::ptrdiff_t>(count_), [](bool h) { return h; }))
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
    if (!(candidate.values[i] >= limits_.lower[i] && candidate.values[i] <= limits_.upper[i])) return std::nullopt;
  }
  candidate.cost = solution->cost;
  candidate.iterations = solution->iterations;
  return candidate;
}

/// The bottoms along the shape, with the best of all other parameters for each (variable projection: Golub & Pereyra 1973), on
/// a few of the samples, best first: what a descent in all parameters finds only by a long way through a narrow valley.
std::vector<Fitter::Candidate> Fitter::search_shapes(const LensCentre& centre) const {
  constexpr std::size_t kSamples = 48;
  constexpr std::size_t kMostBottoms = 3;
  constexpr int kSections = 12;
  const std::span<const double> shapes = target_.shapes();
  const std::vector<Correspondence> few = spread(samples_, kSamples);
  std::vector<std::optional<Candidate>> tried;
  for (const double shape : shapes) tried.push_back(fit_terms(few, centre, shape));
  const auto cost = [](const std::optional<Candidate>& c) { return c ? c->cost : std::numeric_limits<double>::infinity(); };
  std::vector<std::size_t> bottoms;
  for (std::size_t i = 0; i < tried.size(); ++i) {
    const bool falls = i == 0 || cost(tried[i]) < cost(tried[i - 1]);
    const bool rises = i + 1 == tried.size() || cost(tried[i]) <= cost(tried[i + 1]);
    if (tried[i] && falls && rises) bottoms.push_back(i);
  }
  std::ranges::sort(bottoms, {}, [&](std::size_t i) { return cost(tried[i]); });
  bottoms.resize(std::min(bottoms.size(), kMostBottoms));
  std::vector<Candidate> found;
  for (const std::size_t bottom : bottoms) {
    std::optional<Candidate> best = tried[bottom];
    double at = shapes[bottom];
    double low = shapes[bottom > 0 ? bottom - 1 : bottom];
    double high = shapes[std::min(bottom + 1, shapes.size() - 1)];
    // Golden section: the longer side of what is left is divided.
    constexpr double kGolden = 0.381966011250105;
    for (int i = 0; i < kSections; ++i) {
      const double trial = high - at > at - low ? at + kGolden * (high - at) : at - kGolden * (at - low);
      std::optional<Candidate> candidate = fit_terms(few, centre, trial);
      if (cost(candidate) < cost(best)) {
        (trial > at ? low : high) = at;
        at = trial;
        best = candidate;
      } else {
        (trial > at ? high : low) = trial;
      }
    }
    hold_fixed(*best);
    found.push_back(*best);
  }
  std::ranges::sort(found, {}, &Candidate::cost);
  return found;
}

/// A start may not reach every sample: fit those it reaches, then ask again with the better parameters.
bool Fitter::polish(Candidate& candidate, const Effort& effort) {
  constexpr int kMostRounds = 4;
  std::size_t before = 0;
  for (int round = 0; round < kMostRounds; ++round) {
    pixels_.resize(samples_.size());
    std::vector<Correspondence> active;
    if (target_.pixels(candidate.values.data(), samples_, pixels_.data())) {
      active.assign(samples_.begin(), samples_.end());
    } else {
      for (std::size_t k = 0; k < samples_.size(); ++k) {
        if (!std::isnan(pixels_[k][0])) active.push_back(samples_[k]);
      }
    }
    if (active.size() * 2 < count_ || (round > 0 && active.size() <= before)) break;
    before = active.size();
    linearised_.reset(std::move(active), candidate.fixed);
    if (!minimise_active(candidate, effort)) return false;
    if (before == samples_.size()) break;
  }
  return before > 0;
}

bool Fitter::minimise_active(Candidate& candidate, const Effort& effort) {
  ParameterValues free{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    if (!candidate.fixed[i]) free[count++] = candidate.values[i];
  }
  if (count == 0) {
    candidate.on_all = false;
    return true;
  }
  const Evaluate evaluate_at = [this, &candidate](const double* p, NormalEquations& sums) {
    return linearised_.evaluate(merged(candidate, p), sums);
  };
  // So close to an optimum that J'J leads nowhere: refine() goes on from the start itself.
  constexpr double kTinyCost = 1e-9;
  NormalEquations at_start;
  if (!evaluate_at(free.data(), at_start)) return false;
  Minimum minimum{true, at_start.cost, 0};
  if (!has_many_parameters(target_) || !(at_start.cost < kTinyCost))
    minimum = minimise(evaluate_at, effort, std::span(free).first(count));
  if (!minimum.usable) return false;
  candidate.cost = minimum.cost;
  candidate.iterations += minimum.iterations;
  candidate.on_all = linearised_.rows() == 2 * samples_.size();
  if (minimum.cost < kSmallCost) refine(candidate, effort, std::span(free).first(count));
  candidate.values = merged(candidate, free.data());
  return true;
}

/// The same in coordinates in which the Jacobian's columns are orthonormal at the start: J'J squares the condition of J, and
/// where next to nothing is left to gain, in a valley, the way is lost in its rounding. Again while that helps, because the
/// coordinates are those of one point.
void Fitter::refine(Candidate& candidate, const Effort& effort, std::span<double> free) {
  constexpr int kMostRounds = 8;
  for (int round = 0; round < kMostRounds && candidate.cost > kExactCost; ++round) {
    if (!linearised_.linearise(merged(candidate, free.data()))) return;
    orthonormal_.reset(linearised_.rows(), linearised_.columns().size());
    for (const Column& column : linearised_.columns()) orthonormal_.add(column.data);
    ParameterValues centre{};
    std::ranges::copy(free, centre.begin());
    const auto free_at = [&](const double* y) {
      ParameterValues values = centre;
      orthonormal_.step(y, values.data());
      return values;
    };
    const Evaluate evaluate_at = [&](const double* y, NormalEquations& sums) {
      const ParameterValues values = merged(candidate, free_at(y).data());
      if (sums.gradient.empty()) return linearised_.evaluate(values, sums);
      if (!linearised_.linearise(values)) return false;
      orthonormal_.transform(linearised_.columns(), moved_);
      const Column r = linearised_.residuals();
      products(std::span(&r, 1), r, &sums.cost);
      products(orthonormal_.columns(moved_), r, sums.gradient.data());
      products(orthonormal_.columns(moved_), sums.hessian.data());
      return true;
    };
    ParameterValues y{};
    const Minimum minimum = minimise(evaluate_at, effort, std::span(y).first(free.size()));
    if (!minimum.usable || !(minimum.cost < candidate.cost)) return;
    std::copy_n(free_at(y.data()).begin(), free.size(), free.begin());
    const bool helps = minimum.cost < kWorthwhile * candidate.cost;
    candidate.cost = minimum.cost;
    candidate.iterations += minimum.iterations;
    if (!helps) return;
  }
}

ParameterValues Fitter::merged(const Candidate& candidate, const double* free) const {
  ParameterValues values = candidate.values;
  for (std::size_t i = 0, k = 0; i < count_; ++i) {
    if (!candidate.fixed[i]) values[i] = free[k++];
  }
  return values;
}

/// While a parameter lies outside its range: put the one furthest outside on its bound, hold it there, fit the others again.
void Fitter::respect_bounds(Candidate& candidate) {
  for (std::size_t round = 0; round < count_; ++round) {
    std::optional<std::size_t> worst;
    double furthest = 0.0;
    for (std::size_t i = 0; i < count_; ++i) {
      const double value = candidate.values[i];
      const double outside = std::max(limits_.lower[i] - value, value - limits_.upper[i]) / (1.0 + std::abs(value));
      if (!candidate.fixed[i] && outside > furthest) {
        furthest = outside;
        worst = i;
      }
    }
    if (!worst) return;
    candidate.values[*worst] = std::clamp(candidate.values[*worst], limits_.lower[*worst], limits_.upper[*worst]);
    candidate.fixed[*worst] = true;
    if (!polish(candidate, full_)) return;
  }
}

/// How far from the samples, and whether all of them are in the model's domain.
void Fitter::score(const Candidate& candidate, FoundFit& result) const {
  double weight = 0.0;
  double lowest = 1.0;
  for (const Correspondence& s : samples_) {
    weight += s.weight;
    lowest = std::min(lowest, s.ray[2]);
  }
  // The fit knows the distances; the domain's limit, an angle, decides for all rays at once, unless it is too close to tell.
  constexpr double kHair = 1e-9;
  if (candidate.on_all && lowest > std::cos(target_.max_angle(candidate.values.data())) + kHair) {
    result.rms_px = std::sqrt(candidate.cost / weight);
    return;
  }
  weight = 0.0;
  double sum = 0.0;
  for (const Correspondence& s : samples_) {
    double pixel[2];
    if (!target_.project(candidate.values.data(), s.ray.data(), pixel)) {
      result.reaches_all = false;
      continue;
    }
    weight += s.weight;
    sum += s.weight * (std::pow(pixel[0] - s.pixel[0], 2) + std::pow(pixel[1] - s.pixel[1], 2));
  }
  result.rms_px = weight > 0.0 ? std::sqrt(sum / weight) : 0.0;
}

FoundFit Fitter::finish(const Candidate& candidate) const {
  FoundFit result;
  result.parameters = candidate.values;
  result.iterations = candidate.iterations;
  score(candidate, result);
  for (std::size_t i = 0; i < count_; ++i) {
    if (candidate.fixed[i] && !limits_.fixed(i)) result.at_bound.emplace_back(target_.parameters()[i].name);
  }
  return result;
}

std::optional<FoundFit> fit_target(const FitTarget& target, std::span<const Correspondence> samples, const LensCentre& centre,
                                   std::span<const ParameterRange> ranges) {
  return Fitter(target, samples, ranges).fit(centre);
}

}  // namespace fca::internal
