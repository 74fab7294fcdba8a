// SPDX-License-Identifier: BSD-3-Clause
// "Half sine" is short for the sine of half the angle between a ray and the axis. Along a line of an image it is nearly linear.
#pragma once

#include "line.h"
#include "radial_borders.h"
#include "scorer.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace fca::internal {

/// Cuts lines of an image where they cross a border: of an angle band, of the field of view or of the target's maximum angle.
/// Verdict and band are constant on each piece, so that the errors on it are smooth.
class LineCutter {
 public:
  explicit LineCutter(const Scorer& scorer);

  /// A part of a line, from one fraction of its length to another.
  struct Piece {
    double begin;
    double end;
    bool scored;  ///< The piece lies inside the field of view and inside the target's maximum angle.
    [[nodiscard]] double share() const { return end - begin; }
  };

  /// Computes the half sines at kSteps + 1 places of each line. Does nothing for a source whose borders have a closed form.
  void sample_lines(std::span<const Line> lines);

  /// The pieces of `line`, which was number `i` in the last call of sample_lines(). They are valid until the next call.
  [[nodiscard]] std::span<const Piece> pieces(std::size_t i, const Line& line);

 private:
  static constexpr std::size_t kSteps = 12;

  /// The part of the line inside the field of view's circle; the whole line if there is no circle.
  [[nodiscard]] LineSpan part_in_circle(const Line& line) const;
  /// The half sine of a pixel's ray, from the source itself; kNoHalfSine if the pixel has no ray.
  [[nodiscard]] double half_sine_at(const Pixel& pixel) const;

  /// Cuts a line by the closed form of RadialBorders, which must exist.
  void cut_at_radii(const Line& line);

  /// Ends the current piece at the place `at`. Cuts it where it crosses the circle. `scored`: the piece lies inside the scored
  /// angle.
  void end_piece(double at, bool scored) {
    for (const double edge : {in_circle_.begin, in_circle_.end}) {
      if (edge > begin_ && edge < at) add_piece(edge, scored);
    }
    add_piece(at, scored);
  }

  /// Adds the piece from the end of the previous one to the place `at`, or lengthens the previous one if the piece is very
  /// short.
  void add_piece(double at, bool in_angle) {
    constexpr double kShortest = 1e-4;  // as a fraction of the line's length
    at = std::max(at, begin_);
    const double middle = 0.5 * (begin_ + at);
    const bool scored = in_angle && in_circle_.holds(middle);
    if (at - begin_ > kShortest || pieces_.empty()) {
      pieces_.push_back({begin_, at, scored});
    } else {
      pieces_.back().end = at;
    }
    begin_ = at;
  }

  /// One of the kSteps steps of a line. Between its ends, the half sine is approximated by a parabola.
  struct Step {
    double begin;        ///< The place of the step's begin, as a fraction of the line's length.
    double end;          ///< The place of its end.
    double from;         ///< The half sine at its begin.
    double to;           ///< The half sine at its end.
    double bend;         ///< The second difference of the half sines.
    bool steep = false;  ///< The rays end at one end of the step, where the half sine may be far from a parabola.
    /// The place at which the parabola has the value `border`, which is between from and to.
    [[nodiscard]] double crossing(double border) const {
      const double rise = to - from;
      const double straight = (border - from) / rise;
      double share = straight;
      constexpr int kIterations = 2;
      for (int i = 0; i < kIterations; ++i) share = std::clamp(straight + 0.5 * share * (1.0 - share) * bend / rise, 0.0, 1.0);
      return begin + share * (end - begin);
    }
  };

  /// Cuts the line where it crosses borders in its step number `i`. `half_sines`: those of the whole line.
  void cut_step(const Line& line, std::span<double> half_sines, std::size_t i);

  /// The place in a step at which the half sine is `edge`, by a search that ends with a change of less than 1e-3 of the line's
  /// length. nullopt if the search leaves the step, comes to a pixel without a ray, or does not converge.
  [[nodiscard]] std::optional<double> crossing_of_edge(const Line& line, const Step& step, double edge) const;

  /// Shortens a step that leaves the field of view, so that it ends at the field of view's edge. False if that edge was not
  /// found; `step` is then unchanged.
  [[nodiscard]] bool end_at_field_of_view(const Line& line, Step& step) const;

  /// The place in a step at which the half sine is `border`, a value between step.from and step.to. It is exact (by a search)
  /// for the border of the scored region and in steep steps, otherwise approximate.
  [[nodiscard]] double place_of(const Line& line, const Step& step, double border) const {
    if (border == step.to) return step.end;
    if (border != scored_half_sine_ && !step.steep) return step.crossing(border);
    if (const std::optional<double> at = crossing_of_edge(line, step, border)) return *at;
    return step.from < step.to ? halve_to(line, border, step.begin, step.end) : halve_to(line, border, step.end, step.begin);
  }

  /// The place between `inside` and `outside` at which the half sine passes `border`, by halving. For steps in which the half
  /// sine is far from a parabola.
  [[nodiscard]] double halve_to(const Line& line, double border, double inside, double outside) const;

  /// Finds the last place with a ray in the field of view, between the place `inside`, which has a ray, and `place`, which has
  /// none. Sets `place` to the last place and `last_half_sine` to its half sine.
  void find_last_ray(const Line& line, double inside, double& place, double& last_half_sine) const;

  const Scorer& scorer_;
  double field_of_view_half_sine_;  ///< The half sine of the field of view's largest angle.
  double scored_half_sine_;         ///< The half sine of the largest scored angle.
  std::vector<double> borders_;     ///< The half sines of all borders, ascending. Empty if radial_ has the borders.
  /// The borders in closed form, that of the scored region first. nullopt if there is no closed form: borders are then
  /// searched.
  std::optional<RadialBorders> radial_;
  std::vector<double> places_;      ///< The places at which the current line is cut.
  std::vector<double> half_sines_;  ///< kSteps + 1 half sines of each line of the last sample_lines().
  std::vector<Piece> pieces_;       ///< The pieces of the current line.
  double begin_ = 0.0;              ///< The end of the last piece.
  LineSpan in_circle_{0.0, 1.0};    ///< part_in_circle() of the current line.
};

}  // namespace fca::internal
