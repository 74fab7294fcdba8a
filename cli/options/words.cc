// SPDX-License-Identifier: BSD-3-Clause
#include "words.h"

#include <fca/code.h>
#include <fca/formats/program_names.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/prose.h>
#include <fca/normalised_id.h>
#include <fca/toolkit/programs.h>
#include <fca/toolkit/target.h>

#include <algorithm>
#include <set>
#include <utility>

namespace fca::cli {

namespace {

/// "640x480"
std::optional<ImageSize> parse_size(std::string_view text) {
  const std::size_t x = text.find_first_of("xX");
  if (x == std::string_view::npos) return std::nullopt;
  const std::optional<int> width = text::parse_int(text.substr(0, x));
  const std::optional<int> height = text::parse_int(text.substr(x + 1));
  if (!width || !height || *width < 1 || *height < 1) return std::nullopt;
  return ImageSize{*width, *height};
}

/// A program that fca-io knows and has no format for, or not for all of it.
std::string not_served(const ProgramName& program, std::string_view option) {
  const bool reading = option == "--from";
  const std::string what = std::string(program.title) + " reads " + std::string(program.reads) + ", which fca-io does not " +
                           (reading ? "read" : "write");
  const std::string format = (reading ? "" : std::string(option) + " ") + std::string(program.format);
  if (!program.served_part.empty()) return what + "; " + format + " is for " + std::string(program.served_part);
  return what + "; the nearest " + (reading ? "format is " : "is ") + format;
}

}  // namespace

std::string unknown_word(std::string_view kind, std::string_view typed, std::span<const std::string> names,
                         std::string_view otherwise) {
  const std::string text = "unknown " + std::string(kind) + " '" + std::string(typed) + "'; ";
  std::vector<std::string> near = text::nearest(typed, names);
  std::ranges::sort(near);
  near.erase(std::unique(near.begin(), near.end()), near.end());
  if (!near.empty()) return text + "did you mean " + text::enumerated(near, "or") + "?";
  return text + (otherwise.empty() ? "there are " + text::enumerated(names) : std::string(otherwise));
}

std::vector<std::string> format_ids() {
  std::vector<std::string> ids;
  for (const Format& format : all_formats()) ids.emplace_back(format.id);
  return ids;
}

std::vector<std::string> target_ids() {
  std::vector<std::string> ids;
  for (const Format& format : written_formats()) ids.emplace_back(format.id);
  return ids;
}

std::vector<std::string> model_ids() {
  std::vector<std::string> ids;
  for (const ModelInfo& model : all_models()) ids.emplace_back(model.id);
  return ids;
}

std::vector<std::string> code_ids() {
  std::set<std::string> ids;
  for (const CodeInfo& code : all_codes()) {
    if (find_code(code.id) != nullptr) ids.emplace(code.id);
  }
  return {ids.begin(), ids.end()};
}

std::string format_names() { return text::enumerated(format_ids()); }

std::string target_names() { return text::enumerated(target_ids()) + "; or a program, such as vins-fusion, ros2 or orbslam2"; }

std::string model_names() {
  std::vector<std::string> names;
  for (const ModelInfo& model : all_models()) {
    if (!model.kept_only) names.emplace_back(model.id);
  }
  return text::enumerated(names);
}

std::string unknown_format(std::string_view typed) { return unknown_word("format", typed, format_ids()); }

std::string unknown_model(std::string_view typed) { return unknown_word("camera model", typed, model_ids()); }

std::string unknown_code(std::string_view typed, std::string_view otherwise) {
  return unknown_word("code", typed, code_ids(), otherwise);
}

std::vector<std::string> split(std::string_view list) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t end = std::min(list.find(',', at), list.size());
    parts.emplace_back(list.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

std::string unknown_target(const std::string& option, const std::string& word) {
  const ProgramName* program = find_program_name(word);
  if (program == nullptr && find_model(word) != nullptr) {
    const std::string instead = option == "--to" ? " (and --model " + word + ")" : "";
    return "'" + word + "' is a camera model; " + option + " takes a format" + instead;
  }
  return program != nullptr ? not_served(*program, option) : unknown_format(word);
}

std::string unknown_program(const std::string& word) {
  const ProgramName* program = find_program_name(word);
  if (program != nullptr && !program->is_served()) return unknown_target("--for", word);
  const Format* format = find_format(program != nullptr ? program->format : word);
  if (format == nullptr) return unknown_word("program", word, program_ids());
  return "fca-io imitates no program that reads files of " + std::string(format->program) + " (" + std::string(format->id) +
         ")";
}

std::optional<std::string> take_format(const std::string& option, const std::string& word, const Format*& target) {
  const std::optional<Target> found = find_target(word);
  if (!found) return unknown_target(option, word);
  target = found->format;
  return std::nullopt;
}

std::optional<std::string> take_target(const std::string& word, ConvertRequest& request) {
  std::optional<Target> found = find_target(word);
  if (!found) return unknown_target("--to", word);
  if (!found->format->is_written()) {
    const std::vector<std::string> written = target_ids();
    return "fca-io reads " + std::string(found->format->title) + " and does not write it; --to takes " +
           text::enumerated(written, "or");
  }
  request.to = found->format;
  request.program = found->program;
  request.extension = std::move(found->extension);
  if (!request.layout) request.layout = found->layout;
  return std::nullopt;
}

std::optional<std::string> take_model(const std::string& word, const ModelInfo*& target) {
  // The name by which ORB-SLAM3's files call a pinhole: images become rectified by more than a model.
  if (normalised_id(word) == "rectified") {
    return "--model rectified would change the lens and not the images; fca-io rectify FILE --to orbslam3 rectifies a pair and "
           "writes its settings";
  }
  target = find_model(word);
  return target != nullptr ? std::nullopt : std::optional(unknown_model(word));
}

std::optional<std::string> take_size(const std::string& option, const std::string& word, std::optional<ImageSize>& target) {
  target = parse_size(word);
  if (target) return std::nullopt;
  return option + " wants WIDTHxHEIGHT in whole pixels, such as 640x480; got '" + word + "'";
}

}  // namespace fca::cli
