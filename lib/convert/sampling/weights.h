// SPDX-License-Identifier: BSD-3-Clause
// Samples with unequal weights.
#pragma once

#include <fca/convert/field_of_view.h>
#include <fca/convert/fit_weight.h>
#include <fca/convert/lens.h>
#include <fca/rig/transform.h>

#include <cstddef>
#include <vector>

namespace fca::internal {

/// True if all pixels have the same weight. A fit is then identical to that with FitWeight(), to the last bit.
[[nodiscard]] bool has_equal_weights(const FitWeight& weight);

/// True if `density`, an image of the field of view's size, is not black at every pixel of the field of view.
[[nodiscard]] bool counts_any(const GreyImage& density, const Lens& source, const FieldOfView& field_of_view);

/// About as many samples as requested, whose weights sum to 1: those of sample() or, for an image of weights, a grid with more
/// samples, since the image may have edges. `counted`: the number of samples that weigh more than black.
struct WeightedSamples {
  std::vector<Correspondence> samples;
  std::size_t counted = 0;
};
[[nodiscard]] WeightedSamples weighted_samples(const FitWeight& weight, const Lens& source, const FieldOfView& field_of_view,
                                               int count);

/// The weighted rms [px] of the errors of `target` over those rays of the field of view, up to `max_angle_rad` from the
/// source's axis, for which it has a pixel. `T_target_source` rotates the rays first unless it is null. 0 if there are no such
/// rays.
[[nodiscard]] double weighted_rms(const FitWeight& weight, const Lens& source, const CameraModel& target,
                                  const FieldOfView& field_of_view, double max_angle_rad,
                                  const Transform* T_target_source = nullptr);

}  // namespace fca::internal
