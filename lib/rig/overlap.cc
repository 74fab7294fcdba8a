// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/overlap.h>

#include <fca/rig/rotation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace fca {

namespace {

/// How far beyond each side of an image, in px. Pixels are areas: an image ends half a pixel beyond its last centres.
using Beyond = std::array<double, 4>;

Beyond beyond(const ImageSize& size, const Pixel& pixel) {
  return {-0.5 - pixel[0], -0.5 - pixel[1], pixel[0] - (size.width - 0.5), pixel[1] - (size.height - 0.5)};
}

bool inside(const Beyond& beyond) {
  return std::ranges::all_of(beyond, [](double side) { return side <= 0.0; });
}

/// Are both so far beyond one side that what lies between them is, too?
bool clearly_beyond(const Beyond& a, const Beyond& b) {
  // Between rows h px apart a line that is bent like a circle of radius R px leaves a straight one by h^2 / 8R.
  constexpr double kBend = 0.25;
  for (std::size_t side = 0; side < a.size(); ++side) {
    if (a.at(side) > kBend && b.at(side) > kBend) return true;
  }
  return false;
}

class SharedColumns {
 public:
  SharedColumns(const Camera& camera, const Camera& other, const Transform& T_other_camera, double max_angle_rad)
      : camera_(camera), other_(other), T_other_camera_(T_other_camera), max_angle_rad_(max_angle_rad) {}

  [[nodiscard]] bool any() const { return first_step().has_value(); }

  [[nodiscard]] std::optional<ColumnRange> range() const {
    const std::optional<int> found = first_step();
    if (!found) return std::nullopt;
    const int first = *found;
    int last = kSteps;
    while (!shares(column_at(last))) --last;
    return ColumnRange{first == 0 ? 0 : bulge(border(column_at(first), column_at(first - 1)), -1),
                       last == kSteps ? column_at(kSteps) : bulge(border(column_at(last), column_at(last + 1)), 1)};
  }

 private:
  static constexpr int kSteps = 32;

  static int at_step(int size, int step) { return static_cast<int>(static_cast<long long>(size - 1) * step / kSteps); }
  [[nodiscard]] int height() const { return camera_.image_size->height; }
  [[nodiscard]] int column_at(int step) const { return at_step(camera_.image_size->width, step); }

  [[nodiscard]] std::optional<int> first_step() const {
    for (int step = 0; step <= kSteps; ++step) {
      if (shares(column_at(step))) return step;
    }
    return std::nullopt;
  }

  [[nodiscard]] bool is_lens(const Ray& ray) const {
    return max_angle_rad_ >= std::numbers::pi || angle_from_axis(ray) <= max_angle_rad_;
  }

  /// Where the other camera has that pixel; nothing where one of them has no lens there.
  [[nodiscard]] std::optional<Beyond> seen_by_other(int column, int row) const {
    const Pixel here = {static_cast<double>(column), static_cast<double>(row)};
    if (camera_.lens_circle && !camera_.lens_circle->contains(here)) return std::nullopt;
    const std::optional<Ray> ray = unproject(camera_.model, here);
    if (!ray || !is_lens(*ray)) return std::nullopt;
    const Ray there = rotated(T_other_camera_, *ray);
    if (!is_lens(there)) return std::nullopt;
    const std::optional<Pixel> pixel = project(other_.model, there);
    if (!pixel || (other_.lens_circle && !other_.lens_circle->contains(*pixel))) return std::nullopt;
    return beyond(*other_.image_size, *pixel);
  }

  [[nodiscard]] bool shares_pixel(int column, int row) const {
    const std::optional<Beyond> seen = seen_by_other(column, row);
    return seen && inside(*seen);
  }

  [[nodiscard]] bool shares(int column) const {
    for (int step = 0; step <= kSteps; ++step) {
      if (shares_pixel(column, at_step(height(), step))) return true;
    }
    return false;
  }

  /// The border between a column that shares something and one that does not.
  [[nodiscard]] int border(int shared, int not_shared) const {
    while (std::abs(shared - not_shared) > 1) {
      const int middle = (shared + not_shared) / 2;
      (shares(middle) ? shared : not_shared) = middle;
    }
    return shared;
  }

  /// What is shared bulges between the lattice's rows: on from a border, looking at every row near those that share, but for
  /// those between two that clearly do not.
  [[nodiscard]] int bulge(int column, int outwards) const {
    const int near = height() / kSteps + 1;
    int top = height();
    int bottom = -1;
    for (int step = 0; step <= kSteps; ++step) {
      const int row = at_step(height(), step);
      if (!shares_pixel(column, row)) continue;
      top = std::min(top, std::max(0, row - near));
      bottom = std::min(height() - 1, row + near);
    }
    const auto shares_near = [&](int next) {
      for (int first = top; first <= bottom; first += near) {
        const int last = std::min(first + near, bottom);
        const std::optional<Beyond> a = seen_by_other(next, first);
        const std::optional<Beyond> b = seen_by_other(next, last);
        if ((a && inside(*a)) || (b && inside(*b))) return true;
        if (a && b && clearly_beyond(*a, *b)) continue;
        for (int row = first + 1; row < last; ++row) {
          if (shares_pixel(next, row)) return true;
        }
      }
      return false;
    };
    for (int next = column + outwards; next >= 0 && next < camera_.image_size->width && shares_near(next); next += outwards)
      column = next;
    return column;
  }

  const Camera& camera_;
  const Camera& other_;
  const Transform& T_other_camera_;
  double max_angle_rad_;
};

}  // namespace

std::optional<ColumnRange> columns_shared(const Camera& camera, const Camera& other, const Transform& T_other_camera,
                                          double max_angle_rad) {
  if (!camera.image_size || !other.image_size) return std::nullopt;
  return SharedColumns(camera, other, T_other_camera, max_angle_rad).range();
}

bool share_columns(const Camera& camera, const Camera& other, const Transform& T_other_camera, double max_angle_rad) {
  return camera.image_size && other.image_size && SharedColumns(camera, other, T_other_camera, max_angle_rad).any();
}

}  // namespace fca
