// SPDX-License-Identifier: BSD-3-Clause
// An entry of OKVIS' list of cameras.
//
//   T_SC                      16 numbers row by row: p_imu = T p_cam
//   image_dimension           [width, height]
//   focal_length              [fx, fy]
//   principal_point           [cx, cy], with the centre of the first pixel at 0
//   distortion_type           radialtangential (plumb_bob), radialtangential8 (plumb_bob8), equidistant
//   distortion_coefficients   k1 k2 p1 p2, k1 k2 p1 p2 k3 k4 k5 k6, or k1 k2 k3 k4 of cv::fisheye
//   cam_model                 OKVIS2-X only: pinhole, or eucm with eucm_parameters [alpha, beta] in place of the distortion
//   camera_type, slam_use     OKVIS2: gray, rgb, gray+depth, rgb+depth; none, okvis, okvis-depth, okvis-virtual
#include "table.h"

#include "../column.h"

#include <fca/code.h>

#include <algorithm>
#include <array>
#include <string>

namespace fca::okvis {

using schema::FactKind;
using schema::Key;
using schema::required;
using schema::Statement;
using schema::Subject;
using text::Node;

namespace {

constexpr std::size_t kLongestWord = 40;  ///< Of the file, in a message.
constexpr std::string_view kCoefficients = "distortion_coefficients";
constexpr std::string_view kEucmParameters = "eucm_parameters";
constexpr std::string_view kPinhole = "pinhole";

constexpr std::array<ParameterId, 2> kFocal = {"fx", "fy"};
constexpr std::array<ParameterId, 2> kCentre = {"cx", "cy"};
constexpr std::array<ParameterId, 2> kAlphaBeta = {"alpha", "beta"};
constexpr std::array<ParameterId, 4> kRadtan = {"k1", "k2", "p1", "p2"};
constexpr std::array<ParameterId, 8> kRational = {"k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"};
constexpr std::array<ParameterId, 4> kEquidistant = {"k1", "k2", "k3", "k4"};

/// A distortion by name. Written is the first of a model.
struct Distortion {
  std::string_view name;
  std::string_view model;
  std::span<const ParameterId> coefficients;
};
constexpr std::array<Distortion, 5> kDistortions = {{{"radialtangential", "radtan", kRadtan},
                                                     {"radialtangential8", "rational", kRational},
                                                     {"equidistant", "kb4", kEquidistant},
                                                     {"plumb_bob", "radtan", kRadtan},
                                                     {"plumb_bob8", "rational", kRational}}};

const Distortion* distortion_of(const CameraModel& model) {
  const auto* const found = std::ranges::find(kDistortions, model_info(model).id, &Distortion::model);
  return found == kDistortions.end() ? nullptr : found;
}

bool is_eucm(const CameraModel& model) { return model_info(model).id == kEucm; }

bool read_list(schema::Reading& reading, const Key& key, const Node& node, std::span<const ParameterId> ids) {
  const std::string what = reading.label(key);
  if (!node.is_sequence() || node.items.size() != ids.size()) {
    static_cast<void>(reading.reader.reals(node, ids.size(), what));
    return false;
  }
  bool good = true;
  for (std::size_t i = 0; i < ids.size(); ++i)
    good = reading.reader.parameter(node.items[i], what, ids[i], reading.camera->model) && good;
  return good;
}

std::vector<Statement> write_list(const Subject& subject, const Key& key, std::span<const ParameterId> ids) {
  std::vector<double> values;
  Statement statement;
  for (const ParameterId id : ids) {
    values.push_back(parameter(subject.the_camera().model, id).value());
    statement.facts.push_back({.kind = FactKind::kParameter, .parameter = id.name()});
  }
  statement.field = fields::list(key.text(), values);
  return {std::move(statement)};
}

/// The lens, by two names of which the first may be missing.
bool read_lens(schema::Reading& reading, const Key& /*key*/, const Node& node) {
  const Node* model = reading.reader.find(*reading.mapping, kCameraModel);
  if (model != nullptr && model->value != kPinhole && model->value != kEucm) {
    reading.reader.say(*model, Code::kTableUnknownWord,
                       {reading.owner + " " + std::string(kCameraModel), model->value.substr(0, kLongestWord),
                        std::vector<std::string>{std::string(kPinhole), std::string(kEucm)}});
    return false;
  }
  if (model != nullptr && model->value == kEucm) {
    reading.camera->model = make_model(kEucm).value();
    return reading.reader.require(*reading.mapping, kEucmParameters, reading.owner) != nullptr;
  }
  const auto* const row = std::ranges::find(kDistortions, node.value, &Distortion::name);
  if (!node.is_scalar() || row == kDistortions.end()) {
    reading.reader.say(node, Code::kTableUnknownWord,
                       {reading.owner + " distortion_type", fields::value_text(node).substr(0, kLongestWord),
                        column(kDistortions, &Distortion::name)});
    return false;
  }
  reading.camera->model = make_model(row->model).value();
  reading.lens = row->name;
  const Node* list = reading.reader.find(*reading.mapping, kCoefficients);
  if (list == nullptr || !list->is_sequence() || list->items.size() == row->coefficients.size()) return true;
  reading.reader.say(*list, Code::kTableCoefficientCount,
                     {reading.owner + " " + std::string(kCoefficients), list->items.size(),
                      std::vector<std::string>{std::to_string(row->coefficients.size())}, row->name});
  return false;
}

/// OKVIS2 leaves a camera of a distortion that it does not know out, and OKVIS2-X does not read that of an EUCM.
std::vector<Statement> write_distortion(const Subject& subject, const Key& key) {
  const Distortion* distortion = distortion_of(subject.the_camera().model);
  if (distortion == nullptr && !is_eucm(subject.the_camera().model)) return {};
  return schema::states(fields::scalar(key.text(), distortion != nullptr ? std::string(distortion->name) : "none"),
                        {FactKind::kModel});
}

/// The first program reads a few keys, and a fresh file has no others.
bool is_fresh_of_first(const Subject& subject) { return subject.fresh != nullptr && &subject.schema == &kOkvis1; }

std::vector<Statement> write_camera_model(const Subject& subject, const Key& key) {
  if (is_fresh_of_first(subject)) return {};
  return schema::states(fields::scalar(key.text(), std::string(is_eucm(subject.the_camera().model) ? kEucm : kPinhole)),
                        {FactKind::kModel});
}

bool read_coefficients(schema::Reading& reading, const Key& key, const Node& node) {
  if (is_eucm(reading.camera->model)) return true;
  return reading.lens.empty() || read_list(reading, key, node, distortion_of(reading.camera->model)->coefficients);
}

/// All programs want four at least.
std::vector<Statement> write_coefficients(const Subject& subject, const Key& key) {
  const CameraModel& model = subject.the_camera().model;
  if (is_eucm(model)) return {{fields::list(key.text(), std::array<double, 4>{})}};
  const Distortion* distortion = distortion_of(model);
  return distortion != nullptr ? write_list(subject, key, distortion->coefficients) : std::vector<Statement>();
}

bool read_eucm(schema::Reading& reading, const Key& key, const Node& node) {
  return !is_eucm(reading.camera->model) || read_list(reading, key, node, kAlphaBeta);
}

std::vector<Statement> write_eucm(const Subject& subject, const Key& key) {
  return is_eucm(subject.the_camera().model) ? write_list(subject, key, kAlphaBeta) : std::vector<Statement>();
}

bool read_focal(schema::Reading& reading, const Key& key, const Node& node) { return read_list(reading, key, node, kFocal); }
std::vector<Statement> write_focal(const Subject& subject, const Key& key) { return write_list(subject, key, kFocal); }
bool read_centre(schema::Reading& reading, const Key& key, const Node& node) { return read_list(reading, key, node, kCentre); }
std::vector<Statement> write_centre(const Subject& subject, const Key& key) { return write_list(subject, key, kCentre); }

bool read_size(schema::Reading& reading, const Key& key, const Node& node) {
  const std::string what = reading.label(key);
  if (!reading.reader.reals(node, 2, what)) return false;
  reading.camera->image_size = reading.reader.image_size(node.items[0], node.items[1], what + " ");
  return reading.camera->image_size.has_value();
}

constexpr std::string_view kWordCharacters = "abcdefghijklmnopqrstuvwxyz+-";

/// A word that a file with it had, else the usual one.
std::vector<Statement> write_word(const Subject& subject, const Key& key) {
  if (subject.fresh == nullptr || is_fresh_of_first(subject)) return {};
  const std::string& camera = subject.the_camera().name;
  const ExtraField* kept = subject.rig.find_extra_field(camera, key.text());
  const bool is_word =
      kept != nullptr && !kept->value.empty() && kept->value.find_first_not_of(kWordCharacters) == std::string::npos;
  const std::string token = is_word ? kept->value : std::string(key.with.token);
  if (!is_word) subject.fresh->defaults.push_back({camera + " " + key.text(), token, true, false});
  return schema::states(fields::scalar(key.text(), token));
}

constexpr Key word(std::string_view name, std::string_view token) {
  return {name, FactKind::kOther, schema::keep, write_word, {.token = token}};
}

/// T_imu_camera
constexpr schema::PoseLayout kPoseInImu = {.frame = schema::kImu,
                                           .kind = FrameKind::kImu,
                                           .translation = {},
                                           .rotation = {},
                                           .in_frame = Code::kTablePoseInFrame,
                                           .identity = Code::kTableIdentity};

constexpr std::array kKeys = {
    schema::matrix("T_SC", "T_SC", kPoseInImu),
    Key{"image_dimension", FactKind::kImageSize, read_size, schema::write_image_size},
    required(Key{"distortion_type", FactKind::kModel, read_lens, write_distortion}),
    required(Key{kCoefficients, FactKind::kParameter, read_coefficients, write_coefficients}),
    required(Key{"focal_length", FactKind::kParameter, read_focal, write_focal}),
    required(Key{"principal_point", FactKind::kParameter, read_centre, write_centre}),
    Key{kCameraModel, FactKind::kModel, nullptr, write_camera_model},
    Key{kEucmParameters, FactKind::kParameter, read_eucm, write_eucm},
    word("camera_type", "gray"),
    word("slam_use", "okvis"),
};
constexpr std::array<std::string_view, 10> kOrder = {"T_SC",
                                                     "image_dimension",
                                                     "distortion_coefficients",
                                                     "distortion_type",
                                                     "focal_length",
                                                     "principal_point",
                                                     "cam_model",
                                                     "eucm_parameters",
                                                     "camera_type",
                                                     "slam_use"};

}  // namespace

constinit const schema::Mapping kCamera = {
    .keys = kKeys, .written = kOrder, .unread = "", .warns_of_duplicates = true, .stops_at_error = true};

bool read_camera(schema::Reading& reading, const Key& key, const Node& node) {
  if (!schema::read_object(reading, key, node)) return false;
  schema::keep_unread(reading, kCamera, node, reading.camera->name);
  return true;
}

}  // namespace fca::okvis
