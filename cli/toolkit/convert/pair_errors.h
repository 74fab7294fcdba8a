// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/rectify/vertical_disparity.h>
#include <fca/toolkit/convert.h>

#include <optional>

namespace fca {

/// The errors, after rectification, that the written lenses and poses (result.poses) cause for the stereo pair among the
/// input's cameras. nullopt if there is no pair, or if the written files do not contain the pose between its cameras.
[[nodiscard]] std::optional<PairError> pair_error_of(const Rig& input, const ConvertResult& result);

}  // namespace fca
