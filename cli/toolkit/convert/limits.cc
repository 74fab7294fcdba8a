// SPDX-License-Identifier: BSD-3-Clause
#include "limits.h"

#include <fca/code.h>
#include <fca/formats/wording.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fca {

void warn_of_poor_fits(const ConvertRequest& request, ConvertResult& result) {
  constexpr double kPoorRmsPx = 1.0;
  constexpr double kPoorMaxPx = 10.0;
  for (const ConvertedCamera& camera : result.cameras) {
    if (!camera.report || camera.report->exact) continue;
    const ErrorSummary& error = camera.report->statistics.error;
    if (error.rms <= kPoorRmsPx && error.max <= kPoorMaxPx) continue;
    result.diagnostics.add(Code::kPoorFit,
                           {camera.source.name, camera.report->to_model, error.rms, error.max, request.inputs.files.front()});
  }
}

namespace {

/// The reason why the largest error of a fit is not known to be within the limit [px]; nullopt if it is known. The measured
/// maximum is used only if the proven bound exceeds it by at most 10 %: the lattice may miss the worst ray, for example in an
/// image one pixel wide.
std::optional<Message> beyond_limit(const ConvertedCamera& camera, double limit_px) {
  const ErrorSummary& error = camera.report->statistics.error;
  constexpr double kConfirmedRatio = 1.1;
  if (error.max > limit_px) return Message{Code::kErrorBeyondLimit, {camera.source.name, error.max, limit_px}};
  if (error.bound <= std::max(limit_px, kConfirmedRatio * error.max)) return std::nullopt;
  if (std::isinf(error.bound)) return Message{Code::kNoBoundBelowLimit, {camera.source.name, error.max, limit_px}};
  return Message{Code::kBoundBeyondLimit, {camera.source.name, error.max, error.bound, limit_px}};
}

}  // namespace

bool has_needed_covariances(const ConvertRequest& request, const Rig& rig, ConvertResult& result) {
  if (!request.max_error_sigmas) return true;
  for (const Camera& camera : rig.cameras) {
    const Uncertainty* uncertainty = rig.find_uncertainty(camera.name);
    if (camera.rays.empty() && uncertainty != nullptr && uncertainty->has_covariance()) continue;
    Message why{Code::kSigmaOfNothing};
    if (uncertainty != nullptr) why = {Code::kSigmaOnlyLimit, {uncertainty->where.file}};
    if (!camera.rays.empty()) why = {Code::kSigmaOfRays};
    result.diagnostics.add(Code::kSigmaUnknown, {camera.name, why});
    result.status = Status::kBadRequest;
    return false;
  }
  return true;
}

void apply_limits(const ConvertRequest& request, ConvertResult& result) {
  for (const ProofResult& proof : result.proofs) {
    if (!request.max_error_px || proof.misread_px <= *request.max_error_px) continue;
    result.diagnostics.add(Code::kMisreadBeyondLimit, {proof.program, proof.misread_px, *request.max_error_px});
    result.status = Status::kRejected;
  }
  for (const ConvertedCamera& camera : result.cameras) {
    if (!request.max_error_px || !camera.report) continue;
    // A pixel that the model cannot represent exceeds every limit.
    constexpr double kNoticeableShare = 1e-3;  // of the image
    const double missing = camera.report->statistics.coverage.unrepresentable;
    if (missing > kNoticeableShare || (camera.report->angle_reduced && missing > 0.0)) {
      std::vector<Message> instead;
      if (!request.inputs.lens_circles.empty()) instead.push_back({Code::kInPlaceOfCircle});
      result.diagnostics.add(Code::kMissingBeyondLimit, {camera.source.name, missing, camera.report->to_model,
                                                         std::floor(camera.report->scored_to_deg), instead});
      result.status = Status::kRejected;
    }
    if (camera.report->exact) continue;
    if (std::optional<Message> beyond = beyond_limit(camera, *request.max_error_px)) {
      result.diagnostics.add(beyond->code, std::move(beyond->arguments));
      result.status = Status::kRejected;
    }
  }
  for (const ConvertedCamera& camera : result.cameras) {
    if (!request.max_error_sigmas || !camera.report || camera.report->exact || !camera.report->uncertainty) continue;
    const double sigmas = camera.report->uncertainty->most_sigmas;
    if (sigmas <= *request.max_error_sigmas) continue;
    result.diagnostics.add(Code::kErrorBeyondSigmas, {camera.source.name, sigmas, *request.max_error_sigmas});
    result.status = Status::kRejected;
  }
  std::vector<Message> losses;
  for (const Loss& loss : result.losses) {
    if (request.strict && loss.matters) losses.push_back(facts_of(loss));
  }
  if (!losses.empty()) {
    result.diagnostics.add(Code::kLossesNotAllowed, {losses});
    result.status = Status::kRejected;
  }
}

}  // namespace fca
