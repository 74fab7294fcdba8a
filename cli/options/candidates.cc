// SPDX-License-Identifier: BSD-3-Clause
#include "candidates.h"

#include "words.h"

#include <fca/formats/format.h>
#include <fca/formats/program_names.h>
#include <fca/toolkit/programs.h>
#include <fca/toolkit/read.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

namespace fca::cli {

namespace {

using Words = std::span<const std::string>;
using Values = std::vector<std::string>;

Values formats(Words /*words*/) {
  Values ids = format_ids();
  for (const ProgramName& name : all_program_names()) {
    if (name.is_served() && std::ranges::find(ids, name.names.front()) == ids.end()) ids.emplace_back(name.names.front());
  }
  return ids;
}

Values layouts(Words /*words*/) {
  Values names;
  for (const Format& format : written_formats()) names.insert(names.end(), format.layouts.begin(), format.layouts.end());
  return names;
}

Values models(Words /*words*/) { return model_ids(); }

Values programs(Words /*words*/) { return program_ids(); }

Values modes(Words /*words*/) {
  std::set<std::string> names;
  for (const Format& format : written_formats()) names.insert(format.modes.begin(), format.modes.end());
  return {names.begin(), names.end()};
}

Values codes(Words /*words*/) { return code_ids(); }

/// Of the first of the words that is a calibration file.
Values cameras(Words words) {
  for (const std::string& word : words) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(word, ignored)) continue;
    ReadRequest request;
    request.inputs.files = {word};
    Files files;
    const Reading reading = read(request, files);
    if (!reading.calibration) continue;
    Values names;
    for (const Camera& camera : reading.calibration->rig.cameras) names.push_back(camera.name);
    return names;
  }
  return {};
}

struct Row {
  std::string_view type;
  Values (*values)(Words words);
};

constexpr std::array kRows = {Row{"FORMAT", formats}, Row{"MODEL", models},  Row{"PROGRAM", programs},
                              Row{"MODE", modes},     Row{"CODE", codes},    Row{"CODE[:CAMERA]", codes},
                              Row{"LIST", cameras},   Row{"LAYOUT", layouts}};

/// A word as it is typed; capitals stand for another.
bool is_literal(std::string_view word) {
  return std::ranges::none_of(word, [](char c) { return c >= 'A' && c <= 'Z'; });
}

}  // namespace

std::vector<std::string> candidates(std::string_view type, std::span<const std::string> words) {
  const auto* const row = std::ranges::find(kRows, type, &Row::type);
  if (row != kRows.end()) return row->values(words);
  Values values;
  if (type.find('|') == std::string_view::npos) return values;
  while (!type.empty()) {  // "rms|max", "MODEL|all"
    const std::string_view word = type.substr(0, type.find('|'));
    type.remove_prefix(std::min(word.size() + 1, type.size()));
    const Values meant = is_literal(word) ? Values{std::string(word)} : candidates(word, words);
    values.insert(values.end(), meant.begin(), meant.end());
  }
  return values;
}

bool is_path_type(std::string_view type) {
  constexpr std::array<std::string_view, 8> kPaths = {"FILE", "BASE",  "PATH",           "PNG",
                                                      "NPY",  "IMAGE", "[CAMERA=]IMAGE", "pixel|angle|IMAGE"};
  return std::ranges::find(kPaths, type) != kPaths.end();
}

}  // namespace fca::cli
