// SPDX-License-Identifier: BSD-3-Clause
#include "target.h"

#include "limits.h"
#include "shell/option_hints.h"
#include "words.h"

#include <fca/code.h>
#include <fca/formats/text/message.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/prose.h>
#include <fca/rig/limits.h>
#include <fca/toolkit/acceptance.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fca::cli {

namespace {

/// One of the modes of any format.
std::optional<std::string> take_mode(const std::string& word, std::optional<FormatMode>& target) {
  std::vector<std::string> known;
  for (const Format& format : written_formats()) {
    target = FormatMode::find(format, word);
    if (target) return std::nullopt;
    known.insert(known.end(), format.modes.begin(), format.modes.end());
  }
  return unknown_word("sensor mode", word, known);
}

std::optional<std::string> take_layout(const std::string& word, const Format& format, std::optional<FormatLayout>& target) {
  target = FormatLayout::find(format, word);
  if (target) return std::nullopt;
  return unknown_word("layout", word, std::vector<std::string>(format.layouts.begin(), format.layouts.end()));
}

std::optional<std::string> take_setting(const std::string& word, std::vector<KeyValue>& settings) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos || equals == 0)
    return "--set takes KEY=VALUE, such as Viewer.PointSize=3.0; got '" + word + "'";
  const std::string key = word.substr(0, equals);
  if (std::ranges::find(settings, key, &KeyValue::key) != settings.end())
    return "--set " + key + " is given twice; a key has one value";
  settings.push_back({key, word.substr(equals + 1)});
  return std::nullopt;
}

std::optional<std::string> take_acceptance(const std::string& word, std::vector<Acceptance>& accepted) {
  TypedAcceptance typed = parse_acceptance(word);
  if (!typed.acceptance) return unknown_code(typed.id, "the verdict names them");
  if (!may_be_accepted(typed.acceptance->code))
    return "--accept " + typed.id + ": you set that limit yourself; leave out its option";
  accepted.push_back(*std::move(typed.acceptance));
  return std::nullopt;
}

/// "ocamcalib: 4 to 8" of each model that has a degree; `between` stands between its name and its degrees.
std::string degrees_in_words(const std::string& between) {
  std::vector<std::string> models;
  for (const ModelInfo& model : all_models()) {
    if (model.least_degree == 0) continue;
    models.push_back(std::string(model.id) + between + std::to_string(model.least_degree) + " to " +
                     std::to_string(model.most_degree));
  }
  return text::enumerated(models, "or");
}

/// "orbslam3: mono, stereo or rgbd" of each format that has modes.
std::string modes_in_words() {
  std::string words;
  for (const Format& format : written_formats()) {
    if (format.modes.empty()) continue;
    const std::vector<std::string> modes(format.modes.begin(), format.modes.end());
    words += (words.empty() ? "" : "; ") + std::string(format.id) + ": " + text::enumerated(modes, "or");
  }
  return words;
}

std::optional<std::string> take_degree(const std::string& word, std::optional<int>& target) {
  target = word == "auto" ? std::nullopt : text::parse_int(word);
  const bool is_known = std::ranges::any_of(all_models(), [&target](const ModelInfo& model) {
    return target && model.least_degree > 0 && *target >= model.least_degree && *target <= model.most_degree;
  });
  if (word != "auto" && !is_known)
    return "--degree takes auto, or a degree that a model has (" + degrees_in_words(": ") + "), not '" + word + "'";
  return std::nullopt;
}

/// "fx=fy", "k3=0" or "cx".
std::optional<std::string> take_fixed(const std::string& word, FixedParameters& target) {
  constexpr std::string_view kWants = "--fix takes parameters such as k3=0, cx (as in the input) or fx=fy, not '";
  const std::size_t equals = word.find('=');
  const std::string name = word.substr(0, equals);
  const std::optional<ParameterId> parameter = ParameterId::find(name);
  if (!parameter) return std::string(kWants) + word + "': no model has a parameter '" + name + "'";
  const auto has_name = [&name](const auto& other) { return other.name() == name; };
  if (std::ranges::any_of(target.kept, has_name) || std::ranges::any_of(target.at, has_name, &ParameterRange::parameter))
    return "--fix " + name + " is given twice";
  if (equals == std::string::npos) {
    target.kept.push_back(*parameter);
    return std::nullopt;
  }
  const std::string value = word.substr(equals + 1);
  if ((name == "fx" && value == "fy") || (name == "fy" && value == "fx")) {
    target.one_focal_length = true;
    return std::nullopt;
  }
  const std::optional<double> number = text::parse_real(value);
  if (!number || !std::isfinite(*number)) return std::string(kWants) + word + "'";
  target.at.push_back({*parameter, *number, *number});
  return std::nullopt;
}

std::optional<std::string> take_objective(const std::string& word, Objective& target) {
  if (word != "rms" && word != "max") return "unknown objective '" + word + "'; there are rms and max";
  target = word == "max" ? Objective::kMax : Objective::kRms;
  return std::nullopt;
}

/// A file of that name is ./pixel.
void take_weight(const std::string& word, ConvertRequest& request) {
  request.weight = word == "pixel" ? WeightKind::kPixel : word == "angle" ? WeightKind::kAngle : WeightKind::kImage;
  request.weight_image = request.weight == WeightKind::kImage ? word : "";
}

}  // namespace

void add_to_option(Options& options, const std::string& help, ConvertRequest& request) {
  options.group(OptionGroup::kTarget);
  options.value("--to", "FORMAT", help + ": " + target_names(),
                [&request](const std::string& word) { return take_target(word, request); });
}

void add_model_option(Options& options, const ModelOption& option, TakeWord take) {
  options.group(OptionGroup::kTarget);
  options.value("--model", option.values, option.help + ": " + model_names() + option.more, std::move(take), OptionKey::kModel);
}

void add_target_options(Options& options, ConvertRequest& request) {
  options.group(OptionGroup::kTarget);
  options.value("--sensor", "MODE", modes_in_words() + " (default: the richest the input serves)",
                [&request](const std::string& word) { return take_mode(word, request.mode); });
  for (const Format& format : written_formats()) {
    if (format.layouts.empty()) continue;
    options.value("--" + std::string(format.id) + "-layout", "LAYOUT", text::text_of({format.about_layouts, {}}),
                  [&request, &format](const std::string& word) { return take_layout(word, format, request.layout); });
  }
  options.value("--into", "BASE", "Write the input's calibration into the text of this file, in this file's format",
                request.into);
  options.value("--objective", "rms|max",
                "What a fit minimises: rms, or max, the error of the worst pixel (the report shows what that costs in rms)",
                [&request](const std::string& word) { return take_objective(word, request.objective); });
  options.value("--weight", "pixel|angle|IMAGE",
                "The weights of the rms that a fit minimises: each pixel alike (default), each direction alike (by solid "
                "angle), or each pixel by the grey of an image of the camera's size (white: most, black: nothing)",
                [&request](const std::string& word) -> std::optional<std::string> {
                  if (word.empty()) return "--weight takes pixel, angle or an image";
                  take_weight(word, request);
                  return std::nullopt;
                });
  options.value(
      "--degree", "N|auto",
      "The degree of " + degrees_in_words("'s polynomial, ") + " (default: auto, the lowest that is nearly as good as any)",
      [&request](const std::string& word) { return take_degree(word, request.degree); });
  options.each("--fix", "NAME[=VALUE],...",
               "Parameters of the written model that a fit holds: at a number (k3=0), at the input's value (cx,cy), or fx=fy; "
               "repeatable",
               [&request](const std::string& words) -> std::optional<std::string> {
                 for (const std::string& word : split(words)) {
                   if (const std::optional<std::string> error = take_fixed(word, request.fixed)) return error;
                 }
                 return std::nullopt;
               });
  options.flag("--absorb-rotation",
               "Also fit a turn of each camera, and write it into the poses: most of what a model without tangential terms "
               "cannot hold is a tilt of the lens",
               request.absorb_turn);
  options.flag(
      "--pair",
      "Fit both cameras of a stereo pair together, so that the images of a point lie in one row after rectification; a "
      "small turn may go into the poses",
      request.fit_pair);
  add_every_pixel_option(options, request.every_pixel);
  options.group(OptionGroup::kTarget);
  options.flag("--rewrite", "Write a fresh file, even if the input's own text could be edited; comments are lost",
               request.rewrite);
  options.flag("--anew", "The older name of --rewrite", request.rewrite);
  options.hide({"--anew"});
  options.number("--fps", "HZ", "Frame rate, for formats that have it", [&request](double rate) -> std::optional<std::string> {
    if (!(rate > 0.0 && rate < 1e6)) return "--fps wants a rate in Hz, more than 0 and below 1e6";
    request.frame_rate_hz = rate;
    return std::nullopt;
  });
  options.number("--baseline", "METRES", "Baseline of a rectified pair or depth sensor",
                 [&request](double metres) -> std::optional<std::string> {
                   if (problem_with_baseline(metres).is_said()) return "--baseline wants a positive number of metres";
                   request.baseline_m = metres;
                   return std::nullopt;
                 });
  options.each(
      "--set", "KEY=VALUE",
      "Set a value of the written file that is not part of a calibration; KEY may be nested (cam0/rostopic); repeatable",
      [&request](const std::string& word) { return take_setting(word, request.settings); });
}

void add_accept_option(Options& options, std::vector<Acceptance>& accepted) {
  options.group(OptionGroup::kProof);
  options.each("--accept", "CODE[:CAMERA]", "Write the file although the verdict is 'do not use' for this reason; repeatable",
               [&accepted](const std::string& word) { return take_acceptance(word, accepted); });
}

std::optional<std::string> problem_with(const ConvertRequest& request) {
  if (request.absorb_turn && !request.into.empty()) {
    return "--absorb-rotation changes the camera's frame, but the poses of BASE are for the old frame: leave out one of the "
           "two";
  }
  if (request.absorb_turn && request.objective != Objective::kRms)
    return "--absorb-rotation works only for the rms; leave out --objective max";
  if (request.weight != WeightKind::kPixel && request.objective != Objective::kRms)
    return "--weight works only for the rms; leave out --objective max";
  const Message problem = request.to != nullptr ? without_use(request, *request.to) : Message{};
  return problem.is_said() ? std::optional(text::text_of(problem, with_options)) : std::nullopt;
}

std::optional<std::string> target_without_file(const ConvertRequest& request) {
  if (request.to != nullptr || !request.into.empty()) return std::nullopt;
  struct Given {
    bool given;
    std::string option;
  };
  const std::string layout = request.layout ? "--" + std::string(request.layout->format().id) + "-layout" : "";
  for (const Given& each :
       {Given{request.mode.has_value(), "--sensor"}, Given{!layout.empty(), layout},
        Given{request.frame_rate_hz.has_value(), "--fps"}, Given{request.baseline_m.has_value(), "--baseline"},
        Given{!request.settings.empty(), "--set"}, Given{request.rewrite, "--rewrite"}}) {
    if (each.given) return each.option + " is about the written file; give its format with --to FORMAT";
  }
  return std::nullopt;
}

bool has_use_for_opencv_model(const ConvertResult& result) {
  const auto has_use = [](const Format* format) { return format == nullptr || format->leaves_model_open; };
  return has_use(result.from) || has_use(result.to) || !result.one_format;
}

std::string opencv_model_without_use(const std::string& file, const Format& format) {
  return "--opencv-model is for OpenCV files, and " + file + " is " + std::string(format.title);
}

}  // namespace fca::cli
