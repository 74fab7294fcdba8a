// SPDX-License-Identifier: BSD-3-Clause
#include "taken_models.h"

#include <fca/code.h>

#include <algorithm>
#include <string>
#include <vector>

namespace fca::consumers {
namespace {

bool begins_with(char character, std::string_view bytes) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (bytes.starts_with(kMark)) bytes.remove_prefix(kMark.size());
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && bytes[first] == character;
}

}  // namespace

bool is_json(std::string_view bytes) { return begins_with('{', bytes); }

ConsumerView load_taken_of_colmap(std::string_view bytes, std::string_view program, std::span<const std::string_view> models,
                                  const colmap::OwnReading& own) {
  ConsumerView view = colmap::load(bytes, own);
  view.warnings.clear();
  const bool is_of_rigs = view.loads() && (view.cameras.empty() || begins_with('[', bytes));  // COLMAP's alone reads them
  if (is_of_rigs) view.refusals = {{Code::kColmapSaysRigFile, "", std::vector<Argument>{program}}};
  for (const ConsumerCamera& camera : view.cameras) {
    if (models.empty() || std::ranges::find(models, camera.model) != models.end()) continue;
    const std::vector<std::string> all(models.begin(), models.end());
    view.refusals.emplace_back(Code::kColmapSaysModelNotTaken, "", std::vector<Argument>{program, camera.model, all});
    break;
  }
  if (!view.loads()) view.cameras.clear();
  return view;
}

}  // namespace fca::consumers
