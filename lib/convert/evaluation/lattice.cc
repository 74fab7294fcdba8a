// SPDX-License-Identifier: BSD-3-Clause
#include "lattice.h"

#include "../sampling/gauss_legendre.h"
#include "lattice_points.h"
#include "line_cutter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace fca::internal {

namespace {

/// The smallest number of scored points. Error statistics are then within 0.3 % of those over all pixels.
constexpr std::size_t kFewestPoints = 4000;

/// Adds every pixel of a small image as a point.
void add_all_pixels(const ImageSize& size, LatticePoints& points) {
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) points.add({static_cast<double>(x), static_cast<double>(y)}, 1.0);
  }
  points.finish();
}

/// Chooses points on spokes: lines from the principal point (or from the image's pixel nearest to it) to points on the image's
/// four sides. Sides and spokes are cut into pieces where the verdict or the angle band changes. The points of a piece are
/// Gauss-Legendre nodes, whose weights are the areas of the image that they stand for.
class Lattice {
 public:
  Lattice(const Scorer& scorer, const LatticeSink& sink)
      : scored_(scorer, sink), unscored_(scorer, sink), cutter_(scorer), size_(scorer.field_of_view().size) {
    const Pixel axis = scorer.source().centre().point;
    for (std::size_t i = 0; i < 2; ++i) centre_[i] = std::clamp(axis[i], 0.0, last()[i]);
  }

  /// Chooses the points, evaluates them and passes them to the sink.
  void score() {
    add_sides();
    cutter_.sample_lines(spokes_);
    parts_.reserve(kUsualParts * spokes_.size());
    for (std::size_t i = 0; i < spokes_.size(); ++i) divide_spoke(i);
    const double density = find_density();
    std::size_t begin = 0;
    for (std::size_t i = 0; i < spokes_.size(); ++i) {
      add_spoke(i, std::span(parts_).subspan(begin, ends_[i] - begin), density);
      begin = ends_[i];
    }
    scored_.finish();
    unscored_.finish();
  }

 private:
  /// The same as gauss_legendre(count), but faster: a look-up in its table takes as long as several points.
  const std::vector<Node>& nodes(int count) {
    const std::vector<Node>*& found = nodes_.at(static_cast<std::size_t>(count));
    if (found == nullptr) found = &gauss_legendre(count);
    return *found;
  }

  /// The last pixel of the image, in its lower right corner.
  [[nodiscard]] Pixel last() const { return {size_.width - 1.0, size_.height - 1.0}; }
  /// The collection to which the points of a piece belong.
  LatticePoints& points_of(const LineCutter::Piece& piece) { return piece.scored ? scored_ : unscored_; }

  static constexpr std::size_t kUsualParts = 16;  ///< The number of parts of a spoke for which memory is reserved.

  /// Adds the points of the four sides, and the spokes that end there.
  void add_sides() {
    const auto [right, bottom] = last();
    const std::array<Line, 4> sides = {{{{0.0, 0.0}, {right, 0.0}},
                                        {{right, 0.0}, {right, bottom}},
                                        {{right, bottom}, {0.0, bottom}},
                                        {{0.0, bottom}, {0.0, 0.0}}}};
    cutter_.sample_lines(sides);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      for (const LineCutter::Piece& piece : cutter_.pieces(i, sides[i])) add_piece_of_side(sides[i], piece);
      add_corner(sides[i].from);
    }
  }

  /// Weights of the first two pixels at each end of a line. The sum of f over the pixels of a line is the integral of f from
  /// the first to the last pixel plus, at each end, f(end) / 2 + (f(end) - f(next to the end)) / 12 (the formula of Euler and
  /// Maclaurin, with a difference instead of the derivative).
  static constexpr double kOutermost = 1.0 / 2.0 + 1.0 / 12.0;
  static constexpr double kNextToOutermost = -1.0 / 12.0;

  /// A step of one pixel from the border into the image: across a side, diagonal at a corner.
  [[nodiscard]] Pixel inwards(const Pixel& pixel) const {
    Pixel step{};
    for (std::size_t i = 0; i < 2; ++i) step[i] = pixel[i] == 0.0 ? 1.0 : pixel[i] == last()[i] ? -1.0 : 0.0;
    return step;
  }

  /// Adds the four pixels at a corner, with their weights along both sides.
  void add_corner(const Pixel& corner) {
    const auto [right, down] = inwards(corner);
    scored_.add(corner, kOutermost * kOutermost);
    scored_.add({corner[0] + right, corner[1]}, kOutermost * kNextToOutermost);
    scored_.add({corner[0], corner[1] + down}, kOutermost * kNextToOutermost);
    scored_.add({corner[0] + right, corner[1] + down}, kNextToOutermost * kNextToOutermost);
  }

  /// Cuts a piece of a side into parts and adds these. Near a corner the error may grow tenfold within 2 % of the side. So the
  /// parts there are short and have at least four nodes each.
  void add_piece_of_side(const Line& side, const LineCutter::Piece& piece) {
    static constexpr std::array kCuts = {0.02, 0.1, 0.9, 0.98, 1.0};
    constexpr double kEndOfMiddle = 0.9;  // the part that ends here is the only one that is not near a corner
    double begin = piece.begin;
    for (const double cut : kCuts) {
      const double end = piece.scored ? std::min(cut, piece.end) : piece.end;
      if (end <= begin) continue;
      add_part_of_side(side, {begin, end, piece.scored}, cut != kEndOfMiddle);
      begin = end;
    }
  }

  /// Adds a spoke that ends at each node of the part. The spokes cover the area between the centres of the border's pixels, but
  /// these pixels reach half a pixel further. The points added here and at the corners have the weight of the missing area.
  void add_part_of_side(const Line& side, const LineCutter::Piece& part, bool near_corner) {
    constexpr double kSpokes = 64.0;  // in the whole image, except for the smallest numbers per part
    constexpr int kFewestSpokes = 3;
    constexpr int kFewestSpokesNearCorner = 4;
    const double length = part.share() * side.length();
    const double twice_area = part.share() * std::abs((side.from[0] - centre_[0]) * (side.to[1] - centre_[1]) -
                                                      (side.from[1] - centre_[1]) * (side.to[0] - centre_[0]));
    const int fewest = part.scored && near_corner ? kFewestSpokesNearCorner : kFewestSpokes;
    const double perimeter = 2.0 * (last()[0] + last()[1]);
    const int count = std::max(fewest, static_cast<int>(std::lround(kSpokes * length / perimeter)));
    for (const Node& node : gauss_legendre(count)) {
      const Pixel end = side.at(part.begin + node.position * part.share());
      const auto [right, down] = inwards(end);
      points_of(part).add(end, kOutermost * node.weight * length);
      points_of(part).add({end[0] + right, end[1] + down}, kNextToOutermost * node.weight * length);
      spokes_.push_back({centre_, end});
      twice_areas_.push_back(node.weight * twice_area);
    }
  }

  /// A part of a spoke. It has its own Gauss-Legendre nodes.
  struct Part {
    double begin;  ///< As a fraction of the spoke's length: 0 at the centre, 1 at the border.
    double share;  ///< The part's length, as a fraction of the spoke's length.
    int fewest;    ///< The smallest number of nodes.
    bool scored;
    bool last_of_scored;  ///< The part is scored and ends inside the image; the next part of the spoke is not scored.

    /// The number of nodes. `density`: the number for a whole spoke.
    [[nodiscard]] int nodes(double density) const {
      return std::max(fewest, 1 + static_cast<int>(std::min(density * share, kMostNodes - 1.0)));
    }
  };
  static constexpr int kMostNodes = 64;

  /// Divides each scored piece of a spoke in two parts, at another fraction of the piece on each spoke. The error is often 0 at
  /// some angle from the axis and has a kink there. With nodes at the same angles on all spokes, the kink would bias the mean.
  void divide_spoke(std::size_t i) {
    constexpr double kGoldenRatio = 0.6180339887498949;  // its multiples, modulo 1, are spread evenly
    constexpr int kFewestAtEdge = 6;                     // the error has its largest curvature at the edge
    const int few = i % 2 == 0 ? 3 : 4;
    const double multiple = static_cast<double>(i) * kGoldenRatio;
    const double shift = multiple - std::floor(multiple);
    const std::span<const LineCutter::Piece> pieces = cutter_.pieces(i, spokes_[i]);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const LineCutter::Piece& piece = pieces[k];
      if (!piece.scored) {
        parts_.push_back({piece.begin, piece.share(), 1, false, false});
        continue;
      }
      const bool at_edge = k + 1 == pieces.size() || !pieces[k + 1].scored;
      const int fewest = at_edge ? kFewestAtEdge : few;
      const double share = (at_edge ? 0.55 + 0.3 * shift : 0.25 + 0.5 * shift) * piece.share();
      parts_.push_back({piece.begin, share, fewest, true, false});
      parts_.push_back({piece.begin + share, piece.share() - share, fewest, true, at_edge && piece.end < 1.0});
    }
    ends_.push_back(parts_.size());
  }

  /// The number of nodes of a whole spoke with which at least kFewestPoints points are scored.
  [[nodiscard]] double find_density() const {
    constexpr double kSmallestDensity = 20.0;
    constexpr double kLargestDensity = 1e7;   // then every part has kMostNodes, and a tiny scored region has fewer points
    constexpr double kSmallestGrowth = 1.25;  // the search must end although some parts keep their number of nodes
    // One point of each spoke lies at the edge of the field of view and may turn out to be outside.
    const std::size_t fewest = kFewestPoints + spokes_.size();
    double density = kSmallestDensity;
    while (density < kLargestDensity) {
      std::size_t points = scored_.added();
      for (const Part& part : parts_) points += part.scored ? static_cast<std::size_t>(part.nodes(density)) : 0;
      if (points >= fewest) break;
      density *= std::max(kSmallestGrowth, static_cast<double>(fewest) / static_cast<double>(points));
    }
    return density;
  }

  /// Adds the points of a spoke. The scored points are added as rows, since they lie on one line.
  void add_spoke(std::size_t i, std::span<const Part> parts, double density) {
    constexpr double kInsideEdge = 1e-6;
    std::array<double, Batch::kSize> places;
    std::array<double, Batch::kSize> weights;
    std::size_t count = 0;
    const Line& spoke = spokes_[i];
    const auto finish = [&] {
      if (count > 0) scored_.add_row(spoke, std::span(places).first(count), std::span(weights).first(count));
      count = 0;
    };
    for (const Part& part : parts) {
      // The area for which a node stands grows with its distance from the centre.
      const double area = twice_areas_[i] * part.share;
      if (!part.scored) {
        const double middle = part.begin + 0.5 * part.share;
        unscored_.add(spoke.at(middle), area * middle);
        continue;
      }
      if (count + kMostNodes + 1 > places.size()) finish();
      for (const Node& node : nodes(part.nodes(density))) {
        const double place = part.begin + node.position * part.share;
        places[count] = place;
        weights[count++] = area * node.weight * place;
      }
      if (!part.last_of_scored) continue;
      // The largest error is often at the edge. A point with the weight 0 there changes the maximum, but not the mean.
      places[count] = part.begin + part.share - kInsideEdge;
      weights[count++] = 0.0;
    }
    finish();
  }

  LatticePoints scored_;
  LatticePoints unscored_;  ///< A collection of its own, since batches whose points are all scored take less time.
  LineCutter cutter_;
  ImageSize size_;
  Pixel centre_{};
  std::vector<Line> spokes_;
  std::vector<double> twice_areas_;  ///< Twice the area of the triangle that each spoke stands for [px^2].
  std::vector<Part> parts_;          ///< The parts of all spokes, spoke by spoke.
  std::vector<std::size_t> ends_;    ///< The index in parts_ after the last part of each spoke.
  std::array<const std::vector<Node>*, kMostNodes + 1>
      nodes_{};  ///< Nodes that nodes() has returned, by their number; null: not yet.
};

}  // namespace

void score_lattice(const Scorer& scorer, const LatticeSink& sink) {
  constexpr long long kSmallImage = 5000;  // the lattice has about as many points
  const ImageSize& size = scorer.field_of_view().size;
  if (1LL * size.width * size.height <= kSmallImage) {
    LatticePoints points(scorer, sink);
    add_all_pixels(size, points);
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
