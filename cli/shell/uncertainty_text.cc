// SPDX-License-Identifier: BSD-3-Clause
#include "uncertainty_text.h"

#include "words.h"

#include <fca/convert/repeatability.h>
#include <fca/formats/text/numbers.h>

#include <cmath>
#include <span>

namespace fca::cli {

namespace {

/// Less is rounding.
constexpr double kSeenPx = 1e-6;

const Repeatability& repeatability_of(const ConversionReport& report) {
  return typical_repeatability(report.statistics.coverage.max_angle_deg);
}

bool has_error(const ConversionReport& report) { return !report.exact && report.statistics.error.rms > kSeenPx; }

std::string repeatability_in_words(const ConversionReport& report) {
  constexpr double kMany = 1000.0;
  const Repeatability& typical = repeatability_of(report);
  const double times = typical.rms_px / report.statistics.error.rms;
  return "two calibrations of " + std::string(typical.camera) + " differ by " + pixels(typical.rms_px) + " px rms, " +
         (times > kMany ? "more than 1000" : text::format_short(times, 2)) + " times this error (" +
         std::string(typical.source) + ")";
}

}  // namespace

std::string uncertainty_in_words(const ConversionReport& report) {
  if (!report.uncertainty) return has_error(report) ? repeatability_in_words(report) : "";
  const PixelUncertainty& own = *report.uncertainty;
  const std::string what = own.of_residuals ? "residuals up to " : "conversion error ";
  const std::string error = has_error(report) ? what + pixels(report.statistics.error.max) + " px, " : "";
  const std::string whose = own.of_residuals ? "the fit's own uncertainty " : "the calibration's own uncertainty ";
  const std::string by = own.of_residuals ? ", by the residuals of the rays" : ", by " + text::printable(own.source);
  return error + whose + (own.is_limit ? "at most " : "") + pixels(own.max_px) + " px (1 sigma, at the worst pixel" +
         (own.is_limit ? "; correlations unknown" : "") + ")" + by;
}

void put_uncertainty(Json& json, const ConversionReport& report, const CameraModel& target) {
  if (report.uncertainty) {
    const PixelUncertainty& own = *report.uncertainty;
    json.object("uncertainty", [&] {
      json.put("source", own.of_residuals ? std::string("residuals") : own.source);
      json.put("correlations_known", !own.is_limit);
      json.put("rms_px", own.rms_px);
      json.put("max_px", own.max_px);
      json.put("max_at", std::span<const double>(own.max_at));
      if (!own.is_limit && !own.of_residuals) json.put("error_sigmas", own.most_sigmas);
      if (own.sigmas.empty()) return;
      json.object("sigmas", [&] {
        const std::span<const Parameter> parameters = model_info(target).parameters;
        for (std::size_t i = 0; i < own.sigmas.size(); ++i) json.put(parameters[i].name, own.sigmas[i]);
      });
      json.put("covariance", std::span<const double>(own.covariance));
    });
  }
  if (has_error(report)) {
    const Repeatability& typical = repeatability_of(report);
    json.object("repeatability", [&] {
      json.put("camera", typical.camera);
      json.put("source", typical.source);
      json.put("rms_px", typical.rms_px);
      json.put("times_the_error", typical.rms_px / report.statistics.error.rms);
    });
  }
}

}  // namespace fca::cli
