// SPDX-License-Identifier: BSD-3-Clause
// Private: what the files that a verdict is about state. Without files (a check) that is all of the rig.
#pragma once

#include <fca/formats/verdict.h>
#include <fca/rig/contradictions.h>

#include <string>

namespace fca {

/// Does what is written say where the cameras stand?
[[nodiscard]] bool states_poses(const VerdictFacts& facts);

/// Does one of the written files hold the camera?
[[nodiscard]] bool is_written(const std::string& camera, const VerdictFacts& facts);

/// Is the finding about a pose that no written file specifies, by its name, or about poses where none is specified?
[[nodiscard]] bool is_of_unwritten_pose(const Finding& finding, const VerdictFacts& facts);

/// Which of two statements of a pose the written files have, a clause; none where they have neither, or nothing is written.
[[nodiscard]] Message written_statement(const Contradiction& contradiction, const VerdictFacts& facts);

}  // namespace fca
