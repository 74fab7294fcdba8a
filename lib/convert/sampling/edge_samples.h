// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/convert/domain.h>
#include <fca/convert/lens.h>
#include <fca/models/camera_model.h>

#include <vector>

namespace fca::internal {

/// Adds to samples of a domain points of its edge that stand for next to nothing of its area: a pole between it and the
/// outermost sample, or a radius that turns back there, would cost a fit nothing and spoil the pixels around it.
void add_edge(const CameraModel& source, const Domain& domain, std::vector<Correspondence>& samples);

}  // namespace fca::internal
