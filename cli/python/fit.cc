// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.h"

#include <fca/code.h>
#include <fca/convert/convert.h>

#include <numbers>

namespace fca::python {

namespace {

/// A fitted camera, and how far it is from the source over the image.
struct Fit {
  Camera camera;
  ConversionReport report;
};

Fit fit(const Camera& source, const std::string& model, const std::optional<double>& max_angle, const std::string& objective) {
  if (objective != "rms" && objective != "max") raise_value_error("objective is 'rms' or 'max'");
  ConvertOptions options;
  options.model = model;
  options.objective = objective == "max" ? Objective::kMax : Objective::kRms;
  if (max_angle) options.max_angle_rad = *max_angle * std::numbers::pi / 180.0;
  Diagnostics diagnostics;
  std::optional<Conversion> conversion;
  {
    const py::gil_scoped_release released;
    conversion = convert(source, options, diagnostics);
  }
  if (!conversion) raise(diagnostics);
  return {std::move(conversion->camera), std::move(conversion->report)};
}

}  // namespace

void add_fit(py::module_& module) {
  py::class_<ErrorSummary>(module, "PixelError", "Distances between two cameras' pixels of the same rays, in pixels.")
      .def_readonly("rms", &ErrorSummary::rms)
      .def_readonly("mean", &ErrorSummary::mean)
      .def_readonly("p99", &ErrorSummary::p99, "99th percentile")
      .def_readonly("max", &ErrorSummary::max)
      .def_readonly("max_at", &ErrorSummary::max_at, "The pixel (u, v) of the source where it is.")
      .def_readonly("bound", &ErrorSummary::bound, "No error is larger, between the pixels, too: proven. inf: nothing is.");
  py::class_<Fit>(module, "Fit", "A camera fitted to another one.")
      .def_readonly("camera", &Fit::camera)
      .def_property_readonly("error", [](const Fit& fit) { return fit.report.judgement.error; })
      .def_property_readonly(
          "exact", [](const Fit& fit) { return fit.report.exact; },
          "The model contains the source: the same pixels by construction.")
      .def_property_readonly(
          "scored", [](const Fit& fit) { return fit.report.judgement.coverage.scored; },
          "Share of the image that was compared, 0 to 1.")
      .def_property_readonly(
          "unrepresentable", [](const Fit& fit) { return fit.report.judgement.coverage.unrepresentable; },
          "Share of the image that the model cannot reach.")
      .def_property_readonly(
          "max_angle", [](const Fit& fit) { return fit.report.scored_to_deg; },
          "Degrees from the axis up to which it was compared.");
  module.def("fit", &fit, py::arg("source"), py::arg("model"), py::arg("max_angle") = py::none(), py::arg("objective") = "rms",
             R"(Fits another model to a camera, without images, at the least-squares optimum in pixels over the whole image.

max_angle: degrees from the axis that count as lens. objective: 'rms', or 'max' for the smallest largest error. The source's
image size has to be known.)");
}

}  // namespace fca::python
