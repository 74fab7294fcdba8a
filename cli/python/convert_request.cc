// SPDX-License-Identifier: BSD-3-Clause
#include "convert_request.h"

#include "request_words.h"

#include <fca/rig/limits.h>
#include <fca/toolkit/acceptance.h>

#include <map>

namespace fca::python {

namespace {

template <class Word>
Word word_of(const Format& format, const std::string& kind, const std::string& word) {
  const std::optional<Word> found = Word::find(format, word);
  if (!found) raise_value_error(std::string(format.id) + " has no " + kind + " '" + word + "'");
  return *found;
}

/// A code, or a list of them: "CODE" or "CODE:CAMERA".
void take_accepted(const Value& value, AskedConversion& asked) {
  for (const std::string& word : value.as<std::vector<std::string>>()) {
    TypedAcceptance typed = parse_acceptance(word);
    if (!typed.acceptance) raise_value_error("there is no code '" + typed.id + "'");
    if (!may_be_accepted(typed.acceptance->code)) raise_value_error("'" + typed.id + "' is a limit of your own");
    asked.request.accepted.push_back(*std::move(typed.acceptance));
  }
}

/// As cv2.imread gives it: grey (height, width) or coloured (height, width, 3).
Image image_of(const Value& value) {
  const auto array = value.as<py::array_t<std::uint8_t, py::array::c_style>>();
  if ((array.ndim() != 2 && array.ndim() != 3) || array.size() == 0)
    value.refuse("'pixel', 'angle', or an image (height, width)");
  Image image;
  image.height = static_cast<int>(array.shape(0));
  image.width = static_cast<int>(array.shape(1));
  image.channels = array.ndim() == 2 ? 1 : static_cast<int>(array.shape(2));
  if (image.channels != 1 && image.channels != 3) value.refuse("an image of one or three channels");
  image.bytes.assign(array.data(), array.data() + array.size());
  return image;
}

void take_weight(const Value& value, AskedConversion& asked) {
  if (!py::isinstance<py::str>(value.given())) {
    asked.weights = image_of(value);
    asked.request.weight = WeightKind::kImage;
    asked.request.weight_image = "weight";
    return;
  }
  const auto word = value.as<std::string>();
  if (word != "pixel" && word != "angle") value.refuse("'pixel', 'angle', or an image (height, width)");
  asked.request.weight = word == "angle" ? WeightKind::kAngle : WeightKind::kPixel;
}

void take_objective(const Value& value, AskedConversion& asked) {
  const auto word = value.as<std::string>();
  if (word != "rms" && word != "max") value.refuse("'rms' or 'max'");
  asked.request.objective = word == "max" ? Objective::kMax : Objective::kRms;
}

void take_degree(const Value& value, AskedConversion& asked) {
  const int degree = value.as<int>();
  const bool is_known = std::ranges::any_of(all_models(), [degree](const ModelInfo& model) {
    return model.least_degree > 0 && degree >= model.least_degree && degree <= model.most_degree;
  });
  if (!is_known) value.refuse("a degree that no model has");
  asked.request.degree = degree;
}

void take_limit(const Value& value, std::optional<double>& limit) {
  limit = value.as<double>();
  if (!(*limit >= 0.0)) value.refuse("at least 0");
}

void take_frame_rate(const Value& value, AskedConversion& asked) {
  constexpr double kFastest = 1e6;
  const auto rate_hz = value.as<double>();
  if (!(rate_hz > 0.0 && rate_hz < kFastest)) value.refuse("a rate in Hz, more than 0 and below 1e6");
  asked.request.frame_rate_hz = rate_hz;
}

void take_baseline(const Value& value, AskedConversion& asked) {
  const auto metres = value.as<double>();
  if (problem_with_baseline(metres).is_said()) value.refuse("a positive number of metres");
  asked.request.baseline_m = metres;
}

/// {"Viewer.PointSize": 3.0}
void take_settings(const Value& value, AskedConversion& asked) {
  for (const auto& [key, setting] : value.as<std::map<std::string, py::object>>()) {
    const bool is_flag = py::isinstance<py::bool_>(setting);
    const std::string word = is_flag ? (setting.cast<bool>() ? "true" : "false") : std::string(py::str(setting));
    asked.request.settings.push_back({key, word});
  }
}

void take_sensor(const Value& value, AskedConversion& asked) {
  const auto word = value.as<std::string>();
  if (!word.empty()) asked.request.mode = word_of<FormatMode>(*asked.request.to, "sensor mode", word);
}

void take_layout(const Value& value, AskedConversion& asked) {
  const auto word = value.as<std::string>();
  if (!word.empty()) asked.request.layout = word_of<FormatLayout>(*asked.request.to, "layout", word);
}

constexpr std::array kKeywords = {
    Keyword<AskedConversion>{"parts",
                             [](const Value& value, AskedConversion& asked) { take_parts(value, asked.request.inputs); }},
    Keyword<AskedConversion>{
        "model",
        [](const Value& value, AskedConversion& asked) { asked.request.model = &model_named(value.as<std::string>()); }},
    Keyword<AskedConversion>{"max_angle",
                             [](const Value& value, AskedConversion& asked) { take_max_angle(value, asked.request.inputs); }},
    Keyword<AskedConversion>{"camera",
                             [](const Value& value, AskedConversion& asked) { take_cameras(value, asked.request.inputs); }},
    Keyword<AskedConversion>{"sensor", &take_sensor},
    Keyword<AskedConversion>{"layout", &take_layout},
    Keyword<AskedConversion>{"into",
                             [](const Value& value, AskedConversion& asked) { asked.request.into = path_of(value.given()); }},
    Keyword<AskedConversion>{"rewrite",
                             [](const Value& value, AskedConversion& asked) { asked.request.rewrite = value.as<bool>(); }},
    Keyword<AskedConversion>{"objective", &take_objective},
    Keyword<AskedConversion>{"weight", &take_weight},
    Keyword<AskedConversion>{"degree", &take_degree},
    Keyword<AskedConversion>{"fix", [](const Value& value, AskedConversion& asked) { take_fixed(value, asked.request); }},
    Keyword<AskedConversion>{"absorb_rotation",
                             [](const Value& value, AskedConversion& asked) { asked.request.absorb_turn = value.as<bool>(); }},
    Keyword<AskedConversion>{"pair",
                             [](const Value& value, AskedConversion& asked) { asked.request.fit_pair = value.as<bool>(); }},
    Keyword<AskedConversion>{"every_pixel",
                             [](const Value& value, AskedConversion& asked) { asked.request.every_pixel = value.as<bool>(); }},
    Keyword<AskedConversion>{"fps", &take_frame_rate},
    Keyword<AskedConversion>{"baseline", &take_baseline},
    Keyword<AskedConversion>{"set", &take_settings},
    Keyword<AskedConversion>{"accept", &take_accepted},
    Keyword<AskedConversion>{"strict",
                             [](const Value& value, AskedConversion& asked) { asked.request.strict = value.as<bool>(); }},
    Keyword<AskedConversion>{"max_error",
                             [](const Value& value, AskedConversion& asked) { take_limit(value, asked.request.max_error_px); }},
    Keyword<AskedConversion>{
        "max_error_sigmas",
        [](const Value& value, AskedConversion& asked) { take_limit(value, asked.request.max_error_sigmas); }},
};

/// Requests that are contradictions whatever the files are.
void refuse_contradictions(const ConvertRequest& request) {
  if ((request.absorb_turn || request.fit_pair) && !request.into.empty())
    raise_value_error("absorb_rotation and pair turn cameras, and the poses of `into` would be those of the old ones");
  if (request.objective != Objective::kRms && (request.absorb_turn || request.weight != WeightKind::kPixel))
    raise_value_error("absorb_rotation and weight are about the rms: not with objective='max'");
}

}  // namespace

AskedConversion asked_conversion(const py::object& source, const std::string& to, const py::kwargs& keywords) {
  AskedConversion asked;
  ConvertRequest& request = asked.request;
  request.inputs = inputs_of(source);
  Target target = target_named(to);
  request.to = target.format;
  request.program = target.program;
  request.layout = target.layout;
  request.extension = std::move(target.extension);
  request.made_by = "Python: fca_io.convert(to='" + to + "')";
  take_keywords(kKeywords, keywords, asked);
  refuse_contradictions(request);
  return asked;
}

}  // namespace fca::python
