// SPDX-License-Identifier: BSD-3-Clause
#include "map_figure.h"

#include "colour_scale.h"
#include "contours.h"
#include "nice_numbers.h"
#include "pictures/png.h"
#include "shell/base64.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace fca::cli {

namespace {

constexpr double kWidth = 480.0;
constexpr double kPictureWidth = 476.0;  // and its frame next to it
constexpr double kPictureHeight = 476.0;
constexpr double kEdge = 2.0;

/// Of what the target cannot represent: stripes, so that they are told from any colour of the scale, in grey print, too.
constexpr Rgb kStripe = {0xD8, 0x3A, 0x56};
constexpr Rgb kBetweenStripes = {0xFF, 0xE3, 0xE6};
constexpr int kStripePeriod = 10;  // cells
constexpr int kStripeWidth = 4;

/// Takes a value to its place on a scale: 0 at its begin, 1 at its end.
class ShareOfScale {
 public:
  explicit ShareOfScale(const ColourScale& scale)
      : scale_(scale), length_(scale.logarithmic ? std::log(scale.to / scale.from) : scale.to - scale.from) {}
  [[nodiscard]] double operator()(double value) const {
    return (scale_.logarithmic ? std::log(std::max(value, scale_.from) / scale_.from) : value - scale_.from) / length_;
  }

 private:
  const ColourScale& scale_;
  double length_;
};

/// The scale's colours, and those behind them.
constexpr std::uint8_t kScaleColours = 250;
enum Behind : std::uint8_t { kTransparent = kScaleColours, kOnStripe, kNextToStripe };

std::vector<Rgba> palette() {
  const auto opaque = [](const Rgb& colour) { return Rgba{colour[0], colour[1], colour[2], 0xFF}; };
  std::vector<Rgba> colours;
  colours.reserve(kNextToStripe + 1);
  for (int i = 0; i < kScaleColours; ++i) colours.push_back(opaque(viridis(static_cast<double>(i) / (kScaleColours - 1))));
  colours.push_back({});  // outside the lens the page shows through
  colours.push_back(opaque(kStripe));
  colours.push_back(opaque(kBetweenStripes));
  return colours;
}

std::uint8_t scale_colour(double share) {
  return static_cast<std::uint8_t>(std::lround((share > 0.0 ? std::min(share, 1.0) : 0.0) * (kScaleColours - 1)));
}

Picture picture_of(const MapFigure& figure) {
  const ImageField& field = figure.field;
  Picture picture{field.columns, field.rows, palette(), {}};
  picture.colours.assign(field.parts.size(), kTransparent);
  const ShareOfScale share_of(figure.scale);
  for (int row = 0; row < field.rows; ++row) {
    for (int column = 0; column < field.columns; ++column) {
      const std::size_t i = field.index(column, row);
      std::uint8_t& colour = picture.colours[i];
      if (field.parts[i] == Part::kUnrepresentable)
        colour = (column + row) % kStripePeriod < kStripeWidth ? kOnStripe : kNextToStripe;
      if (field.parts[i] == Part::kScored) colour = scale_colour(share_of(field.values[i]));
    }
  }
  return picture;
}

/// Where pixels are in the figure.
struct Placed {
  double x = 0.0;  ///< Of the image's left border.
  double width = 0.0;
  double height = 0.0;
  ImageSize image;

  [[nodiscard]] double x_of(double u) const { return x + (u + 0.5) * width / image.width; }
  [[nodiscard]] double y_of(double v) const { return kEdge + (v + 0.5) * height / image.height; }
};

Placed place(const ImageSize& image) {
  const double scale = std::min(kPictureWidth / image.width, kPictureHeight / image.height);
  return {0.5 * (kWidth - scale * image.width), scale * image.width, scale * image.height, image};
}

std::vector<double> contour_levels(const ColourScale& scale) {
  if (!scale.logarithmic) return linear_ticks(scale.from, scale.to, 10);
  // Where it matters. Far below there are thin rings where the error changes its sign.
  constexpr double kLess = 0.02;
  std::vector<double> levels = decades(kLess * scale.to, scale.to);
  double level = scale.to;
  for (int i = 0; i < 2; ++i) {
    level = nice_below(0.9 * level);
    levels.push_back(level);
  }
  std::erase_if(levels, [&scale](double each) { return each > 0.99 * scale.to; });
  std::ranges::sort(levels);
  const auto same = [](double a, double b) { return b < 1.01 * a; };
  levels.erase(std::unique(levels.begin(), levels.end(), same), levels.end());
  return levels;
}

void put_text(Html& html, double x, double y, const char* anchor, const std::string& text, const char* style) {
  html.element("text", {{"class", style}, {"x", coordinate(x)}, {"y", coordinate(y)}, {"text-anchor", anchor}}, text);
}

using Point = std::array<double, 2>;

/// Labels keep away from each other and from the border.
class Labels {
 public:
  explicit Labels(const Placed& placed) : placed_(placed) {}

  [[nodiscard]] bool free(const Point& at) const {
    constexpr double kBeside = 46.0;
    constexpr double kAbove = 22.0;
    constexpr double kBorder = 22.0;
    if (at[0] < placed_.x + kBorder || at[0] > placed_.x + placed_.width - kBorder || at[1] < kBorder ||
        at[1] > placed_.height - kBorder)
      return false;
    return std::ranges::none_of(taken_, [&at](const Point& other) {
      return std::abs(other[0] - at[0]) < kBeside && std::abs(other[1] - at[1]) < kAbove;
    });
  }
  void take(const Point& at) { taken_.push_back(at); }

 private:
  const Placed& placed_;
  std::vector<Point> taken_;
};

void put_contours(Html& html, const MapFigure& figure, const Placed& placed, Labels& labels) {
  const ImageField& grid = figure.coarse;
  std::vector<std::pair<Point, std::string>> texts;
  for (const double level : contour_levels(figure.scale)) {
    std::string path;
    bool labelled = false;
    for (const ContourLine& line : contours(grid, level)) {
      constexpr std::size_t kSpeck = 40;  // points: shorter ones are where a thin ring falls between the cells
      if (line.size() < kSpeck) continue;
      std::vector<Point> points;
      for (const auto& [column, row] : line) {
        points.push_back(
            {placed.x + (column + 0.5) * placed.width / grid.columns, kEdge + (row + 0.5) * placed.height / grid.rows});
      }
      const bool closed = line.front() == line.back();
      for (std::size_t i = 0; i + (closed ? 1 : 0) < points.size(); ++i)
        path += (i == 0 ? "M" : "L") + coordinate(points[i][0]) + " " + coordinate(points[i][1]);
      if (closed) path += "Z";
      if (labelled) continue;
      const auto at = std::ranges::find_if(points, [&labels](const Point& point) { return labels.free(point); });
      if (at == points.end()) continue;
      labels.take(*at);
      texts.emplace_back(*at, tick_label(level));
      labelled = true;
    }
    if (!path.empty()) html.element("path", {{"class", "contour"}, {"d", path}}, "");
  }
  constexpr double kHalfLine = 4.0;
  for (const auto& [at, text] : texts) put_text(html, at[0], at[1] + kHalfLine, "middle", text, "onmap");
}

/// The worst pixel, and where the words about it stand.
struct Marked {
  Point at{};
  bool words_left = false;
  Point words{};
};

Marked marked_in(const Placed& placed, const Pixel& pixel) {
  constexpr double kAway = 12.0;
  constexpr double kHalfLine = 5.0;
  Marked marked;
  marked.at = {placed.x_of(pixel[0]), placed.y_of(pixel[1])};
  marked.words_left = marked.at[0] > placed.x + 0.5 * placed.width;
  marked.words = {marked.at[0] + (marked.words_left ? -kAway : kAway),
                  std::clamp(marked.at[1] + kHalfLine, kEdge + 3.0 * kHalfLine, kEdge + placed.height - kHalfLine)};
  return marked;
}

void put_marked(Html& html, const Marked& marked, const std::string& words) {
  for (const char* style : {"ring back", "ring"}) {
    html.element("circle", {{"class", style}, {"cx", coordinate(marked.at[0])}, {"cy", coordinate(marked.at[1])}, {"r", "7"}},
                 "");
  }
  put_text(html, marked.words[0], marked.words[1], marked.words_left ? "end" : "start", words, "onmap");
}

void put_axis_cross(Html& html, const Placed& placed, const Pixel& axis) {
  constexpr double kArm = 6.0;
  const double x = placed.x_of(axis[0]);
  const double y = placed.y_of(axis[1]);
  if (x < placed.x || x > placed.x + placed.width || y < kEdge || y > kEdge + placed.height) return;
  const std::string path = "M" + coordinate(x - kArm) + " " + coordinate(y) + "L" + coordinate(x + kArm) + " " + coordinate(y) +
                           "M" + coordinate(x) + " " + coordinate(y - kArm) + "L" + coordinate(x) + " " + coordinate(y + kArm);
  for (const char* style : {"ring back", "ring"}) html.element("path", {{"class", style}, {"d", path}}, "");
}

/// A picture in the picture: what of the rim lies beyond the image is cut off.
void put_rim(Html& html, const Placed& placed, const LensCircle& rim) {
  const double scale = placed.width / placed.image.width;
  html.element("svg",
               {{"x", coordinate(placed.x)},
                {"y", coordinate(kEdge)},
                {"width", coordinate(placed.width)},
                {"height", coordinate(placed.height)}},
               [&] {
                 for (const char* style : {"rim back", "rim"}) {
                   html.element("circle",
                                {{"class", style},
                                 {"cx", coordinate(placed.x_of(rim.centre[0]) - placed.x)},
                                 {"cy", coordinate(placed.y_of(rim.centre[1]) - kEdge)},
                                 {"r", coordinate(rim.radius_px * scale)}},
                                "");
                 }
               });
}

void put_colour_bar(Html& html, const ColourScale& scale, double y) {
  constexpr double kLeft = 14.0;
  constexpr double kRight = 424.0;
  constexpr double kHeight = 12.0;
  html.element("rect",
               {{"class", "bar"},
                {"x", coordinate(kLeft)},
                {"y", coordinate(y)},
                {"width", coordinate(kRight - kLeft)},
                {"height", coordinate(kHeight)}},
               "");
  std::vector<double> ticks = scale.logarithmic ? decades(scale.from, scale.to) : linear_ticks(scale.from, scale.to, 6);
  // The ends of a scale that begins or ends between powers of ten.
  if (scale.logarithmic && ticks.back() < scale.to * 0.9) {
    constexpr double kTooClose = 3.0;
    if (scale.to / ticks.back() < kTooClose) ticks.pop_back();
    ticks.push_back(scale.to);
  }
  for (const double tick : ticks) {
    const double x = kLeft + (kRight - kLeft) * ShareOfScale(scale)(tick);
    html.element("line",
                 {{"class", "frame"},
                  {"x1", coordinate(x)},
                  {"x2", coordinate(x)},
                  {"y1", coordinate(y + kHeight)},
                  {"y2", coordinate(y + kHeight + 4.0)}},
                 "");
    put_text(html, x, y + kHeight + 18.0, "middle", tick_label(tick), "label");
  }
  put_text(html, kRight + 12.0, y + 11.0, "start", scale.unit, "label");
}

/// A rectangle or a picture as large as the image.
void put_over_image(Html& html, std::string_view tag, const Placed& placed, const Html::Attribute& look) {
  html.element(tag,
               {look,
                {"x", coordinate(placed.x)},
                {"y", coordinate(kEdge)},
                {"width", coordinate(placed.width)},
                {"height", coordinate(placed.height)},
                {"preserveAspectRatio", "none"}},
               "");
}

void put_legend(Html& html, const MapFigure& figure) {
  const auto has = [&figure](Part part) { return std::ranges::find(figure.field.parts, part) != figure.field.parts.end(); };
  html.element("div", {{"class", "legend"}}, [&] {
    const auto entry = [&html](std::string_view style, std::string_view text) {
      html.element("span", {{"class", "entry"}}, [&] {
        html.element("span", {{"class", "patch " + std::string(style)}}, "");
        html.text(text);
      });
    };
    if (has(Part::kOutsideLens)) entry("outside", "outside the lens");
    if (has(Part::kUnrepresentable)) entry("unrepresentable", "beyond what the target represents");
    if (figure.marked) entry("worst", "worst pixel");
    entry("cross", "principal point");
    if (figure.rim) entry("rim", "image circle");
  });
}

}  // namespace

void put_colour_scale(Html& html) {
  html.element("svg", {{"class", "unseen"}, {"width", "0"}, {"height", "0"}, {"aria-hidden", "true"}}, [&] {
    html.element("linearGradient", {{"id", "viridis"}}, [&] {
      for (std::size_t i = 0; i < kViridis.size(); ++i) {
        html.element("stop",
                     {{"offset", coordinate(static_cast<double>(i) / (kViridis.size() - 1))},
                      {"stop-color", css_colour(kViridis.at(i))}},
                     "");
      }
    });
  });
}

ColourScale error_scale(double largest) {
  constexpr double kRange = 1e3;
  const double to = nice_above(std::clamp(largest, kSeenError, kLargestError));
  return {to / kRange, to, true, "px"};
}

ColourScale angle_scale(const ImageField& field) {
  double largest = 0.0;
  for (const double value : field.values) {
    if (std::isfinite(value)) largest = std::max(largest, value);
  }
  return {0.0, std::max(largest, 1e-3), false, "deg"};
}

void put_map(Html& html, const MapFigure& figure) {
  const Placed placed = place(figure.field.image);
  constexpr double kBar = 16.0;
  constexpr double kBelowBar = 34.0;
  const double bar = kEdge + placed.height + kBar;
  const double height = bar + kBelowBar;
  html.element("figure", {{"class", "map"}}, [&] {
    html.element("figcaption", {}, figure.title);
    html.element("svg",
                 {{"class", "chart"},
                  {"viewBox", "0 0 " + coordinate(kWidth) + " " + coordinate(height)},
                  {"role", "img"},
                  {"aria-label", figure.what}},
                 [&] {
                   put_over_image(html, "rect", placed, {"class", "nolens"});
                   put_over_image(html, "image", placed, {"href", "data:image/png;base64," + base64(png(picture_of(figure)))});
                   Labels labels(placed);
                   std::optional<Marked> marked;
                   if (figure.marked) marked = marked_in(placed, *figure.marked);
                   if (marked) {
                     // Words take more room than a number.
                     for (const double along : {0.0, 40.0, 80.0, 120.0})
                       labels.take({marked->words[0] + (marked->words_left ? -along : along), marked->words[1]});
                   }
                   put_contours(html, figure, placed, labels);
                   if (figure.rim) put_rim(html, placed, *figure.rim);
                   put_axis_cross(html, placed, figure.axis);
                   if (marked) put_marked(html, *marked, figure.mark_label);
                   put_over_image(html, "rect", placed, {"class", "frame"});
                   put_colour_bar(html, figure.scale, bar);
                 });
    put_legend(html, figure);
  });
}

}  // namespace fca::cli
