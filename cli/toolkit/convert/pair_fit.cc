// SPDX-License-Identifier: BSD-3-Clause
#include "pair_fit.h"

#include "stereo_cameras.h"

#include <fca/code.h>
#include <fca/convert/pair_fit.h>
#include <fca/rectify/rectify.h>

#include <array>
#include <optional>
#include <utility>

namespace fca {

namespace {

/// The fit of one camera, from which the fit of the pair starts. nullopt if nothing was computed for the camera, or if the
/// format does not store its model.
std::optional<SeparateFit> separate_fit(const ConvertedCamera& camera, const Format& to, const ModelChoice& choice) {
  const StoredModel* stored = find_stored_model(to, model_info(camera.target.model).id, false);
  if (!camera.report || stored == nullptr) return std::nullopt;
  return SeparateFit{camera.source, {camera.target, *camera.report}, options_for(*stored, choice)};
}

}  // namespace

bool may_fit_pair(const ConvertRequest& request, const Format& to, Diagnostics& diagnostics) {
  if (!request.fit_pair) return true;
  const bool shares_lens = request.layout && request.layout->name() == to.common_lens_layout;
  const bool has_conflicting_options = request.objective != Objective::kRms || request.weight != WeightKind::kPixel ||
                                       request.absorb_turn || request.fixed.any() || shares_lens;
  // A fit of the pair rotates cameras, but poses that stay in the file of --into are for the cameras as they were.
  if (!has_conflicting_options && request.into.empty()) return true;
  diagnostics.add(Code::kPairFitWithOthers);
  return false;
}

bool fit_as_pair(const Rig& input, const Format& to, const ModelChoice& choice, std::vector<ConvertedCamera>& cameras,
                 Diagnostics& diagnostics) {
  if (!choice.request.fit_pair) return true;
  const std::optional<StereoCameras> pair = stereo_cameras(input, cameras);
  if (!pair) {
    diagnostics.add(Code::kPairFitNeedsPair);
    return false;
  }
  const std::array<ConvertedCamera*, 2> pair_cameras = {&cameras[pair->first], &cameras[pair->second]};
  RectifyOptions rectifying;
  rectifying.valid_regions = false;
  if (!rectify(pair_cameras[0]->source, pair_cameras[1]->source, pair->T_second_first, rectifying, diagnostics)) return false;
  const std::optional<SeparateFit> first = separate_fit(*pair_cameras[0], to, choice);
  const std::optional<SeparateFit> second = separate_fit(*pair_cameras[1], to, choice);
  std::optional<PairFit> fit =
      first && second ? fit_pair({*first, *second}, pair->T_second_first, to.extrinsics && !to.facts_apart) : std::nullopt;
  if (!fit) {
    diagnostics.add(Code::kPairFitDoesNotHelp, {pair_cameras[0]->source.name, pair_cameras[1]->source.name});
    return true;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    pair_cameras.at(i)->target = std::move(fit->conversions.at(i).camera);
    pair_cameras.at(i)->report = std::move(fit->conversions.at(i).report);
  }
  diagnostics.add(Code::kPairFitted, {pair_cameras[0]->source.name, pair_cameras[1]->source.name, fit->after.rms_px(),
                                      fit->after.max_px(), fit->before.rms_px(), fit->before.max_px()});
  return true;
}

}  // namespace fca
