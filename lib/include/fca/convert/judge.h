// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/convert/domain.h>
#include <fca/convert/report.h>

#include <functional>
#include <optional>

namespace fca {

/// Any function ray -> pixel: a model, or what a program does.
using Projection = std::function<std::optional<Pixel>(const Ray&)>;

/// Compares `target` with `source` over the domain, on a lattice of at least 4,000 points that includes the image's border and has
/// nothing to do with the points of a fit. Lattice weights are trapezoidal, so that rms is the image's; the maximum is polished
/// between lattice points to about 1e-3 px in position.
[[nodiscard]] Judgement judge(const CameraModel& source, const Projection& target, const Domain& domain);
[[nodiscard]] Judgement judge(const CameraModel& source, const CameraModel& target, const Domain& domain);

}  // namespace fca
