// SPDX-License-Identifier: BSD-3-Clause
// The error statistics of two cameras, as members of an open object: the same keys wherever two cameras are evaluated.
#pragma once

#include "json.h"
#include "option_hints.h"

#include <fca/convert/report.h>

#include <span>

namespace fca::cli {

inline void put_field_of_view(Json& json, const Coverage& coverage, double scored_to_deg) {
  json.object("domain", [&] {
    json.put("max_angle_deg", coverage.max_angle_deg);
    json.put("why", text::text_of(coverage.why, with_options));
    if (coverage.circle) {
      json.object("lens_circle", [&] {
        json.put("centre", std::span<const double>(coverage.circle->centre));
        json.put("radius_px", coverage.circle->radius_px);
        json.put("rim_share", coverage.circle->rim_share);
        json.put("rms_px", coverage.circle->rms_px);
      });
    }
    json.put("scored_to_deg", scored_to_deg);
    json.put("scored_share", coverage.scored);
    json.put("outside_lens_share", coverage.outside_lens);
    json.put("unrepresentable_share", coverage.unrepresentable);
    if (coverage.scored_pixels > 0) {
      json.put("scored_pixels", coverage.scored_pixels);
      json.put("outside_lens_pixels", coverage.outside_lens_pixels);
      json.put("unrepresentable_pixels", coverage.unrepresentable_pixels);
    }
  });
}

inline void put_error(Json& json, const ErrorSummary& error) {
  json.object("error_px", [&] {
    json.put("rms", error.rms);
    json.put("mean", error.mean);
    json.put("p50", error.p50);
    json.put("p95", error.p95);
    json.put("p99", error.p99);
    json.put("max", error.max);
    json.put("max_at", std::span<const double>(error.max_at));
    json.put("bound", error.bound);  // null where nothing is proven
  });
}

/// Of an open object of the array "bands".
inline void put_band(Json& json, const ErrorBand& band) {
  json.put("from_deg", band.from_deg);
  json.put("to_deg", band.to_deg);
  json.put("share", band.share);
  json.put("rms_px", band.rms_px);
  json.put("max_px", band.max_px);
}

}  // namespace fca::cli
