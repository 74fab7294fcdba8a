// SPDX-License-Identifier: BSD-3-Clause
#include "contours.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace fca::cli {

namespace {

/// A side between two neighbouring cells, on which a line may cross: it belongs to the two squares next to it.
struct Side {
  int column = 0;
  int row = 0;
  bool down = false;  ///< To the cell below; else to the one on the right.
  bool operator==(const Side&) const = default;
  bool operator<(const Side& other) const {
    return std::tie(row, column, down) < std::tie(other.row, other.column, other.down);
  }
};

/// The sides that a line goes on to from each side: two within a line, one at its end.
using Links = std::map<Side, std::vector<Side>>;

class Square {
 public:
  Square(const ImageField& field, double level, int column, int row)
      : column_(column),
        row_(row),
        above_{field.values[field.index(column, row)] > level, field.values[field.index(column + 1, row)] > level,
               field.values[field.index(column + 1, row + 1)] > level, field.values[field.index(column, row + 1)] > level} {}

  /// Joins the sides of the square whose ends lie on different sides of the level.
  void link(bool middle_above, Links& links) const {
    const std::array<Side, 4> sides = {Side{column_, row_, false}, Side{column_ + 1, row_, true},
                                       Side{column_, row_ + 1, false}, Side{column_, row_, true}};
    std::vector<Side> crossed;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (above_.at(i) != above_.at((i + 1) % sides.size())) crossed.push_back(sides.at(i));
    }
    // A saddle: the value in the middle tells which corners hang together, and the lines go around the other two.
    if (crossed.size() == 4 && above_[0] != middle_above) std::rotate(crossed.begin(), crossed.begin() + 1, crossed.end());
    for (std::size_t i = 0; i + 1 < crossed.size(); i += 2) {
      links[crossed[i]].push_back(crossed[i + 1]);
      links[crossed[i + 1]].push_back(crossed[i]);
    }
  }

 private:
  int column_;
  int row_;
  std::array<bool, 4> above_;  ///< Corners, clockwise from the top left.
};

std::array<double, 2> crossing(const ImageField& field, double level, const Side& side) {
  const double from = field.values[field.index(side.column, side.row)];
  const double to = field.values[field.index(side.column + (side.down ? 0 : 1), side.row + (side.down ? 1 : 0))];
  const double part = std::clamp((level - from) / (to - from), 0.0, 1.0);
  return {side.column + (side.down ? 0.0 : part), side.row + (side.down ? part : 0.0)};
}

/// Takes a line out of the links, from a side of it on.
std::vector<Side> taken_line(Side at, Links& links) {
  std::vector<Side> line = {at};
  for (auto found = links.find(at); found != links.end() && !found->second.empty(); found = links.find(at)) {
    const Side next = found->second.back();
    found->second.pop_back();
    std::erase(links[next], at);
    line.push_back(next);
    at = next;
  }
  return line;
}

}  // namespace

std::vector<ContourLine> contours(const ImageField& field, double level) {
  Links links;
  for (int row = 0; row + 1 < field.rows; ++row) {
    for (int column = 0; column + 1 < field.columns; ++column) {
      double sum = 0.0;
      for (const int down : {0, 1}) {
        for (const int right : {0, 1}) sum += field.values[field.index(column + right, row + down)];
      }
      constexpr double kCorners = 4.0;
      if (std::isfinite(sum)) Square(field, level, column, row).link(sum / kCorners > level, links);
    }
  }
  std::vector<ContourLine> lines;
  const auto take = [&](const Side& from) {
    ContourLine& line = lines.emplace_back();
    for (const Side& side : taken_line(from, links)) line.push_back(crossing(field, level, side));
  };
  // Lines with ends first; what remains is closed.
  std::vector<Side> sides;
  for (const auto& [side, next] : links) sides.push_back(side);
  for (const std::size_t neighbours : {1U, 2U}) {
    for (const Side& side : sides) {
      if (links[side].size() == neighbours) take(side);
    }
  }
  std::ranges::stable_sort(lines, std::ranges::greater(), &ContourLine::size);
  return lines;
}

}  // namespace fca::cli
