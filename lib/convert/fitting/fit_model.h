// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/convert/convert.h>
#include <fca/convert/fit_target.h>

#include <cstdint>
#include <memory>
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
  bool reaches_all = true;  ///< Every sample projects, but for the very edge.
  std::vector<std::string> at_bound;
};

/// What a fit must reach to reach all.
enum class Reach : std::uint8_t {
  kAlmostAll,    ///< All samples but next to none of their weight: the very edge of a lens.
  kEverySample,  ///< Those of no weight, too, which a conversion adds where a model may end early (edge_samples.h).
};

/// Fits the listed model of that id to the samples of a lens with that centre; nothing if no start leads to a camera.
///
/// Never worse than the fit of a model that the target contains (pinhole in radtan, ucm in eucm, ...), but for a thousandth of
/// a pixel: where the target's own starts fail, do not reach every sample or may have lost to the contained model, that is
/// fitted, too, and what it finds is one more start.
[[nodiscard]] std::optional<FittedModel> fit_model(std::string_view id, std::span<const Correspondence> samples,
                                                   const LensCentre& centre, std::span<const ParameterRange> ranges,
                                                   Reach reach = Reach::kAlmostAll);

/// Has no camera of that model a pixel for rays at 90 degrees from the axis and beyond?
[[nodiscard]] bool sees_ahead_only(std::string_view id);

/// Can a camera of that model have a pole inside its image?
[[nodiscard]] bool has_poles(std::string_view id);

/// May a fit of that model end, at a pole or where its radius turns back, between the outermost sample and the domain's edge?
[[nodiscard]] bool may_end_early(std::string_view id);

/// The coefficient that may bend the radius of that model back before the edge of a wide lens; nothing if it has none.
[[nodiscard]] std::optional<ParameterId> bends_back(std::string_view id);

/// What a fit asks of that model.
[[nodiscard]] std::unique_ptr<FitTarget> fit_target_of(const CameraModel& model);

/// The fit to which that camera leads, or itself, whichever is better; nothing if it leads nowhere and is outside the ranges.
[[nodiscard]] std::optional<FittedModel> fit_from(const CameraModel& start, std::span<const Correspondence> samples,
                                                  std::span<const ParameterRange> ranges);

}  // namespace fca::internal
