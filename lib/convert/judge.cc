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
  double weight;  ///< share of the image's area
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

  /// A lattice whose points lie on the image's border, too. A cell whose corners and centre have one verdict is weighted 2/3 centre,
  /// 1/12 each corner (exact for cubics; the trapezoidal rule is 2 % off where errors soar at the edge of a lens); one that the
  /// domain's edge crosses is split into 6 x 6 parts, each judged at its centre.
  [[nodiscard]] std::vector<Scored> score_lattice(Coverage& coverage) const {
    const auto [columns, rows] = lattice_size();
    const double width = domain_.size.width - 1.0;
    const double height = domain_.size.height - 1.0;
    std::vector<Point> points;
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        points.push_back(at({columns > 1 ? width * i / (columns - 1) : 0.0, rows > 1 ? height * j / (rows - 1) : 0.0}));
      }
    }
    const auto corner = [&](int i, int j) -> std::size_t {
      return static_cast<std::size_t>(std::min(j, rows - 1)) * static_cast<std::size_t>(columns) +
             static_cast<std::size_t>(std::min(i, columns - 1));
    };
    std::vector<double> weights(points.size(), 0.0);
    std::vector<Scored> scored;
    const int cells_across = std::max(columns - 1, 1);
    const int cells_down = std::max(rows - 1, 1);
    const double share = 1.0 / (static_cast<double>(cells_across) * cells_down);
    for (int j = 0; j < cells_down; ++j) {
      for (int i = 0; i < cells_across; ++i) {
        const std::array<std::size_t, 4> corners = {corner(i, j), corner(i + 1, j), corner(i, j + 1), corner(i + 1, j + 1)};
        const Verdict verdict = points[corners[0]].verdict;
        const Pixel& first = points[corners[0]].pixel;
        const Pixel& last = points[corners[3]].pixel;
        const Point centre = at({0.5 * (first[0] + last[0]), 0.5 * (first[1] + last[1])});
        const bool whole = centre.verdict == verdict &&
                           std::ranges::all_of(corners, [&](std::size_t c) { return points[c].verdict == verdict; });
        if (whole) {
          for (const std::size_t c : corners) weights[c] += share / 12.0;
          add(centre, share * (2.0 / 3.0), coverage, scored);
        } else {
          score_split_cell(first, last, share, coverage, scored);
        }
      }
    }
    for (std::size_t k = 0; k < points.size(); ++k) add(points[k], weights[k], coverage, scored);
    // Thousands of additions leave a few units in the last place: the shares are to sum to 1.
    const double total = coverage.scored + coverage.outside_lens + coverage.unrepresentable;
    for (double* part : {&coverage.scored, &coverage.outside_lens, &coverage.unrepresentable}) *part /= total;
    for (Scored& s : scored) s.weight /= total;
    return scored;
  }

  [[nodiscard]] std::pair<int, int> lattice_size() const {
    // 51 x 51 corners and 50 x 50 centres on a square image; the longer side gets more, so that cells stay square.
    constexpr double kPointsPerSide = 51.0;
    const double aspect = std::sqrt(static_cast<double>(domain_.size.width) / domain_.size.height);
    const auto side = [](double points, int pixels) { return std::min(pixels, std::clamp(static_cast<int>(std::lround(points)), 17, 300)); };
    return {side(kPointsPerSide * aspect, domain_.size.width), side(kPointsPerSide / aspect, domain_.size.height)};
  }

  void score_split_cell(const Pixel& first, const Pixel& last, double share, Coverage& coverage, std::vector<Scored>& scored) const {
    constexpr int kParts = 6;
    for (int i = 0; i < kParts; ++i) {
      for (int j = 0; j < kParts; ++j) {
        const Pixel centre = {first[0] + (last[0] - first[0]) * (i + 0.5) / kParts, first[1] + (last[1] - first[1]) * (j + 0.5) / kParts};
        add(at(centre), share / (kParts * kParts), coverage, scored);
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

  /// Points along the edge of the lens, where errors are often largest: no share of the area, but candidates for the maximum.
  [[nodiscard]] std::vector<Point> edge_points() const {
    constexpr int kAzimuths = 720;
    std::vector<Point> points;
    for (int i = 0; i < kAzimuths; ++i) {
      if (const std::optional<Point> point = edge_point(2.0 * std::numbers::pi * i / kAzimuths)) points.push_back(*point);
    }
    return points;
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

  /// Pattern search from the worst lattice points and the worst point of the edge: the error is smooth between them, its maximum
  /// rarely on one.
  void polish_maximum(const std::vector<Scored>& sorted, Judgement& result) const {
    constexpr std::size_t kCandidates = 12;
    for (std::size_t n = 0; n < std::min(kCandidates, sorted.size()); ++n) keep_if_worse(climb(sorted[sorted.size() - 1 - n].pixel), result);
    const std::vector<Point> edge = edge_points();
    const auto worst = std::ranges::max_element(edge, {}, &Point::error);
    if (worst != edge.end()) keep_if_worse(climb(worst->pixel), result);
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
    constexpr std::array<Pixel, 8> kDirections = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1},
                                                   {kDiagonal, kDiagonal}, {-kDiagonal, kDiagonal},
                                                   {kDiagonal, -kDiagonal}, {-kDiagonal, -kDiagonal}}};
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

Judgement judge(const CameraModel& source, const Projection& target, const Domain& domain) {
  return Judge(source, target, domain).judge();
}

Judgement judge(const CameraModel& source, const CameraModel& target, const Domain& domain) {
  return judge(source, [&target](const Ray& ray) { return project(target, ray); }, domain);
}

}  // namespace fca
