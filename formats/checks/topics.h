// SPDX-License-Identifier: BSD-3-Clause
// Private: the checks, one topic each. They look at a file that was read, and return whether it had anything for them to look
// at. A new topic is a function here, its file, and a row in check.cc.
#pragma once

#include "subject.h"

namespace fca::checks {

[[nodiscard]] bool check_image(const Subject& subject, Findings& findings);
[[nodiscard]] bool check_lens(const Subject& subject, Findings& findings);
[[nodiscard]] bool check_family(const Subject& subject, Findings& findings);
[[nodiscard]] bool check_undistortion(const Subject& subject, Findings& findings);
[[nodiscard]] bool check_rotations(const Subject& subject, Findings& findings);
[[nodiscard]] bool check_distances(const Subject& subject, Findings& findings);
[[nodiscard]] bool check_redundant_poses(const Subject& subject, Findings& findings);
[[nodiscard]] bool check_imu(const Subject& subject, Findings& findings);
[[nodiscard]] bool check_time(const Subject& subject, Findings& findings);
[[nodiscard]] bool check_ocamcalib(const Subject& subject, Findings& findings);
[[nodiscard]] bool check_orbslam3(const Subject& subject, Findings& findings);
[[nodiscard]] bool check_stella(const Subject& subject, Findings& findings);

/// Who reads the bytes? A program that refuses them is a finding at the place that it stumbles over, with the fix where one is
/// certain. `calibration`: null if the file could not be read.
void check_programs(const text::Document& document, const Format& format, const Calibration* calibration,
                    const CheckOptions& options, CheckReport& report);

}  // namespace fca::checks
