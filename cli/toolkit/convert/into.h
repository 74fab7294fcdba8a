// SPDX-License-Identifier: BSD-3-Clause
// Writing into an existing file (--into), which is called the base: facts of the input replace those of the base.
#pragma once

#include <fca/diagnostics.h>
#include <fca/formats/format.h>
#include <fca/rig/rig.h>

#include <string>
#include <vector>

namespace fca {

/// What put_into() kept of the base because the input does not have it, and which cameras of the base it replaced.
struct Kept {
  std::vector<std::string> names;         ///< The input's cameras, in their order, by their names in the result.
  std::vector<std::string> replaced;      ///< Names of the base's cameras that a camera with another name replaces.
  std::vector<std::string> cameras;       ///< Names of the base's cameras that remain.
  std::vector<PoseEdge> poses;            ///< Poses that remain although the input has another model for one of their cameras.
  std::optional<double> baseline_m = {};  ///< The baseline [m] that remains although the first camera gets another model.
};

/// Returns the rig that the file is to contain. A camera of `rig` (the input) replaces the camera of the base with the same
/// name. If no camera has the name of one in the base, or with `in_order`, the first camera of `rig` replaces the first one of
/// the base, and so on; the cameras then get the names of the base, with a note. Further cameras of `rig` are added, and
/// further cameras of the base remain. IMUs, poses, baseline, image sizes, time offsets, frame rates and topics come from `rig`
/// if it has them, otherwise from the base. Fills `kept`.
[[nodiscard]] Rig put_into(const Rig& base, Rig rig, bool in_order, Kept& kept, Diagnostics& diagnostics);

/// Adds notes about cameras, poses and a baseline that were kept of the base, if the written files contain them.
void report_kept(const Kept& kept, const Written& written, Diagnostics& diagnostics);

/// True if the poses of `rig` determine one of the poses in `base`. A base without cameras may number them (cam0, ...): these
/// numbers are then indices of the cameras in `rig`.
[[nodiscard]] bool has_common_pose(const Rig& base, const Rig& rig);

}  // namespace fca
