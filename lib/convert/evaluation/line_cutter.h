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

/// Cuts lines where they cross the borders of the angle bands and the edges of the domain and of the target's reach: between
/// them nothing of a judgement jumps.
class LineCutter {
 public:
  explicit LineCutter(const Scorer& scorer);

  /// A part of a line.
  struct Piece {
    double begin;
    double end;
    bool scored;  ///< Inside the lens and the target's reach.
    [[nodiscard]] double share() const { return end - begin; }
  };

  /// Looks along the lines, at kSteps + 1 places of each, if it must.
  void look_along(std::span<const Line> lines);

  /// The pieces of line number `i` of those that were looked along.
  [[nodiscard]] std::span<const Piece> pieces(std::size_t i, const Line& line);

 private:
  static constexpr std::size_t kSteps = 12;

  [[nodiscard]] LineSpan lit_part(const Line& line) const;
  [[nodiscard]] double ask(const Pixel& pixel) const;

  /// Without a search, where the source allows it.
  void cut_at_radii(const Line& line);

  void end_piece(double at, bool scored) {
    for (const double edge : {lit_.begin, lit_.end}) {
      if (edge > begin_ && edge < at) add_piece(edge, scored);
    }
    add_piece(at, scored);
  }

  void add_piece(double at, bool in_cone) {
    constexpr double kSliver = 1e-4;
    at = std::max(at, begin_);
    const double middle = 0.5 * (begin_ + at);
    const bool scored = in_cone && lit_.holds(middle);
    if (at - begin_ > kSliver || pieces_.empty()) {
      pieces_.push_back({begin_, at, scored});
    } else {
      pieces_.back().end = at;
    }
    begin_ = at;
  }

  /// A step of a line: half sines at both ends, and how much the line bends.
  struct Step {
    double begin;
    double end;
    double from;
    double to;
    double bend;         ///< Second difference.
    bool steep = false;  ///< One end is that of the rays: up to there the angle may be no parabola.
    /// Where a border between from and to is crossed.
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

  /// Where the edge of what is scored is crossed in a step, as precisely as that asks for; nothing if the lens has no ray
  /// there.
  [[nodiscard]] std::optional<double> crossing_of_edge(const Line& line, const Step& step, double edge) const;

  /// Shortens a step out of the domain to where that ends: mostly the lens bends on until there. False if it does not.
  [[nodiscard]] bool end_at_lens(const Line& line, Step& step) const;

  [[nodiscard]] double place_of(const Line& line, const Step& step, double border) const {
    if (border == step.to) return step.end;
    const double roughly = step.crossing(border);
    if (border != scored_ && !step.steep) return roughly;
    if (const std::optional<double> at = crossing_of_edge(line, step, border)) return *at;
    return step.from < step.to ? halve_to(line, border, step.begin, step.end) : halve_to(line, border, step.end, step.begin);
  }

  /// Where a border is crossed on the way from `inside` to `outside`, by halving: where the angle is all but a line.
  [[nodiscard]] double halve_to(const Line& line, double border, double inside, double outside) const;

  /// From where the domain's rays end on the way from `there` (with a ray) to `none` (without): its place and half sine.
  void find_last_ray(const Line& line, double there, double& none, double& seen) const;

  const Scorer& scorer_;
  // Half sines:
  double lens_;    ///< of the domain's edge
  double scored_;  ///< of the edge of what is scored
  std::vector<double> borders_;
  std::optional<RadialBorders> radial_;  ///< The edge of what is scored first, then all others; nothing: search.
  std::vector<double> places_;
  std::vector<double> seen_;
  std::vector<Piece> pieces_;
  double begin_ = 0.0;
  LineSpan lit_{0.0, 1.0};  ///< Of the line in hand: what the domain's circle holds.
};

}  // namespace fca::internal
