// SPDX-License-Identifier: BSD-3-Clause
// Samples that do not count alike.
#pragma once

#include <fca/convert/domain.h>
#include <fca/convert/fit_weight.h>
#include <fca/convert/lens.h>
#include <fca/rig/transform.h>

#include <cstddef>
#include <vector>

namespace fca::internal {

/// Does every pixel count the same? Then a fit is the one of FitWeight(), to the last bit.
[[nodiscard]] bool counts_alike(const FitWeight& weight);

/// Is the image, which is of the domain's size, not black at some pixel of the domain?
[[nodiscard]] bool counts_any(const GreyImage& density, const Lens& source, const Domain& domain);

/// Of about so many places (sample(); of an image a grid, and more, for it may have edges); the weights sum to 1. `counted`:
/// how many of them count more than black does.
struct WeightedSamples {
  std::vector<Correspondence> samples;
  std::size_t counted = 0;
};
[[nodiscard]] WeightedSamples weighted_samples(const FitWeight& weight, const Lens& source, const Domain& domain, int count);

/// The weighted root mean square [px] of the errors of `target` over what of the domain it has a pixel for, up to `reach_rad`
/// from the source's axis. Rays are turned by `T_target_source` if there is one. 0 where there is nothing.
[[nodiscard]] double weighted_rms(const FitWeight& weight, const Lens& source, const CameraModel& target, const Domain& domain,
                                  double reach_rad, const Transform* T_target_source = nullptr);

}  // namespace fca::internal
