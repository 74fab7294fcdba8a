// SPDX-License-Identifier: BSD-3-Clause
#include "model_candidates.h"

#include "commands/show/show_command.h"
#include "model_advice.h"

#include <algorithm>

namespace fca::cli {

namespace {

/// Who stores these very numbers, and who demands others.
std::vector<std::string> stored_by(const CameraModel& model) {
  std::vector<std::string> names;
  for (const Format& format : all_formats()) {
    const StoredModel* row = find_stored_model(format, model_info(model).id, false);
    if (row == nullptr) continue;
    const std::string anew = within(model, row->ranges) ? "" : " (fitted anew: " + std::string(row->why) + ")";
    const std::string name = name_in(format, *row) + anew;
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return names;
}

/// An exact one that is the camera's own before one that contains it.
bool is_better_choice(const Candidate& a, const Candidate& b) {
  const ConversionReport& of_a = a.conversion->report;
  const ConversionReport& of_b = b.conversion->report;
  if (of_a.exact != of_b.exact) return of_a.exact;
  if (of_a.exact) return of_a.from_model == of_a.to_model;
  return is_better(of_a, of_b);
}

template <class Admits>
const Candidate* best(const std::vector<Candidate>& candidates, Admits&& admits) {
  const Candidate* result = nullptr;
  for (const Candidate& candidate : candidates) {
    if (!candidate.conversion || !admits(candidate)) continue;
    if (result == nullptr || is_better_choice(candidate, *result)) result = &candidate;
  }
  return result;
}

}  // namespace

std::vector<Candidate> candidates(const Camera& camera, std::optional<double> max_angle_rad) {
  std::vector<Candidate> result;
  for (const ModelInfo& model : all_models()) {
    Candidate candidate;
    candidate.model = &model;
    ConvertOptions options;
    options.model = model.id;
    options.max_angle_rad = max_angle_rad;
    candidate.conversion = convert(camera, options, candidate.diagnostics);
    if (candidate.conversion) candidate.stored_by = stored_by(candidate.conversion->camera.model);
    result.push_back(std::move(candidate));
  }
  return result;
}

const Candidate* recommended(const std::vector<Candidate>& candidates, const Format* format) {
  return best(candidates, [format](const Candidate& candidate) {
    return format == nullptr || find_stored_model(*format, candidate.model->id, true) != nullptr;
  });
}

const Candidate* recommended_beside(const std::vector<Candidate>& candidates, const Candidate& other) {
  return best(candidates, [&other](const Candidate& candidate) { return &candidate != &other; });
}

}  // namespace fca::cli
