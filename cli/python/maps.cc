// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.h"

#include <fca/models/camera_model.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <cmath>

namespace fca::python {

namespace {

/// As cv2.remap takes it: where a pixel is in another image.
using Map = py::array_t<float, py::array::c_style>;

/// Turned by a rotation of 3 x 3.
void turn(const Array& rotation, std::span<double> rays) {
  const double* r = rotation.data();
  for (std::size_t i = 0; i + 2 < rays.size(); i += 3) {
    const std::array<double, 3> ray = {rays[i], rays[i + 1], rays[i + 2]};
    for (std::size_t row = 0; row < 3; ++row)
      rays[i + row] = r[3 * row] * ray[0] + r[3 * row + 1] * ray[1] + r[3 * row + 2] * ray[2];
  }
}

/// But for rounding.
bool is_rotation(const Array& matrix) {
  Transform T;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) T(row, column) = matrix.data()[3 * row + column];
  }
  constexpr double kRounding = 1e-6;
  return rotation_determinant(T) > 0.0 && rotation_defect(T) <= kRounding;
}

/// Far outside of any image: cv2.remap takes no "not a number" for it.
constexpr float kOutside = -1e4F;

/// A row of the target's pixels in the source's image. Where there is none, far outside.
void map_row(const Camera& source, const Camera& target, const std::optional<Array>& rotation, std::size_t row,
             std::span<float> u, std::span<float> v) {
  std::vector<double> pixels(2 * u.size());
  for (std::size_t column = 0; column < u.size(); ++column) {
    pixels[2 * column] = static_cast<double>(column);
    pixels[2 * column + 1] = static_cast<double>(row);
  }
  std::vector<double> rays(3 * u.size());
  unproject_all(target.model, pixels, rays);
  if (rotation) turn(*rotation, rays);
  project_all(source.model, rays, pixels);
  for (std::size_t column = 0; column < u.size(); ++column) {
    const bool is_there = std::isfinite(pixels[2 * column]) && std::isfinite(pixels[2 * column + 1]);
    u[column] = is_there ? static_cast<float>(pixels[2 * column]) : kOutside;
    v[column] = is_there ? static_cast<float>(pixels[2 * column + 1]) : kOutside;
  }
}

py::tuple undistort_maps(const Camera& source, const Camera& target, const std::optional<Array>& rotation) {
  if (!target.image_size) raise_value_error("the target's image_size has to be known");
  if (rotation && (rotation->ndim() != 2 || rotation->shape(0) != 3 || rotation->shape(1) != 3))
    raise_value_error("R is a matrix of 3 x 3");
  if (rotation && !is_rotation(*rotation)) raise_value_error("R is no rotation");
  const auto width = static_cast<std::size_t>(target.image_size->width);
  const auto height = static_cast<std::size_t>(target.image_size->height);
  const std::vector<py::ssize_t> shape = {target.image_size->height, target.image_size->width};
  Map u(shape);
  Map v(shape);
  float* const first_u = u.mutable_data();
  float* const first_v = v.mutable_data();
  {
    const py::gil_scoped_release released;
    for (std::size_t row = 0; row < height; ++row)
      map_row(source, target, rotation, row, {first_u + row * width, width}, {first_v + row * width, width});
  }
  return py::make_tuple(u, v);
}

}  // namespace

py::tuple as_maps(const ImageMap& map) {
  const std::vector<py::ssize_t> shape = {map.size.height, map.size.width};
  Map u(shape);
  Map v(shape);
  float* const first_u = u.mutable_data();
  float* const first_v = v.mutable_data();
  for (std::size_t i = 0; 2 * i + 1 < map.uv.size(); ++i) {
    const bool is_there = std::isfinite(map.uv[2 * i]) && std::isfinite(map.uv[2 * i + 1]);
    first_u[i] = is_there ? map.uv[2 * i] : kOutside;
    first_v[i] = is_there ? map.uv[2 * i + 1] : kOutside;
  }
  return py::make_tuple(u, v);
}

void add_maps(py::module_& module) {
  module.def(
      "undistort_maps", &undistort_maps, py::arg("source"), py::arg("target"), py::arg("R") = py::none(),
      R"(Two float32 arrays (height, width) of the target's image, as cv2.remap takes them: where each of its pixels (x right,
y down) is in the source's image. Far outside of it where the source has none.

R: 3 x 3, turns the target's rays into the source's; none: they look the same way. An undistorted image is that of a pinhole:
fca_io.Camera("pinhole", {"fx": ..., "fy": ..., "cx": ..., "cy": ...}, size).)");
}

}  // namespace fca::python
