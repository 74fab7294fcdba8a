// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/judge.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace fca {

namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
constexpr double kBandDegrees = 10.0;

struct Scored {
  Pixel pixel;
  double error;
  double weight;  ///< pixels, then share of the image
  double angle_deg;
};

/// What the pair of models makes of a pixel.
enum class Verdict { kOutsideLens, kUnrepresentable, kScored };
struct Point {
  Verdict verdict = Verdict::kOutsideLens;
  Pixel pixel{};
  double error = 0.0;
  double angle_deg = 0.0;
};

double percentile(const std::vector<Scored>& sorted_by_error, double total, double fraction) {
  double sum = 0.0;
  for (const Scored& s : sorted_by_error) {
    sum += s.weight;
    if (sum >= fraction * total) return s.error;
  }
  return sorted_by_error.empty() ? 0.0 : sorted_by_error.back().error;
}

/// The lattice, and the error at any pixel.
class Judge {
 public:
  Judge(const CameraModel& source, const Projection& target, const Domain& domain)
      : source_(source), target_(target), domain_(domain) {}

  [[nodiscard]] Judgement judge() const {
    Judgement result;
    result.coverage.max_angle_deg = domain_.max_angle_rad * kDegreesPerRadian;
    result.coverage.why = domain_.why;
    std::vector<Scored> scored = score_lattice(result.coverage);
    if (scored.empty()) return result;
    std::ranges::sort(scored, {}, &Scored::error);
    result.error = summarise(scored, result.coverage.scored);
    result.bands = bands(scored);
    polish_maximum(scored, result);
    return result;
  }

 private:
  [[nodiscard]] Point at(const Pixel& pixel) const {
    Point point;
    point.pixel = pixel;
    const std::optional<Ray> ray = domain_.ray(source_, pixel);
    if (!ray) return point;
    point.angle_deg = angle_from_axis(*ray) * kDegreesPerRadian;
    const std::optional<Pixel> image = target_(*ray);
    point.verdict = image ? Verdict::kScored : Verdict::kUnrepresentable;
    if (image) point.error = std::hypot((*image)[0] - pixel[0], (*image)[1] - pixel[1]);
    return point;
  }

  /// A lattice whose points lie on the image's border, too. A cell whose corners and centre have one verdict is weighted 2/3
  /// centre, 1/12 each corner (exact for cubics; the trapezoidal rule is 2 % off where errors soar at the edge of a lens); one
  /// that the domain's edge crosses is split into 6 x 6 parts, each judged at its centre.
  [[nodiscard]] std::vector<Scored> score_lattice(Coverage& coverage) const {
    const Lattice lattice = make_lattice();
    std::vector<Point> points;
    for (const double y : lattice.y) {
      for (const double x : lattice.x) points.push_back(at({x, y}));
    }
    std::vector<double> weights = border_weights(lattice);
    std::vector<Scored> scored;
    for (std::size_t j = 0; j + 1 < lattice.y.size(); ++j) {
      for (std::size_t i = 0; i + 1 < lattice.x.size(); ++i) {
        const std::array corners = {lattice.at(i, j), lattice.at(i + 1, j), lattice.at(i, j + 1), lattice.at(i + 1, j + 1)};
        const Pixel& first = points[corners.front()].pixel;
        const Pixel& last = points[corners.back()].pixel;
        const double area = (last[0] - first[0]) * (last[1] - first[1]);
        const Point centre = at({0.5 * (first[0] + last[0]), 0.5 * (first[1] + last[1])});
        if (std::ranges::all_of(corners, [&](std::size_t c) { return points[c].verdict == centre.verdict; })) {
          for (const std::size_t c : corners) weights[c] += area / 12.0;
          add(centre, area * (2.0 / 3.0), coverage, scored);
        } else {
          score_split_cell(first, last, area, coverage, scored);
        }
      }
    }
    for (std::size_t k = 0; k < points.size(); ++k) add(points[k], weights[k], coverage, scored);
    // From pixels to shares of the image, which sum to 1.
    const double total = coverage.scored + coverage.outside_lens + coverage.unrepresentable;
    for (double* part : {&coverage.scored, &coverage.outside_lens, &coverage.unrepresentable}) *part /= total;
    for (Scored& s : scored) s.weight /= total;
    return scored;
  }

  /// The coordinates of the lattice's columns and rows, and the numbering of its points.
  struct Lattice {
    std::vector<double> x;
    std::vector<double> y;
    [[nodiscard]] std::size_t at(std::size_t column, std::size_t row) const { return row * x.size() + column; }
  };

  [[nodiscard]] Lattice make_lattice() const {
    // 51 x 51 corners and 50 x 50 centres on a square image; the longer side gets more, so that cells stay square.
    constexpr double kPointsPerSide = 51.0;
    const double aspect = std::sqrt(static_cast<double>(domain_.size.width) / domain_.size.height);
    return {lattice_side(domain_.size.width, kPointsPerSide * aspect),
            lattice_side(domain_.size.height, kPointsPerSide / aspect)};
  }

  /// From 0 to pixels - 1, denser towards both ends: errors are steepest in the corners of an image.
  [[nodiscard]] static std::vector<double> lattice_side(int pixels, double points) {
    const int last = std::min(pixels, std::clamp(static_cast<int>(std::lround(points)), 17, 300)) - 1;
    std::vector<double> positions = {0.0};
    for (int i = 1; i <= last; ++i) positions.push_back(0.5 * (pixels - 1.0) * (1.0 - std::cos(std::numbers::pi * i / last)));
    return positions;
  }

  /// Pixels on the border reach half a pixel beyond [0, w - 1] x [0, h - 1]: with these strips a sum over the lattice stands
  /// for the sum over all pixels.
  [[nodiscard]] static std::vector<double> border_weights(const Lattice& lattice) {
    std::vector<double> weights(lattice.x.size() * lattice.y.size(), 0.0);
    constexpr double kHalfStripPerEnd = 0.25;
    const std::size_t right = lattice.x.size() - 1;
    const std::size_t bottom = lattice.y.size() - 1;
    for (std::size_t i = 0; i < right; ++i) {
      for (const std::size_t row : {std::size_t{0}, bottom}) {
        for (const std::size_t end : {i, i + 1})
          weights[lattice.at(end, row)] += kHalfStripPerEnd * (lattice.x[i + 1] - lattice.x[i]);
      }
    }
    for (std::size_t j = 0; j < bottom; ++j) {
      for (const std::size_t column : {std::size_t{0}, right}) {
        for (const std::size_t end : {j, j + 1})
          weights[lattice.at(column, end)] += kHalfStripPerEnd * (lattice.y[j + 1] - lattice.y[j]);
      }
    }
    for (const std::size_t column : {std::size_t{0}, right}) {
      for (const std::size_t row : {std::size_t{0}, bottom}) weights[lattice.at(column, row)] += 0.25;
    }
    return weights;
  }

  void score_split_cell(const Pixel& first, const Pixel& last, double area, Coverage& coverage,
                        std::vector<Scored>& scored) const {
    constexpr int kParts = 6;
    for (int i = 0; i < kParts; ++i) {
      for (int j = 0; j < kParts; ++j) {
        const Pixel centre = {first[0] + (last[0] - first[0]) * (i + 0.5) / kParts,
                              first[1] + (last[1] - first[1]) * (j + 0.5) / kParts};
        add(at(centre), area / (kParts * kParts), coverage, scored);
      }
    }
  }

  static void add(const Point& point, double weight, Coverage& coverage, std::vector<Scored>& scored) {
    switch (point.verdict) {
      case Verdict::kOutsideLens:
        coverage.outside_lens += weight;
        return;
      case Verdict::kUnrepresentable:
        coverage.unrepresentable += weight;
        return;
      case Verdict::kScored:
        coverage.scored += weight;
        scored.push_back({point.pixel, point.error, weight, point.angle_deg});
    }
  }

  /// The worst point of the edge of the lens, where errors are often largest: none of the area, but a candidate for the
  /// maximum.
  [[nodiscard]] std::optional<Point> worst_edge_point() const {
    constexpr int kAzimuths = 720;
    constexpr double kSpacing = 2.0 * std::numbers::pi / kAzimuths;
    std::optional<Point> worst;
    double azimuth = 0.0;
    const auto keep_if_worse_at = [&](double candidate) {
      const std::optional<Point> point = edge_point(candidate);
      if (!point || (worst && point->error <= worst->error)) return false;
      worst = point;
      azimuth = candidate;
      return true;
    };
    for (int i = 0; i < kAzimuths; ++i) keep_if_worse_at(kSpacing * i);
    constexpr double kFinest = 1e-6;
    for (double step = 0.5 * kSpacing; worst && step > kFinest;) {
      if (!keep_if_worse_at(azimuth + step) && !keep_if_worse_at(azimuth - step)) step *= 0.5;
    }
    return worst;
  }

  [[nodiscard]] std::optional<Point> edge_point(double azimuth) const {
    const double angle = domain_.max_angle_rad * (1.0 - 1e-9);  // a hair inside, so that rounding keeps it in the domain
    const Ray ray = {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)};
    const std::optional<Pixel> pixel = project(source_, ray);
    if (!pixel || (*pixel)[0] < 0.0 || (*pixel)[1] < 0.0 || (*pixel)[0] > domain_.size.width - 1.0 ||
        (*pixel)[1] > domain_.size.height - 1.0) {
      return std::nullopt;
    }
    const Point point = at(*pixel);
    return point.verdict == Verdict::kScored ? std::optional(point) : std::nullopt;
  }

  [[nodiscard]] static ErrorSummary summarise(const std::vector<Scored>& sorted, double total) {
    ErrorSummary summary;
    for (const Scored& s : sorted) {
      summary.mean += s.weight * s.error / total;
      summary.rms += s.weight * s.error * s.error / total;
    }
    summary.rms = std::sqrt(summary.rms);
    summary.p50 = percentile(sorted, total, 0.50);
    summary.p95 = percentile(sorted, total, 0.95);
    summary.p99 = percentile(sorted, total, 0.99);
    return summary;
  }

  [[nodiscard]] static std::vector<ErrorBand> bands(const std::vector<Scored>& scored) {
    std::vector<ErrorBand> bands;
    for (const Scored& s : scored) {
      const auto index = static_cast<std::size_t>(s.angle_deg / kBandDegrees);
      while (bands.size() <= index) {
        const double from = kBandDegrees * static_cast<double>(bands.size());
        bands.push_back({from, from + kBandDegrees, 0.0, 0.0, 0.0});
      }
      ErrorBand& band = bands[index];
      band.share += s.weight;
      band.rms_px += s.weight * s.error * s.error;
      band.max_px = std::max(band.max_px, s.error);
    }
    for (ErrorBand& band : bands) band.rms_px = band.share > 0.0 ? std::sqrt(band.rms_px / band.share) : 0.0;
    return bands;
  }

  /// Pattern search from the worst lattice points and the worst point of the edge: the error is smooth between them, its
  /// maximum rarely on one.
  void polish_maximum(const std::vector<Scored>& sorted, Judgement& result) const {
    constexpr std::size_t kCandidates = 12;
    for (std::size_t n = 0; n < std::min(kCandidates, sorted.size()); ++n)
      keep_if_worse(climb(sorted[sorted.size() - 1 - n].pixel), result);
    if (const std::optional<Point> edge = worst_edge_point()) keep_if_worse(climb(edge->pixel), result);
  }

  static void keep_if_worse(const Point& point, Judgement& result) {
    if (point.error < result.error.max) return;
    result.error.max = point.error;
    result.error.max_at = point.pixel;
    const auto band = static_cast<std::size_t>(point.angle_deg / kBandDegrees);
    if (band < result.bands.size()) result.bands[band].max_px = std::max(result.bands[band].max_px, point.error);
  }

  /// Uphill from a pixel, along eight directions with steps down to a thousandth of a pixel.
  [[nodiscard]] Point climb(const Pixel& start) const {
    constexpr double kFinestStep = 1e-3;  // px
    constexpr double kDiagonal = 0.7071067811865476;
    constexpr std::array<Pixel, 8> kDirections = {{{1, 0},
                                                   {-1, 0},
                                                   {0, 1},
                                                   {0, -1},
                                                   {kDiagonal, kDiagonal},
                                                   {-kDiagonal, kDiagonal},
                                                   {kDiagonal, -kDiagonal},
                                                   {-kDiagonal, -kDiagonal}}};
    const Pixel last = {domain_.size.width - 1.0, domain_.size.height - 1.0};
    Point best = at(start);
    for (double step = std::max(last[0], last[1]) / 64.0; step > kFinestStep;) {
      bool moved = false;
      for (const Pixel& direction : kDirections) {
        const Point next = at({std::clamp(best.pixel[0] + step * direction[0], 0.0, last[0]),
                               std::clamp(best.pixel[1] + step * direction[1], 0.0, last[1])});
        if (next.verdict == Verdict::kScored && next.error > best.error) {
          best = next;
          moved = true;
        }
      }
      if (!moved) step *= 0.5;
    }
    return best;
  }

  const CameraModel& source_;
  const Projection& target_;
  const Domain& domain_;
};

}  // namespace

Judgement judge(const CameraModel& source, const Projection& target, const Domain& domain, const JudgeOptions& /*o*/) {
  return Judge(source, target, domain).judge();
}

Judgement judge(const CameraModel& source, const CameraModel& target, const Domain& domain, const JudgeOptions& o) {
  return judge(
      source, [&target, &o](const Ray& ray) { return angle_from_axis(ray) <= o.target_reach_rad ? project(target, ray) : std::nullopt; }, domain);
}

}  // namespace fca
