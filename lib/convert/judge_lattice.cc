// SPDX-License-Identifier: BSD-3-Clause
#include "judge_lattice.h"

#include "gauss_legendre.h"
#include "judge_summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace fca::internal {

namespace {

/// Sine of half an angle from the axis: along a line of an image it is nearly linear.
double half_sine(double cosine) { return std::sqrt(std::max(0.0, 0.5 - 0.5 * cosine)); }
/// Where there is no ray: more than any half sine.
constexpr double kNone = 2.0;

/// From one pixel, at 0, to another, at 1.
struct Line {
  Pixel from;
  Pixel to;
  [[nodiscard]] Pixel at(double t) const { return {from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])}; }
  [[nodiscard]] double length() const { return std::hypot(to[0] - from[0], to[1] - from[1]); }
};

/// Points that are scored and handed on as soon as they fill a batch.
class Points {
 public:
  Points(const Scorer& scorer, const LatticeSink& sink) : scorer_(scorer), sink_(sink) {}

  /// The points that follow lie in a row; others stand for themselves.
  void begin_line() { ++line_; }
  void add(const Pixel& pixel, double weight) {
    batch_.u[count_] = pixel[0];
    batch_.v[count_] = pixel[1];
    batch_.weight[count_] = weight;
    lines_[count_] = line_;
    if (++count_ == Batch::kSize) finish();
  }
  void finish() {
    scorer_.score(batch_, count_);
    find_spreads();
    sink_(batch_, count_);
    count_ = 0;
  }

 private:
  /// A point in a row stands for the errors half way to its neighbours.
  void find_spreads() {
    std::array<bool, Batch::kSize + 1> joined{};  // to the point before
    for (std::size_t i = 1; i < count_; ++i)
      joined[i] = lines_[i] == lines_[i - 1] && lines_[i] > 0 && batch_.verdict[i] == batch_.verdict[i - 1];
    for (std::size_t i = 0; i < count_; ++i) {
      const double before = batch_.error[joined[i] ? i - 1 : i];
      const double after = batch_.error[joined[i + 1] ? i + 1 : i];
      batch_.spread[i] = (joined[i] && joined[i + 1] ? 0.25 : 0.5) * std::abs(after - before);
    }
  }

  const Scorer& scorer_;
  const LatticeSink& sink_;
  Batch batch_;
  std::array<int, Batch::kSize> lines_{};
  int line_ = 0;
  std::size_t count_ = 0;
};

/// The part of a line inside a circle; empty (end < begin) where there is none.
struct Span {
  double begin;
  double end;

  static Span of(const Line& line, const LensCircle& circle) {
    const std::array<double, 2> way = {line.to[0] - line.from[0], line.to[1] - line.from[1]};
    const std::array<double, 2> start = {line.from[0] - circle.centre[0], line.from[1] - circle.centre[1]};
    const double square = way[0] * way[0] + way[1] * way[1];
    const double nearest = -(way[0] * start[0] + way[1] * start[1]) / square;
    const double across = (way[0] * start[1] - way[1] * start[0]) / square;
    const double half = circle.radius_px * circle.radius_px / square - across * across;
    if (!(half > 0.0)) return {1.0, 0.0};
    return {nearest - std::sqrt(half), nearest + std::sqrt(half)};
  }
};

/// Cuts lines where they cross the borders of the angle bands and the edges of the domain and of the target's reach: between
/// them nothing of a judgement jumps.
class Cutter {
 public:
  explicit Cutter(const Scorer& scorer)
      : scorer_(scorer),
        lens_(edge_at(scorer.domain().max_angle_rad)),
        scored_(std::min(lens_, edge_at(scorer.target_reach_rad()))) {
    const double last = scorer.domain().max_angle_rad;
    for (double angle = kBandRad; angle < last; angle += kBandRad) borders_.push_back(edge_at(angle));
    for (const double edge : {scored_, lens_}) {
      if (edge < 1.0) borders_.push_back(edge);
    }
    std::ranges::sort(borders_);
  }

  /// A part of a line.
  struct Piece {
    double begin;
    double end;
    bool scored;  ///< Inside the lens and the target's reach.
    [[nodiscard]] double share() const { return end - begin; }
  };

  /// Looks along the lines, at kSteps + 1 places of each.
  void look_along(std::span<const Line> lines) {
    seen_.resize(lines.size() * (kSteps + 1));
    Batch batch;
    std::size_t first = 0;
    std::size_t count = 0;
    const auto finish = [&] {
      scorer_.find_rays(batch, count);
      for (std::size_t i = 0; i < count; ++i) {
        seen_[first + i] = batch.z[i] == kNoRay        ? kNone
                           : std::isfinite(batch.z[i]) ? half_sine(batch.z[i])
                                                       : ask({batch.u[i], batch.v[i]});
      }
      first += count;
      count = 0;
    };
    for (const Line& line : lines) {
      for (std::size_t step = 0; step <= kSteps; ++step) {
        const Pixel pixel = line.at(static_cast<double>(step) / kSteps);
        batch.u[count] = pixel[0];
        batch.v[count] = pixel[1];
        if (++count == Batch::kSize) finish();
      }
    }
    finish();
  }

  /// The pieces of line number `i` of those that were looked along.
  [[nodiscard]] std::span<const Piece> pieces(std::size_t i, const Line& line) {
    pieces_.clear();
    begin_ = 0.0;
    lit_ = scorer_.domain().circle ? Span::of(line, *scorer_.domain().circle) : Span{0.0, 1.0};
    const std::span<double> seen = std::span(seen_).subspan(i * (kSteps + 1), kSteps + 1);
    for (std::size_t step = 0; step < kSteps; ++step) cut_step(line, seen, step);
    end_piece(1.0, seen[kSteps] <= scored_);
    return pieces_;
  }

 private:
  static constexpr std::size_t kSteps = 12;
  static constexpr double kBandRad = Summary::kBandDegrees * std::numbers::pi / 180.0;

  static double edge_at(double angle) { return angle < std::numbers::pi ? half_sine(std::cos(angle)) : 1.0; }

  [[nodiscard]] double ask(const Pixel& pixel) const {
    const std::optional<Ray> ray = scorer_.source().ray(pixel);
    return ray ? half_sine((*ray)[2]) : kNone;
  }

  void end_piece(double at, bool scored) {
    for (const double edge : {lit_.begin, lit_.end}) {
      if (edge > begin_ && edge < at) add_piece(edge, scored);
    }
    add_piece(at, scored);
  }

  void add_piece(double at, bool in_cone) {
    constexpr double kSliver = 1e-4;
    const double middle = 0.5 * (begin_ + at);
    const bool scored = in_cone && middle >= lit_.begin && middle <= lit_.end;
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
    double bend;  ///< Second difference.
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

  void cut_step(const Line& line, std::span<double> seen, std::size_t i) {
    Step step = {static_cast<double>(i) / kSteps, static_cast<double>(i + 1) / kSteps, seen[i], seen[i + 1], 0.0};
    if (step.from == kNone && step.to == kNone) return;
    if (step.from == kNone) {
      find_last_ray(line, step.end, step.begin, step.from);
      end_piece(step.begin, false);
    } else if (step.to == kNone) {
      if (i > 1) {
        step.bend = seen[i] - 2.0 * seen[i - 1] + seen[i - 2];
        step.to = 2.0 * seen[i] - seen[i - 1] + step.bend;
      }
      if (!end_at_lens(line, step)) {
        step.bend = 0.0;
        find_last_ray(line, step.begin, step.end, step.to);
      }
    } else if (const std::size_t middle = std::clamp<std::size_t>(i, 1, kSteps - 1);
               seen[middle - 1] != kNone && seen[middle + 1] != kNone) {
      step.bend = seen[middle + 1] - 2.0 * seen[middle] + seen[middle - 1];
    }
    if (step.from < step.to) {
      for (auto border = std::ranges::upper_bound(borders_, step.from); border != borders_.end() && *border <= step.to;
           ++border)
        end_piece(place_of(line, step, *border), *border <= scored_);
    } else {
      for (auto border = std::ranges::upper_bound(borders_, step.from);
           border != borders_.begin() && *std::prev(border) > step.to;) {
        --border;
        end_piece(place_of(line, step, *border), *border < scored_);
      }
    }
    if (seen[i + 1] == kNone && step.to <= lens_) end_piece(step.end, step.to <= scored_);
  }

  /// Where the edge of what is scored is crossed in a step, as precisely as that asks for; nothing if the lens has no ray
  /// there.
  [[nodiscard]] std::optional<double> crossing_of_edge(const Line& line, const Step& step, double edge) const {
    constexpr double kClose = 0.01;  // of a half sine
    constexpr double kFine = 1e-3;   // of a line; the next step would be a tenth of that
    const double whole = step.end - step.begin;
    double at = step.crossing(edge);
    double slope = (step.to - step.from + ((at - step.begin) / whole - 0.5) * step.bend) / whole;
    double before = at;
    double seen = kNone;
    constexpr int kMostRounds = 8;
    for (int round = 0; round < kMostRounds; ++round) {
      const double found = ask(line.at(at));
      if (!(std::abs(found - edge) < kClose)) return std::nullopt;
      if (seen != kNone && found != seen) slope = (found - seen) / (at - before);
      before = at;
      seen = found;
      at += (edge - found) / slope;
      if (!(at > step.begin && at <= step.end)) return std::nullopt;
      if (std::abs(at - before) < kFine) return at;
    }
    return std::nullopt;
  }

  /// Shortens a step out of the domain to where that ends: mostly the lens bends on until there. False if it does not.
  [[nodiscard]] bool end_at_lens(const Line& line, Step& step) const {
    if (step.to == kNone || !(step.to > lens_)) return false;
    const std::optional<double> at = crossing_of_edge(line, step, lens_);
    if (!at) return false;
    const double share = (*at - step.begin) / (step.end - step.begin);
    step = {step.begin, *at, step.from, lens_, step.bend * share * share};
    return true;
  }

  [[nodiscard]] double place_of(const Line& line, const Step& step, double border) const {
    if (border == step.to) return step.end;
    const double roughly = step.crossing(border);
    return border == scored_ ? crossing_of_edge(line, step, border).value_or(roughly) : roughly;
  }

  /// From where the domain's rays end on the way from `there` (with a ray) to `none` (without): its place and half sine.
  void find_last_ray(const Line& line, double there, double& none, double& seen) const {
    constexpr int kHalvings = 12;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (there + none);
      if (const double found = ask(line.at(middle)); found <= lens_) {
        there = middle;
        seen = found;
      } else {
        none = middle;
      }
    }
    none = there;
  }

  const Scorer& scorer_;
  // Half sines:
  double lens_;    ///< of the domain's edge
  double scored_;  ///< of the edge of what is scored
  std::vector<double> borders_;
  std::vector<double> seen_;
  std::vector<Piece> pieces_;
  double begin_ = 0.0;
  Span lit_{0.0, 1.0};  ///< Of the line in hand: what the domain's circle holds.
};

/// Small images: every pixel.
void score_pixels(const ImageSize& size, Points& points) {
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) points.add({static_cast<double>(x), static_cast<double>(y)}, 1.0);
  }
  points.finish();
}

/// Spokes from the principal point (or the pixel next to it) to nodes along the image's sides: the sides' pieces and the
/// spokes' end where anything jumps, so that Gauss-Legendre nodes stand for the area between them.
class Lattice {
 public:
  Lattice(const Scorer& scorer, const LatticeSink& sink)
      : scored_(scorer, sink), unscored_(scorer, sink), cutter_(scorer), size_(scorer.domain().size) {
    const Pixel axis = scorer.source().centre().point;
    for (std::size_t i = 0; i < 2; ++i) centre_[i] = std::clamp(axis[i], 0.0, last()[i]);
  }

  void score() {
    add_sides();
    cutter_.look_along(spokes_);
    for (std::size_t i = 0; i < spokes_.size(); ++i) add_spoke(i);
    scored_.finish();
    unscored_.finish();
  }

 private:
  [[nodiscard]] Pixel last() const { return {size_.width - 1.0, size_.height - 1.0}; }
  Points& points_of(const Cutter::Piece& piece) { return piece.scored ? scored_ : unscored_; }

  void add_sides() {
    const auto [right, bottom] = last();
    const std::array<Line, 4> sides = {{{{0.0, 0.0}, {right, 0.0}},
                                        {{right, 0.0}, {right, bottom}},
                                        {{right, bottom}, {0.0, bottom}},
                                        {{0.0, bottom}, {0.0, 0.0}}}};
    cutter_.look_along(sides);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      for (const Cutter::Piece& piece : cutter_.pieces(i, sides[i])) add_piece_of_side(sides[i], piece);
      scored_.add(sides[i].from, 0.25);
    }
  }

  /// Its nodes are the ends of spokes. Pixels on the border reach half a pixel beyond it: with the weights of these strips, and
  /// of the corners, a sum over the lattice stands for that over all pixels.
  void add_piece_of_side(const Line& side, const Cutter::Piece& piece) {
    constexpr double kSpokes = 64.0;
    constexpr int kFewest = 2;
    constexpr int kFewestInCorner = 7;  // there errors are the steepest
    const double length = piece.share() * side.length();
    const double twice_area = piece.share() * std::abs((side.from[0] - centre_[0]) * (side.to[1] - centre_[1]) -
                                                       (side.from[1] - centre_[1]) * (side.to[0] - centre_[0]));
    const bool corner = piece.scored && (piece.begin == 0.0 || piece.end == 1.0);
    const double perimeter = 2.0 * (last()[0] + last()[1]);
    const int count = std::max(corner ? kFewestInCorner : kFewest, static_cast<int>(std::lround(kSpokes * length / perimeter)));
    for (const Node& node : gauss_legendre(count)) {
      const Pixel end = side.at(piece.begin + node.position * piece.share());
      points_of(piece).add(end, 0.5 * node.weight * length);
      spokes_.push_back({centre_, end});
      twice_areas_.push_back(node.weight * twice_area);
    }
  }

  /// Where errors are 0 at some angle, their mean asks for nodes at many angles: pieces are divided elsewhere on each spoke.
  void add_spoke(std::size_t i) {
    constexpr double kGoldenRatio = 0.6180339887498949;
    constexpr int kManyAtEdge = 6;  // there errors bend the most
    const int few = i % 2 == 0 ? 3 : 4;
    const double turn = static_cast<double>(i) * kGoldenRatio;
    const double shift = turn - std::floor(turn);
    const std::span<const Cutter::Piece> pieces = cutter_.pieces(i, spokes_[i]);
    scored_.begin_line();
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const Cutter::Piece& piece = pieces[k];
      if (!piece.scored) {
        add_nodes(i, piece, 1);
        continue;
      }
      const bool at_edge = k + 1 == pieces.size() || !pieces[k + 1].scored;
      const int fewest = at_edge ? kManyAtEdge : few;
      const double middle = piece.begin + (at_edge ? 0.55 + 0.3 * shift : 0.25 + 0.5 * shift) * piece.share();
      for (const Cutter::Piece& half : {Cutter::Piece{piece.begin, middle, true}, Cutter::Piece{middle, piece.end, true}}) {
        constexpr double kPerSpoke = 20.0;
        add_nodes(i, half, std::max(fewest, static_cast<int>(std::ceil(kPerSpoke * half.share()))));
      }
      // A candidate for the maximum.
      if (at_edge && piece.end < 1.0) scored_.add(spokes_[i].at(piece.end - kHair), 0.0);
    }
  }
  static constexpr double kHair = 1e-6;

  void add_nodes(std::size_t spoke, const Cutter::Piece& piece, int count) {
    for (const Node& node : gauss_legendre(count)) {
      const double t = piece.begin + node.position * piece.share();
      points_of(piece).add(spokes_[spoke].at(t), twice_areas_[spoke] * node.weight * piece.share() * t);
    }
  }

  Points scored_;
  Points unscored_;  ///< Apart: batches of which all is scored take less time.
  Cutter cutter_;
  ImageSize size_;
  Pixel centre_{};
  std::vector<Line> spokes_;
  std::vector<double> twice_areas_;  ///< Of the triangles for which the spokes stand.
};

}  // namespace

void score_lattice(const Scorer& scorer, const LatticeSink& sink) {
  constexpr long long kPixels = 5000;
  const ImageSize& size = scorer.domain().size;
  if (1LL * size.width * size.height <= kPixels) {
    Points points(scorer, sink);
    score_pixels(size, points);
  } else {
    Lattice(scorer, sink).score();
  }
}

std::vector<Point> score_lattice(const Scorer& scorer) {
  std::vector<Point> points;
  score_lattice(scorer, [&](const Batch& batch, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) points.push_back(batch.point(i));
  });
  return points;
}

}  // namespace fca::internal
