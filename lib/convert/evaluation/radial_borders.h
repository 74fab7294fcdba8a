// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "line.h"

#include <fca/convert/lens.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace fca::internal {

/// The part of a line inside a border, as fractions of the line's length; empty (end < begin) if the line does not meet it.
struct LineSpan {
  double begin = 1.0;
  double end = 0.0;
  [[nodiscard]] bool holds(double place) const { return place >= begin && place <= end; }
};

/// A line in the plane in which the borders are circles about the origin. Computes the part of the line inside a circle.
class LinePast {
 public:
  /// `start`: the line's begin; `way`: the vector from its begin to its end.
  LinePast(const std::array<double, 2>& start, const std::array<double, 2>& way);
  [[nodiscard]] LineSpan inside(double radius) const;

 private:
  double inverse_square_;  ///< 1 / |way|^2
  double nearest_;         ///< The place on the line, 0 to 1 from begin to end, that is nearest to the centre.
  double across_;          ///< The squared distance of that place from the centre, in units of |way|^2.
};

/// The image curves of given angles from the axis. Without tangential distortion they are ellipses about the principal point
/// with one common ratio of axes. A linear map then turns them into circles, and a line crosses them at places with a closed
/// form.
class RadialBorders {
 public:
  /// nullopt if the source's curves are not such ellipses. An angle [rad] beyond the source's largest counts as that.
  [[nodiscard]] static std::optional<RadialBorders> of(const Lens& source, std::span<const double> angles);

  [[nodiscard]] LinePast past(const Line& line) const;
  /// The circles' radii, one for each angle: arguments of LinePast::inside().
  [[nodiscard]] std::span<const double> radii() const { return radii_; }

 private:
  [[nodiscard]] std::array<double, 2> in_plane(double right, double down) const;

  Pixel centre_{};
  std::array<double, 4> to_plane_{};  ///< The 2 x 2 linear map from ellipses to circles; row-major.
  std::vector<double> radii_;
};

}  // namespace fca::internal
