// SPDX-License-Identifier: BSD-3-Clause
// Writing into an existing file (--into): facts of the input replace those of the file, the base.
#pragma once

#include <fca/diagnostics.h>
#include <fca/formats/format.h>
#include <fca/rig/rig.h>

#include <string>
#include <vector>

namespace fca {

/// What remains of a base because the input does not have it, and which of its cameras do not remain.
struct Kept {
  std::vector<std::string> names;     ///< The names of the rig's cameras in the result, in the rig's order.
  std::vector<std::string> replaced;  ///< Cameras of the base that a camera of the input with another name replaces.
  std::vector<std::string> cameras;
  std::vector<PoseEdge> poses;            ///< Poses of the base whose camera the input replaces by another one.
  std::optional<double> baseline_m = {};  ///< Baseline [m] of the base, if its first camera is replaced by another one.
};

/// The rig that the file is to contain. Cameras of the rig replace those of the base with the same names. If no name is in the
/// base, or with `in_order`, they replace them one by one and take the base's names, with a note. IMUs, poses, time offsets,
/// rates and topics are those of the rig where it has them, otherwise those of the base. Cameras that only the base has remain.
[[nodiscard]] Rig put_into(const Rig& base, Rig rig, bool in_order, Kept& kept, Diagnostics& diagnostics);

/// Adds notes about what was kept of the base, as far as the written files contain it (a mode may have no place for it).
void report_kept(const Kept& kept, const Written& written, Diagnostics& diagnostics);

/// True if the rig has one of the poses in `base`. A base that numbers its cameras is matched to the rig's cameras in order.
[[nodiscard]] bool has_common_pose(const Rig& base, const Rig& rig);

}  // namespace fca
