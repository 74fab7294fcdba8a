// SPDX-License-Identifier: BSD-3-Clause
#include <fca/convert/sample.h>

#include "../../models/kernels/batch.h"
#include "gauss_legendre.h"
#include "gauss_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace fca {

namespace {

using internal::gauss_legendre;
using internal::gauss_pixels;
using internal::Node;

/// True if the camera's model is one of Ms.
template <class... Ms>
bool is_any_of(const CameraModel& model) {
  return (std::holds_alternative<Intrinsics<Ms>>(model) || ...);
}

/// Computes the rays of pixels in the field of view, faster than FieldOfView::ray(): that computes the angle of each ray, which
/// takes longer than the ray itself. Here the ray's z, its cosine, nearly always decides.
class Rays {
 public:
  Rays(const Lens& source, const FieldOfView& field_of_view)
      : source_(source), field_of_view_(field_of_view), lowest_cosine_(std::cos(field_of_view.max_angle_rad)) {}

  /// The ray of a pixel; nullopt if it is not in the field of view.
  [[nodiscard]] std::optional<Ray> operator()(const Pixel& pixel) const {
    if (!is_lit(pixel)) return std::nullopt;
    std::optional<Ray> ray = source_.ray(pixel);
    if (!ray || surely_inside((*ray)[2])) return ray;
    if ((*ray)[2] < lowest_cosine_ - kUncertain || angle_from_axis(*ray) > field_of_view_.max_angle_rad) return std::nullopt;
    return ray;
  }
  /// True if a ray with this cosine of the angle from the axis is certainly in the field of view.
  [[nodiscard]] bool surely_inside(double cosine) const { return cosine > lowest_cosine_ + kUncertain; }
  /// The kernel that computes the rays of many pixels at a time. nullopt for models without a search in their rays, for which
  /// it would not be faster.
  [[nodiscard]] std::optional<internal::BatchRays> batch() const {
    const CameraModel* model = source_.model();
    if (model == nullptr || !is_any_of<Kb4, Radtan, Rational>(*model) || !validate(*model).empty()) return std::nullopt;
    return internal::BatchRays(*model, field_of_view_.max_angle_rad);
  }
  [[nodiscard]] bool is_lit(const Pixel& pixel) const { return field_of_view_.is_lit(pixel); }
  [[nodiscard]] bool has(const Pixel& pixel) const { return (*this)(pixel).has_value(); }
  /// The angle [rad] between a pixel's ray and the field of view's edge: positive outside, negative inside. It is approximate
  /// if the edge is a circle. nullopt if the pixel has no ray.
  [[nodiscard]] std::optional<double> beyond(const Pixel& pixel) const {
    const std::optional<Ray> ray = source_.ray(pixel);
    if (!ray) return std::nullopt;
    const double beyond_angle = angle_from_axis(*ray) - field_of_view_.max_angle_rad;
    if (!field_of_view_.circle) return beyond_angle;
    return std::max(beyond_angle,
                    field_of_view_.circle->beyond(pixel) / field_of_view_.circle->radius_px * field_of_view_.max_angle_rad);
  }
  [[nodiscard]] const ImageSize& size() const { return field_of_view_.size; }

 private:
  static constexpr double kUncertain = 1e-9;  ///< Cosines that are nearer to lowest_cosine_ do not decide.
  const Lens& source_;
  const FieldOfView& field_of_view_;
  double lowest_cosine_;  ///< The cosine of the field of view's largest angle.
};

/// A pixel that may be a sample.
struct Candidate {
  Pixel pixel;
  double weight;
};

/// The samples: those candidates that have a ray in the field of view.
std::vector<Correspondence> samples_of(const Rays& rays, const std::vector<Candidate>& candidates) {
  std::vector<Correspondence> samples;
  samples.reserve(candidates.size());
  const std::optional<internal::BatchRays> many = rays.batch();
  internal::Batch batch;
  for (std::size_t first = 0; first < candidates.size(); first += internal::Batch::kSize) {
    const std::size_t count = std::min(internal::Batch::kSize, candidates.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      batch.u[i] = candidates[first + i].pixel[0];
      batch.v[i] = candidates[first + i].pixel[1];
    }
    if (many) {
      (*many)(batch, count);
    } else {
      std::fill_n(batch.z.begin(), count, internal::kAskModel);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const auto& [pixel, weight] = candidates[first + i];
      if (batch.z[i] == internal::kNoRay || !rays.is_lit(pixel)) continue;
      if (std::isfinite(batch.z[i]) && rays.surely_inside(batch.z[i])) {
        samples.push_back({{batch.x[i], batch.y[i], batch.z[i]}, pixel, weight});
      } else if (const std::optional<Ray> ray = rays(pixel)) {
        samples.push_back({*ray, pixel, weight});
      }
    }
  }
  return samples;
}

/// Samples a grid over the whole image, with Gauss nodes of its rows and columns. Points outside the field of view are dropped.
std::vector<Correspondence> sample_rectangle(const Rays& rays, int count) {
  const ImageSize& size = rays.size();
  const double aspect = std::clamp(static_cast<double>(size.width) / size.height, 0.1, 10.0);
  const int columns = std::max(2, static_cast<int>(std::lround(std::sqrt(count * aspect))));
  const int rows = std::max(2, static_cast<int>(std::lround(static_cast<double>(count) / columns)));
  std::vector<Candidate> candidates;
  candidates.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  const std::vector<Node>& vertical = gauss_pixels(rows, size.height);
  for (const Node& u : gauss_pixels(columns, size.width)) {
    for (const Node& v : vertical) candidates.push_back({{u.position, v.position}, u.weight * v.weight});
  }
  return samples_of(rays, candidates);
}

/// The distance from `centre` to the image's border in a direction, in units of the length of `direction`.
double distance_to_border(const ImageSize& size, const Pixel& centre, const Pixel& direction) {
  const Pixel last = {size.width - 1.0, size.height - 1.0};
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < direction.size(); ++k) {
    if (direction[k] > 0.0) distance = std::min(distance, (last[k] - centre[k]) / direction[k]);
    if (direction[k] < 0.0) distance = std::min(distance, -centre[k] / direction[k]);
  }
  constexpr double kJustInside = 1.0 - 1e-12;  // rounding must not put the border outside the image
  return distance * kJustInside;
}

/// The pixel at a distance from `centre` in a direction; `distance` as for distance_to_border().
Pixel along(const Pixel& centre, const Pixel& direction, double distance) {
  return {centre[0] + distance * direction[0], centre[1] + distance * direction[1]};
}

/// True if the field of view reaches the image's border at that azimuth [rad].
bool reaches_border(const Rays& rays, const Pixel& centre, double azimuth) {
  const Pixel direction = {std::cos(azimuth), std::sin(azimuth)};
  return rays.has(along(centre, direction, distance_to_border(rays.size(), centre, direction)));
}

/// The distance [px] from `centre` to the edge of the field of view at that azimuth [rad]: to the image's border, or to the
/// lens's edge if that is nearer. Angles grow outwards, so that the search keeps a bracket [near, far] around the lens's edge.
/// It uses regula falsi (Illinois) if there are rays beyond the edge, otherwise halving.
double distance_to_edge(const Rays& rays, const Pixel& centre, double azimuth) {
  const Pixel direction = {std::cos(azimuth), std::sin(azimuth)};
  double far = distance_to_border(rays.size(), centre, direction);
  std::optional<double> beyond_far = rays.beyond(along(centre, direction, far));
  if (beyond_far && *beyond_far <= 0.0) return far;
  double near = 0.0;
  double beyond_near = rays.beyond(centre).value_or(-1.0);
  bool near_moved = false;
  constexpr int kMostSteps = 60;
  constexpr double kCloseEnough = 1e-9;  // px
  for (int i = 0; i < kMostSteps && far - near > kCloseEnough; ++i) {
    const bool interpolate = beyond_far && beyond_near < 0.0;
    const double share = interpolate ? beyond_near / (beyond_near - *beyond_far) : 0.5;
    const double middle = near + share * (far - near);
    const std::optional<double> beyond = rays.beyond(along(centre, direction, middle));
    constexpr double kOnTheEdge = 1e-13;  // rad
    if (beyond && std::abs(*beyond) < kOnTheEdge) return middle;
    if (beyond && *beyond <= 0.0) {
      if (near_moved && beyond_far) *beyond_far *= 0.5;
      near = middle;
      beyond_near = *beyond;
      near_moved = true;
    } else {
      if (!near_moved && i > 0) beyond_near *= 0.5;
      far = middle;
      beyond_far = beyond;
      near_moved = false;
    }
  }
  return near;
}

/// The azimuths [rad] at which the edge of the field of view is not smooth, ascending over a whole turn: those of the image's
/// corners, and those at which the edge changes between the image's border and the lens's edge.
std::vector<double> ends_of_smooth_pieces(const Rays& rays, const Pixel& centre) {
  const double width = rays.size().width - 1.0;
  const double height = rays.size().height - 1.0;
  std::vector<double> corners;
  for (const Pixel& corner : {Pixel{width, height}, Pixel{0.0, height}, Pixel{0.0, 0.0}, Pixel{width, 0.0}}) {
    double azimuth = std::atan2(corner[1] - centre[1], corner[0] - centre[0]);
    if (!corners.empty() && azimuth < corners.back()) azimuth += 2.0 * std::numbers::pi;
    corners.push_back(azimuth);
  }
  corners.push_back(corners.front() + 2.0 * std::numbers::pi);

  const auto at_border = [&](double azimuth) { return reaches_border(rays, centre, azimuth); };
  constexpr int kStepsPerSide = 12;
  constexpr double kJustInside = 1e-9;  // rad; as a share of a side, too
  std::vector<double> pieces = {corners.front()};
  for (std::size_t side = 0; side + 1 < corners.size(); ++side) {
    const double span = corners[side + 1] - corners[side];
    // A corner belongs to two sides: the azimuth is slightly inside this one.
    const auto azimuth_of = [&](int step) {
      return corners[side] + span * std::clamp(static_cast<double>(step) / kStepsPerSide, kJustInside, 1.0 - kJustInside);
    };
    bool is_border_after = false;
    for (int step = 0; step < kStepsPerSide; ++step) {
      double before = azimuth_of(step);
      double after = azimuth_of(step + 1);
      const bool is_border = step == 0 ? at_border(before) : is_border_after;
      is_border_after = at_border(after);
      if (is_border_after == is_border) continue;
      constexpr int kHalvings = 30;
      for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (before + after);
        (at_border(middle) == is_border ? before : after) = middle;
      }
      pieces.push_back(0.5 * (before + after));
    }
    // If the lens ends before the corner, its edge is smooth at that azimuth: no cut is needed.
    const bool last = side + 2 == corners.size();
    if (last || is_border_after || at_border(corners[side + 1] + kJustInside)) pieces.push_back(corners[side + 1]);
  }
  return pieces;
}

/// Samples in polar coordinates about a pixel (mostly the principal point), piece by piece of the field of view.
class PolarSampler {
 public:
  PolarSampler(const Rays& rays, const Pixel& centre, int count)
      : rays_(rays), centre_(centre), pieces_(ends_of_smooth_pieces(rays, centre)) {
    // Errors change fast along the radius (like tan^7 for radtan), so that many radii are needed.
    constexpr int kFewestRadii = 10;
    constexpr int kMostRadii = 40;
    const int pieces = static_cast<int>(pieces_.size()) - 1;
    radii_ = std::clamp(count / (kFewestAzimuths * pieces), kFewestRadii, kMostRadii);
    azimuths_per_radian_ = count / (radii_ * 2.0 * std::numbers::pi);
  }

  /// The samples. Their weights do not sum to 1.
  std::vector<Correspondence> run() {
    for (std::size_t piece = 0; piece + 1 < pieces_.size(); ++piece) {
      const double begin = pieces_[piece];
      const double end = pieces_[piece + 1];
      if (reaches_border(rays_, centre_, 0.5 * (begin + end))) {
        add_triangle(begin, end);
      } else {
        add_sector(begin, end);
      }
    }
    return samples_of(rays_, candidates_);
  }

 private:
  static constexpr int kFewestAzimuths = 3;  ///< In one piece.

  static Pixel direction(double azimuth) { return {std::cos(azimuth), std::sin(azimuth)}; }

  /// Samples a sector that ends at the lens's edge. Errors change slowly with the azimuth there. Along the radius their
  /// derivative may be infinite at the edge: if the source's domain ends there, its image radius stops growing with the angle.
  /// With the substitution r = edge sin(pi t / 2), errors are smooth functions of t.
  void add_sector(double begin, double end) {
    const double span = end - begin;
    const int azimuths = std::max(kFewestAzimuths, static_cast<int>(std::lround(azimuths_per_radian_ * span)));
    for (const Node& azimuth : gauss_legendre(azimuths)) {
      const double phi = begin + azimuth.position * span;
      const double edge = distance_to_edge(rays_, centre_, phi);
      for (const Node& node : gauss_legendre(radii_)) {
        const double angle = 0.5 * std::numbers::pi * node.position;  // of the substitution
        const double derivative = 0.5 * std::numbers::pi * std::cos(angle);
        const double weight = azimuth.weight * span * edge * edge * node.weight * derivative * std::sin(angle);
        candidates_.push_back({along(centre_, direction(phi), edge * std::sin(angle)), weight});
      }
    }
  }

  /// Samples a triangle that ends at a side of the image. Its azimuths are Gauss-Legendre nodes along the side, so that a
  /// polynomial of the pixel is a polynomial along the side, too. Errors grow as fast towards the corners as along the radius.
  void add_triangle(double begin, double end) {
    const auto border = [&](double azimuth) {
      return along(centre_, direction(azimuth), distance_to_border(rays_.size(), centre_, direction(azimuth)));
    };
    const Pixel first = border(begin + 1e-12);
    const Pixel last = border(end - 1e-12);
    const double length = std::hypot(last[0] - first[0], last[1] - first[1]);
    const double whole = std::max(rays_.size().width, rays_.size().height);
    const double twice_area =
        std::abs((first[0] - centre_[0]) * (last[1] - centre_[1]) - (first[1] - centre_[1]) * (last[0] - centre_[0]));
    const int along_side = std::max(kFewestAzimuths, static_cast<int>(std::lround(radii_ * length / whole)));
    for (const Node& node : gauss_legendre(along_side)) {
      const Pixel border_point = {first[0] + node.position * (last[0] - first[0]),
                                  first[1] + node.position * (last[1] - first[1])};
      const Pixel to_border = {border_point[0] - centre_[0], border_point[1] - centre_[1]};
      for (const Node& radius : gauss_legendre(radii_ - 1)) {
        const double weight = node.weight * twice_area * radius.weight * radius.position;
        candidates_.push_back({along(centre_, to_border, radius.position), weight});
      }
      // Pixels on the border extend half a pixel beyond it.
      candidates_.push_back({border_point, 0.5 * node.weight * length});
    }
  }

  const Rays& rays_;
  Pixel centre_;
  std::vector<double> pieces_;  ///< The azimuths at which the pieces begin, and the end of the last one [rad].
  int radii_ = 0;               ///< The number of radii at each azimuth.
  double azimuths_per_radian_ = 0.0;
  std::vector<Candidate> candidates_;
};

/// True if the four corners, and so the whole image, are in the field of view.
bool is_whole_image(const Rays& rays) {
  const double width = rays.size().width - 1.0;
  const double height = rays.size().height - 1.0;
  return std::ranges::all_of(std::array<Pixel, 4>{{{0.0, 0.0}, {width, 0.0}, {0.0, height}, {width, height}}},
                             [&](const Pixel& corner) { return rays.has(corner); });
}

}  // namespace

std::vector<Correspondence> sample(const Lens& source, const FieldOfView& field_of_view, int count) {
  // The centre of the polar samples: the principal point or, if that is outside the circle, the circle's centre.
  Pixel centre = source.centre().point;
  if (!field_of_view.is_lit(centre)) centre = field_of_view.circle->centre;
  const bool is_centre_inside = centre[0] > 0.0 && centre[1] > 0.0 && centre[0] < field_of_view.size.width - 1.0 &&
                                centre[1] < field_of_view.size.height - 1.0;
  const Rays rays(source, field_of_view);
  std::vector<Correspondence> samples;
  if (is_centre_inside && !is_whole_image(rays)) {
    samples = PolarSampler(rays, centre, count).run();
  } else {
    // If the principal point is outside the image, which is rare, many points of the grid are dropped: it must be finer.
    samples = sample_rectangle(rays, is_centre_inside ? count : 4 * count);
  }
  double total = 0.0;
  for (const Correspondence& s : samples) total += s.weight;
  for (Correspondence& s : samples) s.weight /= total;
  return samples;
}

}  // namespace fca
