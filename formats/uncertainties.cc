// SPDX-License-Identifier: BSD-3-Clause
#include "uncertainties.h"

#include <fca/code.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fca {

namespace {

bool has_same_values(const Uncertainty& stated, const Camera& camera, Diagnostics& diagnostics) {
  // NumPy prints 8 digits.
  constexpr double kPrinted = 1e-7;
  const std::span<const double> values = parameter_values(camera.model);
  for (std::size_t i = 0; i < stated.values.size(); ++i) {
    const double difference = std::abs(stated.values[i] - values[i]);
    if (!(difference > kPrinted * std::max(1.0, std::abs(values[i])))) continue;
    const double sigma = stated.sigmas[i];
    const double apart = sigma > 0.0 ? difference / sigma : std::numeric_limits<double>::infinity();
    const bool is_other = apart > 1.0;
    diagnostics.add(is_other ? Severity::kError : Severity::kWarning, Code::kUncertaintyOfOtherValues,
                    {camera.name, model_info(camera.model).parameters[i].name, stated.values[i], values[i], apart},
                    stated.where);
    if (is_other) return false;
  }
  return true;
}

bool matches(const Uncertainty& stated, const Rig& rig, Diagnostics& diagnostics) {
  const Camera* camera = rig.find_camera(stated.camera);
  if (camera == nullptr) {
    std::vector<std::string> names;
    for (const Camera& each : rig.cameras) names.push_back(each.name);
    diagnostics.add(Code::kUncertaintyOfOtherCamera, {stated.camera, names}, stated.where);
    return false;
  }
  if (stated.sigmas.empty()) return true;
  if (stated.model != camera->lens_id()) {
    diagnostics.add(Code::kUncertaintyOfOtherModel, {stated.camera, stated.model, camera->lens_id()}, stated.where);
    return false;
  }
  return has_same_values(stated, *camera, diagnostics);
}

}  // namespace

bool is_uncertainty_alone(const Rig& rig) {
  return rig.cameras.empty() && rig.imus.empty() && rig.poses.empty() && !rig.uncertainties.empty();
}

bool match_uncertainties(const Rig& rig, Diagnostics& diagnostics) {
  if (rig.cameras.empty()) return true;
  return std::ranges::all_of(rig.uncertainties, [&](const Uncertainty& stated) { return matches(stated, rig, diagnostics); });
}

}  // namespace fca
