// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/overlap.h>

#include <fca/rig/rotation.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace fca {

namespace {

/// Pixels are areas: an image ends half a pixel beyond its last centres.
bool inside(const ImageSize& size, const Pixel& pixel) {
  return pixel[0] >= -0.5 && pixel[1] >= -0.5 && pixel[0] <= size.width - 0.5 && pixel[1] <= size.height - 0.5;
}

}  // namespace

std::optional<ColumnRange> columns_shared(const Camera& camera, const Camera& other, const Transform& T_other_camera,
                                          double max_angle_rad) {
  if (!camera.image_size || !other.image_size) return std::nullopt;
  constexpr int kSteps = 32;
  const auto at_step = [](int size, int step) { return static_cast<int>(static_cast<long long>(size - 1) * step / kSteps); };
  const auto shares_pixel = [&](int column, int row) {
    const std::optional<Ray> ray = unproject(camera.model, {static_cast<double>(column), static_cast<double>(row)});
    if (!ray || angle_from_axis(*ray) > max_angle_rad) return false;
    const Ray there = rotated(T_other_camera, *ray);
    if (angle_from_axis(there) > max_angle_rad) return false;
    const std::optional<Pixel> pixel = project(other.model, there);
    return pixel && inside(*other.image_size, *pixel);
  };
  const int height = camera.image_size->height;
  const auto shares = [&](int column) {
    for (int step = 0; step <= kSteps; ++step) {
      if (shares_pixel(column, at_step(height, step))) return true;
    }
    return false;
  };
  const auto column_at = [&](int step) { return at_step(camera.image_size->width, step); };
  // The border between a column that shares something and one that does not.
  const auto border = [&](int shared, int not_shared) {
    while (std::abs(shared - not_shared) > 1) {
      const int middle = (shared + not_shared) / 2;
      (shares(middle) ? shared : not_shared) = middle;
    }
    return shared;
  };
  // What is shared bulges between the lattice's rows: on from a border, looking at every row near those that share.
  const auto bulge = [&](int column, int outwards) {
    const int near = height / kSteps + 1;
    int top = height;
    int bottom = -1;
    for (int step = 0; step <= kSteps; ++step) {
      const int row = at_step(height, step);
      if (!shares_pixel(column, row)) continue;
      top = std::min(top, std::max(0, row - near));
      bottom = std::min(height - 1, row + near);
    }
    const auto shares_near = [&](int next) {
      for (int row = top; row <= bottom; ++row) {
        if (shares_pixel(next, row)) return true;
      }
      return false;
    };
    for (int next = column + outwards; next >= 0 && next < camera.image_size->width && shares_near(next); next += outwards)
      column = next;
    return column;
  };
  int first = 0;
  while (first <= kSteps && !shares(column_at(first))) ++first;
  if (first > kSteps) return std::nullopt;
  int last = kSteps;
  while (!shares(column_at(last))) --last;
  return ColumnRange{first == 0 ? 0 : bulge(border(column_at(first), column_at(first - 1)), -1),
                     last == kSteps ? column_at(kSteps) : bulge(border(column_at(last), column_at(last + 1)), 1)};
}

}  // namespace fca
