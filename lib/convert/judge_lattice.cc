// SPDX-License-Identifier: BSD-3-Clause
#include "judge_lattice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fca::internal {

namespace {

/// The coordinates of the lattice's columns and rows, and the numbering of its points.
struct Lattice {
  std::vector<double> x;
  std::vector<double> y;
  [[nodiscard]] std::size_t at(std::size_t column, std::size_t row) const { return row * x.size() + column; }
};

/// From 0 to pixels - 1, denser towards both ends: errors are steepest in the corners of an image.
std::vector<double> lattice_side(int pixels, double points) {
  const int last = std::min(pixels, std::clamp(static_cast<int>(std::lround(points)), 17, 300)) - 1;
  std::vector<double> positions = {0.0};
  for (int i = 1; i <= last; ++i) positions.push_back(0.5 * (pixels - 1.0) * (1.0 - std::cos(std::numbers::pi * i / last)));
  return positions;
}

Lattice make_lattice(const ImageSize& size) {
  // 51 x 51 corners and 50 x 50 centres on a square image; the longer side gets more, so that cells stay square.
  constexpr double kPointsPerSide = 51.0;
  const double aspect = std::sqrt(static_cast<double>(size.width) / size.height);
  return {lattice_side(size.width, kPointsPerSide * aspect), lattice_side(size.height, kPointsPerSide / aspect)};
}

/// Pixels on the border reach half a pixel beyond [0, w - 1] x [0, h - 1]: with these strips a sum over the lattice stands
/// for the sum over all pixels.
void add_border_weights(const Lattice& lattice, std::vector<Point>& corners) {
  constexpr double kHalfStripPerEnd = 0.25;
  const std::size_t right = lattice.x.size() - 1;
  const std::size_t bottom = lattice.y.size() - 1;
  for (std::size_t i = 0; i < right; ++i) {
    for (const std::size_t row : {std::size_t{0}, bottom}) {
      for (const std::size_t end : {i, i + 1})
        corners[lattice.at(end, row)].weight += kHalfStripPerEnd * (lattice.x[i + 1] - lattice.x[i]);
    }
  }
  for (std::size_t j = 0; j < bottom; ++j) {
    for (const std::size_t column : {std::size_t{0}, right}) {
      for (const std::size_t end : {j, j + 1})
        corners[lattice.at(column, end)].weight += kHalfStripPerEnd * (lattice.y[j + 1] - lattice.y[j]);
    }
  }
  for (const std::size_t column : {std::size_t{0}, right}) {
    for (const std::size_t row : {std::size_t{0}, bottom}) corners[lattice.at(column, row)].weight += 0.25;
  }
}

/// 6 x 6 parts of a cell, each to be judged at its centre.
void add_parts(const Pixel& first, const Pixel& last, double area, std::vector<Point>& points) {
  constexpr int kParts = 10;
  for (int i = 0; i < kParts; ++i) {
    for (int j = 0; j < kParts; ++j) {
      Point part;
      part.pixel = {first[0] + (last[0] - first[0]) * (i + 0.5) / kParts, first[1] + (last[1] - first[1]) * (j + 0.5) / kParts};
      part.weight = area / (kParts * kParts);
      points.push_back(part);
    }
  }
}

/// 3 x 3 Gauss-Legendre points of a cell.
void add_gauss_points(const Pixel& first, const Pixel& last, double area, std::vector<Point>& points) {
  struct Node {
    double position;
    double weight;
  };
  constexpr std::array<Node, 3> kNodes = {
      {{0.5 - 0.3872983346207417, 5.0 / 18.0}, {0.5, 8.0 / 18.0}, {0.5 + 0.3872983346207417, 5.0 / 18.0}}};
  for (const Node& u : kNodes) {
    for (const Node& v : kNodes) {
      Point point;
      point.pixel = {first[0] + (last[0] - first[0]) * u.position, first[1] + (last[1] - first[1]) * v.position};
      point.weight = area * u.weight * v.weight;
      points.push_back(point);
    }
  }
}

/// The cells of a lattice that the domain's edge crosses: those whose corners and centre have not one verdict.
class CrossedCells {
 public:
  CrossedCells(const Lattice& lattice, const std::vector<Point>& corners, const std::vector<Point>& centres)
      : columns_(lattice.x.size() - 1), rows_(lattice.y.size() - 1), crossed_(centres.size()) {
    for (std::size_t j = 0; j < rows_; ++j) {
      for (std::size_t i = 0; i < columns_; ++i) {
        const std::size_t cell = j * columns_ + i;
        const std::array ends = {lattice.at(i, j), lattice.at(i + 1, j), lattice.at(i, j + 1), lattice.at(i + 1, j + 1)};
        crossed_[cell] = !std::ranges::all_of(ends, [&](std::size_t c) { return corners[c].verdict == centres[cell].verdict; });
      }
    }
  }

  [[nodiscard]] bool crossed(std::size_t i, std::size_t j) const { return crossed_[j * columns_ + i]; }
  /// Is one of the eight cells around it crossed?
  [[nodiscard]] bool next_to_crossed(std::size_t i, std::size_t j) const {
    for (std::size_t y = j > 0 ? j - 1 : 0; y <= std::min(j + 1, rows_ - 1); ++y) {
      for (std::size_t x = i > 0 ? i - 1 : 0; x <= std::min(i + 1, columns_ - 1); ++x) {
        if (crossed(x, y)) return true;
      }
    }
    return false;
  }

 private:
  std::size_t columns_;
  std::size_t rows_;
  std::vector<bool> crossed_;
};

}  // namespace

/// A cell is weighted 2/3 centre, 1/12 each corner (exact for cubics; the trapezoidal rule is 2 % off where errors soar at the
/// edge of a lens); one that the domain's edge crosses is split into parts, and its neighbours, where errors are steepest, get
/// Gauss-Legendre points (woodscape -> rational at 60 degrees: 2 % off without them).
std::vector<Point> score_lattice(const Scorer& scorer) {
  const Lattice lattice = make_lattice(scorer.domain().size);
  std::vector<Point> corners;
  corners.reserve(2 * lattice.x.size() * lattice.y.size());
  for (const double y : lattice.y) {
    for (const double x : lattice.x) corners.emplace_back().pixel = {x, y};
  }
  std::vector<Point> centres;
  centres.reserve(corners.size());
  for (std::size_t j = 0; j + 1 < lattice.y.size(); ++j) {
    for (std::size_t i = 0; i + 1 < lattice.x.size(); ++i)
      centres.emplace_back().pixel = {0.5 * (lattice.x[i] + lattice.x[i + 1]), 0.5 * (lattice.y[j] + lattice.y[j + 1])};
  }
  scorer.score(corners);
  scorer.score(centres);
  add_border_weights(lattice, corners);
  const CrossedCells cells(lattice, corners, centres);
  std::vector<Point> parts;
  auto centre = centres.begin();
  for (std::size_t j = 0; j + 1 < lattice.y.size(); ++j) {
    for (std::size_t i = 0; i + 1 < lattice.x.size(); ++i, ++centre) {
      const std::array ends = {lattice.at(i, j), lattice.at(i + 1, j), lattice.at(i, j + 1), lattice.at(i + 1, j + 1)};
      const Pixel& first = corners[ends.front()].pixel;
      const Pixel& last = corners[ends.back()].pixel;
      const double area = (last[0] - first[0]) * (last[1] - first[1]);
      if (cells.crossed(i, j)) {
        add_parts(first, last, area, parts);
      } else if (centre->verdict == Verdict::kScored && cells.next_to_crossed(i, j)) {
        add_gauss_points(first, last, area, parts);
      } else {
        for (const std::size_t c : ends) corners[c].weight += area / 12.0;
        centre->weight = area * (2.0 / 3.0);
      }
    }
  }
  scorer.score(parts);
  // Points without weight are points all the same, perhaps the worst of all.
  corners.insert(corners.end(), centres.begin(), centres.end());
  corners.insert(corners.end(), parts.begin(), parts.end());
  return corners;
}

}  // namespace fca::internal
