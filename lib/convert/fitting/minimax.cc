// SPDX-License-Identifier: BSD-3-Clause
#include "minimax.h"

#include "../evaluation/lattice.h"
#include "../evaluation/lens_edges.h"
#include "../evaluation/maximum.h"
#include "fit_limits.h"
#include "fit_model.h"
#include "sample_jacobian.h"
#include "smooth_maximum.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace fca::internal {

namespace {

/// The errors of a model at given points, as a function of its parameters.
class ModelErrors final : public PointErrors {
 public:
  ModelErrors(const FitTarget& target, std::span<const Correspondence> points, const std::array<bool, kMostParameters>& fixed)
      : target_(target), points_(points), fixed_(fixed), jacobian_(target), pixels_(points.size()) {
    for (const Correspondence& point : points_) lowest_cosine_ = std::min(lowest_cosine_, point.ray[2]);
  }

  [[nodiscard]] std::size_t size() const override { return points_.size(); }

  bool squares(std::span<const double> values, std::span<double> result) override {
    // If the largest angle of all rays is inside the model's domain, no ray needs a test. Otherwise, or if it is close to the
    // edge of the domain, project() tests each ray.
    constexpr double kRoundingMargin = 1e-9;
    const bool all_within = lowest_cosine_ > std::cos(target_.max_angle(values.data())) + kRoundingMargin;
    if (all_within && !target_.pixels(values.data(), points_, pixels_.data())) return false;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Correspondence& point = points_[i];
      if (!all_within && !target_.project(values.data(), point.ray.data(), pixels_[i].data())) return false;
      const double du = pixels_[i][0] - point.pixel[0];
      const double dv = pixels_[i][1] - point.pixel[1];
      result[i] = du * du + dv * dv;
      if (!std::isfinite(result[i])) return false;
    }
    return true;
  }

  bool compute_jacobian(std::span<const double> values, std::span<const WeightedPoint> points, LinearErrors& result) override {
    std::vector<Correspondence> chosen;
    chosen.reserve(points.size());
    for (const WeightedPoint& point : points) {
      chosen.push_back(points_[point.index]);
      chosen.back().weight = point.weight;
    }
    jacobian_.reset(std::move(chosen), fixed_);
    ParameterValues at{};
    std::ranges::copy(values, at.begin());
    if (!jacobian_.compute_jacobian(at)) return false;
    result = {jacobian_.columns(), jacobian_.residuals()};
    return true;
  }

 private:
  const FitTarget& target_;
  std::span<const Correspondence> points_;
  std::array<bool, kMostParameters> fixed_;
  SampleJacobian jacobian_;
  std::vector<Pixel> pixels_;
  double lowest_cosine_ = 1.0;  ///< Cosine of the rays' largest angle from the axis.
};

/// Minimises the largest error over the points, starting from `fit.model`, and writes the result to `fit`.
void minimise_on(std::span<const Correspondence> points, std::span<const ParameterRange> ranges, double first_sharpness,
                 MinimaxFit& fit) {
  const std::unique_ptr<FitTarget> target = fit_target_of(fit.model);
  const FitLimits limits(*target, ranges);
  std::array<bool, kMostParameters> fixed{};
  std::vector<FreeParameter> free;
  std::visit(
      [&](auto& model) {
        for (std::size_t i = 0; i < model.values.size(); ++i) {
          fixed[i] = limits.fixed(i);
          if (fixed[i]) continue;
          free.push_back({i, limits.lower[i], limits.upper[i]});
          model.values[i] = std::clamp(model.values[i], limits.lower[i], limits.upper[i]);
        }
        ModelErrors errors(*target, points, fixed);
        fit.iterations += minimise_maximum(errors, free, first_sharpness, model.values);
      },
      fit.model);
  fit.at_bound.clear();
  for (const FreeParameter& p : free) {
    const double value = parameter_values(fit.model)[p.index];
    if (value == p.lower || value == p.upper) fit.at_bound.emplace_back(target->parameters()[p.index].name);
  }
}

/// Scores the points of the evaluation's lattice and of the lens's edges. Returns those for which the target has a pixel, the
/// largest error first.
std::vector<Point> scored_points(const Scorer& scorer) {
  std::vector<Point> points = score_lattice(scorer);
  constexpr int kAzimuths = 360;
  for (const LensEdge& edge : lens_edges(scorer)) {
    const std::vector<Point> rim = points_of(scorer, edge, kAzimuths);
    points.insert(points.end(), rim.begin(), rim.end());
  }
  std::erase_if(points, [](const Point& point) { return point.verdict != Verdict::kScored; });
  std::ranges::stable_sort(points, std::ranges::greater{}, &Point::error);
  return points;
}

/// Chooses 600 to 900 of the points, or all if there are fewer than 1,200. The points are evenly spaced in the order of their
/// angles from the axis. The point furthest from the axis is included: if it is in a model's domain, so are the others.
std::vector<Point> choose_few(std::vector<Point> points) {
  constexpr std::size_t kFewest = 600;
  const std::size_t stride = std::max<std::size_t>(1, points.size() / kFewest);
  std::ranges::stable_sort(points, {}, &Point::cosine);
  std::vector<Point> few;
  for (std::size_t i = 0; i < points.size(); i += stride) few.push_back(points[i]);
  return few;
}

/// The local maxima of the error that a climb from one of the worst points reaches. Points close to an earlier point or maximum
/// are no starts.
std::vector<Point> error_maxima(const Scorer& scorer, std::span<const Point> worst_first) {
  constexpr double kHighError = 0.97;  // fraction of the largest error
  constexpr std::size_t kMostMaxima = 32;
  const ImageSize& size = scorer.field_of_view().size;
  const double close = std::max(size.width, size.height) / 20.0;
  std::vector<Point> maxima;
  std::vector<Pixel> known;
  for (const Point& point : worst_first) {
    if (maxima.size() >= kMostMaxima || point.error < kHighError * worst_first.front().error) break;
    const auto near = [&](const Pixel& other) {
      return std::hypot(point.pixel[0] - other[0], point.pixel[1] - other[1]) < close;
    };
    if (std::ranges::any_of(known, near)) continue;
    maxima.push_back(climb(scorer, point.pixel));
    known.push_back(point.pixel);
    known.push_back(maxima.back().pixel);
  }
  return maxima;
}

/// Adds the points whose error is at least `at_least` [px] to `set`, with the source's rays. False if it adds none.
bool add_points(const Scorer& scorer, std::span<const Point> points, double at_least, std::vector<Correspondence>& set) {
  bool added = false;
  for (const Point& point : points) {
    const std::optional<Ray> ray = scorer.source().ray(point.pixel);
    if (!ray || point.error < at_least) continue;
    set.push_back({*ray, point.pixel, 1.0});
    added = true;
  }
  return added;
}

/// The largest error [px] of the model at those points for which it has a pixel.
double largest_error(const CameraModel& model, std::span<const Correspondence> points) {
  double largest = 0.0;
  for (const Correspondence& point : points) {
    const std::optional<Pixel> pixel = project(model, point.ray);
    if (pixel) largest = std::max(largest, std::hypot((*pixel)[0] - point.pixel[0], (*pixel)[1] - point.pixel[1]));
  }
  return largest;
}

}  // namespace

MinimaxFit fit_largest_error(const CameraModel& source, const CameraModel& start, const FieldOfView& field_of_view,
                             double target_max_angle_rad, std::span<const ParameterRange> ranges) {
  constexpr int kMostExchanges = 12;
  constexpr double kRoundingPx = 1e-9;       // smaller errors are mostly rounding
  constexpr double kNewPointRatio = 1.0005;  // of a new point's error to the largest error at the points of the set
  MinimaxFit fit{start, 0, {}};
  std::vector<Correspondence> set;
  double sharpness = kLowSharpness;
  for (int exchange = 0; exchange <= kMostExchanges; ++exchange) {
    const Scorer scorer(source, &fit.model, nullptr, field_of_view, target_max_angle_rad);
    const std::vector<Point> points = scored_points(scorer);
    if (points.empty() || points.front().error < kRoundingPx) break;
    bool added = set.empty() && add_points(scorer, choose_few(points), 0.0, set);
    const double at_least = kNewPointRatio * largest_error(fit.model, set);
    added = add_points(scorer, points, at_least, set) || added;
    added = add_points(scorer, error_maxima(scorer, points), at_least, set) || added;
    if (!added) break;
    minimise_on(set, ranges, sharpness, fit);
    sharpness = kHighSharpness;
  }
  return fit;
}

}  // namespace fca::internal
