// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/convert/convert.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fca::internal {

/// A fitted model of the list.
struct FittedModel {
  CameraModel model;
  double rms_px = 0.0;
  int iterations = 0;
  bool reaches_all = true;  ///< Every sample projects.
  std::vector<std::string> at_bound;
};

/// Fits the listed model of that id; nothing if no start leads anywhere.
[[nodiscard]] std::optional<FittedModel> fit_model(std::string_view id, std::span<const Correspondence> samples,
                                                   const LensCentre& centre, std::span<const ParameterRange> ranges);

}  // namespace fca::internal
