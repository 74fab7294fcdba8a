// SPDX-License-Identifier: BSD-3-Clause
// The borders of regions of an image, as curves of constant angle from the axis, in closed form.
#pragma once

#include "line.h"

#include <fca/convert/lens.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace fca::internal {

/// A part of a line, as fractions of the line's length. They may lie outside 0 to 1, beyond the line's ends. Empty if end <
/// begin.
struct LineSpan {
  double begin = 1.0;
  double end = 0.0;
  [[nodiscard]] bool holds(double place) const { return place >= begin && place <= end; }
};

/// A line in the plane in which the borders are circles about the origin.
class LineAmongCircles {
 public:
  /// `start`: the line's begin. `direction`: the vector from its begin to its end.
  LineAmongCircles(const std::array<double, 2>& start, const std::array<double, 2>& direction);
  /// The part of the line inside the circle with this radius; empty if there is none.
  [[nodiscard]] LineSpan inside(double radius) const;

 private:
  double inverse_square_;  ///< 1 / |direction|^2
  double nearest_;         ///< The place on the line that is nearest to the circles' centre, as a fraction of its length.
  double across_;          ///< The squared distance of that place from the centre, in units of |direction|^2.
};

/// The curves in the image at which rays have given angles from the axis. Without tangential distortion, these curves are
/// ellipses of the same shape about the principal point. A linear map turns them into circles, so that the places at which a
/// line crosses them have a closed form.
class RadialBorders {
 public:
  /// The curves of `angles` [rad]. An angle beyond the source's largest angle is replaced by that. nullopt if the source's
  /// curves are not known to be such ellipses.
  [[nodiscard]] static std::optional<RadialBorders> of(const Lens& source, std::span<const double> angles);

  /// The line in the plane in which the curves are circles.
  [[nodiscard]] LineAmongCircles among_circles(const Line& line) const;
  /// The radii of the circles, one for each angle: arguments of LineAmongCircles::inside().
  [[nodiscard]] std::span<const double> radii() const { return radii_; }

 private:
  /// The linear map of a vector of the image.
  [[nodiscard]] std::array<double, 2> in_plane(double right, double down) const;

  Pixel centre_{};
  std::array<double, 4> to_plane_{};  ///< The 2 x 2 linear map from ellipses to circles; row-major.
  std::vector<double> radii_;
};

}  // namespace fca::internal
