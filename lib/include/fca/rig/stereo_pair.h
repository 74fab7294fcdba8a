// SPDX-License-Identifier: BSD-3-Clause
// Which two cameras of a rig are a stereo pair: by where they look, not by their order.
#pragma once

#include <fca/rig/rig.h>

#include <cstddef>
#include <optional>
#include <utility>

namespace fca {

/// How much of the smaller image two cameras have in common, of what is infinitely far away, as a share of 0 to 1. 0 where
/// their axes are more than 45 degrees apart. Nothing where their pose or the size of an image is not known.
[[nodiscard]] std::optional<double> common_view(const Rig& rig, const Camera& a, const Camera& b);

/// Have they a quarter of the smaller image in common, or is that not known?
[[nodiscard]] bool may_be_stereo(const Rig& rig, const Camera& a, const Camera& b);

/// The places in Rig::cameras of the two that have most in common, and at least a quarter of the smaller image; the earlier
/// first. Nothing where no two are known to have that.
[[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> stereo_pair(const Rig& rig);

}  // namespace fca
