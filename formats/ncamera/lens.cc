// SPDX-License-Identifier: BSD-3-Clause
#include "lens.h"

#include "../ocamcalib/inverse.h"
#include "../ocamcalib/ocamcalib.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string>

namespace fca::ncamera {

using schema::FactKind;
using schema::Key;
using schema::required;
using schema::Statement;
using schema::Subject;
using text::Node;

namespace {

constexpr std::size_t kLongestWord = 40;  ///< Of the file, in a message.

constexpr std::array<ParameterId, 4> kPinhole = {"fx", "fy", "cx", "cy"};
constexpr std::array<ParameterId, 5> kUnified = {"xi", "fx", "fy", "cx", "cy"};
/// The first ten of SVO's 24 numbers; the inverse polynomial and the mask follow.
constexpr std::array<ParameterId, 10> kOmni = {"a0", "a1", "a2", "a3", "a4", "cx", "cy", "c", "d", "e"};
constexpr std::size_t kInverseCount = 12;
constexpr std::size_t kMaskCount = 2;
constexpr std::array<ParameterId, 4> kRadtan = {"k1", "k2", "p1", "p2"};
constexpr std::array<ParameterId, 4> kEquidistant = {"k1", "k2", "k3", "k4"};
constexpr std::array<ParameterId, 1> kFov = {"w"};

/// A lens by its two names. Written is the first of a model.
struct NamedLens {
  std::string_view name;  ///< Of both.
  std::string_view type;
  std::string_view distortion;
  std::string_view model;
  std::span<const ParameterId> intrinsics;
  std::span<const ParameterId> coefficients = {};
};
/// "fisheye" is the model of Devernay and Faugeras, with one coefficient.
constexpr std::array<NamedLens, 7> kLenses = {
    {{"pinhole, none", "pinhole", "none", "pinhole", kPinhole},
     {"pinhole, radial-tangential", "pinhole", "radial-tangential", "radtan", kPinhole, kRadtan},
     {"pinhole, equidistant", "pinhole", "equidistant", "kb4", kPinhole, kEquidistant},
     {"pinhole, fisheye", "pinhole", "fisheye", "fov", kPinhole, kFov},
     {"unified-projection, radial-tangential", "unified-projection", "radial-tangential", "mei", kUnified, kRadtan},
     {"unified-projection, none", "unified-projection", "none", "mei", kUnified},
     {"omni", "omni", "none", "ocamcalib", kOmni}}};

constexpr std::string_view kOcamcalib = "ocamcalib";

bool is_omni(const NamedLens& lens) { return lens.model == kOcamcalib; }

const NamedLens* lens_of(const CameraModel& model) {
  const auto* const found = std::ranges::find(kLenses, model_info(model).id, &NamedLens::model);
  return found == kLenses.end() ? nullptr : found;
}

const NamedLens* lens_of(const schema::Reading& reading) {
  const auto* const found = std::ranges::find(kLenses, reading.lens, &NamedLens::name);
  return found == kLenses.end() ? nullptr : found;
}

/// Each once, of the lenses of which `wanted` holds.
template <typename Wanted>
std::vector<std::string> words(std::string_view NamedLens::*word, const Wanted& wanted) {
  std::vector<std::string> result;
  for (const NamedLens& lens : kLenses) {
    if (wanted(lens) && std::ranges::find(result, lens.*word) == result.end()) result.emplace_back(lens.*word);
  }
  return result;
}

bool read_list(schema::Reading& reading, const Key& key, const Node& node, std::span<const ParameterId> ids) {
  const std::string what = reading.label(key);
  bool good = true;
  for (std::size_t i = 0; i < ids.size(); ++i)
    good = reading.reader.parameter(node.items[i], what, ids[i], reading.camera->model) && good;
  return good;
}

/// What stands after the parameters of an omni lens.
void keep_rest(schema::Reading& reading, const std::vector<double>& numbers) {
  const Camera& camera = *reading.camera;
  const auto* const first = numbers.data() + kOmni.size();
  const std::vector<double> inverse(first, first + kInverseCount);
  std::string listed;
  for (const double value : inverse) listed += (listed.empty() ? "" : " ") + text::format_real(value);
  reading.rig.extra_fields.push_back(
      {camera.name,
       std::string(ocamcalib::kInverse),
       listed,
       {Code::kCalibResultsInverse, {inverse.size(), ocamcalib::inverse_error(camera, inverse), listed}}});
  const double from = numbers[kOmni.size() + kInverseCount];
  const double to = numbers.back();
  if (from != 0.0 || to != 0.0) {
    reading.rig.extra_fields.push_back(
        {camera.name, std::string(kMask), "[" + text::format_real(from) + ", " + text::format_real(to) + "]"});
  }
}

bool read_intrinsics(schema::Reading& reading, const Key& key, const Node& node) {
  const NamedLens* lens = lens_of(reading);
  if (lens == nullptr) return false;
  const std::size_t count = lens->intrinsics.size() + (is_omni(*lens) ? kInverseCount + kMaskCount : 0);
  const std::optional<std::vector<double>> numbers = reading.reader.reals(node, count, reading.label(key));
  if (!numbers || !read_list(reading, key, node, lens->intrinsics)) return false;
  if (is_omni(*lens)) keep_rest(reading, *numbers);
  return true;
}

bool read_coefficients(schema::Reading& reading, const Key& key, const Node& node) {
  const NamedLens* lens = lens_of(reading);
  if (lens == nullptr) return false;
  if (lens->coefficients.empty()) return true;
  return reading.reader.reals(node, lens->coefficients.size(), reading.label(key)) &&
         read_list(reading, key, node, lens->coefficients);
}

std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  std::istringstream words(text);
  for (std::string word; words >> word;) numbers.push_back(text::parse_real(word).value_or(0.0));
  return numbers;
}

std::vector<Statement> write_list(const Subject& subject, const Key& key, std::span<const ParameterId> ids,
                                  std::span<const double> more = {}) {
  std::vector<double> values;
  Statement statement;
  for (const ParameterId id : ids) {
    values.push_back(parameter(subject.the_camera().model, id).value());
    statement.facts.push_back({.kind = FactKind::kParameter, .parameter = id.name()});
  }
  values.insert(values.end(), more.begin(), more.end());
  statement.field = fields::list(key.text(), values);
  return {std::move(statement)};
}

std::vector<Statement> write_intrinsics(const Subject& subject, const Key& key) {
  const Camera& camera = subject.the_camera();
  const NamedLens* lens = lens_of(camera.model);
  if (lens == nullptr) return {};
  if (!is_omni(*lens)) return write_list(subject, key, lens->intrinsics);
  const ExtraField* inverse = subject.rig.find_extra_field(camera.name, ocamcalib::kInverse);
  const ExtraField* mask = subject.rig.find_extra_field(camera.name, kMask);
  std::vector<double> rest = inverse != nullptr ? numbers_in(inverse->value) : std::vector<double>();
  rest.resize(kInverseCount, 0.0);
  std::vector<double> radii =
      mask != nullptr ? text::reals_in(mask->value).value_or(std::vector<double>()) : std::vector<double>();
  radii.resize(kMaskCount, 0.0);
  rest.insert(rest.end(), radii.begin(), radii.end());
  return write_list(subject, key, lens->intrinsics, rest);
}

std::vector<Statement> write_intrinsics_count(const Subject& subject, const Key& key) {
  const NamedLens* lens = lens_of(subject.the_camera().model);
  if (lens == nullptr) return {};
  const std::size_t count = lens->intrinsics.size() + (is_omni(*lens) ? kInverseCount + kMaskCount : 0);
  return schema::states(fields::integer(key.text(), static_cast<int>(count)));
}

std::vector<Statement> write_coefficients(const Subject& subject, const Key& key) {
  const NamedLens* lens = lens_of(subject.the_camera().model);
  return lens != nullptr ? write_list(subject, key, lens->coefficients) : std::vector<Statement>();
}

std::vector<Statement> write_coefficient_count(const Subject& subject, const Key& key) {
  const NamedLens* lens = lens_of(subject.the_camera().model);
  if (lens == nullptr) return {};
  return schema::states(fields::integer(key.text(), static_cast<int>(lens->coefficients.size())));
}

std::vector<Statement> write_one(const Subject& subject, const Key& key) {
  if (subject.fresh == nullptr) return {};
  return schema::states(fields::integer(key.text(), 1));
}

std::vector<Statement> write_distortion_type(const Subject& subject, const Key& key) {
  const NamedLens* lens = lens_of(subject.the_camera().model);
  if (lens == nullptr) return {};
  return schema::states(fields::scalar(key.text(), std::string(lens->distortion)), {FactKind::kModel});
}

constexpr Key kColumns = {"cols", FactKind::kOther, schema::read_fixed, write_one};

constexpr std::array kParameterKeys = {kColumns, Key{"rows", FactKind::kOther, schema::read_fixed, write_coefficient_count},
                                       required(Key{"data", FactKind::kParameter, read_coefficients, write_coefficients})};
constexpr schema::Mapping kParameters = {.keys = kParameterKeys};
constexpr std::array kDistortionKeys = {Key{"type", FactKind::kModel, nullptr, write_distortion_type},
                                        schema::object("parameters", kParameters)};
constexpr std::array kIntrinsicsKeys = {kColumns, Key{"rows", FactKind::kOther, schema::read_fixed, write_intrinsics_count},
                                        required(Key{"data", FactKind::kParameter, read_intrinsics, write_intrinsics})};

}  // namespace

constinit const schema::Mapping kDistortion = {.keys = kDistortionKeys};
constinit const schema::Mapping kIntrinsics = {.keys = kIntrinsicsKeys, .unread = ""};

bool read_lens(schema::Reading& reading, const Key& key, const Node& node) {
  const Node* distortion = reading.reader.find(*reading.mapping, "distortion");
  const Node* name =
      distortion != nullptr ? reading.reader.require(*distortion, "type", reading.owner + " distortion") : nullptr;
  if (distortion != nullptr && name == nullptr) return false;
  const std::string type = fields::value_text(node);
  const auto of_type = [&type](const NamedLens& lens) { return lens.type == type; };
  if (std::ranges::none_of(kLenses, of_type)) {
    reading.reader.say(
        node, Code::kTableUnknownWord,
        {reading.label(key), type.substr(0, kLongestWord), words(&NamedLens::type, [](const NamedLens&) { return true; })});
    return false;
  }
  const std::string bent = name != nullptr ? fields::value_text(*name) : "none";
  const auto* const lens = std::ranges::find_if(
      kLenses, [&](const NamedLens& each) { return of_type(each) && (is_omni(each) || each.distortion == bent); });
  if (lens == kLenses.end()) {
    reading.reader.say(
        *name, Code::kTableUnknownWord,
        {reading.owner + " distortion type", bent.substr(0, kLongestWord), words(&NamedLens::distortion, of_type)});
    return false;
  }
  reading.camera->model = make_model(lens->model).value();
  reading.lens = lens->name;
  // A file that was cut off says no less.
  if (distortion == nullptr && !is_omni(*lens))
    reading.reader.say(Severity::kNote, node, Code::kOrbslamTakesZero, {reading.owner + " distortion", "SVO"});
  // A lens without its coefficients would be another one.
  return lens->coefficients.empty() ||
         reading.reader.require(*distortion, "parameters", reading.owner + " distortion") != nullptr;
}

std::vector<Statement> write_type(const Subject& subject, const Key& key) {
  const NamedLens* lens = lens_of(subject.the_camera().model);
  if (lens == nullptr) return {};
  return schema::states(fields::scalar(key.text(), std::string(lens->type)), {FactKind::kModel});
}

bool has_same_polynomial(const CameraModel& a, const CameraModel& b) {
  if (model_info(a).id != kOcamcalib || model_info(b).id != kOcamcalib) return false;
  return std::ranges::all_of(model_info(a).parameters, [&](const Parameter& row) {
    const ParameterId id(row);
    return !row.name.starts_with('a') || parameter(a, id) == parameter(b, id);
  });
}

std::optional<ExtraField> inverse_of(const Rig& rig, const Camera& camera, bool is_edited, Written& written,
                                     Diagnostics& diagnostics) {
  if (model_info(camera.model).id != kOcamcalib) return std::nullopt;
  constexpr double kGoal = 1e-6;  // px
  const ExtraField* kept = rig.find_extra_field(camera.name, ocamcalib::kInverse);
  if (kept != nullptr) {
    const std::vector<double> numbers = numbers_in(kept->value);
    const bool fits = numbers.size() <= kInverseCount && (is_edited || ocamcalib::inverse_error(camera, numbers) <= kGoal);
    if (fits) return *kept;
  }
  const ocamcalib::InversePolynomial fitted = ocamcalib::fit_inverse(camera, kInverseCount);
  written.defaults.push_back({camera.name + " " + std::string(ocamcalib::kInverse),
                              Message{Code::kCalibResultsInverseFitted, {fitted.coefficients.size(), fitted.error_px}},
                              fitted.error_px > kGoal});
  if (fitted.error_px > kGoal) diagnostics.add(Code::kVinsInverseInexact, {camera.name, fitted.error_px, kInverseCount, "SVO"});
  std::string listed;
  for (const double value : fitted.coefficients) listed += (listed.empty() ? "" : " ") + text::format_real(value);
  return ExtraField{camera.name, std::string(ocamcalib::kInverse), listed};
}

}  // namespace fca::ncamera
