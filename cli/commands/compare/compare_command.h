// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/application.h"
#include "options/compare.h"
#include "shell/console.h"

#include <fca/toolkit/compare.h>

#include <string>
#include <vector>

namespace fca::cli {

void add_compare_command(Application& application);

/// In one line what matters most, mistakes first, else the largest differences; or why nothing was compared.
[[nodiscard]] std::string verdict_of(const ComparedFile& compared);
/// "0.31 deg: its rays lie 0.3 to the right and 0.08 up": how the rays of a camera lie that is turned by that vector
/// (BestRotation). At a distance also where its projection centre is: "; its projection centre is x 1.2, y -0.3, z 4 mm from
/// REF's, for points 2 m away".
[[nodiscard]] std::string rotation_in_words(const BestRotation& rotation);

/// "the same camera up to 83.2 deg from the axis (within 0.25 px)"
[[nodiscard]] std::string same_in_words(const CameraDifference& difference);
/// "cam0: turned by 0.369 deg, and its poses turn back: they cancel; 0.54 px rms remain", of a camera with turn_cancels.
[[nodiscard]] std::string cancelled_turn_in_words(const CameraComparison& camera);
/// Does the best rotation bring the two nearer to each other, where rays count?
[[nodiscard]] bool turning_helps(const CameraComparison& camera);

/// "cam0", or "cam0 and left"
[[nodiscard]] std::string names_of(const CameraComparison& camera);
/// A table of those parameters, poses and other numbers that differ.
[[nodiscard]] std::string numbers_text(const RigComparison& comparison);
/// `with_bands`: the errors over the angle from the axis, too.
[[nodiscard]] std::string compare_text(const ReferenceFile& reference, const ComparedFile& compared, bool with_bands);
[[nodiscard]] std::string compare_json(const ReferenceFile& reference, const std::vector<ComparedFile>& files,
                                       const Console& console);

}  // namespace fca::cli
