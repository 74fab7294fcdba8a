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

/// A line in the plane in which borders are circles about a centre: which part of it a circle holds.
class LinePast {
 public:
  /// start: vector from the centre to the line's begin; way: vector from its begin to its end.
  LinePast(const std::array<double, 2>& start, const std::array<double, 2>& way);
  [[nodiscard]] LineSpan inside(double radius) const;

 private:
  double inverse_square_;  ///< 1 / |way|^2
  double nearest_;         ///< The place on the line, 0 to 1 from begin to end, that is nearest to the centre.
  double across_;          ///< The squared distance of that place from the centre, in units of |way|^2.
};

/// The curves on which the pixels of given angles from the axis lie. Without tangential distortion they are ellipses about the
/// principal point with the same axes' ratio, so that a linear map makes circles of them, and where a line crosses them has a
/// closed form.
class RadialBorders {
 public:
  /// Nothing if the source's curves are no such ellipses. For angles [rad] beyond the source's largest, its largest is taken.
  [[nodiscard]] static std::optional<RadialBorders> of(const Lens& source, std::span<const double> angles);

  [[nodiscard]] LinePast past(const Line& line) const;
  /// The circles' radii, one for each angle: arguments of LinePast::inside().
  [[nodiscard]] std::span<const double> radii() const { return radii_; }

 private:
  [[nodiscard]] std::array<double, 2> in_plane(double right, double down) const;

  Pixel centre_{};
  std::array<double, 4> to_plane_{};  ///< Makes circles of the ellipses; row by row.
  std::vector<double> radii_;
};

}  // namespace fca::internal
