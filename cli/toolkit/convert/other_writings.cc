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

// Limits of the largest distance [px] between a camera and what the program reads:
constexpr double kNoticeablePx = 0.25;  // a smaller distance needs no other model
constexpr double kRoundingPx = 0.02;    // a smaller distance may be rounding and needs no other layout

/// The proof with the program that the files are written for; null if no program was asked.
const ProofResult* first_proof(const ConvertResult& result) {
  const auto proof = std::ranges::find_if(result.proofs, [](const ProofResult& each) { return each.is_first; });
  return proof == result.proofs.end() ? nullptr : &*proof;
}

/// True if `other` is for the same program and mode as `result`, and that program loads it.
bool is_alternative(const ConvertResult& other, const ConvertResult& result) {
  const ProofResult* proof = first_proof(other);
  return other.status == Status::kDone && other.mode == result.mode && proof != nullptr && proof->loads &&
         proof->program == first_proof(result)->program;
}

/// Writes the request, whose layout or model differs from that of `result`. nullopt if that fails or the program of `result`
/// does not load the files. `before`: the result before anything was written.
std::optional<ConvertResult> alternative(const ConvertRequest& request, const Start& start, const ConvertResult& before,
                                         const ConvertResult& result, Partial partial = Partial::kSmallerAngle) {
  ConvertResult other = before;
  if (!write_as_asked(request, start, other, partial) || !is_alternative(other, result)) return std::nullopt;
  return other;
}

/// The cameras of all files, as the first program of each file reads them.
std::vector<CameraProof> cameras_read(const ConvertResult& result) {
  std::vector<CameraProof> cameras;
  for (const ProofResult& proof : result.proofs) {
    if (proof.is_first) cameras.insert(cameras.end(), proof.cameras.begin(), proof.cameras.end());
  }
  return cameras;
}

/// The largest value that a statistic has for any camera.
double largest(const ConvertResult& result, double PixelDistance::*statistic) {
  double worst = 0.0;
  for (const CameraProof& camera : cameras_read(result)) worst = std::max(worst, camera.distance.decisive().*statistic);
  return worst;
}

double sum_of_rms_px(const ConvertResult& result) {
  double sum = 0.0;
  for (const CameraProof& camera : cameras_read(result)) sum += camera.distance.decisive().rms;
  return sum;
}

/// A row of ConvertResult::others for this result. An empty layout is the first one of the format.
OtherWriting row_of_others(const ConvertResult& result, std::string layout) {
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

/// True if the program reads every camera with errors for which the verdict is "ready".
bool is_good(const ConvertResult& result) {
  return std::ranges::all_of(cameras_read(result), [](const CameraProof& camera) {
    return word_of(camera.distance.decisive()) == VerdictWord::kReady;
  });
}

/// True if `other` is to be written instead of `best`, because the program reads it with smaller errors. If `best` is already
/// good, `other` must have the same models: another model would add an error for all programs.
bool is_better(const ConvertResult& other, const ConvertResult& best) {
  const bool is_tie = worst_rms_px(other) == worst_rms_px(best);
  const bool has_smaller_errors =
      is_tie ? sum_of_rms_px(other) < sum_of_rms_px(best) - kRoundingPx : worst_rms_px(other) < worst_rms_px(best);
  if (!has_smaller_errors) return false;
  return !is_good(best) || has_same_models(other, best);
}

// A smaller difference between two shares of an image is ignored.
constexpr double kShareTolerance = 0.01;

/// The share of the camera's image for which the program has no correct ray.
double share_lost(const CameraProof& camera) { return camera.distance.in_image.region * camera.distance.in_image.no_rays; }

double largest_share_lost(const ConvertResult& result) {
  double share = 0.0;
  for (const CameraProof& camera : cameras_read(result)) share = std::max(share, share_lost(camera));
  return share;
}

/// True if the program ignores a part of the image that the fitted model covers. False for a camera that keeps its model.
bool is_cut_by_program(const ConvertedCamera& camera, const std::vector<CameraProof>& seen) {
  const auto proof = std::ranges::find(seen, camera.source.name, &CameraProof::name);
  if (proof == seen.end() || !camera.report) return false;
  if (camera.source.lens_id() == camera.target.lens_id()) return false;
  // Outside the scored part the model itself has no correct ray: its formula has none, or it was fitted up to a smaller angle.
  return share_lost(*proof) > 1.0 - camera.report->statistics.coverage.scored + kShareTolerance;
}

/// Collects the results in several layouts: the best one so far, and a row for each of the others.
class LayoutChoice {
 public:
  LayoutChoice(const ConvertRequest& request, const ConvertResult& result)
      : is_free_(!request.layout), best_(result), layout_(name_of(request.layout)) {
    for (const std::string_view layout : result.to->layouts) {
      if (layout != layout_ && layout != result.to->common_lens_layout) untried_.push_back(layout);
    }
  }

  /// Compares a result in that layout with the best one. Does nothing for nullopt or for files equal to the best ones.
  void consider(std::optional<ConvertResult> other, std::string_view layout) {
    if (!other) return;
    std::erase(untried_, layout);
    if (std::ranges::equal(other->files, best_.files, {}, &ConvertedFile::bytes, &ConvertedFile::bytes)) return;
    if (is_free_ && is_better(*other, best_)) {
      others_.push_back(row_of_others(best_, layout_));
      best_ = *std::move(other);
      layout_ = layout;
    } else if (is_free_ || worst_rms_px(*other) < worst_rms_px(best_)) {
      others_.push_back(row_of_others(*other, std::string(layout)));
    }
  }

  /// True if the program reads the best files without errors, so that another layout cannot improve anything.
  [[nodiscard]] bool is_read_exactly() const { return largest(best_, &PixelDistance::max) <= kRoundingPx; }

  /// True if a result has no noticeable errors, so that another model need not be tried.
  [[nodiscard]] bool has_good_result() const {
    const auto is_enough = [](const OtherWriting& other) { return other.max_px <= kNoticeablePx; };
    return largest(best_, &PixelDistance::max) <= kNoticeablePx || std::ranges::any_of(others_, is_enough);
  }

  /// The layouts without a result so far.
  [[nodiscard]] std::vector<std::string_view> untried_layouts() const { return untried_; }

  /// The best result, with its layout and the rows of the others.
  [[nodiscard]] ConvertResult take() && {
    best_.layout = layout_;
    best_.others = std::move(others_);
    return std::move(best_);
  }

 private:
  bool is_free_;  ///< The request names no layout, so that the best result is chosen.
  ConvertResult best_;
  std::string layout_;  ///< The layout of the best result; empty: the usual one.
  std::vector<OtherWriting> others_;
  std::vector<std::string_view> untried_;
};

/// True if the file to edit is for another program than the written file: the program of the written file does not load it, but
/// another program does.
bool is_file_of_other_program(const ConvertRequest& request, const Start& start, const ConvertResult& result) {
  if (!request.into.empty()) return false;
  const consumers::LoadOptions options = load_options(ReadOptions(), result.mode);
  const std::string& bytes = start.base.document->source().bytes;
  const ConvertedFile& file = result.files.front();
  if (file.programs.empty() || file.bytes == bytes) return false;  // the file is unchanged, and the program loads it
  const auto reads = [&](const consumers::Consumer& each) {
    return each.cameras && each.reads(result.to->id) && start.views->of(each, bytes, options).loads();
  };
  const std::span<const consumers::Consumer> programs = consumers::all_consumers();
  const consumers::Consumer* program = consumers::find_consumer(file.programs.front());
  return program != nullptr && !reads(*program) && std::any_of(programs.begin(), programs.end(), reads);
}

}  // namespace

double worst_rms_px(const ConvertResult& result) { return largest(result, &PixelDistance::rms); }
double worst_max_px(const ConvertResult& result) { return largest(result, &PixelDistance::max); }

void try_other_layouts(const ConvertRequest& request, const Start& start, const ConvertResult& before, ConvertResult& result) {
  const ProofResult* proof = first_proof(result);
  if (proof == nullptr || !proof->loads) return;
  const bool is_edited = start.base.document != nullptr && !request.rewrite;
  if (is_edited && !is_file_of_other_program(request, start, result)) return;
  const auto is_wrong = [](const CameraProof& camera) {
    return camera.misread && camera.distance.decisive().max > kRoundingPx;
  };
  if (std::ranges::none_of(proof->cameras, is_wrong)) return;
  const bool is_wide = std::ranges::any_of(proof->cameras, [](const CameraProof& camera) { return camera.distance.is_wide; });
  LayoutChoice choice(request, result);
  ConvertRequest other = request;
  // First, try the models that the cameras have: they need no fit.
  for (const std::string_view layout : result.to->layouts) {
    if (choice.is_read_exactly()) break;
    if (layout == name_of(request.layout) || layout == result.to->common_lens_layout ||
        !stores_models(*result.to, layout, result))
      continue;
    other.layout = FormatLayout::find(*result.to, layout);
    choice.consider(alternative(other, start, before, result), layout);
  }
  // A model that does not cover the whole lens is no improvement.
  if (!choice.has_good_result() && request.model == nullptr) {
    for (const std::string_view layout : choice.untried_layouts()) {
      for (const StoredModel& stored : result.to->models) {
        if (!stored.stock || (is_wide && is_perspective(stored.model))) continue;
        if (!layout_stores(*result.to, layout, stored.model)) continue;
        other.layout = FormatLayout::find(*result.to, layout);
        other.model = find_model(stored.model);
        choice.consider(alternative(other, start, before, result, Partial::kNothing), layout);
      }
    }
  }
  result = std::move(choice).take();
}

void try_other_models(const ConvertRequest& request, const Start& start, const ConvertResult& before, ConvertResult& result) {
  const ProofResult* proof = first_proof(result);
  if (proof == nullptr || !proof->loads || request.model != nullptr || !request.into.empty()) return;
  const std::vector<CameraProof> seen = cameras_read(result);
  const auto is_cut = [&seen](const ConvertedCamera& camera) { return is_cut_by_program(camera, seen); };
  if (std::ranges::none_of(result.cameras, is_cut)) return;
  ConvertRequest other = request;
  if (!result.layout.empty()) other.layout = FormatLayout::find(*result.to, result.layout);
  const ModelChoice choice = choice_of(other, start, *result.to);
  std::optional<ConvertResult> best;
  for (const StoredModel& stored : result.to->models) {
    // A camera that the program reads completely must keep its model.
    const auto may_have_model = [&](const ConvertedCamera& camera) {
      return camera.target.lens_id() == stored.model || is_cut(camera);
    };
    if (!may_be_chosen(stored, choice) || !std::ranges::all_of(result.cameras, may_have_model)) continue;
    other.model = find_model(stored.model);
    std::optional<ConvertResult> tried = alternative(other, start, before, result);
    if (!tried || !is_good(*tried)) continue;
    const double share_gained = largest_share_lost(best ? *best : result) - largest_share_lost(*tried);
    const bool has_smaller_error =
        best && std::abs(share_gained) <= kShareTolerance && worst_rms_px(*tried) < worst_rms_px(*best);
    if (share_gained <= kShareTolerance && !has_smaller_error) continue;
    tried->layout = result.layout;
    tried->others = result.others;
    best = std::move(tried);
  }
  if (best) result = *std::move(best);
}

void try_fit_in_circle(const ConvertRequest& request, const Start& start, const ConvertResult& before, ConvertResult& result) {
  const ProofResult* proof = first_proof(result);
  if (proof == nullptr || !proof->loads || result.lens_given || is_good(result)) return;
  const std::vector<CameraProof> cameras = cameras_read(result);
  double degrees = 0.0;
  for (const ConvertedCamera& camera : result.cameras) {
    const auto seen = std::ranges::find(cameras, camera.source.name, &CameraProof::name);
    if (seen == cameras.end() || !seen->distance.is_wide || !camera.report || camera.report->exact) continue;
    degrees = std::max(degrees, degrees_in_circle(camera.source).value_or(0.0));
  }
  if (degrees == 0.0) return;
  ConvertRequest in_circle = request;
  in_circle.inputs.max_angle_rad = degrees * std::numbers::pi / 180.0;
  const std::optional<ConvertResult> other = alternative(in_circle, start, before, result);
  const bool is_worth_it = other && is_worth_a_nearer_fit(worst_rms_px(result), worst_rms_px(*other)) &&
                           largest(*other, &PixelDistance::no_rays) <= largest(result, &PixelDistance::no_rays);
  if (is_worth_it) result.nearer = {degrees, worst_rms_px(*other)};
}

}  // namespace fca
