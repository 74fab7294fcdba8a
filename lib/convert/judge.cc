// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/judge.h>

#include <algorithm>
#include <cmath>
#include <numbers>
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

/// One coordinate of the lattice with its trapezoidal share of the side: border points count half.
struct Step {
  double position;
  double share;
};

std::vector<Step> lattice_side(int pixels, int points) {
  if (pixels == 1) return {{0.0, 1.0}};
  std::vector<Step> steps;
  const int last = std::min(points, pixels) - 1;
  for (int i = 0; i <= last; ++i) {
    const bool border = i == 0 || i == last;
    steps.push_back({(pixels - 1.0) * i / last, (border ? 0.5 : 1.0) / last});
  }
  return steps;
}

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
  [[nodiscard]] std::optional<double> error_at(const Pixel& pixel) const {
    const std::optional<Ray> ray = domain_.ray(source_, pixel);
    if (!ray) return std::nullopt;
    const std::optional<Pixel> image = target_(*ray);
    if (!image) return std::nullopt;
    return std::hypot((*image)[0] - pixel[0], (*image)[1] - pixel[1]);
  }

  [[nodiscard]] std::vector<Scored> score_lattice(Coverage& coverage) const {
    // 71 x 71 = 5041 points on a square image; the longer side gets more, so that cells stay square.
    constexpr double kPointsPerSide = 71.0;
    const double aspect = std::sqrt(static_cast<double>(domain_.size.width) / domain_.size.height);
    const int columns = std::clamp(static_cast<int>(std::lround(kPointsPerSide * aspect)), 17, 300);
    const int rows = std::clamp(static_cast<int>(std::lround(kPointsPerSide / aspect)), 17, 300);
    std::vector<Scored> scored;
    const std::vector<Step> vertical = lattice_side(domain_.size.height, rows);
    for (const Step& u : lattice_side(domain_.size.width, columns)) {
      for (const Step& v : vertical) {
        const Pixel pixel = {u.position, v.position};
        const double share = u.share * v.share;
        const std::optional<Ray> ray = domain_.ray(source_, pixel);
        if (!ray) {
          coverage.outside_lens += share;
          continue;
        }
        const std::optional<Pixel> image = target_(*ray);
        if (!image) {
          coverage.unrepresentable += share;
          continue;
        }
        const double error = std::hypot((*image)[0] - pixel[0], (*image)[1] - pixel[1]);
        coverage.scored += share;
        scored.push_back({pixel, error, share, angle_from_axis(*ray) * kDegreesPerRadian});
      }
    }
    return scored;
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

  /// Pattern search from the worst lattice points: the error is smooth between them, its maximum rarely on one.
  void polish_maximum(const std::vector<Scored>& sorted, Judgement& result) const {
    constexpr std::size_t kCandidates = 12;
    constexpr double kFinestStep = 1e-3;  // px
    const Pixel last = {domain_.size.width - 1.0, domain_.size.height - 1.0};
    const double first_step = std::max(last[0], last[1]) / 64.0;
    for (std::size_t n = 0; n < std::min(kCandidates, sorted.size()); ++n) {
      const Scored& candidate = sorted[sorted.size() - 1 - n];
      Pixel at = candidate.pixel;
      double error = candidate.error;
      for (double step = first_step; step > kFinestStep;) {
        bool moved = false;
        for (const Pixel& direction : {Pixel{1, 0}, Pixel{-1, 0}, Pixel{0, 1}, Pixel{0, -1}}) {
          const Pixel next = {std::clamp(at[0] + step * direction[0], 0.0, last[0]),
                              std::clamp(at[1] + step * direction[1], 0.0, last[1])};
          const std::optional<double> next_error = error_at(next);
          if (next_error && *next_error > error) {
            at = next;
            error = *next_error;
            moved = true;
          }
        }
        if (!moved) step *= 0.5;
      }
      if (error >= result.error.max) {
        result.error.max = error;
        result.error.max_at = at;
      }
    }
    // The polished point belongs to a band, too.
    if (const std::optional<Ray> ray = domain_.ray(source_, result.error.max_at)) {
      const auto index = static_cast<std::size_t>(angle_from_axis(*ray) * kDegreesPerRadian / kBandDegrees);
      if (index < result.bands.size()) {
        result.bands[index].max_px = std::max(result.bands[index].max_px, result.error.max);
      }
    }
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
