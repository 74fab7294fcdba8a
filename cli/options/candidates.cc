// SPDX-License-Identifier: BSD-3-Clause
#include "candidates.h"

#include <fca/code.h>
#include <fca/formats/format.h>
#include <fca/models/camera_model.h>
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
  Values ids;
  for (const Format& format : all_formats()) ids.emplace_back(format.id);
  return ids;
}

Values models(Words /*words*/) {
  Values ids;
  for (const ModelInfo& model : all_models()) ids.emplace_back(model.id);
  return ids;
}

Values programs(Words /*words*/) { return program_ids(); }

Values modes(Words /*words*/) {
  std::set<std::string> names;
  for (const Format& format : all_formats()) names.insert(format.modes.begin(), format.modes.end());
  return {names.begin(), names.end()};
}

Values codes(Words /*words*/) {
  Values ids;
  for (const CodeInfo& code : check_codes()) ids.emplace_back(code.id);
  return ids;
}

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

constexpr std::array kRows = {Row{"FORMAT", formats}, Row{"MODEL", models},        Row{"PROGRAM", programs}, Row{"MODE", modes},
                              Row{"CODE", codes},     Row{"CODE[:CAMERA]", codes}, Row{"LIST", cameras}};

}  // namespace

std::vector<std::string> candidates(std::string_view type, std::span<const std::string> words) {
  const auto* const row = std::ranges::find(kRows, type, &Row::type);
  if (row != kRows.end()) return row->values(words);
  Values values;
  while (type.find('|') != std::string_view::npos || !values.empty()) {  // "rms|max"
    const std::size_t end = std::min(type.find('|'), type.size());
    values.emplace_back(type.substr(0, end));
    if (end == type.size()) break;
    type.remove_prefix(end + 1);
  }
  return values;
}

bool is_path_type(std::string_view type) {
  constexpr std::array<std::string_view, 7> kPaths = {"FILE", "BASE", "PATH", "PNG", "NPY", "IMAGE", "[CAMERA=]IMAGE"};
  return std::ranges::find(kPaths, type) != kPaths.end();
}

}  // namespace fca::cli
