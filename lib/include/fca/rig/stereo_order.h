// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/rig/rig.h>

#include <optional>
#include <string>

namespace fca {

/// How far, in metres, the rig's second camera stands to the left of the first. Nothing where it does not, where one stands
/// above the other (such pairs have no left camera), or the pose is not known. Programs that look for disparities to one side
/// only (ORB-SLAM3) take the first camera for the left one.
[[nodiscard]] std::optional<double> second_left_of_first(const Rig& rig);

/// How far, in metres, the rig's second camera stands below the first (negative: above), where it stands more below or above
/// than to the side. Nothing where it does not, or the pose is not known.
[[nodiscard]] std::optional<double> second_below_first(const Rig& rig);
/// The same of two cameras, by their names.
[[nodiscard]] std::optional<double> second_below_first(const Rig& rig, const std::string& first, const std::string& second);

}  // namespace fca
