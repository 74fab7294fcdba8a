// SPDX-License-Identifier: BSD-3-Clause
#include "limits.h"

#include <fca/code.h>
#include <fca/formats/wording.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fca {

void warn_of_poor_fits(const ConvertRequest& request, ConvertResult& result) {
  constexpr double kPoorRms = 1.0;   // px
  constexpr double kPoorMax = 10.0;  // px
  for (const ConvertedCamera& camera : result.cameras) {
    if (!camera.report || camera.report->exact) continue;
    const ErrorSummary& error = camera.report->statistics.error;
    if (error.rms <= kPoorRms && error.max <= kPoorMax) continue;
    result.diagnostics.add(Code::kPoorFit,
                           {camera.source.name, camera.report->to_model, error.rms, error.max, request.inputs.files.front()});
  }
}

namespace {

/// The reason why the error of a fit is not known to be within the limit; nullopt if it is. The measured maximum counts only if
/// the proven bound confirms it to 10 %: in an image one pixel wide the lattice may miss the worst ray.
std::optional<Message> beyond_limit(const ConvertedCamera& camera, double limit_px) {
  const ErrorSummary& error = camera.report->statistics.error;
  constexpr double kConfirmed = 1.1;
  if (error.max > limit_px) return Message{Code::kErrorBeyondLimit, {camera.source.name, error.max, limit_px}};
  if (error.bound <= std::max(limit_px, kConfirmed * error.max)) return std::nullopt;
  if (std::isinf(error.bound)) return Message{Code::kNoBoundBelowLimit, {camera.source.name, error.max, limit_px}};
  return Message{Code::kBoundBeyondLimit, {camera.source.name, error.max, error.bound, limit_px}};
}

}  // namespace

bool has_sigmas(const ConvertRequest& request, const Rig& rig, ConvertResult& result) {
  if (!request.max_error_sigmas) return true;
  for (const Camera& camera : rig.cameras) {
    const Uncertainty* stated = rig.find_uncertainty(camera.name);
    if (camera.rays.empty() && stated != nullptr && stated->has_covariance()) continue;
    Message why{Code::kSigmaOfNothing};
    if (stated != nullptr) why = {Code::kSigmaOnlyLimit, {stated->where.file}};
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
    // A missing pixel exceeds every limit.
    constexpr double kNoticeable = 1e-3;
    const double missing = camera.report->statistics.coverage.unrepresentable;
    if (missing > kNoticeable || (camera.report->angle_reduced && missing > 0.0)) {
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
  std::vector<Message> what;
  for (const Loss& loss : result.losses) {
    if (request.strict && loss.matters) what.push_back(facts_of(loss));
  }
  if (!what.empty()) {
    result.diagnostics.add(Code::kLossesNotAllowed, {what});
    result.status = Status::kRejected;
  }
}

}  // namespace fca
