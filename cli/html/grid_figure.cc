// SPDX-License-Identifier: BSD-3-Clause
#include "grid_figure.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace fca::cli {

namespace {

constexpr int kLines = 12;  // along each side

struct Extent {
  Pixel low{};
  Pixel high{};
};

/// Of the camera's pixels.
Extent extent_of(const CameraDistance& distance) {
  Extent extent{{1e300, 1e300}, {-1e300, -1e300}};
  for (const std::optional<SeenPixel>& point : distance.grid) {
    for (std::size_t i = 0; point && i < 2; ++i) {
      extent.low.at(i) = std::min(extent.low.at(i), point->camera.at(i));
      extent.high.at(i) = std::max(extent.high.at(i), point->camera.at(i));
    }
  }
  return extent;
}

/// How many times larger differences are drawn: the worst about a third of the distance between two lines.
double enlargement(const CameraDistance& distance, double cell_px) {
  double worst = 0.0;
  for (const std::optional<SeenPixel>& point : distance.grid) {
    if (!point || !point->program) continue;
    worst = std::max(worst, std::hypot((*point->program)[0] - point->camera[0], (*point->program)[1] - point->camera[1]));
  }
  constexpr double kSeen = 1e-3;  // px: less is no difference
  constexpr double kOfCell = 1.0 / 3.0;
  if (worst < kSeen) return 1.0;
  const double most = kOfCell * cell_px / worst;
  const double decade = std::pow(10.0, std::floor(std::log10(most)));
  const double nice = most >= 5.0 * decade ? 5.0 : most >= 2.0 * decade ? 2.0 : 1.0;
  return std::max(1.0, nice * decade);
}

using PointOf = std::function<std::optional<Pixel>(const SeenPixel& point)>;

/// "M 0 0 L 1 1 ...": the lines of the grid through those points.
std::string lines_through(const CameraDistance& distance, const PointOf& point_of) {
  const int steps = distance.grid_steps;
  const int stride = std::max(1, steps / kLines);
  std::string path;
  const auto add_line = [&](const std::function<std::size_t(int)>& index) {
    bool is_drawn = false;
    for (int i = 0; i <= steps; ++i) {
      const std::optional<SeenPixel>& point = distance.grid[index(i)];
      const std::optional<Pixel> at = point ? point_of(*point) : std::nullopt;
      if (at) path += (is_drawn ? "L" : "M") + coordinate((*at)[0]) + " " + coordinate((*at)[1]);
      is_drawn = at.has_value();
    }
  };
  for (int line = 0; line <= steps; line += stride) {
    add_line([&](int i) { return static_cast<std::size_t>(line * (steps + 1) + i); });
    add_line([&](int i) { return static_cast<std::size_t>(i * (steps + 1) + line); });
  }
  return path;
}

}  // namespace

void put_grid(Html& html, const std::string& camera, const std::string& program, const CameraDistance& distance) {
  if (distance.grid_steps == 0 || std::ranges::none_of(distance.grid, [](const auto& point) { return point.has_value(); }))
    return;
  const Extent extent = extent_of(distance);
  const double width = std::max(1.0, extent.high[0] - extent.low[0]);
  const double height = std::max(1.0, extent.high[1] - extent.low[1]);
  const double factor = enlargement(distance, std::min(width, height) / kLines);
  constexpr double kWidth = 240.0;  // of the drawing
  constexpr double kMargin = 12.0;
  const double scale = (kWidth - 2.0 * kMargin) / width;
  const auto drawn = [&](const Pixel& pixel) -> Pixel {
    return {kMargin + scale * (pixel[0] - extent.low[0]), kMargin + scale * (pixel[1] - extent.low[1])};
  };
  const auto before = [&](const SeenPixel& point) { return std::optional(drawn(point.camera)); };
  const auto after = [&](const SeenPixel& point) -> std::optional<Pixel> {
    if (!point.program) return std::nullopt;
    const double u = point.camera[0] + factor * ((*point.program)[0] - point.camera[0]);
    const double v = point.camera[1] + factor * ((*point.program)[1] - point.camera[1]);
    return drawn({u, v});
  };
  const std::string times = factor > 1.0 ? ", differences " + text::format_short(factor) + " times as large" : "";
  const std::string what = camera + ": the image's pixels, and where " + program + " sees them" + times;
  html.element("figure", {{"class", "tile"}}, [&] {
    html.element("svg",
                 {{"viewBox", "0 0 " + coordinate(kWidth) + " " + coordinate(scale * height + 2.0 * kMargin)},
                  {"class", "thumbnail"},
                  {"role", "img"},
                  {"aria-label", what}},
                 [&] {
                   html.element("path", {{"class", "lattice before"}, {"d", lines_through(distance, before)}}, "");
                   html.element("path", {{"class", "lattice after"}, {"d", lines_through(distance, after)}}, "");
                 });
    html.element("div", {{"class", "soft"}}, what);
  });
}

}  // namespace fca::cli
