// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "line.h"

#include <fca/convert/lens.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace fca::internal {

/// The part of a line inside a border; empty (end < begin) where there is none.
struct LineSpan {
  double begin = 1.0;
  double end = 0.0;
  [[nodiscard]] bool holds(double place) const { return place >= begin && place <= end; }
};

/// A line as it runs past a centre, in the plane in which borders are circles.
class LinePast {
 public:
  /// start: from the centre to the line's begin; way: from there to its end.
  LinePast(const std::array<double, 2>& start, const std::array<double, 2>& way);
  [[nodiscard]] LineSpan inside(double radius) const;

 private:
  double inverse_square_;  ///< Of the way's length.
  double nearest_;         ///< Where the line is nearest to the centre,
  double across_;          ///< and how far from it then, squared, in lengths of the way.
};

/// Where the pixels of certain angles from the axis lie: on ellipses around the centre, all alike, for every model of the list
/// but with tangential distortion. Where a line crosses them needs no search.
class RadialBorders {
 public:
  /// Nothing if that is not so of the source. Of angles [rad] beyond its last the border is that of the last.
  [[nodiscard]] static std::optional<RadialBorders> of(const Lens& source, std::span<const double> angles);

  [[nodiscard]] LinePast past(const Line& line) const;
  /// One for each angle, to be asked for the part of a line inside.
  [[nodiscard]] std::span<const double> radii() const { return radii_; }

 private:
  [[nodiscard]] std::array<double, 2> in_plane(double right, double down) const;

  Pixel centre_{};
  std::array<double, 4> to_plane_{};  ///< Makes circles of the ellipses; row by row.
  std::vector<double> radii_;
};

}  // namespace fca::internal
