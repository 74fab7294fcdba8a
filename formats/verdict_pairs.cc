// SPDX-License-Identifier: BSD-3-Clause
#include "verdict_pairs.h"

#include "written_facts.h"

#include <fca/code.h>
#include <fca/rig/stereo_order.h>
#include <fca/rig/stereo_pair.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace fca {

namespace {

/// The first two cameras of a file, that nothing relates to each other.
std::optional<std::array<std::string, 2>> unrelated(const Rig& rig, std::span<const std::string> cameras) {
  for (std::size_t i = rig.baseline_m ? 2 : 1; i < cameras.size(); ++i) {
    const bool of_rig = rig.find_camera(cameras[0]) != nullptr && rig.find_camera(cameras[i]) != nullptr;
    if (of_rig && !rig.resolve(cameras[0], cameras[i])) return {{cameras[0], cameras[i]}};
  }
  return std::nullopt;
}

/// The cameras of each file that was written; of the one that was read.
std::vector<std::vector<std::string>> cameras_of_files(const VerdictFacts& facts) {
  if (!facts.files.empty()) return {facts.files.begin(), facts.files.end()};
  std::vector<std::string> names;
  for (const Camera& camera : facts.rig->cameras) names.push_back(camera.name);
  return {names};
}

/// The model of a camera as the program reads it; of a file that was not asked about, as the rig has it.
std::string_view model_read(const std::string& camera, const VerdictFacts& facts) {
  for (const ProofResult& proof : facts.proofs) {
    const auto read = std::ranges::find(proof.cameras, camera, &CameraProof::name);
    if (read == proof.cameras.end()) continue;
    const auto stored = std::ranges::find(facts.to->models, std::string_view(read->model), &StoredModel::file_name);
    if (stored != facts.to->models.end()) return stored->model;
  }
  const Camera* stated = facts.rig->find_camera(camera);
  return stated != nullptr ? model_info(stated->model).id : std::string_view();
}

}  // namespace

void add_missing_poses(const VerdictFacts& facts, std::vector<Reason>& reasons) {
  if (facts.rig == nullptr || !states_poses(facts)) return;
  if (facts.files.empty() && facts.to->poses_apart) return;
  const bool is_invented = std::ranges::any_of(facts.defaults, &DefaultedValue::invented);
  for (const std::vector<std::string>& cameras : cameras_of_files(facts)) {
    const auto pair = unrelated(*facts.rig, cameras);
    if (!pair) continue;
    reasons.push_back({.word = is_invented ? VerdictWord::kDoNotUse : VerdictWord::kUseWithCare,
                       .facts = {Code::kVerdictNoPose, {pair->front(), pair->back()}}});
  }
}

void add_strange_pair(const VerdictFacts& facts, std::vector<Reason>& reasons) {
  if (facts.rig == nullptr || !facts.mode.starts_with("stereo")) return;
  for (const std::vector<std::string>& cameras : facts.files) {
    if (cameras.size() < 2) continue;
    const Camera* first = facts.rig->find_camera(cameras[0]);
    const Camera* second = facts.rig->find_camera(cameras[1]);
    if (first == nullptr || second == nullptr || may_be_stereo(*facts.rig, *first, *second)) continue;
    reasons.push_back({.facts = {Code::kVerdictNoCommonView, {cameras[0], cameras[1]}}});
  }
}

void add_epipolar_error(const VerdictFacts& facts, std::vector<Reason>& reasons) {
  if (facts.pair == nullptr) return;
  const auto is_wide = [](const CameraProof& camera) { return camera.distance.is_wide; };
  if (std::ranges::any_of(facts.proofs, [&](const ProofResult& proof) { return std::ranges::any_of(proof.cameras, is_wide); }))
    return;
  const VerdictWord word = std::min(word_of(PixelDistance{.rms = facts.pair->rms_px()}), VerdictWord::kUseWithCare);
  if (word == VerdictWord::kReady) return;
  reasons.push_back({.word = word,
                     .facts = {Code::kVerdictEpipolarError,
                               {facts.pair->first, facts.pair->second, facts.pair->rms_px(), facts.pair->max_px()}}});
}

void add_vertical_pair(const VerdictFacts& facts, std::vector<Reason>& reasons) {
  if (facts.rig == nullptr || !facts.mode.starts_with("stereo") || facts.to->matches_along_rows == nullptr) return;
  for (const std::vector<std::string>& cameras : cameras_of_files(facts)) {
    if (cameras.size() < 2) continue;
    const std::string& first = cameras[0];
    const std::string& second = cameras[1];
    const std::optional<double> below = second_below_first(*facts.rig, first, second);
    if (!below || !facts.to->matches_along_rows(model_read(first, facts))) continue;
    constexpr double kCmPerM = 100.0;
    reasons.push_back({.word = VerdictWord::kDoNotUse,
                       .facts = {Code::kOrbslam3PairVertical,
                                 {second, kCmPerM * std::abs(*below), *below > 0.0 ? "below" : "above", first}}});
  }
}

}  // namespace fca
