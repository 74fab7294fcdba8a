// SPDX-License-Identifier: BSD-3-Clause
// A lens that Python knows: a function from pixels to rays, or a table of both.
#include "fit_rays.h"

#include <fca/convert/fit.h>
#include <fca/convert/ray_table.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fca::python {

namespace {

using Table = std::vector<Correspondence>;

/// Of rays of any length; rows with a number that is none, and rays beyond the angle, are left out. The weights sum to 1.
Table table_of(std::span<const double> rays, std::span<const double> pixels, const std::optional<double>& max_angle_rad) {
  Table table;
  for (std::size_t i = 0; 2 * i < pixels.size(); ++i) {
    Correspondence entry;
    std::copy_n(rays.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, entry.ray.begin());
    std::copy_n(pixels.begin() + static_cast<std::ptrdiff_t>(2 * i), 2, entry.pixel.begin());
    const bool is_number = std::isfinite(entry.pixel[0]) && std::isfinite(entry.pixel[1]);
    if (!is_number || !internal::normalise(entry.ray.data())) continue;
    if (max_angle_rad && angle_from_axis(entry.ray) > *max_angle_rad) continue;
    table.push_back(entry);
  }
  for (Correspondence& entry : table) entry.weight = 1.0 / static_cast<double>(table.size());
  return table;
}

Table table_of(const Array& rays, const Array& pixels, const std::optional<double>& max_angle_rad) {
  const std::span<const double> each_ray = rows_of(rays, 3, "rays");
  const std::span<const double> each_pixel = rows_of(pixels, 2, "pixels");
  if (each_ray.size() / 3 != each_pixel.size() / 2) raise_value_error("there must be as many rays as pixels");
  return table_of(each_ray, each_pixel, max_angle_rad);
}

/// The centres of so many squares along the longer side, which cover the image.
Array lattice_over(const ImageSize& size, int steps) {
  const double spacing = static_cast<double>(std::max(size.width, size.height)) / steps;
  const int columns = std::max(1, static_cast<int>(std::lround(size.width / spacing)));
  const int rows = std::max(1, static_cast<int>(std::lround(size.height / spacing)));
  Array pixels(std::vector<py::ssize_t>{py::ssize_t{columns} * rows, 2});
  double* next = pixels.mutable_data();
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      *next++ = (i + 0.5) * size.width / columns - 0.5;
      *next++ = (j + 0.5) * size.height / rows - 0.5;
    }
  }
  return pixels;
}

Table asked(const py::function& rays_of, const ImageSize& size, int steps, const std::optional<double>& max_angle_rad) {
  const Array pixels = lattice_over(size, steps);
  return table_of(rays_of(pixels).cast<Array>(), pixels, max_angle_rad);
}

/// The model fitted to the table; nothing if no start leads to a camera.
std::optional<CameraModel> fitted(const Table& table, const LensCentre& centre, std::string_view id, bool& reaches_all) {
  std::optional<CameraModel> model;
  ModelList::for_each([&]<CameraModelType M>() {
    if (M::kId != id) return;
    if (const auto found = fit<M>(table, centre)) {
      model = found->model;
      reaches_all = found->reaches_all;
    }
  });
  return model;
}

Fit fit_to(const Table& table, const Table& all, const ModelInfo& info, const std::optional<Size>& image_size) {
  constexpr std::size_t kFewest = 6;
  const std::size_t fewest = std::max(kFewest, info.parameters.size());
  if (table.size() < fewest) {
    raise_value_error(std::string(info.id) + " needs at least " + std::to_string(fewest) + " rays; there are " +
                      std::to_string(table.size()));
  }
  const std::optional<LensCentre> centre = centre_of(table);
  if (!centre) raise_value_error("the rays nearest to the axis determine no focal length and principal point");
  Fit result;
  std::optional<CameraModel> model;
  bool reaches_all = false;
  {
    const py::gil_scoped_release released;
    model = fitted(table, *centre, info.id, reaches_all);
    if (model) result.report.statistics.error = evaluate(all, [&model](const Ray& ray) { return project(*model, ray); });
  }
  if (!model) raise_value_error("no camera of " + std::string(info.id) + " has such rays");
  if (!reaches_all) {
    raise_value_error(std::string(info.id) + " does not reach all of these rays; max_angle leaves out those that are further " +
                      "from the axis");
  }
  double reached = 0.0;
  double furthest = 0.0;
  for (const Correspondence& entry : all) {
    if (!project(*model, entry.ray)) continue;
    reached += entry.weight;
    furthest = std::max(furthest, angle_from_axis(entry.ray));
  }
  result.camera.name = "cam0";
  result.camera.model = *model;
  result.camera.image_size = size_of(image_size);
  result.report.statistics.coverage.scored = reached;
  result.report.statistics.coverage.unrepresentable = std::max(0.0, 1.0 - reached);
  result.report.scored_to_deg = furthest * kDegreesPerRadian;
  return result;
}

}  // namespace

Fit fit_to_function(const py::function& rays_of, const ModelInfo& model, const Size& image_size,
                    const std::optional<double>& max_angle_rad) {
  const ImageSize size = *size_of(image_size);
  constexpr int kFitted = 80;  // along the longer side
  constexpr int kEvaluated = 200;
  const Table table = asked(rays_of, size, kFitted, max_angle_rad);
  return fit_to(table, asked(rays_of, size, kEvaluated, max_angle_rad), model, image_size);
}

Fit fit_to_table(const Array& rays, const Array& pixels, const ModelInfo& model, const std::optional<Size>& image_size,
                 const std::optional<double>& max_angle_rad) {
  const Table table = table_of(rays, pixels, max_angle_rad);
  return fit_to(table, table, model, image_size);
}

}  // namespace fca::python
