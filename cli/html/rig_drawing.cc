// SPDX-License-Identifier: BSD-3-Clause
#include "rig_drawing.h"

#include "nice_numbers.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace fca::cli {

namespace {

using Point = std::array<double, 2>;
using Point3 = std::array<double, 3>;
using Kind = PlacedRig::Frame::Kind;

/// A way to look at the rig: which coordinates of the first frame go to the right and down in the figure.
struct View {
  std::string title;
  std::string legend;
  std::size_t right;
  std::size_t down;
  double down_sign;

  [[nodiscard]] Point seen(const Point3& point) const { return {point.at(right), down_sign * point.at(down)}; }
};

Point3 moved(const Transform& T_a_b, const Point3& point) {
  Point3 result{};
  for (int row = 0; row < 3; ++row) {
    double sum = T_a_b(row, 3);
    for (int column = 0; column < 3; ++column) sum += T_a_b(row, column) * point.at(static_cast<std::size_t>(column));
    result.at(static_cast<std::size_t>(row)) = sum;
  }
  return result;
}

struct Box {
  Point low{1e300, 1e300};
  Point high{-1e300, -1e300};

  void add(const Point& point) {
    for (const std::size_t i : {0U, 1U}) {
      low.at(i) = std::min(low.at(i), point.at(i));
      high.at(i) = std::max(high.at(i), point.at(i));
    }
  }
  [[nodiscard]] double width() const { return high[0] - low[0]; }
  [[nodiscard]] double height() const { return high[1] - low[1]; }
  [[nodiscard]] bool meets(const Box& other) const {
    return low[0] < other.high[0] && other.low[0] < high[0] && low[1] < other.high[1] && other.low[1] < high[1];
  }
};

/// A camera is a pyramid towards what it sees: its corners, in lengths of an axis.
constexpr double kDeep = 0.75;
constexpr std::array<Point3, 4> kCorners = {
    {{-0.5, -0.38, kDeep}, {0.5, -0.38, kDeep}, {0.5, 0.38, kDeep}, {-0.5, 0.38, kDeep}}};
constexpr std::array<Point3, 3> kAxes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr std::array<const char*, 3> kAxisStyles = {"axis x", "axis y", "axis z"};

Point3 scaled(const Point3& point, double factor) { return {factor * point[0], factor * point[1], factor * point[2]}; }

Box extent(const PlacedRig& placed, const View& view, double axis_m) {
  Box box;
  for (const PlacedRig::Frame& frame : placed.frames) {
    box.add(view.seen(moved(frame.T_first_frame, {0, 0, 0})));
    for (const Point3& axis : kAxes) box.add(view.seen(moved(frame.T_first_frame, scaled(axis, axis_m))));
    if (frame.kind != Kind::kCamera) continue;
    for (const Point3& corner : kCorners) box.add(view.seen(moved(frame.T_first_frame, scaled(corner, axis_m))));
  }
  return box;
}

/// As long as lets one tell the frames apart.
double axis_length(const PlacedRig& placed) {
  double farthest = 0.0;
  for (const PlacedRig::Frame& frame : placed.frames) {
    for (int row = 0; row < 3; ++row) farthest = std::max(farthest, std::abs(frame.T_first_frame(row, 3)));
  }
  constexpr double kOfTheRig = 0.22;
  constexpr double kAlone = 0.05;
  return farthest > 0.0 ? kOfTheRig * farthest : kAlone;
}

std::string length_in_words(double metres, bool in_metres) {
  if (!in_metres) return text::format_short(metres, 3) + " units";
  if (metres < 0.0099) return text::format_short(1e3 * metres, 3) + " mm";
  if (metres < 0.99) return text::format_short(100.0 * metres, 3) + " cm";
  return text::format_short(metres, 3) + " m";
}

constexpr double kWidth = 480.0;
constexpr double kMargin = 40.0;
constexpr double kBelow = 34.0;  // for the scale bar
constexpr double kMostHeight = 400.0;
constexpr double kLeastHeight = 90.0;

/// One figure.
class Drawing {
 public:
  Drawing(const PlacedRig& placed, const View& view, double axis_m, double px_per_m)
      : placed_(placed), view_(view), axis_m_(axis_m), scale_(px_per_m), box_(extent(placed, view, axis_m)) {
    height_ = std::max(kLeastHeight, scale_ * box_.height() + 2.0 * kMargin) + kBelow;
    constexpr int kPieces = 8;
    for (const PlacedRig::Frame& frame : placed.frames) {
      for (const Point3& axis : kAxes) {
        for (int i = 0; i <= kPieces; ++i) {
          const Point point = at(frame.T_first_frame, scaled(axis, axis_m * i / kPieces));
          lines_.push_back({{point[0] - 3.0, point[1] - 3.0}, {point[0] + 3.0, point[1] + 3.0}});
        }
      }
    }
  }

  void put(Html& html, bool in_metres) {
    std::vector<std::string> names;
    for (const PlacedRig::Frame& frame : placed_.frames) names.push_back(frame.name);
    html.element("figure", {{"class", "rig"}}, [&] {
      html.element("figcaption", {}, view_.title);
      html.element("svg",
                   {{"class", "chart"},
                    {"viewBox", "0 0 " + coordinate(kWidth) + " " + coordinate(height_)},
                    {"role", "img"},
                    {"aria-label", view_.title}},
                   [&] {
                     for (const PlacedRig::Frame& frame : placed_.frames) put_frame(html, frame);
                     for (const PlacedRig::Frame& frame : placed_.frames) put_name(html, frame);
                     put_scale_bar(html, in_metres);
                   });
      html.element("div", {{"class", "legend"}}, [&] {
        for (std::size_t i = 0; i < kAxisStyles.size(); ++i) {
          html.element("span", {{"class", "entry"}}, [&] {
            html.element("svg", {{"class", "sample"}, {"viewBox", "0 0 30 10"}, {"aria-hidden", "true"}}, [&] {
              html.element("path", {{"class", kAxisStyles.at(i)}, {"d", "M0 5L30 5"}}, "");
            });
            html.text(std::string(1, static_cast<char>('x' + i)));
          });
        }
        html.element("span", {{"class", "entry"}}, view_.legend);
      });
    });
  }

 private:
  [[nodiscard]] Point at(const Transform& T_first_frame, const Point3& point) const {
    const Point seen = view_.seen(moved(T_first_frame, point));
    return {0.5 * kWidth + scale_ * (seen[0] - 0.5 * (box_.low[0] + box_.high[0])),
            0.5 * (height_ - kBelow) + scale_ * (seen[1] - 0.5 * (box_.low[1] + box_.high[1]))};
  }

  static std::string path(const std::vector<Point>& points, bool closed) {
    std::string text;
    for (const Point& point : points) text += (text.empty() ? "M" : "L") + coordinate(point[0]) + " " + coordinate(point[1]);
    return closed ? text + "Z" : text;
  }

  void put_frame(Html& html, const PlacedRig::Frame& frame) const {
    const Transform& T = frame.T_first_frame;
    const Point origin = at(T, {0, 0, 0});
    if (frame.kind == Kind::kCamera) {
      std::vector<Point> corners;
      corners.reserve(kCorners.size());
      for (const Point3& corner : kCorners) corners.push_back(at(T, scaled(corner, axis_m_)));
      html.element("path", {{"class", "body"}, {"d", path(corners, true)}}, "");
      for (const Point& corner : corners) html.element("path", {{"class", "body"}, {"d", path({origin, corner}, false)}}, "");
    }
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
      const std::vector<Point> line = {origin, at(T, scaled(kAxes.at(i), axis_m_))};
      html.element("path", {{"class", kAxisStyles.at(i)}, {"d", path(line, false)}}, "");
    }
    const std::string x = coordinate(origin[0]);
    const std::string y = coordinate(origin[1]);
    if (frame.kind == Kind::kImu) {
      html.element("rect",
                   {{"class", "imu"},
                    {"x", coordinate(origin[0] - 6.0)},
                    {"y", coordinate(origin[1] - 6.0)},
                    {"width", "12"},
                    {"height", "12"}},
                   "");
    } else {
      html.element("circle", {{"class", "origin"}, {"cx", x}, {"cy", y}, {"r", "3.5"}}, "");
    }
  }

  /// Next to its origin, where nothing else is written.
  void put_name(Html& html, const PlacedRig::Frame& frame) {
    const Point origin = at(frame.T_first_frame, {0, 0, 0});
    constexpr double kLetter = 7.6;
    constexpr double kLine = 15.0;
    constexpr std::size_t kLongest = 24;
    const std::string name = frame.name.size() > kLongest ? frame.name.substr(0, kLongest) + "\u2026" : frame.name;
    const double width = kLetter * static_cast<double>(name.size());
    const auto overlaps = [](const std::vector<Box>& others, const Box& box) {
      return std::ranges::any_of(others, [&box](const Box& other) { return other.meets(box); });
    };
    // Where nothing is drawn, either, if there is such a place.
    std::optional<Box> found;
    for (const bool over_lines : {false, true}) {
      for (const double away : {10.0, 24.0, 40.0, 58.0}) {
        for (const Point& way :
             {Point{0, 1}, Point{0, -1}, Point{1, 1}, Point{-1, 1}, Point{1, -1}, Point{-1, -1}, Point{1, 0}, Point{-1, 0}}) {
          const double x = origin[0] + way[0] * (away + 0.5 * width);
          const double y = origin[1] + way[1] * (away + 0.5 * kLine);
          const Box box = {{x - 0.5 * width, y - 0.5 * kLine}, {x + 0.5 * width, y + 0.5 * kLine}};
          const bool inside = box.low[0] > 0.0 && box.high[0] < kWidth && box.low[1] > 0.0 && box.high[1] < height_ - kBelow;
          if (!found && inside && !overlaps(names_, box) && (over_lines || !overlaps(lines_, box))) found = box;
        }
      }
    }
    if (!found) return;
    names_.push_back(*found);
    html.element("text",
                 {{"class", "label halo strong"},
                  {"x", coordinate(0.5 * (found->low[0] + found->high[0]))},
                  {"y", coordinate(found->high[1] - 3.5)},
                  {"text-anchor", "middle"}},
                 name);
  }

  void put_scale_bar(Html& html, bool in_metres) const {
    constexpr double kMostWide = 140.0;
    const double metres = nice_below(kMostWide / scale_);
    const double y = height_ - 10.0;
    const double width = metres * scale_;
    html.element("path",
                 {{"class", "frame"}, {"d", path({{8.0, y - 5.0}, {8.0, y}, {8.0 + width, y}, {8.0 + width, y - 5.0}}, false)}},
                 "");
    html.element("text", {{"class", "label"}, {"x", coordinate(16.0 + width)}, {"y", coordinate(y + 1.0)}},
                 length_in_words(metres, in_metres));
  }

  const PlacedRig& placed_;
  const View& view_;
  double axis_m_;
  double scale_;
  Box box_;
  double height_ = 0.0;
  std::vector<Box> names_;  ///< What is written already.
  std::vector<Box> lines_;  ///< And drawn: the axes in pieces.
};

}  // namespace

PlacedRig placed_rig(const Rig& rig) {
  std::vector<PlacedRig::Frame> all;
  const auto add = [&all](const std::string& name, Kind kind) {
    if (std::ranges::find(all, name, &PlacedRig::Frame::name) == all.end()) all.push_back({name, {}, kind});
  };
  for (const Camera& camera : rig.cameras) add(camera.name, Kind::kCamera);
  for (const Imu& imu : rig.imus) add(imu.name, Kind::kImu);
  for (const PoseEdge& edge : rig.poses) {
    for (const std::string& name : {edge.a, edge.b})
      add(name, rig.kind_of(name) == FrameKind::kImu ? Kind::kImu : Kind::kOther);
  }
  PlacedRig placed;
  for (PlacedRig::Frame& frame : all) {
    const bool first = placed.frames.empty();
    const std::optional<Transform> T = first ? Transform{} : rig.resolve(placed.frames.front().name, frame.name);
    const bool finite = T && std::ranges::all_of(T->values, [](double value) { return std::isfinite(value); });
    if (!finite) {
      placed.unplaced.push_back(frame.name);
      continue;
    }
    frame.T_first_frame = *T;
    placed.frames.push_back(frame);
  }
  return placed;
}

void put_rig(Html& html, const PlacedRig& placed, bool in_metres) {
  const std::string& first = placed.frames.front().name;
  const std::array<View, 2> views = {
      View{"From above " + first, "of " + first + ": x to the right, z up the page", 0, 2, -1.0},
      View{"From the right of " + first, "of " + first + ": z to the right, y down the page", 2, 1, 1.0}};
  const double axis_m = axis_length(placed);
  // One scale for both.
  double px_per_m = 1e300;
  for (const View& view : views) {
    const Box box = extent(placed, view, axis_m);
    px_per_m = std::min({px_per_m, (kWidth - 2.0 * kMargin) / box.width(), (kMostHeight - 2.0 * kMargin) / box.height()});
  }
  for (const View& view : views) Drawing(placed, view, axis_m, px_per_m).put(html, in_metres);
}

}  // namespace fca::cli
