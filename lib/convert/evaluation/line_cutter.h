// SPDX-License-Identifier: BSD-3-Clause
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

/// Cuts lines where they cross the borders of the angle bands, the edge of the field of view and the edge of the target's
/// maximum angle. Verdict and band are constant on each piece, so that its errors are smooth.
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
  void look_along(std::span<const Line> lines);

  /// The pieces of `line`, which was number `i` in the last call of look_along(). Valid until the next call.
  [[nodiscard]] std::span<const Piece> pieces(std::size_t i, const Line& line);

 private:
  static constexpr std::size_t kSteps = 12;

  [[nodiscard]] LineSpan part_in_circle(const Line& line) const;
  [[nodiscard]] double ask(const Pixel& pixel) const;

  /// Cuts a line by the closed form of RadialBorders, which must exist.
  void cut_at_radii(const Line& line);

  void end_piece(double at, bool scored) {
    for (const double edge : {lit_.begin, lit_.end}) {
      if (edge > begin_ && edge < at) add_piece(edge, scored);
    }
    add_piece(at, scored);
  }

  void add_piece(double at, bool in_angle) {
    constexpr double kSliver = 1e-4;
    at = std::max(at, begin_);
    const double middle = 0.5 * (begin_ + at);
    const bool scored = in_angle && lit_.holds(middle);
    if (at - begin_ > kSliver || pieces_.empty()) {
      pieces_.push_back({begin_, at, scored});
    } else {
      pieces_.back().end = at;
    }
    begin_ = at;
  }

  /// One of the kSteps steps of a line: places (fractions of the line) and half sines at both ends, and the curvature between
  /// them.
  struct Step {
    double begin;
    double end;
    double from;
    double to;
    double bend;         ///< Second difference of the half sines.
    bool steep = false;  ///< The rays end at one end of the step: the half sine may be far from a parabola there.
    /// The place at which the half sine is `border`, a value between from and to.
    [[nodiscard]] double crossing(double border) const {
      const double rise = to - from;
      const double straight = (border - from) / rise;
      double share = straight;
      constexpr int kRounds = 2;
      for (int i = 0; i < kRounds; ++i) share = std::clamp(straight + 0.5 * share * (1.0 - share) * bend / rise, 0.0, 1.0);
      return begin + share * (end - begin);
    }
  };

  void cut_step(const Line& line, std::span<double> seen, std::size_t i);

  /// The place in a step at which the half sine is `edge`, to 1e-3 of the line's length. nullopt if the search leaves the step,
  /// comes to a pixel without a ray, or does not converge.
  [[nodiscard]] std::optional<double> crossing_of_edge(const Line& line, const Step& step, double edge) const;

  /// Shortens a step that leaves the field of view, so that it ends at the field of view's edge. False if that place was not
  /// found; `step` is then unchanged.
  [[nodiscard]] bool end_at_lens(const Line& line, Step& step) const;

  [[nodiscard]] double place_of(const Line& line, const Step& step, double border) const {
    if (border == step.to) return step.end;
    const double roughly = step.crossing(border);
    if (border != scored_ && !step.steep) return roughly;
    if (const std::optional<double> at = crossing_of_edge(line, step, border)) return *at;
    return step.from < step.to ? halve_to(line, border, step.begin, step.end) : halve_to(line, border, step.end, step.begin);
  }

  /// The place between `inside` and `outside` at which the half sine passes `border`, by halving. Used where the half sine is
  /// far from linear.
  [[nodiscard]] double halve_to(const Line& line, double border, double inside, double outside) const;

  /// Finds where the field of view's rays end between `there` (a place with a ray) and `none` (a place without). `none` becomes
  /// the last place with a ray, `seen` its half sine.
  void find_last_ray(const Line& line, double there, double& none, double& seen) const;

  const Scorer& scorer_;
  // Half sines:
  double lens_;    ///< of the field of view's largest angle
  double scored_;  ///< of the largest angle that is scored
  std::vector<double> borders_;
  std::optional<RadialBorders> radial_;  ///< The edge of the scored region first; nullopt: search for the borders.
  std::vector<double> places_;
  std::vector<double> seen_;
  std::vector<Piece> pieces_;
  double begin_ = 0.0;
  /// The part of the current line inside the field of view's circle; all of it if there is no circle.
  LineSpan lit_{0.0, 1.0};
};

}  // namespace fca::internal
