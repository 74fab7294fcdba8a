// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/convert/domain.h>
#include <fca/convert/report.h>

#include <functional>
#include <optional>

namespace fca {

/// Any function ray -> pixel: a model, or what a program does.
using Projection = std::function<std::optional<Pixel>(const Ray&)>;

/// Compares `target` with `source` over the domain, on a lattice of about 5,000 points that includes
/// the image's border and has nothing to do with the points of a fit. Points are weighted by area, the domain's edge followed
/// to a sixth of a cell, so that rms is the image's. The maximum is polished between lattice points and along the edge of the
/// lens to 1e-3 px in position.
[[nodiscard]] Judgement judge(const CameraModel& source, const Projection& target, const Domain& domain);
[[nodiscard]] Judgement judge(const CameraModel& source, const CameraModel& target, const Domain& domain);

}  // namespace fca
