// SPDX-License-Identifier: BSD-3-Clause
// Curves over an axis, as inline SVG. Colours are classes of the page's style sheet.
#pragma once

#include "html.h"

#include <array>
#include <string>
#include <vector>

namespace fca::cli {

struct Axis {
  std::string title;
  double from = 0.0;
  double to = 1.0;
  bool logarithmic = false;
};

struct Curve {
  std::string style;  ///< Class of its line: "source", "target", "reference".
  std::string name;   ///< For the legend; empty: none.
  /// A point that is not finite, or lies outside the axes, is a gap.
  std::vector<std::array<double, 2>> points;
};

/// A vertical line with a word next to it.
struct Mark {
  double x = 0.0;
  std::string label;
};

struct Chart {
  std::string title;
  std::string what;  ///< For who cannot see it.
  Axis x;
  Axis y;
  std::vector<Curve> curves;
  std::vector<Mark> marks;
};

/// A figure with its title and legend.
void put_chart(Html& html, const Chart& chart);

}  // namespace fca::cli
