// SPDX-License-Identifier: BSD-3-Clause
// The Python module fca_io._native; fca_io/__init__.py gives its names to people.
#include "bindings.h"

#include <fca/formats/text/prose.h>

#include <algorithm>

namespace fca::python {

std::span<const double> rows_of(const Array& array, py::ssize_t columns, const char* what) {
  const bool is_row = array.ndim() == 1 && array.shape(0) == columns;
  const bool is_table = array.ndim() == 2 && array.shape(1) == columns;
  if (!is_row && !is_table)
    raise_value_error(std::string(what) + " are an array of (N, " + std::to_string(columns) + "), or one of them");
  return {array.data(), static_cast<std::size_t>(array.size())};
}

Array rows_like(const Array& like, py::ssize_t columns) {
  return like.ndim() == 1 ? Array(columns) : Array(std::vector<py::ssize_t>{like.shape(0), columns});
}

Array matrix_of(const Transform& transform) {
  Array matrix(std::vector<py::ssize_t>{4, 4});
  std::ranges::copy(transform.values, matrix.mutable_data());
  return matrix;
}

Array rotation_of(const Transform& transform) {
  Array matrix(std::vector<py::ssize_t>{3, 3});
  double* const values = matrix.mutable_data();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) values[3 * row + column] = transform(row, column);
  }
  return matrix;
}

std::optional<ImageSize> size_of(const std::optional<Size>& size) {
  if (!size) return std::nullopt;
  if (size->first < 1 || size->second < 1) raise_value_error("image_size is (width, height), both at least 1");
  return ImageSize{size->first, size->second};
}

const ModelInfo& model_named(const std::string& name) {
  if (const ModelInfo* model = find_model(name)) return *model;
  std::vector<std::string> known;
  for (const ModelInfo& model : all_models()) known.emplace_back(model.id);
  raise_value_error("unknown camera model '" + name + "'; there are " + text::enumerated(known));
}

std::optional<double> radians(const std::optional<double>& degrees) {
  return degrees ? std::optional(*degrees / kDegreesPerRadian) : std::nullopt;
}

std::string path_of(const py::handle& path) { return py::str(py::module_::import("os").attr("fspath")(path)); }

Inputs inputs_of(const py::object& source) {
  if (py::isinstance<ReadRig>(source)) return source.cast<const ReadRig&>().inputs;
  Inputs inputs;
  inputs.files = {path_of(source)};
  return inputs;
}

}  // namespace fca::python

PYBIND11_MODULE(_native, module) {
  // Classes and signatures are named as people import them.
  const pybind11::object name = module.attr("__name__");
  module.attr("__name__") = "fca_io";
  module.attr("__version__") = FCA_VERSION;
  fca::python::add_cameras(module);
  fca::python::add_rigs(module);
  fca::python::add_fit(module);
  fca::python::add_maps(module);
  fca::python::add_rectify(module);
  fca::python::add_convert(module);
  fca::python::add_check(module);
  fca::python::add_compare(module);
  module.attr("__name__") = name;
}
