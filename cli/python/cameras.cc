// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.h"

#include <fca/code.h>
#include <fca/formats/opencv_coefficients.h>
#include <fca/formats/text/message.h>
#include <fca/models/camera_model.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

namespace fca::python {

namespace {

void set(CameraModel& model, const std::string& name, double value) {
  const std::optional<ParameterId> id = ParameterId::find(name);
  if (!id || !set_parameter(model, *id, value))
    raise_value_error(std::string(model_info(model).id) + " has no parameter '" + name + "'");
}

void check(const Camera& camera) {
  const std::vector<Message> problems = validate(camera.model);
  if (!problems.empty()) raise_value_error(text::text_of(problems.front()));
}

Camera camera_of(const std::string& model, const std::map<std::string, double>& parameters, const std::optional<Size>& size,
                 const std::string& name) {
  Camera camera;
  camera.name = name;
  camera.image_size = size_of(size);
  camera.model = *make_model(model_named(model).id);
  for (const auto& [key, value] : parameters) set(camera.model, key, value);
  check(camera);
  return camera;
}

py::dict parameters_of(const Camera& camera) {
  py::dict result;
  const std::span<const double> values = parameter_values(camera.model);
  for (std::size_t i = 0; i < values.size(); ++i)
    result[py::str(std::string(model_info(camera.model).parameters[i].name))] = values[i];
  return result;
}

std::string model_for(std::size_t coefficients) {
  switch (coefficients) {
    case 0:
      return "pinhole";
    case 4:
    case kRadtanCount:
      return "radtan";
    case kRationalCount:
      return "rational";
    case kPrismCount:
    case kOpenCvCoefficients.size():
      return "opencv14";
    default:
      raise_value_error("D has " + std::to_string(coefficients) + " coefficients; OpenCV takes 0, 4, 5, 8, 12 or 14");
  }
}

Camera from_opencv(const Array& K, const Array& D, const std::optional<Size>& size, std::string model,
                   const std::string& name) {
  if (K.ndim() != 2 || K.shape(0) != 3 || K.shape(1) != 3) raise_value_error("K is a matrix of 3 x 3");
  const double* k = K.data();
  const std::span<const double> coefficients(D.data(), static_cast<std::size_t>(D.size()));
  if (model.empty()) model = model_for(coefficients.size());
  const ModelInfo& info = model_named(model);
  const std::span<const ParameterId> order =
      info.id == "kb4" ? std::span<const ParameterId>(kFisheyeCoefficients) : std::span<const ParameterId>(kOpenCvCoefficients);
  std::map<std::string, double> parameters = {{"fx", k[0]}, {"fy", k[4]}, {"cx", k[2]}, {"cy", k[5]}};
  if (coefficients.size() > order.size()) raise_value_error("D has more coefficients than " + std::string(info.id));
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    if (coefficients[i] != 0.0 || info.id != "pinhole") parameters[std::string(order[i].name())] = coefficients[i];
  }
  Camera camera = camera_of(model, parameters, size, name);
  if (k[1] == 0.0) return camera;
  const std::optional<CameraModel> skewed = with_skew(camera.model, k[1]);
  if (!skewed) raise_value_error("K has a skew (K[0, 1]), which no model here has with the numbers of " + model);
  camera.model = *skewed;
  return camera;
}

/// (K, D)
py::tuple to_opencv(const Camera& camera) {
  const auto [straight, skew_px] = without_skew(camera.model);
  const std::string_view id = model_info(straight).id;
  std::span<const ParameterId> order = std::span(kOpenCvCoefficients).first(id == "pinhole" ? kRadtanCount : opencv_count(id));
  if (id == "kb4") order = kFisheyeCoefficients;
  if (order.empty()) {
    raise_value_error("OpenCV's K and D hold pinhole, radtan, rational, opencv14 and kb4, not " + std::string(id) +
                      "; fca_io.fit(camera, 'kb4') fits one of them");
  }
  const auto value = [&camera](const ParameterId& each) { return parameter(camera.model, each).value(); };
  const bool has_no_coefficients = id == "pinhole";
  Array K({3, 3});
  std::ranges::copy(std::array{value("fx"), skew_px, value("cx"), 0.0, value("fy"), value("cy"), 0.0, 0.0, 1.0},
                    K.mutable_data());
  Array D(static_cast<py::ssize_t>(order.size()));
  std::ranges::transform(order, D.mutable_data(),
                         [&](const ParameterId& each) { return has_no_coefficients ? 0.0 : value(each); });
  return py::make_tuple(K, D);
}

using ForAll = void (*)(const CameraModel& model, std::span<const double> asked, std::span<double> answers);

/// Rows of `asked`, each with its answer of so many numbers; other threads run meanwhile.
Array answered(const Camera& camera, const Array& asked, std::span<const double> rows, py::ssize_t columns, ForAll for_all) {
  Array answers = rows_like(asked, columns);
  const std::span<double> out(answers.mutable_data(), static_cast<std::size_t>(answers.size()));
  const py::gil_scoped_release released;
  for_all(camera.model, rows, out);
  return answers;
}

Array project_rows(const Camera& camera, const Array& points) {
  return answered(camera, points, rows_of(points, 3, "points"), 2, &project_all);
}

Array unproject_rows(const Camera& camera, const Array& pixels) {
  return answered(camera, pixels, rows_of(pixels, 2, "pixels"), 3, &unproject_all);
}

std::optional<Size> size_as_pair(const Camera& camera) {
  if (!camera.image_size) return std::nullopt;
  return Size{camera.image_size->width, camera.image_size->height};
}

std::string described(const Camera& camera) {
  std::string text = "<fca_io.Camera " + camera.name + ": " + std::string(model_info(camera.model).id);
  if (camera.image_size)
    text += ", " + std::to_string(camera.image_size->width) + " x " + std::to_string(camera.image_size->height);
  return text + ">";
}

}  // namespace

void add_cameras(py::module_& module) {
  py::class_<Camera>(module, "Camera", R"(One camera: a model with its parameters.

Pixels are (u, v), with (0, 0) at the centre of the top-left pixel. Rays are (x right, y down, z forward), of any length.)")
      .def(py::init(&camera_of), py::arg("model"), py::arg("parameters"), py::arg("image_size") = py::none(),
           py::arg("name") = "cam0",
           "A camera of a model ('kb4') with parameters by name ({'fx': 190.0, ...}); those left out are 0.")
      .def_static(
          "from_opencv", &from_opencv, py::arg("K"), py::arg("D"), py::arg("image_size") = py::none(), py::arg("model") = "",
          py::arg("name") = "cam0",
          "A camera from OpenCV's matrix (3, 3) and coefficients: 0, 4, 5, 8, 12 or 14 of cv2.projectPoints, or four of "
          "cv2.fisheye with model='kb4'.")
      .def("to_opencv", &to_opencv, "(K, D) as cv2 takes them: of kb4 for cv2.fisheye. ValueError for other models.")
      .def_readonly("name", &Camera::name, "By which the rig and its poses know it.")
      .def_property_readonly(
          "model", [](const Camera& camera) { return std::string(model_info(camera.model).id); }, "'kb4', 'ds', ...")
      .def_property_readonly("parameters", &parameters_of, "By name, in the model's order.")
      .def_property_readonly("image_size", &size_as_pair, "(width, height), or None where no input contains it.")
      .def_readonly("time_offset", &Camera::time_offset_s, "Seconds: t_imu = t_cam + time_offset. None: not given.")
      .def_readonly("topic", &Camera::topic, "Of its images in ROS; may be empty.")
      .def_property_readonly(
          "max_angle", [](const Camera& camera) { return max_angle(camera.model) * kDegreesPerRadian; },
          "Degrees from the axis at which the model ends.")
      .def("project", &project_rows, py::arg("points"),
           "pixels (N, 2) of points (N, 3), of any length; NaN where the model has none. One point gives one "
           "pixel.")
      .def("unproject", &unproject_rows, py::arg("pixels"),
           "Unit rays (N, 3) of pixels (N, 2); NaN where the model has none. One pixel gives one ray.")
      .def("__eq__", [](const Camera& a, const Camera& b) { return a == b; })
      .def("__repr__", &described);
}

}  // namespace fca::python
