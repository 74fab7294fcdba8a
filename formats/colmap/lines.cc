// SPDX-License-Identifier: BSD-3-Clause
#include "lines.h"

#include "../text/words.h"

#include <fca/formats/text/numbers.h>
#include <fca/formats/text/prose.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fca::colmap {

namespace {

constexpr std::array<ParameterId, 1> kK1 = {"k1"};
constexpr std::array<ParameterId, 2> kK1K2 = {"k1", "k2"};
constexpr std::array<ParameterId, 4> kBrown = {"k1", "k2", "p1", "p2"};
constexpr std::array<ParameterId, 8> kRational = {"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"};
constexpr std::array<ParameterId, 4> kFisheye = {"k1", "k2", "k3", "k4"};
constexpr std::array<ParameterId, 1> kOmega = {"w"};
constexpr std::array<ParameterId, 2> kAlphaBeta = {"alpha", "beta"};
constexpr std::array<ParameterId, 1> kDivision = {"k"};
constexpr std::array<ParameterId, 8> kThinPrism = {"k1", "k2", "p1", "p2", "k3", "k4", "sx1", "sy1"};
constexpr std::array<ParameterId, 12> kAria = {"k0", "k1", "k2", "k3", "k4", "k5", "p0", "p1", "s0", "s1", "s2", "s3"};

/// All models up to COLMAP 4.2. Of those that are one of ours the first is written.
constexpr std::array kModels = {
    Model{"PINHOLE", "pinhole"},
    Model{"SIMPLE_PINHOLE", "pinhole", true},
    Model{"OPENCV", "radtan", false, kBrown},
    Model{"SIMPLE_RADIAL", "radtan", true, kK1},
    Model{"RADIAL", "radtan", true, kK1K2},
    Model{"FULL_OPENCV", "rational", false, kRational},
    Model{"OPENCV_FISHEYE", "kb4", false, kFisheye},
    Model{"SIMPLE_RADIAL_FISHEYE", "kb4", true, kK1},
    Model{"RADIAL_FISHEYE", "kb4", true, kK1K2},
    Model{"FISHEYE", "kb4"},
    Model{"SIMPLE_FISHEYE", "kb4", true},
    Model{"FOV", "fov", false, kOmega},
    Model{"EUCM", "eucm", false, kAlphaBeta},
    Model{"THIN_PRISM_FISHEYE", "thin-prism-fisheye", false, kThinPrism},
    Model{"RAD_TAN_THIN_PRISM_FISHEYE", "fisheye624", false, kAria},
    Model{"DIVISION", "division", false, kDivision},
    Model{"SIMPLE_DIVISION", "division", true, kDivision},
    Model{.name = "EQUIRECTANGULAR", .why_not = Code::kColmapEquirectangular},
};

constexpr std::array<ParameterId, 4> kFocalAndCentre = {"fx", "fy", "cx", "cy"};

bool is_centre(const ParameterId& id) { return id == ParameterId("cx") || id == ParameterId("cy"); }

/// Our parameter from the number of a line, and back.
double parameter_of(const ParameterId& id, double number) { return is_centre(id) ? from_file(number) : number; }
double number_of(const ParameterId& id, double parameter) { return is_centre(id) ? to_file(parameter) : parameter; }

}  // namespace

const Model* find_model(std::string_view name) {
  const auto* const found = std::ranges::find(kModels, name, &Model::name);
  return found == kModels.end() ? nullptr : &*found;
}

std::vector<std::string> names_of_read_models() {
  std::vector<std::string> names;
  for (const Model& model : kModels) {
    if (!model.model.empty()) names.emplace_back(model.name);
  }
  return names;
}

const Model* written_model(const CameraModel& model) {
  const auto* const found = std::ranges::find(kModels, model_info(model).id, &Model::model);
  return found == kModels.end() ? nullptr : &*found;
}

std::vector<ParameterId> set_by(const Model& model, std::size_t index) {
  if (model.one_focal_length && index == 0) return {"fx", "fy"};
  const std::size_t number = index + (model.one_focal_length ? 1 : 0);
  if (number < kFocalAndCentre.size()) return {kFocalAndCentre.at(number)};
  return {model.coefficients[number - kFocalAndCentre.size()]};
}

std::string parameter_names(const Model& model) {
  std::string names;
  for (std::size_t i = 0; i < model.parameters(); ++i) {
    const std::vector<ParameterId> ids = set_by(model, i);
    names += (i > 0 ? " " : "") + (ids.size() > 1 ? "f" : std::string(ids.front().name()));
  }
  return names;
}

std::optional<std::vector<double>> parameters_in(const Model& model, const Camera& camera) {
  if (model_info(camera.model).id != model.model) return std::nullopt;
  std::vector<double> values;
  std::vector<ParameterId> there;
  for (std::size_t i = 0; i < model.parameters(); ++i) {
    const std::vector<ParameterId> ids = set_by(model, i);
    const double value = parameter(camera.model, ids.front()).value();
    for (const ParameterId id : ids) {
      if (parameter(camera.model, id) != value) return std::nullopt;
      there.push_back(id);
    }
    values.push_back(number_of(ids.front(), value));
  }
  for (const Parameter& row : model_info(camera.model).parameters) {
    const ParameterId id(row);
    if (std::ranges::find(there, id) == there.end() && parameter(camera.model, id) != 0.0) return std::nullopt;
  }
  return values;
}

const Model* read_model(const text::Node& word, fields::Reader& reader) {
  const Model* model = find_model(word.value);
  if (model == nullptr) {
    const std::vector<std::string> all = names_of_read_models();
    const std::vector<std::string> alike = text::nearest(word.value, all);
    reader.say(word, Code::kColmapUnknownModel, {word.value.substr(0, 40), alike.empty() ? all : alike});
  } else if (model->model.empty()) {
    reader.say(word, Code::kColmapModelNotRead, {word.value, Message{model->why_not}});
    return nullptr;
  }
  return model;
}

bool read_lens(std::span<const text::Node> numbers, const Model& model, Camera& camera, fields::Reader& reader) {
  // A lens of angle 0 bends nothing.
  const bool straight = model.model == "fov" && text::parse_real(numbers.back().value) == 0.0;
  camera.model = *make_model(straight ? "pinhole" : model.model);
  bool good = true;
  for (std::size_t i = 0; i < numbers.size() - (straight ? 1 : 0); ++i) {
    for (const ParameterId id : set_by(model, i)) {
      const std::optional<double> value = reader.real(numbers[i], id.name());
      if (!value) return false;
      if (model.name == "EUCM" && id == ParameterId("alpha") && !(*value >= 0.0 && *value <= 1.0)) {
        reader.say(numbers[i], Code::kColmapEucmAlpha, {*value});
        return false;
      }
      good = good && reader.parameter(numbers[i], camera.name, id, parameter_of(id, *value), camera.model);
    }
  }
  return good;
}

double from_file(double pixel) { return pixel - 0.5; }

double to_file(double pixel) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double sum = pixel + 0.5;
  for (const double near : {sum, std::nextafter(sum, kInfinity), std::nextafter(sum, -kInfinity)}) {
    if (from_file(near) == pixel) return near;
  }
  return sum;
}

bool has_words(const text::Node& line, std::initializer_list<std::string_view> beginnings) {
  return std::ranges::all_of(beginnings, [&line](std::string_view word) {
    return std::ranges::any_of(line.items, [word](const text::Node& each) { return each.value.starts_with(word); });
  });
}

std::vector<const text::Node*> camera_lines(const text::Document& document) {
  std::vector<const text::Node*> lines;
  for (const text::Node& line : document.root().items) {
    if (!line.items.empty() && line.tag != text::kCommentTag) lines.push_back(&line);
  }
  return lines;
}

}  // namespace fca::colmap
