// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/pixel_distance.h>

#include "reader_pixels.h"

#include <fca/convert/angle_limit.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace fca {

namespace {

/// Points over an image: so many steps along each side, and every so many asked for the program's ray, which takes as long.
struct Lattice {
  int steps;
  int to_next_ray;
};
constexpr Lattice kCoarse = {32, 2};
constexpr Lattice kFine = {ReaderPoints::kSteps, 1};  ///< Where shares of the image are to be told.
/// A pixel or ray that is further off than this, where programs are known to go wrong, is none.
constexpr double kWrongPx = 1.0;
/// How well a model's last angle is known [rad].
constexpr double kLastAngleSlack = 1e-7;

Pixel last_pixel(const ImageSize& size) { return {size.width - 1.0, size.height - 1.0}; }

/// Below any cosine where nothing limits the angle.
double cosine_of(double angle_rad) { return angle_rad < std::numbers::pi ? std::cos(angle_rad) : -2.0; }

struct Circle {
  Pixel centre;
  double radius;
};

/// The largest about the middle of the image.
Circle circle_in(const ImageSize& size) {
  const Pixel last = last_pixel(size);
  return {{0.5 * last[0], 0.5 * last[1]}, 0.5 * std::min(last[0], last[1])};
}

/// For what a point of the lattice stands.
struct Share {
  double area = 0.0;    ///< Cells: half of one at a border.
  double weight = 0.0;  ///< In a mean, by Simpson's rule: errors grow steeply towards the corners.
};

/// One point of the lattice.
struct Point {
  Share share;
  double distance = 0.0;  ///< px
};

Share share_of(int i, int j, int steps) {
  const auto at_border = [steps](int step) { return step == 0 || step == steps; };
  const auto area = [&](int step) { return at_border(step) ? 0.5 : 1.0; };
  const auto weight = [&](int step) { return at_border(step) ? 1.0 : (step % 2 == 0 ? 2.0 : 4.0); };
  return {area(i) * area(j), weight(i) * weight(j)};
}

/// Collects one region.
class Region {
 public:
  void add(const Share& share, const std::optional<double>& distance) {
    asked_ += share.area;
    if (distance) points_.push_back({share, *distance});
  }
  void add_wrong_rays(double area) { wrong_rays_ += area; }

  [[nodiscard]] PixelDistance summary(const Lattice& lattice) && {
    PixelDistance result;
    result.region = asked_ / (lattice.steps * lattice.steps);
    double answered = 0.0;
    double weights = 0.0;
    double squares = 0.0;
    for (const Point& point : points_) {
      answered += point.share.area;
      weights += point.share.weight;
      squares += point.share.weight * point.distance * point.distance;
      result.max = std::max(result.max, point.distance);
    }
    if (asked_ > 0.0) result.no_rays = std::min(1.0, (asked_ - answered + wrong_rays_) / asked_);
    if (!(answered > 0.0)) return result;
    result.rms = std::sqrt(squares / weights);
    result.p99 = percentile(0.99 * answered);
    return result;
  }

 private:
  /// The smallest distance that at least `area` of the points do not exceed.
  double percentile(double area) {
    std::ranges::sort(points_, {}, &Point::distance);
    double below = 0.0;
    for (const Point& point : points_) {
      below += point.share.area;
      if (below >= area) return point.distance;
    }
    return points_.back().distance;
  }

  std::vector<Point> points_;
  double asked_ = 0.0;
  double wrong_rays_ = 0.0;
};

class Comparison {
 public:
  Comparison(const Camera& camera, const CameraModel& written, const consumers::ConsumerCamera& reader,
             const AngleLimits& limits, const Lattice& lattice, const std::optional<Transform>& T_written_camera,
             ReaderPoints* known)
      : T_written_camera_(T_written_camera),
        lattice_(lattice),
        camera_(camera),
        written_(written),
        reader_(reader),
        is_kept_(camera.model == written),
        known_(is_kept_ && !T_written_camera && lattice.steps == ReaderPoints::kSteps ? known : nullptr),
        surely_written_(max_angle(written) - kLastAngleSlack),
        last_cosine_(cosine_of(limits.asked)),
        last_fitted_cosine_(cosine_of(limits.fitted)) {}

  CameraDistance run() {
    CameraDistance result;
    if (!camera_.image_size) return result;
    if (camera_.rays.empty()) {
      compare_lattice(*camera_.image_size);
    } else {
      compare_table(*camera_.image_size);
    }
    constexpr double kWide = std::numbers::pi / 3.0;  // 60 deg from the axis
    result.grid_steps = grid_.empty() ? 0 : lattice_.steps;
    result.grid = std::move(grid_);
    result.is_wide = smallest_cosine_ < std::cos(kWide);
    result.in_circle = std::move(in_circle_).summary(lattice_);
    result.in_image = std::move(in_image_).summary(lattice_);
    return result;
  }

 private:
  void compare_lattice(const ImageSize& size) {
    const Pixel last = last_pixel(size);
    const Circle circle = circle_in(size);
    const int steps = lattice_.steps;
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; j <= steps; ++j) {
        const Pixel pixel = {last[0] * i / steps, last[1] * j / steps};
        const bool in_circle = distance(pixel, circle.centre) <= circle.radius;
        const bool ask_for_ray = i % lattice_.to_next_ray == 0 && j % lattice_.to_next_ray == 0;
        ReaderPoint unknown;
        ReaderPoint& point = known_ != nullptr ? known_->at(i, j) : unknown;
        const std::optional<Ray>& ray = point.ray(camera_.model, pixel);
        grid_.push_back(compare_at(pixel, ray, share_of(i, j, steps), in_circle, ask_for_ray, point));
      }
    }
  }

  /// Of a camera that is known by rays alone: those.
  void compare_table(const ImageSize& size) {
    const Circle circle = circle_in(size);
    for (std::size_t i = 0; i < camera_.rays.size(); ++i) {
      const Correspondence& entry = camera_.rays[i];
      const Share share = {entry.weight * lattice_.steps * lattice_.steps, entry.weight};
      const bool in_circle = distance(entry.pixel, circle.centre) <= circle.radius;
      const bool ask_for_ray = i % static_cast<std::size_t>(lattice_.to_next_ray * lattice_.to_next_ray) == 0;
      ReaderPoint point;
      (void)compare_at(entry.pixel, entry.ray, share, in_circle, ask_for_ray, point);
    }
  }

  /// Nothing where the camera has no ray that counts.
  std::optional<SeenPixel> compare_at(const Pixel& pixel, const std::optional<Ray>& ray, const Share& share, bool in_circle,
                                      bool ask_for_ray, ReaderPoint& point) {
    if (camera_.lens_circle && !camera_.lens_circle->contains(pixel)) return std::nullopt;
    if (!ray || (*ray)[2] < last_cosine_) return std::nullopt;
    smallest_cosine_ = std::min(smallest_cosine_, (*ray)[2]);
    const SeenPixel seen = {pixel, pixel_at(pixel, *ray, point)};
    const std::optional<double> distance = seen.program ? std::optional(fca::distance(*seen.program, pixel)) : std::nullopt;
    const double points = lattice_.to_next_ray * lattice_.to_next_ray;  // for which one that is asked stands
    const bool has_wrong_ray = distance && ask_for_ray && point.wrong_px(reader_, pixel) > kWrongPx;
    for (Region* region : {&in_image_, &in_circle_}) {
      if (region == &in_circle_ && !in_circle) continue;
      region->add(share, distance);
      if (has_wrong_ray) region->add_wrong_rays(points * share.area);
    }
    return has_wrong_ray ? SeenPixel{pixel, std::nullopt} : seen;
  }

  /// The program's, in the file's pixels; nothing where the model of the file or the program has no right one.
  [[nodiscard]] std::optional<Pixel> pixel_at(const Pixel& pixel, const Ray& of_camera, ReaderPoint& point) const {
    const Ray ray = T_written_camera_ ? rotated(*T_written_camera_, of_camera) : of_camera;
    if (of_camera[2] < last_fitted_cosine_ || (!is_kept_ && !has_pixel(ray))) return std::nullopt;
    const std::optional<Pixel>& theirs = point.image(reader_, ray);
    if (!theirs) return std::nullopt;
    const Pixel seen = in_file_pixels(*theirs, reader_);
    const double distance = fca::distance(seen, pixel);
    if (!std::isfinite(distance)) return std::nullopt;
    if (ray[2] > 0.0 || distance <= kWrongPx) return seen;
    // From 90 degrees on some programs mirror; what the written model says there is only a fit's error.
    const std::optional<Pixel> meant = project(written_, ray);
    return meant && fca::distance(seen, *meant) <= kWrongPx ? std::optional(seen) : std::nullopt;
  }

  /// Of the model of the file. It is asked where its last angle is close.
  [[nodiscard]] bool has_pixel(const Ray& ray) const {
    return surely_written_.surely_admits(ray[2]) || project(written_, ray).has_value();
  }

  const std::optional<Transform>& T_written_camera_;
  Lattice lattice_;
  const Camera& camera_;
  const CameraModel& written_;
  const consumers::ConsumerCamera& reader_;
  bool is_kept_;
  ReaderPoints* known_;
  AngleLimit surely_written_;  ///< Within it the model of the file has a pixel.
  double last_cosine_;
  double last_fitted_cosine_;
  double smallest_cosine_ = 1.0;
  std::vector<std::optional<SeenPixel>> grid_;
  Region in_image_;
  Region in_circle_;
};

}  // namespace

CameraDistance distance_of(const Camera& camera, const CameraModel& written, const consumers::ConsumerCamera& reader,
                           const AngleLimits& limits, bool has_gaps, const std::optional<Transform>& T_written_camera) {
  ReaderPoints none;
  return distance_of(camera, written, reader, limits, has_gaps, T_written_camera, none);
}

CameraDistance distance_of(const Camera& camera, const CameraModel& written, const consumers::ConsumerCamera& reader,
                           const AngleLimits& limits, bool has_gaps, const std::optional<Transform>& T_written_camera,
                           ReaderPoints& known) {
  if (!has_gaps) {
    CameraDistance coarse = Comparison(camera, written, reader, limits, kCoarse, T_written_camera, nullptr).run();
    if (coarse.in_image.no_rays == 0.0) return coarse;
  }
  return Comparison(camera, written, reader, limits, kFine, T_written_camera, &known).run();
}

std::optional<double> degrees_in_circle(const Camera& camera) {
  if (!camera.image_size) return std::nullopt;
  const Circle circle = circle_in(*camera.image_size);
  constexpr int kPoints = 32;
  double smallest_cosine = 1.0;
  if (!camera.rays.empty()) {
    for (const Correspondence& entry : camera.rays) {
      if (distance(entry.pixel, circle.centre) <= circle.radius) smallest_cosine = std::min(smallest_cosine, entry.ray[2]);
    }
    return std::ceil(std::acos(smallest_cosine) * 180.0 / std::numbers::pi);
  }
  for (int i = 0; i < kPoints; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / kPoints;
    const std::optional<Ray> ray = unproject(
        camera.model, {circle.centre[0] + circle.radius * std::cos(turn), circle.centre[1] + circle.radius * std::sin(turn)});
    if (!ray) return std::nullopt;
    smallest_cosine = std::min(smallest_cosine, (*ray)[2]);
  }
  return std::ceil(std::acos(smallest_cosine) * 180.0 / std::numbers::pi);
}

}  // namespace fca
