// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json.h"

#include <fca/rectify/vertical_disparity.h>

#include <optional>

namespace fca::cli {

/// Under "pair": what stereo feels; null where there is no pair.
inline void put_pair(Json& json, const std::optional<PairError>& pair) {
  if (!pair) return json.null("pair");
  json.object("pair", [&] {
    json.put("first", pair->first);
    json.put("second", pair->second);
    json.put("epipolar_rms_px", pair->rms_px());
    json.put("epipolar_max_px", pair->max_px());
  });
}

}  // namespace fca::cli
