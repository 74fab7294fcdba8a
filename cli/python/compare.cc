// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.h"

#include <fca/formats/text/message.h>
#include <fca/toolkit/compare.h>
#include <fca/toolkit/models.h>

#include <memory>

namespace fca::python {

namespace {

RigComparison compare_sources(const py::object& reference, const py::object& other, const std::optional<double>& max_angle,
                              const std::optional<double>& focus, const std::optional<double>& distance) {
  if (distance && !(*distance > 0.0)) raise_value_error("distance is in metres, more than 0");
  CompareRequest request;
  request.reference = inputs_of(reference);
  const Inputs inputs = inputs_of(other);
  request.files = inputs.files;
  request.parts = inputs.parts;
  request.reference.max_angle_rad = radians(max_angle);
  request.focus_rad = radians(focus);
  request.distance_m = distance;
  Files files;
  CompareResult result;
  {
    const py::gil_scoped_release released;
    result = compare(request, files);
  }
  if (!result.reference.calibration) raise(result.reference.diagnostics, files.sources());
  ComparedFile& compared = result.files.front();
  if (!compared.comparison) raise(compared.diagnostics, files.sources());
  return *std::move(compared.comparison);
}

/// (name, reference, other) of the parameters that differ.
std::vector<std::tuple<std::string, std::optional<double>, std::optional<double>>> differing(const CameraComparison& camera) {
  std::vector<std::tuple<std::string, std::optional<double>, std::optional<double>>> rows;
  for (const ParameterComparison& row : camera.parameters) {
    if (!row.same_but_for_rounding()) rows.emplace_back(row.name, row.reference, row.other);
  }
  return rows;
}

std::optional<std::array<double, 3>> centre_of(const CameraComparison& camera) {
  return camera.rotated && camera.rotated->distance_m ? std::optional(camera.rotated->centre_m) : std::nullopt;
}

std::vector<std::string> mistakes_of(const RigComparison& comparison) {
  std::vector<std::string> texts;
  for (const Mistake& mistake : comparison.mistakes) texts.push_back(text::text_of(mistake.message));
  return texts;
}

/// One model as a target.
struct ModelRow {
  std::string model;
  std::optional<ErrorSummary> error;  ///< Over the whole image; nothing where it does not fit.
  double decisive_rms = 0.0;
  bool exact = false;
  bool reaches_all = false;
};

std::vector<ModelRow> models_of(const Camera& camera, const std::optional<double>& max_angle) {
  Diagnostics diagnostics;
  std::optional<std::vector<ModelsResult::OfCamera>> found;
  {
    const py::gil_scoped_release released;
    found = compare_models(std::vector<Camera>{camera}, radians(max_angle), diagnostics);
  }
  if (!found) raise(diagnostics);
  std::vector<ModelRow> rows;
  for (const Candidate* candidate : ranked(found->front().candidates)) {
    const ConversionReport& report = candidate->conversion->report;
    rows.push_back({std::string(candidate->model->id), report.statistics.error, candidate->decisive().rms, report.exact,
                    reaches_all(*candidate)});
  }
  return rows;
}

}  // namespace

void add_compare(py::module_& module) {
  py::class_<CameraComparison>(module, "CameraComparison", "Two cameras, in pixels of the reference's image.")
      .def_readonly("reference", &CameraComparison::reference, "Name.")
      .def_readonly("other", &CameraComparison::other, "Name.")
      .def_readonly("identical", &CameraComparison::identical, "The same pixels, but for rounding.")
      .def_property_readonly(
          "error", [](const CameraComparison& each) { return each.difference.statistics.error; },
          "PixelError over the whole image.")
      .def_property_readonly(
          "decisive_error", [](const CameraComparison& each) { return each.decisive().statistics.error; },
          "PixelError that counts: in focus, and without a turn that the poses cancel.")
      .def_property_readonly(
          "rotation",
          [](const CameraComparison& each) { return each.rotated ? std::optional(each.rotated->vector_rad) : std::nullopt; },
          "Rotation vector from the reference's rays to the other's, radians.")
      .def_property_readonly(
          "centre", [](const CameraComparison& each) { return centre_of(each); },
          "The other's projection centre in the reference's frame, metres; None without a distance.")
      .def_readonly("turn_cancels", &CameraComparison::turn_cancels, "The other's poses turn back by what its lens is turned.")
      .def_property_readonly("differing", &differing, "(parameter, reference's, other's) of those that differ.");
  py::class_<PoseComparison>(module, "PoseComparison", "How the same two things sit to each other in the two rigs.")
      .def_readonly("a", &PoseComparison::a, "Name of a camera or an IMU.")
      .def_readonly("b", &PoseComparison::b, "Name of another one.")
      .def_property_readonly(
          "angle", [](const PoseComparison& each) { return each.angle_rad * kDegreesPerRadian; }, "Degrees.")
      .def_readonly("distance", &PoseComparison::distance_m, "Metres.");
  py::class_<RigComparison>(module, "Comparison", "How two calibrations differ.")
      .def_readonly("cameras", &RigComparison::cameras, "A list of CameraComparison.")
      .def_readonly("poses", &RigComparison::poses, "A list of PoseComparison.")
      .def_property_readonly("identical", &RigComparison::identical, "All cameras and poses are, but for rounding.")
      .def_property_readonly("mistakes", &mistakes_of, "Common mistakes that explain a difference.");
  module.def("compare", &compare_sources, py::arg("reference"), py::arg("other"), py::kw_only(),
             py::arg("max_angle") = py::none(), py::arg("focus") = py::none(), py::arg("distance") = py::none(),
             "How two calibrations, of any formats and models, differ: paths or Rigs. focus: degrees from the axis up to which "
             "rays count; distance: of the points, metres.");
  py::class_<ModelRow>(module, "ModelFit", "One camera model as a target.")
      .def_readonly("model", &ModelRow::model, "'kb4', 'ds', ...")
      .def_readonly("error", &ModelRow::error, "PixelError over the whole image.")
      .def_readonly("decisive_rms", &ModelRow::decisive_rms, "Pixels, in the region that decides: of a wide lens its circle.")
      .def_readonly("exact", &ModelRow::exact, "The model contains the camera: the same pixels by construction.")
      .def_readonly("reaches_all", &ModelRow::reaches_all, "It has a pixel for all that the image shows.");
  module.def("models", &models_of, py::arg("camera"), py::kw_only(), py::arg("max_angle") = py::none(),
             "Every model that the camera could be written as, the best first.");
}

}  // namespace fca::python
