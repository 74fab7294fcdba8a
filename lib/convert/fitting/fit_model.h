// SPDX-License-Identifier: BSD-3-Clause
// Fits models of the list (ModelList) to samples.
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
  double rms_px = 0.0;  ///< Weighted rms over the samples.
  int iterations = 0;
  bool reaches_all = true;            ///< True if the samples that must have a pixel (see MustReach) have one.
  std::vector<std::string> at_bound;  ///< Names of the parameters that ended at a bound of their range.
};

/// Which samples must have a pixel for FittedModel::reaches_all.
enum class MustReach : std::uint8_t {
  /// All samples except a thousandth of their weight (kVeryEdge), which is the very edge of a lens. A model that may have poles
  /// must have a pixel for every sample.
  kAlmostAll,
  /// Every sample, if the image radius of the model may stop growing before the edge (bends_back()); else like kAlmostAll. The
  /// samples of a conversion then include points on the edge with weights near 0 (edge_samples.h).
  kEverySample,
};

/// Fits the listed model `id` to samples of a lens with the given centre. nullopt if no start leads to a camera.
///
/// Some models contain another one: radtan contains pinhole, eucm contains ucm. The rms of the fit is at most 1e-3 px larger
/// than that of a fit of the contained model. The contained model is fitted, too, and its fit is one more start, if the
/// target's own starts fail, lead to a camera without a pixel for some samples, or may lead to a worse fit than the contained
/// model's.
[[nodiscard]] std::optional<FittedModel> fit_model(std::string_view id, std::span<const Correspondence> samples,
                                                   const LensCentre& centre, std::span<const ParameterRange> ranges,
                                                   MustReach must_reach = MustReach::kAlmostAll);

/// True if no camera of the model `id` has pixels for rays at 90 degrees or more from the axis.
[[nodiscard]] bool is_perspective(std::string_view id);

/// True if a camera of the model `id` may have a pole inside its image: an angle near which its pixels go to infinity.
[[nodiscard]] bool has_poles(std::string_view id);

/// True if the domain of a fit of the model `id` may end between the outermost sample and the edge of the field of view: at a
/// pole, or where the image radius stops growing.
[[nodiscard]] bool may_end_early(std::string_view id);

/// The coefficient of the model `id` that may make the image radius shrink towards the edge of a wide lens (k3 of radtan).
/// nullopt if the model has no such coefficient.
[[nodiscard]] std::optional<ParameterId> bends_back(std::string_view id);

/// The interface through which a fit uses a model. It does not depend on the parameters in `model`.
[[nodiscard]] std::unique_ptr<FitTarget> fit_target_of(const CameraModel& model);

/// Returns the fit that starts from the given camera, or the camera itself if that is better. Every sample must have a pixel
/// for FittedModel::reaches_all (MustReach::kEverySample). nullopt if the fit fails and the camera is outside the ranges.
[[nodiscard]] std::optional<FittedModel> fit_from(const CameraModel& start, std::span<const Correspondence> samples,
                                                  std::span<const ParameterRange> ranges);

}  // namespace fca::internal
