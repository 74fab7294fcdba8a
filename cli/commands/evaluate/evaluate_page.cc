// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate_command.h"
#include "html/chart.h"
#include "html/html.h"
#include "html/page.h"
#include "pictures/pictures.h"
#include "shell/base64.h"
#include "shell/words.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace fca::cli {

namespace {

/// A number of a point of Figure 2, and what it is called.
struct Quantity {
  std::string_view title;
  std::string_view axis;
  std::function<double(const SweepPoint&)> value;
};

/// From the power of ten below all values to the one above.
Axis decades_around(std::string title, const std::vector<Curve>& curves) {
  double low = std::numeric_limits<double>::infinity();
  double high = 0.0;
  for (const Curve& curve : curves) {
    for (const auto& [x, y] : curve.points) {
      if (!(y > 0.0)) continue;
      low = std::min(low, y);
      high = std::max(high, y);
    }
  }
  if (!(low <= high)) return {std::move(title), 0.1, 1.0, true};
  const double from = std::floor(std::log10(low));
  const double to = std::max(std::ceil(std::log10(high)), from + 1.0);
  return {std::move(title), std::pow(10.0, from), std::pow(10.0, to), true};
}

/// The conversions from one model.
Chart chart_of(const std::vector<SampleSweep>& sweeps, std::string_view from, const Quantity& quantity) {
  Chart chart;
  chart.title = std::string(quantity.title) + ", from " + std::string(from);
  chart.what = chart.title + ", by the number of samples";
  for (const SampleSweep& sweep : sweeps) {
    if (sweep.from.name != from) continue;
    Curve curve{"c" + std::to_string(chart.curves.size()), std::string(sweep.from.name) + "-" + std::string(sweep.to.name), {}};
    for (const SweepPoint& point : sweep.points)
      curve.points.push_back({static_cast<double>(point.asked), quantity.value(point)});
    chart.curves.push_back(std::move(curve));
  }
  chart.y = decades_around(std::string(quantity.axis), chart.curves);
  const std::vector<std::array<double, 2>>& points = chart.curves.front().points;
  chart.x = {"samples N", points.front()[0], points.back()[0], true};
  return chart;
}

void put_figure_2(Html& html, const std::vector<SampleSweep>& sweeps) {
  const std::array<Quantity, 3> quantities = {
      Quantity{"Parameter error", "PE", [](const SweepPoint& point) { return point.parameter_error; }},
      Quantity{"Error over the image", "rms px", [](const SweepPoint& point) { return point.rms_px; }},
      Quantity{"Time in this run", "ms", [](const SweepPoint& point) { return point.time_us / 1000.0; }}};
  std::vector<std::string_view> sources;
  for (const SampleSweep& sweep : sweeps) {
    const bool is_new = std::ranges::find(sources, sweep.from.name) == sources.end();
    if (is_new && !sweep.points.empty()) sources.push_back(sweep.from.name);
  }
  html.element("h2", {}, "Figure 2: what the number of samples changes");
  html.element(
      "p", {},
      "Conversions of Kalibr's sample camera (Table 1). A fit begins with N samples and takes more where it needs them.");
  for (const Quantity& quantity : quantities) {
    html.element("div", {{"class", "figures"}}, [&] {
      for (const std::string_view source : sources) put_chart(html, chart_of(sweeps, source, quantity));
    });
  }
}

void put_picture(Html& html, const std::string& title, const Image& image) {
  const std::optional<std::string> bytes = encoded(image, ".png");
  if (!bytes) return;
  html.element("figure", {}, [&] {
    html.element("figcaption", {}, title);
    html.element_without_end("img", {{"class", "chart"}, {"alt", title}, {"src", "data:image/png;base64," + base64(*bytes)}});
  });
}

bool has_pictures(const EvaluatedTable& table) {
  return std::ranges::any_of(table.rows, [](const EvaluatedRow& row) { return row.pictures.has_value(); });
}

void put_figure_3(Html& html, const std::vector<EvaluatedTable>& tables) {
  if (std::ranges::none_of(tables, has_pictures)) return;
  html.element("h2", {}, "Figure 3: recovered images");
  html.element(
      "p", {},
      "The image as each converted camera would have taken it, and next to it the difference from the image, 16 times as "
      "large. Black: beyond the border of one of them, or no difference.");
  for (const EvaluatedTable& table : tables) {
    if (!has_pictures(table)) continue;
    html.element("h3", {}, std::string(table.published.title));
    html.element("div", {{"class", "figures"}}, [&] {
      for (const EvaluatedRow& row : table.rows) {
        if (!row.pictures) continue;
        const std::string name = std::string(row.published.from.name) + "-" + std::string(row.published.to.name);
        put_picture(html, name + ", " + pixels(row.conversion.report.statistics.error.rms) + " px rms", row.pictures->image);
        put_picture(html, name + ", the difference 16 times", row.pictures->difference);
      }
    });
  }
}

}  // namespace

std::string evaluate_page(const EvaluateResult& evaluation) {
  return page_around("The paper's figures", [&evaluation](Html& html) {
    html.element("h1", {}, "Lee, Fisheye-Calib-Adapter (2024): its figures, recomputed");
    put_figure_2(html, evaluation.sweeps);
    put_figure_3(html, evaluation.conversions);
    html.element("h2", {}, "Table 4 and Figure 4");
    html.element("p", {}, replacement_in_words(evaluation));
  });
}

}  // namespace fca::cli
