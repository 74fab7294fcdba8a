// SPDX-License-Identifier: BSD-3-Clause
#include "request_words.h"

#include <fca/formats/text/prose.h>

#include <cmath>
#include <map>
#include <variant>

namespace fca::python {

namespace {

using NameOrPlace = std::variant<std::size_t, std::string>;

CameraChoice choice_of(const NameOrPlace& camera) {
  if (const auto* place = std::get_if<std::size_t>(&camera)) return {std::to_string(*place), *place};
  return {std::get<std::string>(camera)};
}

}  // namespace

Target target_named(const std::string& name) {
  if (std::optional<Target> target = find_target(name); target && target->format->is_written()) return *std::move(target);
  std::vector<std::string> known;
  for (const Format& format : written_formats()) known.emplace_back(format.id);
  raise_value_error("fca-io writes no '" + name + "'; there are " + text::enumerated(known));
}

void take_parts(const Value& value, Inputs& inputs) {
  for (const py::object& part : value.as<std::vector<py::object>>()) inputs.parts.push_back(path_of(part));
}

void take_max_angle(const Value& value, Inputs& inputs) {
  const auto degrees = value.as<double>();
  constexpr double kBehind = 180.0;
  if (!(degrees > 0.0 && degrees <= kBehind)) value.refuse("in degrees from the axis, more than 0 and up to 180");
  inputs.max_angle_rad = radians(degrees);
}

void take_cameras(const Value& value, Inputs& inputs) {
  const bool is_one = py::isinstance<py::str>(value.given()) || py::isinstance<py::int_>(value.given());
  inputs.cameras.emplace();
  if (is_one) {
    inputs.cameras->push_back(choice_of(value.as<NameOrPlace>()));
    return;
  }
  for (const NameOrPlace& camera : value.as<std::vector<NameOrPlace>>()) inputs.cameras->push_back(choice_of(camera));
}

void take_fixed(const Value& value, ConvertRequest& request) {
  using Fixed = std::optional<std::variant<double, std::string>>;
  for (const auto& [name, at] : value.as<std::map<std::string, Fixed>>()) {
    const std::optional<ParameterId> parameter = ParameterId::find(name);
    if (!parameter) raise_value_error("fix: no model has a parameter '" + name + "'");
    if (!at) {
      request.fixed.kept.push_back(*parameter);
    } else if (const auto* number = std::get_if<double>(&*at)) {
      if (!std::isfinite(*number)) value.refuse("a finite number for " + name);
      request.fixed.at.push_back({*parameter, *number, *number});
    } else if ((name == "fx" && std::get<std::string>(*at) == "fy") || (name == "fy" && std::get<std::string>(*at) == "fx")) {
      request.fixed.one_focal_length = true;
    } else {
      value.refuse("a number, None (as in the input), or 'fy' for fx");
    }
  }
}

}  // namespace fca::python
