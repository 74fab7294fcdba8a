// SPDX-License-Identifier: BSD-3-Clause
#include "request_words.h"

#include <fca/formats/text/message.h>
#include <fca/toolkit/read.h>

#include <algorithm>
#include <array>
#include <tuple>

namespace fca::python {

namespace {

void take_format(const Value& value, Inputs& inputs) {
  const auto name = value.as<std::string>();
  inputs.format = find_format(name);
  if (inputs.format == nullptr) raise_value_error("unknown format '" + name + "'");
}

void take_opencv_model(const Value& value, Inputs& inputs) {
  const auto name = value.as<std::string>();
  for (const OpenCvModel model : {OpenCvModel::kPinhole, OpenCvModel::kFisheye}) {
    if (name == name_of(model)) inputs.opencv_model = model;
  }
  if (!inputs.opencv_model) value.refuse("'pinhole' or 'fisheye'");
}

void take_unit(const Value& value, Inputs& inputs) {
  constexpr std::array kUnits = {std::pair{"m", 1.0}, std::pair{"cm", 1e-2}, std::pair{"mm", 1e-3}};
  const auto name = value.as<std::string>();
  const auto* const unit = std::ranges::find_if(kUnits, [&name](const auto& each) { return name == each.first; });
  if (unit == kUnits.end()) value.refuse("'m', 'cm' or 'mm'");
  inputs.length_unit_m = unit->second;
}

void take_crop(const Value& value, Inputs& inputs) {
  const auto [x, y, width, height] = value.as<std::tuple<int, int, int, int>>();
  inputs.change.crop = ImageRegion{x, y, {width, height}};
}

void take_binning(const Value& value, Inputs& inputs) {
  inputs.change.binning = value.as<int>();
  if (inputs.change.binning < 1) value.refuse("a whole number from 1");
}

constexpr std::array kKeywords = {
    Keyword<Inputs>{"parts", &take_parts},
    Keyword<Inputs>{"format", &take_format},
    Keyword<Inputs>{"camera", &take_cameras},
    Keyword<Inputs>{"image_size", [](const Value& value, Inputs& inputs) { inputs.image_size = size_of(value.as<Size>()); }},
    Keyword<Inputs>{"opencv_model", &take_opencv_model},
    Keyword<Inputs>{"unit", &take_unit},
    Keyword<Inputs>{"crop", &take_crop},
    Keyword<Inputs>{"binning", &take_binning},
    Keyword<Inputs>{"resize", [](const Value& value, Inputs& inputs) { inputs.change.resize = size_of(value.as<Size>()); }},
};

ReadRig read_rig(const py::object& path, const py::kwargs& keywords) {
  ReadRig result;
  result.inputs.files = {path_of(path)};
  take_keywords(kKeywords, keywords, result.inputs);
  Files files;
  Diagnostics diagnostics;
  std::optional<Calibration> calibration;
  {
    const py::gil_scoped_release released;
    calibration = read_models(result.inputs, files, diagnostics);
  }
  if (!calibration) raise(diagnostics, files.sources());
  result.rig = std::move(calibration->rig);
  result.format = calibration->format->id;
  result.warnings = warnings_of(diagnostics);
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
      .def_readonly("name", &Imu::name, "By which the rig and its poses know it.")
      .def_readonly("gyroscope_noise_density", &Imu::gyroscope_noise_density, "rad/s/sqrt(Hz)")
      .def_readonly("gyroscope_random_walk", &Imu::gyroscope_random_walk, "rad/s^2/sqrt(Hz)")
      .def_readonly("accelerometer_noise_density", &Imu::accelerometer_noise_density, "m/s^2/sqrt(Hz)")
      .def_readonly("accelerometer_random_walk", &Imu::accelerometer_random_walk, "m/s^3/sqrt(Hz)")
      .def_readonly("rate", &Imu::rate_hz, "Hz")
      .def_readonly("topic", &Imu::topic, "Of its samples in ROS; may be empty.");
  py::class_<ReadRig>(module, "Rig", "What a calibration file means: cameras, IMUs, and how they sit to each other.")
      .def_property_readonly(
          "cameras", [](const ReadRig& rig) { return rig.rig.cameras; }, "A list of Camera, in the order of the file.")
      .def_property_readonly(
          "imus", [](const ReadRig& rig) { return rig.rig.imus; }, "A list of Imu.")
      .def_property_readonly("frames", &frames_of, "Names that pose() knows.")
      .def_readonly("format", &ReadRig::format, "'kalibr', 'opencv', ...")
      .def_readonly("warnings", &ReadRig::warnings, "What its reader noticed.")
      .def("camera", &camera_of, py::arg("name"), py::return_value_policy::copy,
           "The Camera of that name; KeyError where there is none.")
      .def("pose", &pose_of, py::arg("a"), py::arg("b"),
           "T_a_b as a matrix (4, 4): takes points in b to points in a, in metres. KeyError where the file contains none.");
  module.def("read", &read_rig, py::arg("path"), R"(Reads a calibration file of any format.

Returns a Rig. All but the first are keywords:

path                a file, or a folder that is one rig
parts               paths of further files of the same calibration: ['imu.yaml']
format              'kalibr', ...; found by the content
camera              these cameras alone, in this order: names, or places from 0
image_size          (width, height), for files that contain none
opencv_model        'pinhole' or 'fisheye', where four coefficients could be either
unit                'm', 'cm' or 'mm', of translations in files that do not contain it; 'm'
crop, binning, resize
                    from the calibrated images to yours, in this order: (x, y, width, height), N, (width, height)

Raises Error with code, file, line and column.)");
}

}  // namespace fca::python
