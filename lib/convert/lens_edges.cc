// SPDX-License-Identifier: BSD-3-Clause
#include "lens_edges.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace fca::internal {

namespace {

constexpr double kInside = 1.0 - 1e-9;  // so that rounding keeps it in the domain

Point point_at(const Scorer& scorer, const std::optional<Pixel>& pixel) {
  return pixel && scorer.domain().size.holds(*pixel) ? scorer.at(*pixel) : Point();
}

}  // namespace

std::vector<LensEdge> lens_edges(const Scorer& scorer) {
  std::vector<LensEdge> edges;
  edges.emplace_back([&scorer](double azimuth) {
    const double angle = std::min(scorer.domain().max_angle_rad, scorer.target_reach_rad()) * kInside;
    const Ray ray = {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)};
    return point_at(scorer, project(*scorer.source().model(), ray));
  });
  if (const std::optional<LensCircle>& circle = scorer.domain().circle) {
    LensCircle inner = *circle;
    inner.radius_px *= kInside;
    edges.emplace_back([&scorer, inner](double azimuth) { return point_at(scorer, inner.rim(azimuth)); });
  }
  return edges;
}

}  // namespace fca::internal
