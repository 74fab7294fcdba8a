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

/// A fit of a listed model.
struct FittedModel {
  CameraModel model;
  double rms_px = 0.0;
  int iterations = 0;
  bool reaches_all = true;  ///< Every sample has a pixel, except at the very edge (kVeryEdge).
  std::vector<std::string> at_bound;
};

/// Which samples must have a pixel for FittedModel::reaches_all.
enum class MustReach : std::uint8_t {
  kAlmostAll,  ///< All but samples of a thousandth of the weight (kVeryEdge): the very edge of a lens.
  /// Also those without weight, which a conversion adds at the edge where a model may end early (edge_samples.h).
  kEverySample,
};

/// Fits the listed model `id` to samples of a lens with the given centre; nullopt if no start leads to a camera.
///
/// The fit is at most 1e-3 px worse than a fit of a model that the target contains (pinhole in radtan, ucm in eucm, ...). If
/// the target's own starts fail, do not reach every sample or may be worse than the contained model, that model is fitted too,
/// and its fit is one more start.
[[nodiscard]] std::optional<FittedModel> fit_model(std::string_view id, std::span<const Correspondence> samples,
                                                   const LensCentre& centre, std::span<const ParameterRange> ranges,
                                                   MustReach must_reach = MustReach::kAlmostAll);

/// True if no camera of that model has pixels for rays at 90 degrees or more from the axis.
[[nodiscard]] bool is_perspective(std::string_view id);

/// True if a camera of that model can have a pole inside its image: an angle near which its pixels go to infinity.
[[nodiscard]] bool has_poles(std::string_view id);

/// True if a fit of that model may end between the outermost sample and the field of view's edge, at a pole or where its image
/// radius turns back.
[[nodiscard]] bool may_end_early(std::string_view id);

/// The coefficient that may bend that model's image radius back before the edge of a wide lens; nullopt if it has none.
[[nodiscard]] std::optional<ParameterId> bends_back(std::string_view id);

/// The interface through which a fit uses that model.
[[nodiscard]] std::unique_ptr<FitTarget> fit_target_of(const CameraModel& model);

/// The fit that starts from the given camera, or that camera itself if it is better; nullopt if the fit fails and the camera
/// lies outside the ranges.
[[nodiscard]] std::optional<FittedModel> fit_from(const CameraModel& start, std::span<const Correspondence> samples,
                                                  std::span<const ParameterRange> ranges);

}  // namespace fca::internal
