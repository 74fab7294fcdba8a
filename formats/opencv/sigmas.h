// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../fields.h"

#include <fca/rig/rig.h>

namespace fca::opencv {

/// What a mapping specifies of the uncertainty of `camera`, whose keys stand there: stdDeviationsIntrinsics as
/// cv::calibrateCamera returns them (18 standard deviations in the order fx fy cx cy k1 k2 p1 p2 k3 ... tau_y, without
/// correlations) and avg_reprojection_error, in any spelling. It is added to the rig; a warning where it is none. The keys stay
/// extra fields.
void read_sigmas(const text::Node& mapping, const Camera& camera, fields::Reader& reader, Rig& rig);

}  // namespace fca::opencv
