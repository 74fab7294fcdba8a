// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.h"

#include <fca/formats/text/message.h>
#include <fca/toolkit/read.h>

#include <algorithm>

namespace fca::python {

namespace {

const Format* format_named(const std::optional<std::string>& name) {
  if (!name) return nullptr;
  if (const Format* format = find_format(*name)) return format;
  raise_value_error("unknown format '" + *name + "'");
}

OpenCvModel opencv_model_named(const std::string& name) {
  if (name == "pinhole") return OpenCvModel::kPinhole;
  if (name == "fisheye") return OpenCvModel::kFisheye;
  raise_value_error("opencv_model is 'pinhole' or 'fisheye'");
}

ReadRig read_rig(const py::object& path, const std::vector<py::object>& parts, const std::optional<std::string>& format,
                 const std::optional<Size>& image_size, const std::optional<std::string>& opencv_model) {
  ReadRig result;
  result.inputs.files = {path_of(path)};
  for (const py::object& part : parts) result.inputs.parts.push_back(path_of(part));
  result.inputs.format = format_named(format);
  result.inputs.image_size = size_of(image_size);
  if (opencv_model) result.inputs.opencv_model = opencv_model_named(*opencv_model);
  Files files;
  Diagnostics diagnostics;
  std::optional<Calibration> calibration = read_models(result.inputs, files, diagnostics);
  if (!calibration) raise(diagnostics, files.sources());
  result.rig = std::move(calibration->rig);
  result.format = calibration->format->id;
  for (const Diagnostic& entry : diagnostics.entries()) {
    if (entry.severity == Severity::kWarning) result.warnings.push_back(message_of(entry));
  }
  return result;
}

Array pose_of(const ReadRig& rig, const std::string& a, const std::string& b) {
  const std::optional<Transform> T_a_b = rig.rig.resolve(a, b);
  if (!T_a_b) throw py::key_error("the file contains no pose between '" + a + "' and '" + b + "'");
  return matrix_of(*T_a_b);
}

const Camera& camera_of(const ReadRig& rig, const std::string& name) {
  if (const Camera* camera = rig.rig.find_camera(name)) return *camera;
  throw py::key_error("no camera '" + name + "'");
}

std::vector<std::string> frames_of(const ReadRig& rig) {
  std::vector<std::string> names;
  const auto add = [&names](const std::string& name) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  for (const Camera& camera : rig.rig.cameras) add(camera.name);
  for (const Imu& imu : rig.rig.imus) add(imu.name);
  for (const PoseEdge& edge : rig.rig.poses) {
    add(edge.a);
    add(edge.b);
  }
  return names;
}

}  // namespace

void add_rigs(py::module_& module) {
  py::class_<Imu>(module, "Imu", "Noise of an IMU as continuous-time densities; None where the file does not say.")
      .def_readonly("name", &Imu::name)
      .def_readonly("gyroscope_noise_density", &Imu::gyroscope_noise_density, "rad/s/sqrt(Hz)")
      .def_readonly("gyroscope_random_walk", &Imu::gyroscope_random_walk, "rad/s^2/sqrt(Hz)")
      .def_readonly("accelerometer_noise_density", &Imu::accelerometer_noise_density, "m/s^2/sqrt(Hz)")
      .def_readonly("accelerometer_random_walk", &Imu::accelerometer_random_walk, "m/s^3/sqrt(Hz)")
      .def_readonly("rate", &Imu::rate_hz, "Hz")
      .def_readonly("topic", &Imu::topic);
  py::class_<ReadRig>(module, "Rig", "What a calibration file means: cameras, IMUs, and how they sit to each other.")
      .def_property_readonly("cameras", [](const ReadRig& rig) { return rig.rig.cameras; })
      .def_property_readonly("imus", [](const ReadRig& rig) { return rig.rig.imus; })
      .def_property_readonly("frames", &frames_of, "Names that pose() knows.")
      .def_readonly("format", &ReadRig::format, "'kalibr', 'opencv', ...")
      .def_readonly("warnings", &ReadRig::warnings, "What its reader noticed.")
      .def("camera", &camera_of, py::arg("name"), py::return_value_policy::copy)
      .def("pose", &pose_of, py::arg("a"), py::arg("b"),
           "T_a_b as a matrix (4, 4): takes points in b to points in a, in metres. KeyError where the file contains none.");
  module.def("read", &read_rig, py::arg("path"), py::arg("parts") = std::vector<py::object>(), py::arg("format") = py::none(),
             py::arg("image_size") = py::none(), py::arg("opencv_model") = py::none(),
             R"(Reads a calibration file of any format.

parts: further files of the same calibration (imu.yaml). format: found by the content unless given. image_size: (width,
height), for files that contain none. opencv_model: 'pinhole' or 'fisheye', where four coefficients could be either.
Raises fca_io.Error with code, file, line and column.)");
}

}  // namespace fca::python
