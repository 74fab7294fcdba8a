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

/// A grid of scored points, one array per figure, row by row.
struct Scores {
  std::span<const double> x;
  std::span<const double> y;
  std::vector<double> error;
  std::vector<double> cosine;
  std::vector<Verdict> verdict;
  std::vector<double> weight;

  Scores(const Scorer& scorer, std::span<const double> columns, std::span<const double> rows)
      : x(columns),
        y(rows),
        error(x.size() * y.size()),
        cosine(error.size()),
        verdict(error.size()),
        weight(error.size(), 0.0) {
    Batch batch;
    in_batches(batch, [&](std::size_t first, std::size_t count) {
      scorer.score(batch, count);
      std::copy_n(batch.error.begin(), count, &error[first]);
      std::copy_n(batch.z.begin(), count, &cosine[first]);
      std::copy_n(batch.verdict.begin(), count, &verdict[first]);
    });
  }

  void hand_to(const LatticeSink& sink) const {
    Batch batch;
    in_batches(batch, [&](std::size_t first, std::size_t count) {
      std::copy_n(&error[first], count, batch.error.begin());
      std::copy_n(&cosine[first], count, batch.z.begin());
      std::copy_n(&verdict[first], count, batch.verdict.begin());
      std::copy_n(&weight[first], count, batch.weight.begin());
      sink(batch, count);
    });
  }

 private:
  /// Fills in the pixels and calls f(number of the first point, count).
  template <class F>
  void in_batches(Batch& batch, const F& f) const {
    std::size_t first = 0;
    std::size_t count = 0;
    for (const double v : y) {
      for (const double u : x) {
        batch.u[count] = u;
        batch.v[count] = v;
        if (++count < Batch::kSize) continue;
        f(first, count);
        first += count;
        count = 0;
      }
    }
    if (count > 0) f(first, count);
  }
};

/// Points of single cells, scored and handed on as soon as they fill a batch.
class Parts {
 public:
  Parts(const Scorer& scorer, const LatticeSink& sink) : scorer_(scorer), sink_(sink) {}

  void add(double u, double v, double weight) {
    batch_.u[count_] = u;
    batch_.v[count_] = v;
    batch_.weight[count_] = weight;
    if (++count_ == Batch::kSize) finish();
  }
  void finish() {
    scorer_.score(batch_, count_);
    sink_(batch_, count_);
    count_ = 0;
  }

 private:
  const Scorer& scorer_;
  const LatticeSink& sink_;
  Batch batch_;
  std::size_t count_ = 0;
};

/// Pixels on the border reach half a pixel beyond [0, w - 1] x [0, h - 1]: with these strips a sum over the lattice stands
/// for the sum over all pixels.
void add_border_weights(const Lattice& lattice, std::span<double> corners) {
  constexpr double kHalfStripPerEnd = 0.25;
  const std::size_t right = lattice.x.size() - 1;
  const std::size_t bottom = lattice.y.size() - 1;
  for (std::size_t i = 0; i < right; ++i) {
    for (const std::size_t row : {std::size_t{0}, bottom}) {
      for (const std::size_t end : {i, i + 1})
        corners[lattice.at(end, row)] += kHalfStripPerEnd * (lattice.x[i + 1] - lattice.x[i]);
    }
  }
  for (std::size_t j = 0; j < bottom; ++j) {
    for (const std::size_t column : {std::size_t{0}, right}) {
      for (const std::size_t end : {j, j + 1})
        corners[lattice.at(column, end)] += kHalfStripPerEnd * (lattice.y[j + 1] - lattice.y[j]);
    }
  }
  for (const std::size_t column : {std::size_t{0}, right}) {
    for (const std::size_t row : {std::size_t{0}, bottom}) corners[lattice.at(column, row)] += 0.25;
  }
}

/// 8 x 8 parts of a cell, each to be judged at its centre.
void add_parts(const Pixel& first, const Pixel& last, double area, Parts& parts) {
  constexpr int kParts = 8;
  for (int i = 0; i < kParts; ++i) {
    for (int j = 0; j < kParts; ++j) {
      parts.add(first[0] + (last[0] - first[0]) * (i + 0.5) / kParts, first[1] + (last[1] - first[1]) * (j + 0.5) / kParts,
                area / (kParts * kParts));
    }
  }
}

/// 3 x 3 Gauss-Legendre points of a cell.
void add_gauss_points(const Pixel& first, const Pixel& last, double area, Parts& parts) {
  struct Node {
    double position;
    double weight;
  };
  constexpr std::array<Node, 3> kNodes = {
      {{0.5 - 0.3872983346207417, 5.0 / 18.0}, {0.5, 8.0 / 18.0}, {0.5 + 0.3872983346207417, 5.0 / 18.0}}};
  for (const Node& u : kNodes) {
    for (const Node& v : kNodes) {
      parts.add(first[0] + (last[0] - first[0]) * u.position, first[1] + (last[1] - first[1]) * v.position,
                area * u.weight * v.weight);
    }
  }
}

/// How a cell is scored: by its corners and centre, by Gauss-Legendre points, or in parts.
enum class Rule : std::uint8_t { kCorners, kGauss, kParts };

std::vector<double> centres_of(std::span<const double> corners) {
  std::vector<double> centres;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) centres.push_back(0.5 * (corners[i] + corners[i + 1]));
  return centres;
}

/// The rule of each cell, row by row: parts where the domain's edge crosses it, that is where its corners and centre have not
/// one verdict, and Gauss-Legendre for the eight cells around those.
std::vector<Rule> rules_of(const Lattice& lattice, std::span<const Verdict> corners, std::span<const Verdict> centres) {
  const std::size_t columns = lattice.x.size() - 1;
  const std::size_t rows = lattice.y.size() - 1;
  std::vector<Rule> rules(columns * rows, Rule::kCorners);
  const auto differs = [&](Verdict verdict) { return verdict != corners.front(); };
  if (std::ranges::none_of(corners, differs) && std::ranges::none_of(centres, differs)) return rules;
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      const Verdict verdict = centres[j * columns + i];
      const auto ends = lattice.ends(i, j);
      if (std::ranges::all_of(ends, [&](std::size_t c) { return corners[c] == verdict; })) continue;
      for (std::size_t y = j > 0 ? j - 1 : 0; y <= std::min(j + 1, rows - 1); ++y) {
        for (std::size_t x = i > 0 ? i - 1 : 0; x <= std::min(i + 1, columns - 1); ++x) {
          Rule& rule = rules[y * columns + x];
          if (rule == Rule::kCorners && centres[y * columns + x] == Verdict::kScored) rule = Rule::kGauss;
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
void score_lattice(const Scorer& scorer, const LatticeSink& sink) {
  const Lattice lattice = make_lattice(scorer.domain().size);
  const std::vector<double> x_centres = centres_of(lattice.x);
  const std::vector<double> y_centres = centres_of(lattice.y);
  Scores corners(scorer, lattice.x, lattice.y);
  Scores centres(scorer, x_centres, y_centres);
  add_border_weights(lattice, corners.weight);
  const std::vector<Rule> rules = rules_of(lattice, corners.verdict, centres.verdict);
  Parts parts(scorer, sink);
  std::size_t cell = 0;
  for (std::size_t j = 0; j < y_centres.size(); ++j) {
    double* above = &corners.weight[lattice.at(0, j)];
    double* below = &corners.weight[lattice.at(0, j + 1)];
    for (std::size_t i = 0; i < x_centres.size(); ++i, ++cell) {
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
          above[i] += area / 12.0;
          above[i + 1] += area / 12.0;
          below[i] += area / 12.0;
          below[i + 1] += area / 12.0;
          centres.weight[cell] = area * (2.0 / 3.0);
      }
    }
  }
  parts.finish();
  // Points without weight are points all the same, perhaps the worst of all.
  corners.hand_to(sink);
  centres.hand_to(sink);
}

std::vector<Point> score_lattice(const Scorer& scorer) {
  std::vector<Point> points;
  score_lattice(scorer, [&](const Batch& batch, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) points.push_back(batch.point(i));
  });
  return points;
}

}  // namespace fca::internal
