// SPDX-License-Identifier: BSD-3-Clause
#include "limits.h"

#include "words.h"

#include <fca/formats/text/numbers.h>
#include <fca/formats/wording.h>

#include <cmath>

namespace fca {

void warn_of_poor_fits(const ConvertRequest& request, ConvertResult& result) {
  constexpr double kPoorRms = 1.0;   // px
  constexpr double kPoorMax = 10.0;  // px
  for (const ConvertedCamera& camera : result.cameras) {
    if (!camera.report || camera.report->exact) continue;
    const ErrorSummary& error = camera.report->judgement.error;
    if (error.rms <= kPoorRms && error.max <= kPoorMax) continue;
    result.diagnostics.warning("poor-fit",
                               camera.source.name + ": " + camera.report->to_model + " does not describe this lens: rms " +
                                   pixels(error.rms) + " px, worst pixel " + pixels(error.max) + " px",
                               {},
                               "fca-io models " + shell_word(request.inputs.files.front()) +
                                   " compares all models; --max-angle DEG if the corners are black");
  }
}

void apply_limits(const ConvertRequest& request, ConvertResult& result) {
  for (const ProofResult& proof : result.proofs) {
    if (!request.max_error_px || proof.misread_px <= *request.max_error_px) continue;
    result.diagnostics.error("error-limit",
                             proof.program + " misreads a camera by up to " + pixels(proof.misread_px) +
                                 " px, more than --max-error " + pixels(*request.max_error_px),
                             {}, text::text_of(result.misread_remedy));
    result.status = Status::kRejected;
  }
  for (const ConvertedCamera& camera : result.cameras) {
    if (!request.max_error_px || !camera.report) continue;
    // A pixel that is not there is off by more than any limit.
    constexpr double kNoticeable = 1e-3;
    const double missing = camera.report->judgement.coverage.unrepresentable;
    if (missing > kNoticeable || (camera.report->fitted_to_cone && missing > 0.0)) {
      const double reach_deg = camera.report->scored_to_deg;
      result.diagnostics.error("error-limit",
                               camera.source.name + ": " + percent(missing) + " of the image has no pixel or a wrong one as " +
                                   camera.report->to_model + ", and --max-error was given",
                               {},
                               "--max-angle " + text::format_short(std::floor(reach_deg), 3) +
                                   (request.inputs.lens_circles.empty() ? "" : " in place of --lens-circle") +
                                   " if nothing further from the axis is needed");
      result.status = Status::kRejected;
    }
    const double worst = camera.report->judgement.error.max;
    if (camera.report->exact || worst <= *request.max_error_px) continue;
    result.diagnostics.error("error-limit", camera.source.name + ": the worst pixel is off by " + text::format_short(worst) +
                                                " px, more than --max-error " + text::format_short(*request.max_error_px));
    result.status = Status::kRejected;
  }
  if (request.strict && !result.losses.empty()) {
    std::vector<std::string> what;
    for (const Loss& loss : result.losses) what.push_back(what_of(loss));
    result.diagnostics.error("strict-loss", "the target cannot carry " + enumerated(what) + ", and --strict was given");
    result.status = Status::kRejected;
  }
}

}  // namespace fca
