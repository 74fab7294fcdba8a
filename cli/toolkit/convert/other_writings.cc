// SPDX-License-Identifier: BSD-3-Clause
#include "other_writings.h"

#include "writing.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace fca {

namespace {

constexpr double kNoticeable = 0.25;  // px, at worst
constexpr double kGoodEnough = 0.25;  // px rms; p99 of four times that: the limits of a file that is ready

const ProofResult* first_proof(const ConvertResult& result) {
  const auto proof = std::ranges::find_if(result.proofs, [](const ProofResult& each) { return each.is_first; });
  return proof == result.proofs.end() ? nullptr : &*proof;
}

/// Written for the same program in the same mode, and it loads.
bool serves_the_same(const ConvertResult& other, const ConvertResult& result) {
  const ProofResult* proof = first_proof(other);
  return other.status == Status::kDone && other.mode == result.mode && proof != nullptr && proof->loads &&
         proof->program == first_proof(result)->program;
}

std::optional<ConvertResult> written_as(const ConvertRequest& request, const Start& start, const ConvertResult& before,
                                        const ConvertResult& result) {
  ConvertResult other = before;
  if (!write_as_asked(request, start, other) || !serves_the_same(other, result)) return std::nullopt;
  return other;
}

/// In the layout, in the cameras' models; where it does not hold them, in that of the format's models which is best in it.
std::optional<ConvertResult> in_layout(ConvertRequest request, std::string_view layout, const Start& start,
                                       const ConvertResult& before, const ConvertResult& result) {
  request.layout = {result.to, std::string(layout)};
  if (std::optional<ConvertResult> kept = written_as(request, start, before, result)) return kept;
  if (request.model != nullptr) return std::nullopt;
  std::optional<ConvertResult> best;
  for (const StoredModel& stored : result.to->models) {
    request.model = find_model(stored.model);
    std::optional<ConvertResult> fitted = written_as(request, start, before, result);
    if (fitted && (!best || worst_rms_px(*fitted) < worst_rms_px(*best))) best = std::move(fitted);
  }
  return best;
}

/// The largest of a figure over the cameras, as the program that the files are written for sees them.
double largest(const ConvertResult& result, double PixelDistance::*figure) {
  const ProofResult* proof = first_proof(result);
  double worst = 0.0;
  if (proof == nullptr) return worst;
  for (const CameraProof& camera : proof->cameras) worst = std::max(worst, camera.distance.decisive().*figure);
  return worst;
}

OtherWriting named(const ConvertResult& result, std::string layout) {
  const std::string_view model = result.cameras.empty() ? "" : model_info(result.cameras.front().target.model).id;
  return {std::move(layout), std::string(model), worst_rms_px(result), largest(result, &PixelDistance::max)};
}

bool has_same_models(const ConvertResult& a, const ConvertResult& b) {
  return std::ranges::equal(a.cameras, b.cameras, [](const ConvertedCamera& x, const ConvertedCamera& y) {
    return model_info(x.target.model).id == model_info(y.target.model).id;
  });
}

/// Is the other one to be written instead? Another model costs all programs something that the exact one does not: it has to be
/// worth it.
bool is_better(const ConvertResult& other, const ConvertResult& best) {
  if (!(worst_rms_px(other) < worst_rms_px(best))) return false;
  const bool is_good = worst_rms_px(best) <= kGoodEnough && largest(best, &PixelDistance::p99) <= 4.0 * kGoodEnough;
  return !is_good || has_same_models(other, best);
}

}  // namespace

double worst_rms_px(const ConvertResult& result) { return largest(result, &PixelDistance::rms); }

void try_other_layouts(const ConvertRequest& request, const Start& start, const ConvertResult& before, ConvertResult& result) {
  const ProofResult* proof = first_proof(result);
  if (proof == nullptr || !proof->loads || start.base.document != nullptr) return;
  const auto is_off = [](const CameraProof& camera) { return camera.misread && camera.distance.decisive().max > kNoticeable; };
  if (std::ranges::none_of(proof->cameras, is_off)) return;
  const bool is_free = request.layout.name.empty() && request.model == nullptr;
  std::vector<OtherWriting> others;
  ConvertResult best = result;
  std::string best_layout = request.layout.name;
  for (const std::string_view layout : result.to->layouts) {
    if (layout == request.layout.name) continue;
    std::optional<ConvertResult> other = in_layout(request, layout, start, before, result);
    if (!other || std::ranges::equal(other->files, result.files, {}, &ConvertedFile::bytes, &ConvertedFile::bytes)) continue;
    if (is_free && is_better(*other, best)) {
      others.push_back(named(best, best_layout));
      best = *std::move(other);
      best_layout = layout;
    } else if (is_free || worst_rms_px(*other) < worst_rms_px(best)) {
      others.push_back(named(*other, std::string(layout)));
    }
  }
  result = std::move(best);
  result.layout = best_layout;
  result.others = std::move(others);
}

}  // namespace fca
