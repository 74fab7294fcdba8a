// SPDX-License-Identifier: BSD-3-Clause
// What the parts of the Python module share. Each add_ function adds the classes and functions of its file.
#pragma once

#include <fca/diagnostics.h>
#include <fca/formats/text/source.h>
#include <fca/remap/image_map.h>
#include <fca/rig/rig.h>
#include <fca/toolkit/inputs.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace fca::python {

namespace py = pybind11;

void add_cameras(py::module_& module);
void add_rigs(py::module_& module);
void add_fit(py::module_& module);
void add_maps(py::module_& module);
void add_rectify(py::module_& module);
void add_convert(py::module_& module);
void add_check(py::module_& module);
void add_compare(py::module_& module);

/// Numbers in rows, as numpy has them. Others are converted.
using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The array's rows of so many numbers. Raises ValueError for another shape: one row, or (N, columns).
[[nodiscard]] std::span<const double> rows_of(const Array& array, py::ssize_t columns, const char* what);
/// An array of as many rows as `like`, with so many columns; one row where that is one.
[[nodiscard]] Array rows_like(const Array& like, py::ssize_t columns);
/// 4 x 4.
[[nodiscard]] Array matrix_of(const Transform& transform);
/// Its 3 x 3 part.
[[nodiscard]] Array rotation_of(const Transform& transform);
/// (u, v), as cv2.remap takes them: float32 (height, width). Far outside where there is no place.
[[nodiscard]] py::tuple as_maps(const ImageMap& map);

/// Raises fca_io.Error of the first error.
[[noreturn]] void raise(const Diagnostics& diagnostics, std::span<const text::Source> sources = {});
/// Texts of the warnings.
[[nodiscard]] std::vector<std::string> warnings_of(const Diagnostics& diagnostics);
/// Raises ValueError.
[[noreturn]] void raise_value_error(const std::string& message);

/// (width, height)
using Size = std::pair<int, int>;
[[nodiscard]] std::optional<ImageSize> size_of(const std::optional<Size>& size);

inline constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
[[nodiscard]] std::optional<double> radians(const std::optional<double>& degrees);

/// Raises ValueError for a name that no model has.
[[nodiscard]] const ModelInfo& model_named(const std::string& name);

/// The calibration that one read: what the functions that take a Rig or a path work on.
struct ReadRig {
  Inputs inputs;
  Rig rig;
  std::string format;
  std::vector<std::string> warnings;
};

/// A path (str or os.PathLike) or a Rig, as inputs.
[[nodiscard]] Inputs inputs_of(const py::object& source);
[[nodiscard]] std::string path_of(const py::handle& path);

}  // namespace fca::python
