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

template <class... Ms>
bool is_any_of(const CameraModel& model) {
  return (std::holds_alternative<Intrinsics<Ms>>(model) || ...);
}

/// Rays of the field of view's pixels, faster than FieldOfView::ray(). That computes an angle, which takes longer than most
/// models' rays; here the ray's z nearly always decides.
class Rays {
 public:
  Rays(const Lens& source, const FieldOfView& field_of_view)
      : source_(source), field_of_view_(field_of_view), lowest_(std::cos(field_of_view.max_angle_rad)) {}

  [[nodiscard]] std::optional<Ray> operator()(const Pixel& pixel) const {
    if (!is_lit(pixel)) return std::nullopt;
    std::optional<Ray> ray = source_.ray(pixel);
    if (!ray || surely_inside((*ray)[2])) return ray;
    if ((*ray)[2] < lowest_ - kUnclear || angle_from_axis(*ray) > field_of_view_.max_angle_rad) return std::nullopt;
    return ray;
  }
  [[nodiscard]] bool surely_inside(double cosine) const { return cosine > lowest_ + kUnclear; }
  /// Kernels for many pixels, for models whose rays need a search; nullopt for other models, whose rays are as fast one by one.
  [[nodiscard]] std::optional<internal::BatchRays> batch() const {
    const CameraModel* model = source_.model();
    if (model == nullptr || !is_any_of<Kb4, Radtan, Rational>(*model) || !validate(*model).empty()) return std::nullopt;
    return internal::BatchRays(*model, field_of_view_.max_angle_rad);
  }
  [[nodiscard]] bool is_lit(const Pixel& pixel) const { return field_of_view_.is_lit(pixel); }
  [[nodiscard]] bool has(const Pixel& pixel) const { return (*this)(pixel).has_value(); }
  /// How far a pixel's ray lies beyond the field of view's edge [rad; at a circle's edge approximately]; negative inside.
  /// nullopt if the source has no ray.
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
  static constexpr double kUnclear = 1e-9;
  const Lens& source_;
  const FieldOfView& field_of_view_;
  double lowest_;  ///< Cosine of the field of view's largest angle.
};

/// A pixel that may be a sample.
struct Candidate {
  Pixel pixel;
  double weight;
};

/// Samples of the candidates that have a ray in the field of view.
std::vector<Correspondence> seen_of(const Rays& rays, const std::vector<Candidate>& candidates) {
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

/// Samples a tensor grid of Gauss nodes over the whole image; points outside the field of view are dropped.
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
  return seen_of(rays, candidates);
}

/// The distance, in units of `direction`, from `centre` to the image's border.
double distance_to_border(const ImageSize& size, const Pixel& centre, const Pixel& direction) {
  const Pixel last = {size.width - 1.0, size.height - 1.0};
  double far = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < direction.size(); ++k) {
    if (direction[k] > 0.0) far = std::min(far, (last[k] - centre[k]) / direction[k]);
    if (direction[k] < 0.0) far = std::min(far, -centre[k] / direction[k]);
  }
  constexpr double kJustInside = 1.0 - 1e-12;  // rounding must not put the border outside the image
  return far * kJustInside;
}

Pixel along(const Pixel& centre, const Pixel& direction, double distance) {
  return {centre[0] + distance * direction[0], centre[1] + distance * direction[1]};
}

/// True if the field of view reaches the image's border at that azimuth [rad].
bool reaches_border(const Rays& rays, const Pixel& centre, double azimuth) {
  const Pixel direction = {std::cos(azimuth), std::sin(azimuth)};
  return rays.has(along(centre, direction, distance_to_border(rays.size(), centre, direction)));
}

/// The distance [px] from `centre` to the edge of the field of view at that azimuth [rad]: to the image's border, or to the
/// lens's edge if that comes first. The edge is found in a bracket, since angles grow along the way: by regula falsi (Illinois)
/// if the source has rays beyond it, by halving if it has none.
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

/// Azimuths [rad] between which the field of view's edge is smooth: those of the image's corners, and those at which the edge
/// changes between the image's border and the lens's edge.
std::vector<double> smooth_pieces(const Rays& rays, const Pixel& centre) {
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
  constexpr double kHair = 1e-9;
  std::vector<double> pieces = {corners.front()};
  for (std::size_t side = 0; side + 1 < corners.size(); ++side) {
    const double span = corners[side + 1] - corners[side];
    // A corner belongs to two sides: look slightly inside this one.
    const auto azimuth_of = [&](int step) {
      return corners[side] + span * std::clamp(static_cast<double>(step) / kStepsPerSide, kHair, 1.0 - kHair);
    };
    bool kind_after = false;
    for (int step = 0; step < kStepsPerSide; ++step) {
      double before = azimuth_of(step);
      double after = azimuth_of(step + 1);
      const bool kind = step == 0 ? at_border(before) : kind_after;
      kind_after = at_border(after);
      if (kind_after == kind) continue;
      constexpr int kHalvings = 30;
      for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (before + after);
        (at_border(middle) == kind ? before : after) = middle;
      }
      pieces.push_back(0.5 * (before + after));
    }
    // If the lens ends before the corner, its edge is smooth at that azimuth: no cut is needed.
    const bool last = side + 2 == corners.size();
    if (last || kind_after || at_border(corners[side + 1] + kHair)) pieces.push_back(corners[side + 1]);
  }
  return pieces;
}

/// Samples in polar coordinates around the principal point, piece by piece.
class PolarSampler {
 public:
  PolarSampler(const Rays& rays, const Pixel& centre, int count)
      : rays_(rays), centre_(centre), pieces_(smooth_pieces(rays, centre)) {
    // Errors change fast along the radius (tan^7 for radtan).
    constexpr int kFewestRadii = 10;
    constexpr int kMostRadii = 40;
    const int pieces = static_cast<int>(pieces_.size()) - 1;
    radial_ = std::clamp(count / (kFewestAzimuths * pieces), kFewestRadii, kMostRadii);
    azimuths_per_radian_ = count / (radial_ * 2.0 * std::numbers::pi);
  }

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
    return seen_of(rays_, candidates_);
  }

 private:
  static constexpr int kFewestAzimuths = 3;

  static Pixel direction(double azimuth) { return {std::cos(azimuth), std::sin(azimuth)}; }

  /// Samples a sector that ends at the lens's edge. There errors change slowly with the azimuth. Along the radius they may
  /// change without limit: where the source's own domain ends, its image radius stops growing with the angle. The substitution
  /// r = edge sin(pi t / 2) matches that.
  void add_sector(double begin, double end) {
    const double span = end - begin;
    const int azimuths = std::max(kFewestAzimuths, static_cast<int>(std::lround(azimuths_per_radian_ * span)));
    for (const Node& azimuth : gauss_legendre(azimuths)) {
      const double phi = begin + azimuth.position * span;
      const double edge = distance_to_edge(rays_, centre_, phi);
      for (const Node& node : gauss_legendre(radial_)) {
        const double turn = 0.5 * std::numbers::pi * node.position;
        const double derivative = 0.5 * std::numbers::pi * std::cos(turn);
        const double weight = azimuth.weight * span * edge * edge * node.weight * derivative * std::sin(turn);
        candidates_.push_back({along(centre_, direction(phi), edge * std::sin(turn)), weight});
      }
    }
  }

  /// Samples a triangle that ends at a side of the image. The nodes lie evenly along the side, so that a polynomial of the
  /// pixel remains one along it. Errors grow as fast towards its corners as along the radius.
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
    const int along_side = std::max(kFewestAzimuths, static_cast<int>(std::lround(radial_ * length / whole)));
    for (const Node& node : gauss_legendre(along_side)) {
      const Pixel border_point = {first[0] + node.position * (last[0] - first[0]),
                                  first[1] + node.position * (last[1] - first[1])};
      const Pixel to_border = {border_point[0] - centre_[0], border_point[1] - centre_[1]};
      for (const Node& radius : gauss_legendre(radial_ - 1)) {
        const double weight = node.weight * twice_area * radius.weight * radius.position;
        candidates_.push_back({along(centre_, to_border, radius.position), weight});
      }
      // Pixels on the border extend half a pixel beyond it.
      candidates_.push_back({border_point, 0.5 * node.weight * length});
    }
  }

  const Rays& rays_;
  Pixel centre_;
  std::vector<double> pieces_;
  int radial_ = 0;
  double azimuths_per_radian_ = 0.0;
  std::vector<Candidate> candidates_;
};

bool whole_image(const Rays& rays) {
  const double width = rays.size().width - 1.0;
  const double height = rays.size().height - 1.0;
  return std::ranges::all_of(std::array<Pixel, 4>{{{0.0, 0.0}, {width, 0.0}, {0.0, height}, {width, height}}},
                             [&](const Pixel& corner) { return rays.has(corner); });
}

}  // namespace

std::vector<Correspondence> sample(const Lens& source, const FieldOfView& field_of_view, int count) {
  Pixel centre = source.centre().point;
  if (!field_of_view.is_lit(centre)) centre = field_of_view.circle->centre;
  const bool centred = centre[0] > 0.0 && centre[1] > 0.0 && centre[0] < field_of_view.size.width - 1.0 &&
                       centre[1] < field_of_view.size.height - 1.0;
  const Rays rays(source, field_of_view);
  std::vector<Correspondence> samples;
  if (centred && !whole_image(rays)) {
    samples = PolarSampler(rays, centre, count).run();
  } else {
    // A principal point outside the image is rare. A finer tensor grid compensates for the points that are dropped.
    samples = sample_rectangle(rays, centred ? count : 4 * count);
  }
  double total = 0.0;
  for (const Correspondence& s : samples) total += s.weight;
  for (Correspondence& s : samples) s.weight /= total;
  return samples;
}

}  // namespace fca
