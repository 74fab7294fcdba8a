// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/rectify/vertical_disparity.h>
#include <fca/toolkit/convert.h>

#include <optional>

namespace fca {

/// What the written lenses and poses (result.poses) do to the stereo pair among the cameras of the input. Nothing where there
/// is none, or the files do not say how it sits.
[[nodiscard]] std::optional<PairError> pair_error_of(const Rig& input, const ConvertResult& result);

}  // namespace fca
