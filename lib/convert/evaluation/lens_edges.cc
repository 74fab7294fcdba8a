// SPDX-License-Identifier: BSD-3-Clause
#include "lens_edges.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace fca::internal {

namespace {

/// Factors that keep points on an edge inside the field of view in spite of rounding: for angles and radii in general, and for
/// the angle at which a lens folds. There the image radius hardly changes with the angle, so that the margin must be larger.
constexpr double kInside = 1.0 - 1e-9;
constexpr double kInsideFold = 1.0 - 1e-7;

/// The angle from the axis [rad] up to which pixels are scored, less that margin for rounding.
double scored_angle(const Scorer& scorer) {
  double fold = max_angle(*scorer.source().model());
  if (scorer.target() != nullptr) fold = std::min(fold, max_angle(*scorer.target()));
  return std::min(kInside * std::min(scorer.field_of_view().max_angle_rad, scorer.target_max_angle_rad()), kInsideFold * fold);
}

/// True if a corner of the image has no ray or a ray beyond the angle: the edge at that angle then lies in the image, because
/// angles are largest in the corners.
bool ends_inside(const Scorer& scorer, double angle_rad) {
  const ImageSize& size = scorer.field_of_view().size;
  for (const double u : {0.0, size.width - 1.0}) {
    for (const double v : {0.0, size.height - 1.0}) {
      const std::optional<Ray> ray = scorer.source().ray({u, v});
      if (!ray || angle_from_axis(*ray) > angle_rad) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<LensEdge> lens_edges(const Scorer& scorer) {
  const ImageSize& size = scorer.field_of_view().size;
  const auto in_image = [size](const std::optional<Pixel>& pixel) {
    return pixel && size.holds(*pixel) ? pixel : std::nullopt;
  };
  std::vector<LensEdge> edges;
  const double max_angle = scored_angle(scorer);
  if (ends_inside(scorer, max_angle)) {
    const auto at = [&scorer, in_image, max_angle](double azimuth) {
      const Ray ray = {std::sin(max_angle) * std::cos(azimuth), std::sin(max_angle) * std::sin(azimuth), std::cos(max_angle)};
      return in_image(project(*scorer.source().model(), ray));
    };
    constexpr double kMargin = 1e-5;  // as a fraction of the range of cosines inside the edge
    const double largest_cosine = std::cos(max_angle) + kMargin * (1.0 - std::cos(max_angle));
    edges.push_back({at, [largest_cosine](const Point& point) { return point.cosine < largest_cosine; }});
  }
  if (const std::optional<LensCircle>& circle = scorer.field_of_view().circle) {
    LensCircle inner = *circle;
    inner.radius_px *= kInside;
    constexpr double kMarginPx = 1e-3;
    edges.push_back({[in_image, inner](double azimuth) { return in_image(inner.rim(azimuth)); },
                     [inner](const Point& point) { return inner.beyond(point.pixel) > -kMarginPx; }});
  }
  return edges;
}

std::vector<Point> points_of(const Scorer& scorer, const LensEdge& edge, int azimuths) {
  std::vector<Point> points(static_cast<std::size_t>(azimuths));
  std::vector<Point> inside;
  inside.reserve(points.size());
  std::vector<std::size_t> at;
  at.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::optional<Pixel> pixel = edge.at(2.0 * std::numbers::pi * static_cast<double>(i) / azimuths);
    if (!pixel) continue;
    inside.emplace_back().pixel = *pixel;
    at.push_back(i);
  }
  scorer.score(inside);
  for (std::size_t k = 0; k < at.size(); ++k) points[at[k]] = inside[k];
  return points;
}

}  // namespace fca::internal
