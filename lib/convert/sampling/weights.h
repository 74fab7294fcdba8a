// SPDX-License-Identifier: BSD-3-Clause
// Samples with unequal weights (FitWeight): by solid angle, or by an image of weights.
#pragma once

#include <fca/convert/field_of_view.h>
#include <fca/convert/fit_weight.h>
#include <fca/convert/lens.h>
#include <fca/rig/transform.h>

#include <cstddef>
#include <vector>

namespace fca::internal {

/// True if all pixels have the same weight. A fit with FitWeight() is then the same to the last bit.
[[nodiscard]] bool has_equal_weights(const FitWeight& weight);

/// True if at least one pixel of the field of view is not black in `density`, an image of the field of view's size.
[[nodiscard]] bool has_weight(const GreyImage& density, const Lens& source, const FieldOfView& field_of_view);

/// Samples whose weights sum to 1.
struct WeightedSamples {
  std::vector<Correspondence> samples;
  std::size_t counted = 0;  ///< The number of samples that are not black.
};
/// About `count` samples, those of sample(), with their weights multiplied by `weight`. For an image of weights, the samples
/// are a grid with more points instead, since such an image may have edges and may be black nearly everywhere.
[[nodiscard]] WeightedSamples weighted_samples(const FitWeight& weight, const Lens& source, const FieldOfView& field_of_view,
                                               int count);

/// The weighted rms [px] of the errors of `target` over the rays of the field of view that are at most `max_angle_rad` from the
/// source's axis and have a pixel in `target`. Unless `T_target_source` is null, it first rotates the rays. 0 if there are no
/// such rays.
[[nodiscard]] double weighted_rms(const FitWeight& weight, const Lens& source, const CameraModel& target,
                                  const FieldOfView& field_of_view, double max_angle_rad,
                                  const Transform* T_target_source = nullptr);

}  // namespace fca::internal
