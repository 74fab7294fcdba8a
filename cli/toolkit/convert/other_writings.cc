// SPDX-License-Identifier: BSD-3-Clause
#include "other_writings.h"

#include "choose_model.h"
#include "models/model_advice.h"
#include "writing.h"

#include <fca/convert/max_angle_table.h>
#include <fca/formats/verdict.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fca {

namespace {

// Limits of the largest distance [px]:
constexpr double kNoticeable = 0.25;
constexpr double kRounding = 0.02;

const ProofResult* first_proof(const ConvertResult& result) {
  const auto proof = std::ranges::find_if(result.proofs, [](const ProofResult& each) { return each.is_first; });
  return proof == result.proofs.end() ? nullptr : &*proof;
}

/// True if `other` is for the same program and mode, and that program loads it.
bool serves_the_same(const ConvertResult& other, const ConvertResult& result) {
  const ProofResult* proof = first_proof(other);
  return other.status == Status::kDone && other.mode == result.mode && proof != nullptr && proof->loads &&
         proof->program == first_proof(result)->program;
}

std::optional<ConvertResult> written_as(const ConvertRequest& request, const Start& start, const ConvertResult& before,
                                        const ConvertResult& result, Partial partial = Partial::kSmallerAngle) {
  ConvertResult other = before;
  if (!write_as_asked(request, start, other, partial) || !serves_the_same(other, result)) return std::nullopt;
  return other;
}

/// The cameras of all files, as the first program of each file sees them.
std::vector<CameraProof> seen_cameras(const ConvertResult& result) {
  std::vector<CameraProof> cameras;
  for (const ProofResult& proof : result.proofs) {
    if (proof.is_first) cameras.insert(cameras.end(), proof.cameras.begin(), proof.cameras.end());
  }
  return cameras;
}

/// The largest value of one statistic over the cameras.
double largest(const ConvertResult& result, double PixelDistance::*figure) {
  double worst = 0.0;
  for (const CameraProof& camera : seen_cameras(result)) worst = std::max(worst, camera.distance.decisive().*figure);
  return worst;
}

double sum_of_rms_px(const ConvertResult& result) {
  double sum = 0.0;
  for (const CameraProof& camera : seen_cameras(result)) sum += camera.distance.decisive().rms;
  return sum;
}

OtherWriting named(const ConvertResult& result, std::string layout) {
  const std::string_view model = result.cameras.empty() ? "" : result.cameras.front().target.lens_id();
  if (layout.empty() && !result.to->layouts.empty()) layout = result.to->layouts.front();
  return {std::move(layout), std::string(model), worst_rms_px(result), worst_max_px(result)};
}

bool has_same_models(const ConvertResult& a, const ConvertResult& b) {
  return std::ranges::equal(a.cameras, b.cameras, [](const ConvertedCamera& x, const ConvertedCamera& y) {
    return x.target.lens_id() == y.target.lens_id();
  });
}

/// True if the layout can contain the models that the cameras have.
bool stores_models(const Format& to, std::string_view layout, const ConvertResult& result) {
  return std::ranges::all_of(result.cameras,
                             [&](const ConvertedCamera& camera) { return layout_stores(to, layout, camera.target.lens_id()); });
}

bool is_good(const ConvertResult& result) {
  return std::ranges::all_of(seen_cameras(result), [](const CameraProof& camera) {
    return word_of(camera.distance.decisive()) == VerdictWord::kReady;
  });
}

/// True if `other` is to be written instead of `best`. If it has other models, `best` must not be good already: another model
/// adds an error for all programs, which the exact one does not have.
bool is_better(const ConvertResult& other, const ConvertResult& best) {
  const bool is_tie = worst_rms_px(other) == worst_rms_px(best);
  const bool has_less =
      is_tie ? sum_of_rms_px(other) < sum_of_rms_px(best) - kRounding : worst_rms_px(other) < worst_rms_px(best);
  if (!has_less) return false;
  return !is_good(best) || has_same_models(other, best);
}

constexpr double kSameShare = 0.01;  // fraction of an image

/// The share of the camera's image for which the program has no correct ray.
double share_lost(const CameraProof& camera) { return camera.distance.in_image.region * camera.distance.in_image.no_rays; }

double largest_share_lost(const ConvertResult& result) {
  double share = 0.0;
  for (const CameraProof& camera : seen_cameras(result)) share = std::max(share, share_lost(camera));
  return share;
}

/// True if the program ignores a part of the image that the fitted model covers.
bool is_cut_by_program(const ConvertedCamera& camera, const std::vector<CameraProof>& seen) {
  const auto proof = std::ranges::find(seen, camera.source.name, &CameraProof::name);
  if (proof == seen.end() || !camera.report) return false;
  if (camera.source.lens_id() == camera.target.lens_id()) return false;
  // Outside the scored part the model itself has no correct ray, by its formula or because it was fitted up to a smaller angle.
  return share_lost(*proof) > 1.0 - camera.report->statistics.coverage.scored + kSameShare;
}

/// The best way to write the files so far, and the others that were tried.
class Choice {
 public:
  Choice(const ConvertRequest& request, const ConvertResult& result)
      : is_free_(!request.layout), best_(result), layout_(name_of(request.layout)) {
    for (const std::string_view layout : result.to->layouts) {
      if (layout != layout_ && layout != result.to->common_lens_layout) left_.push_back(layout);
    }
  }

  void consider(std::optional<ConvertResult> other, std::string_view layout) {
    if (!other) return;
    std::erase(left_, layout);
    if (std::ranges::equal(other->files, best_.files, {}, &ConvertedFile::bytes, &ConvertedFile::bytes)) return;
    if (is_free_ && is_better(*other, best_)) {
      others_.push_back(named(best_, layout_));
      best_ = *std::move(other);
      layout_ = layout;
    } else if (is_free_ || worst_rms_px(*other) < worst_rms_px(best_)) {
      others_.push_back(named(*other, std::string(layout)));
    }
  }

  /// True if another layout cannot improve anything.
  [[nodiscard]] bool is_right() const { return largest(best_, &PixelDistance::max) <= kRounding; }

  /// True if another model need not be tried.
  [[nodiscard]] bool is_good() const {
    const auto is_enough = [](const OtherWriting& other) { return other.max_px <= kNoticeable; };
    return largest(best_, &PixelDistance::max) <= kNoticeable || std::ranges::any_of(others_, is_enough);
  }

  /// The layouts in which the files have not been written for the same program.
  [[nodiscard]] std::vector<std::string_view> layouts_left() const { return left_; }

  [[nodiscard]] ConvertResult take() && {
    best_.layout = layout_;
    best_.others = std::move(others_);
    return std::move(best_);
  }

 private:
  bool is_free_;
  ConvertResult best_;
  std::string layout_;
  std::vector<OtherWriting> others_;
  std::vector<std::string_view> left_;
};

/// True if the input is another program's file, so that the layout of this one could not be kept and a fresh file was composed.
bool is_file_of_other_program(const ConvertRequest& request, const Start& start, const ConvertResult& result) {
  if (!request.into.empty()) return false;
  const consumers::LoadOptions options = load_options(ReadOptions(), result.mode);
  const std::string& bytes = start.base.document->source().bytes;
  const ConvertedFile& file = result.files.front();
  if (file.programs.empty() || file.bytes == bytes) return false;  // the file is unchanged, and the program loads it
  const auto reads = [&](const consumers::Consumer& each) {
    return each.cameras && each.reads(result.to->id) && start.views->of(each, bytes, options).loads();
  };
  const std::span<const consumers::Consumer> all = consumers::all_consumers();
  const consumers::Consumer* program = consumers::find_consumer(file.programs.front());
  return program != nullptr && !reads(*program) && std::any_of(all.begin(), all.end(), reads);
}

}  // namespace

double worst_rms_px(const ConvertResult& result) { return largest(result, &PixelDistance::rms); }
double worst_max_px(const ConvertResult& result) { return largest(result, &PixelDistance::max); }

void try_other_layouts(const ConvertRequest& request, const Start& start, const ConvertResult& before, ConvertResult& result) {
  const ProofResult* proof = first_proof(result);
  if (proof == nullptr || !proof->loads) return;
  const bool is_edited = start.base.document != nullptr && !request.rewrite;
  if (is_edited && !is_file_of_other_program(request, start, result)) return;
  const auto is_off = [](const CameraProof& camera) { return camera.misread && camera.distance.decisive().max > kRounding; };
  if (std::ranges::none_of(proof->cameras, is_off)) return;
  const bool is_wide = std::ranges::any_of(proof->cameras, [](const CameraProof& camera) { return camera.distance.is_wide; });
  Choice choice(request, result);
  ConvertRequest other = request;
  // First with the models that the cameras have: that needs no fit.
  for (const std::string_view layout : result.to->layouts) {
    if (choice.is_right()) break;
    if (layout == name_of(request.layout) || layout == result.to->common_lens_layout ||
        !stores_models(*result.to, layout, result))
      continue;
    other.layout = FormatLayout::find(*result.to, layout);
    choice.consider(written_as(other, start, before, result), layout);
  }
  // A model that does not cover the whole lens is no improvement.
  if (!choice.is_good() && request.model == nullptr) {
    for (const std::string_view layout : choice.layouts_left()) {
      for (const StoredModel& stored : result.to->models) {
        if (!stored.stock || (is_wide && is_perspective(stored.model))) continue;
        if (!layout_stores(*result.to, layout, stored.model)) continue;
        other.layout = FormatLayout::find(*result.to, layout);
        other.model = find_model(stored.model);
        choice.consider(written_as(other, start, before, result, Partial::kNothing), layout);
      }
    }
  }
  result = std::move(choice).take();
}

void try_other_models(const ConvertRequest& request, const Start& start, const ConvertResult& before, ConvertResult& result) {
  const ProofResult* proof = first_proof(result);
  if (proof == nullptr || !proof->loads || request.model != nullptr || !request.into.empty()) return;
  const std::vector<CameraProof> seen = seen_cameras(result);
  const auto is_cut = [&seen](const ConvertedCamera& camera) { return is_cut_by_program(camera, seen); };
  if (std::ranges::none_of(result.cameras, is_cut)) return;
  ConvertRequest other = request;
  if (!result.layout.empty()) other.layout = FormatLayout::find(*result.to, result.layout);
  const ModelChoice choice = choice_of(other, start, *result.to);
  std::optional<ConvertResult> best;
  for (const StoredModel& stored : result.to->models) {
    // Cameras that the program reads completely keep their model.
    const auto stays = [&](const ConvertedCamera& camera) { return camera.target.lens_id() == stored.model || is_cut(camera); };
    if (!may_be_chosen(stored, choice) || !std::ranges::all_of(result.cameras, stays)) continue;
    other.model = find_model(stored.model);
    std::optional<ConvertResult> tried = written_as(other, start, before, result);
    if (!tried || !is_good(*tried)) continue;
    const double gained = largest_share_lost(best ? *best : result) - largest_share_lost(*tried);
    const bool is_nearer = best && std::abs(gained) <= kSameShare && worst_rms_px(*tried) < worst_rms_px(*best);
    if (gained <= kSameShare && !is_nearer) continue;
    tried->layout = result.layout;
    tried->others = result.others;
    best = std::move(tried);
  }
  if (best) result = *std::move(best);
}

void try_fit_in_circle(const ConvertRequest& request, const Start& start, const ConvertResult& before, ConvertResult& result) {
  const ProofResult* proof = first_proof(result);
  if (proof == nullptr || !proof->loads || result.lens_given || is_good(result)) return;
  const std::vector<CameraProof> cameras = seen_cameras(result);
  double degrees = 0.0;
  for (const ConvertedCamera& camera : result.cameras) {
    const auto seen = std::ranges::find(cameras, camera.source.name, &CameraProof::name);
    if (seen == cameras.end() || !seen->distance.is_wide || !camera.report || camera.report->exact) continue;
    degrees = std::max(degrees, degrees_in_circle(camera.source).value_or(0.0));
  }
  if (degrees == 0.0) return;
  ConvertRequest nearer = request;
  nearer.inputs.max_angle_rad = degrees * std::numbers::pi / 180.0;
  const std::optional<ConvertResult> other = written_as(nearer, start, before, result);
  const bool is_worth_it = other && is_worth_a_nearer_fit(worst_rms_px(result), worst_rms_px(*other)) &&
                           largest(*other, &PixelDistance::no_rays) <= largest(result, &PixelDistance::no_rays);
  if (is_worth_it) result.nearer = {degrees, worst_rms_px(*other)};
}

}  // namespace fca
