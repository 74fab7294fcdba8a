// SPDX-License-Identifier: BSD-3-Clause
#include "verdict_json.h"

#include "option_hints.h"
#include "verdict_text.h"

#include <fca/code.h>
#include <fca/formats/wording.h>

namespace fca::cli {

namespace {

void put_reason(Json& json, const Reason& reason) {
  json.put("code", id_of(reason));
  json.put("word", name_of(reason.word));
  reason.camera.empty() ? json.null("camera") : json.put("camera", reason.camera);
  const std::optional<PixelDistance>& distance = reason.distance;
  const auto put = [&](const char* key, double PixelDistance::*figure) {
    distance ? json.put(key, (*distance).*figure) : json.null(key);
  };
  put("rms_px", &PixelDistance::rms);
  put("p99_px", &PixelDistance::p99);
  put("max_px", &PixelDistance::max);
  // Of the image, as the text says it.
  const bool has_share = distance && reason.facts.code == Code::kVerdictNoRays;
  has_share ? json.put("share", distance->region * distance->no_rays) : json.null("share");
  json.put("text", message_of(reason, with_options));
  json.put("fix", remedy_of(reason));
  json.put("accepted", reason.is_accepted);
}

}  // namespace

void put_verdict(Json& json, const Verdict& verdict) {
  json.object("verdict", [&] {
    json.put("word", name_of(verdict.word));
    json.array("reasons", verdict.reasons, [&](const Reason& reason) { json.object([&] { put_reason(json, reason); }); });
  });
}

}  // namespace fca::cli
