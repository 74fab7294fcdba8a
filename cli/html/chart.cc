// SPDX-License-Identifier: BSD-3-Clause
#include "chart.h"

#include "nice_numbers.h"

#include <algorithm>
#include <cmath>

namespace fca::cli {

namespace {

constexpr double kWidth = 480.0;
constexpr double kHeight = 300.0;
constexpr double kLeft = 52.0;
constexpr double kRight = 466.0;
constexpr double kTop = 26.0;
constexpr double kBottom = 256.0;

double share_of(const Axis& axis, double value) {
  if (axis.logarithmic) return std::log(value / axis.from) / std::log(axis.to / axis.from);
  return (value - axis.from) / (axis.to - axis.from);
}

double x_of(const Chart& chart, double value) { return kLeft + (kRight - kLeft) * share_of(chart.x, value); }
double y_of(const Chart& chart, double value) { return kBottom - (kBottom - kTop) * share_of(chart.y, value); }

void put_label(Html& html, double x, double y, const char* anchor, const std::string& text, const char* style = "label") {
  html.element("text", {{"class", style}, {"x", coordinate(x)}, {"y", coordinate(y)}, {"text-anchor", anchor}}, text);
}

void put_line(Html& html, const char* style, double x1, double y1, double x2, double y2) {
  html.element(
      "line",
      {{"class", style}, {"x1", coordinate(x1)}, {"y1", coordinate(y1)}, {"x2", coordinate(x2)}, {"y2", coordinate(y2)}}, "");
}

std::vector<double> ticks_of(const Axis& axis, int count) {
  return axis.logarithmic ? decades(axis.from, axis.to) : linear_ticks(axis.from, axis.to, count);
}

void put_axes(Html& html, const Chart& chart) {
  constexpr double kBelow = 18.0;
  constexpr double kBeside = 7.0;
  constexpr double kHalfLine = 4.5;
  for (const double tick : ticks_of(chart.y, 5)) {
    const double y = y_of(chart, tick);
    put_line(html, "grid", kLeft, y, kRight, y);
    put_label(html, kLeft - kBeside, y + kHalfLine, "end", tick_label(tick));
  }
  for (const double tick : ticks_of(chart.x, 6)) {
    const double x = x_of(chart, tick);
    put_line(html, "grid", x, kTop, x, kBottom);
    put_label(html, x, kBottom + kBelow, "middle", tick_label(tick));
  }
  put_line(html, "frame", kLeft, kBottom, kRight, kBottom);
  put_line(html, "frame", kLeft, kTop, kLeft, kBottom);
  put_label(html, 2.0, kTop - 12.0, "start", chart.y.title);
  put_label(html, kRight, kHeight - 6.0, "end", chart.x.title);
}

/// The words stand in rows of their own: two lines may be close to each other.
void put_marks(Html& html, const Chart& chart) {
  constexpr double kRow = 16.0;
  double y = kTop + kRow;
  for (const Mark& mark : chart.marks) {
    if (mark.x < chart.x.from || mark.x > chart.x.to) continue;
    const double x = x_of(chart, mark.x);
    put_line(html, "mark", x, kTop, x, kBottom);
    const bool left = x > 0.5 * (kLeft + kRight);
    put_label(html, left ? x - 5.0 : x + 5.0, y, left ? "end" : "start", mark.label, "label halo");
    y += kRow;
  }
}

void put_curve(Html& html, const Chart& chart, const Curve& curve) {
  std::string path;
  bool pen_down = false;
  const auto inside = [](const Axis& axis, double value) {
    return std::isfinite(value) && value >= std::min(axis.from, axis.to) && value <= std::max(axis.from, axis.to);
  };
  for (const auto& [x, y] : curve.points) {
    if (!inside(chart.x, x) || !inside(chart.y, y)) {
      pen_down = false;
      continue;
    }
    path += (pen_down ? "L" : "M") + coordinate(x_of(chart, x)) + " " + coordinate(y_of(chart, y));
    pen_down = true;
  }
  if (!path.empty()) html.element("path", {{"class", "curve " + curve.style}, {"d", path}}, "");
}

void put_legend(Html& html, const Chart& chart) {
  html.element("div", {{"class", "legend"}}, [&] {
    for (const Curve& curve : chart.curves) {
      if (curve.name.empty()) continue;
      html.element("span", {{"class", "entry"}}, [&] {
        html.element("svg", {{"class", "sample"}, {"viewBox", "0 0 30 10"}, {"aria-hidden", "true"}}, [&] {
          html.element("path", {{"class", "curve " + curve.style}, {"d", "M0 5L30 5"}}, "");
        });
        html.text(curve.name);
      });
    }
  });
}

}  // namespace

void put_chart(Html& html, const Chart& chart) {
  html.element("figure", {}, [&] {
    html.element("figcaption", {}, chart.title);
    html.element("svg",
                 {{"class", "chart"},
                  {"viewBox", "0 0 " + coordinate(kWidth) + " " + coordinate(kHeight)},
                  {"role", "img"},
                  {"aria-label", chart.what}},
                 [&] {
                   put_axes(html, chart);
                   for (const Curve& curve : chart.curves) put_curve(html, chart, curve);
                   put_marks(html, chart);
                 });
    put_legend(html, chart);
  });
}

}  // namespace fca::cli
