// SPDX-License-Identifier: BSD-3-Clause
#include "judge_lattice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>

namespace fca::internal {

namespace {

/// The coordinates of the lattice's columns and rows, and the numbering of its points.
struct Lattice {
  std::vector<double> x;
  std::vector<double> y;
  [[nodiscard]] std::size_t at(std::size_t column, std::size_t row) const { return row * x.size() + column; }
  /// The corners of a cell.
  [[nodiscard]] std::array<std::size_t, 4> ends(std::size_t column, std::size_t row) const {
    return {at(column, row), at(column + 1, row), at(column, row + 1), at(column + 1, row + 1)};
  }
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
void add_border_weights(const Lattice& lattice, std::span<Point> corners) {
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

/// 8 x 8 parts of a cell, each to be judged at its centre.
void add_parts(const Pixel& first, const Pixel& last, double area, std::vector<Point>& points) {
  constexpr int kParts = 8;
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

/// How a cell is scored: by its corners and centre, by Gauss-Legendre points, or in parts.
enum class Rule : std::uint8_t { kCorners, kGauss, kParts };

/// The rule of each cell, row by row: parts where the domain's edge crosses it, that is where its corners and centre have not
/// one verdict, and Gauss-Legendre for the eight cells around those.
std::vector<Rule> rules_of(const Lattice& lattice, std::span<const Point> corners, std::span<const Point> centres) {
  const std::size_t columns = lattice.x.size() - 1;
  const std::size_t rows = lattice.y.size() - 1;
  std::vector<Rule> rules(columns * rows, Rule::kCorners);
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      const Verdict verdict = centres[j * columns + i].verdict;
      const auto ends = lattice.ends(i, j);
      if (std::ranges::all_of(ends, [&](std::size_t c) { return corners[c].verdict == verdict; })) continue;
      for (std::size_t y = j > 0 ? j - 1 : 0; y <= std::min(j + 1, rows - 1); ++y) {
        for (std::size_t x = i > 0 ? i - 1 : 0; x <= std::min(i + 1, columns - 1); ++x) {
          Rule& rule = rules[y * columns + x];
          if (rule == Rule::kCorners && centres[y * columns + x].verdict == Verdict::kScored) rule = Rule::kGauss;
        }
      }
      rules[j * columns + i] = Rule::kParts;
    }
  }
  return rules;
}

}  // namespace

/// A cell is weighted 2/3 centre, 1/12 each corner (exact for cubics; the trapezoidal rule is 2 % off where errors soar at the
/// edge of a lens); one that the domain's edge crosses is split into parts, and its neighbours, where errors are steepest, get
/// Gauss-Legendre points (woodscape -> rational at 60 degrees: 2 % off without them).
std::vector<Point> score_lattice(const Scorer& scorer) {
  const Lattice lattice = make_lattice(scorer.domain().size);
  const std::size_t corner_count = lattice.x.size() * lattice.y.size();
  const std::size_t cell_count = (lattice.x.size() - 1) * (lattice.y.size() - 1);
  std::vector<Point> points;  // corners, then centres, then those of cells at the domain's edge
  points.reserve(corner_count + cell_count);
  for (const double y : lattice.y) {
    for (const double x : lattice.x) points.emplace_back().pixel = {x, y};
  }
  for (std::size_t j = 0; j + 1 < lattice.y.size(); ++j) {
    for (std::size_t i = 0; i + 1 < lattice.x.size(); ++i)
      points.emplace_back().pixel = {0.5 * (lattice.x[i] + lattice.x[i + 1]), 0.5 * (lattice.y[j] + lattice.y[j + 1])};
  }
  scorer.score(points);
  const std::span<Point> corners = std::span(points).first(corner_count);
  const std::span<Point> centres = std::span(points).subspan(corner_count);
  add_border_weights(lattice, corners);
  const std::vector<Rule> rules = rules_of(lattice, corners, centres);
  std::vector<Point> parts;
  std::size_t cell = 0;
  for (std::size_t j = 0; j + 1 < lattice.y.size(); ++j) {
    for (std::size_t i = 0; i + 1 < lattice.x.size(); ++i, ++cell) {
      const Pixel first = {lattice.x[i], lattice.y[j]};
      const Pixel last = {lattice.x[i + 1], lattice.y[j + 1]};
      const double area = (last[0] - first[0]) * (last[1] - first[1]);
      switch (rules[cell]) {
        case Rule::kParts:
          add_parts(first, last, area, parts);
          break;
        case Rule::kGauss:
          add_gauss_points(first, last, area, parts);
          break;
        case Rule::kCorners:
          for (const std::size_t c : lattice.ends(i, j)) corners[c].weight += area / 12.0;
          centres[cell].weight = area * (2.0 / 3.0);
      }
    }
  }
  scorer.score(parts);
  // Points without weight are points all the same, perhaps the worst of all.
  points.insert(points.end(), parts.begin(), parts.end());
  return points;
}

}  // namespace fca::internal
