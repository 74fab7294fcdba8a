// SPDX-License-Identifier: BSD-3-Clause
#include "fit_rays.h"

#include <fca/code.h>
#include <fca/convert/convert.h>

namespace fca::python {

namespace {

Fit fit_to_camera(const Camera& source, const ModelInfo& model, const std::optional<double>& max_angle_rad, Objective objective,
                  WeightKind weight) {
  ConvertOptions options;
  options.model = model.id;
  options.objective = objective;
  options.weight.kind = weight;
  options.max_angle_rad = max_angle_rad;
  Diagnostics diagnostics;
  std::optional<Conversion> conversion;
  {
    const py::gil_scoped_release released;
    conversion = convert(source, options, diagnostics);
  }
  if (!conversion) raise(diagnostics);
  return {std::move(conversion->camera), std::move(conversion->report)};
}

/// A Camera, a function from pixels to rays, or (rays, pixels).
Fit fit(const py::object& source, const std::string& model, const std::optional<double>& max_angle,
        const std::string& objective, const std::optional<Size>& image_size, const std::string& weight) {
  if (objective != "rms" && objective != "max") raise_value_error("objective is 'rms' or 'max'");
  if (weight != "pixel" && weight != "angle") raise_value_error("weight is 'pixel' or 'angle'");
  const ModelInfo& info = model_named(model);
  if (max_angle && !(*max_angle > 0.0)) raise_value_error("max_angle is a positive number of degrees");
  const std::optional<double> max_angle_rad = radians(max_angle);
  if (py::isinstance<Camera>(source)) {
    if (image_size) raise_value_error("a Camera has its image_size");
    return fit_to_camera(source.cast<const Camera&>(), info, max_angle_rad,
                         objective == "max" ? Objective::kMax : Objective::kRms,
                         weight == "angle" ? WeightKind::kAngle : WeightKind::kPixel);
  }
  if (objective != "rms") raise_value_error("objective 'max' wants a Camera");
  if (weight != "pixel") raise_value_error("weight 'angle' wants a Camera");
  if (py::isinstance<py::function>(source)) {
    if (!image_size) raise_value_error("a function wants an image_size");
    return fit_to_function(source.cast<py::function>(), info, *image_size, max_angle_rad);
  }
  if (py::isinstance<py::tuple>(source) && py::len(source) == 2) {
    const auto table = source.cast<py::tuple>();
    return fit_to_table(table[0].cast<Array>(), table[1].cast<Array>(), info, image_size, max_angle_rad);
  }
  raise_value_error("source is a Camera, a function from pixels (N, 2) to rays (N, 3), or a pair of arrays (rays, pixels)");
}

}  // namespace

void add_fit(py::module_& module) {
  py::class_<ErrorSummary>(module, "PixelError", "Distances between two cameras' pixels of the same rays, in pixels.")
      .def_readonly("rms", &ErrorSummary::rms, "Root mean square.")
      .def_readonly("mean", &ErrorSummary::mean, "Mean distance.")
      .def_readonly("p99", &ErrorSummary::p99, "99th percentile")
      .def_readonly("max", &ErrorSummary::max, "The largest, between the pixels, too.")
      .def_readonly("max_at", &ErrorSummary::max_at, "The pixel (u, v) of the source where it is.")
      .def_readonly("bound", &ErrorSummary::bound, "No error is larger, between the pixels, too: proven. inf: nothing is.");
  py::class_<Fit>(module, "Fit", "A fitted camera, and how far it is from its source.")
      .def_readonly("camera", &Fit::camera, "Of the model that was asked for.")
      .def_property_readonly(
          "error", [](const Fit& fit) { return fit.report.statistics.error; }, "PixelError.")
      .def_property_readonly(
          "weighted_rms",
          [](const Fit& fit) { return fit.report.weighted ? std::optional(fit.report.weighted->rms_px) : std::nullopt; },
          "With weight='angle': the root mean square by solid angle, which the fit made small, in pixels.")
      .def_property_readonly(
          "exact", [](const Fit& fit) { return fit.report.exact; },
          "The model contains the source: the same pixels by construction.")
      .def_property_readonly(
          "scored", [](const Fit& fit) { return fit.report.statistics.coverage.scored; },
          "Share of the image that was compared, 0 to 1.")
      .def_property_readonly(
          "unrepresentable", [](const Fit& fit) { return fit.report.statistics.coverage.unrepresentable; },
          "Share of the image that the model cannot reach.")
      .def_property_readonly(
          "max_angle", [](const Fit& fit) { return fit.report.scored_to_deg; },
          "Degrees from the axis up to which it was compared.");
  module.def("fit", &fit, py::arg("source"), py::arg("model"), py::arg("max_angle") = py::none(), py::arg("objective") = "rms",
             py::kw_only(), py::arg("image_size") = py::none(), py::arg("weight") = "pixel",
             R"(Fits a model, without images, at the least-squares optimum in pixels.

source              a Camera, whose whole image counts; a function from pixels (N, 2) to rays (N, 3), NaN where it sees nothing;
                    or a pair of arrays, rays (N, 3) and pixels (N, 2), each row of which counts alike
model               'kb4', 'ds', ...
max_angle           what counts as lens, degrees from the axis; the whole image
objective           'rms', or 'max' for the smallest largest error, of a Camera
image_size          (width, height), of a function; of a table it may be left out
weight              'pixel', or 'angle' for directions to count alike, of a Camera

Only a Camera's error has a bound: a function and a table are known at points alone.)");
}

}  // namespace fca::python
