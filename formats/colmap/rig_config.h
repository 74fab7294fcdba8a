// SPDX-License-Identifier: BSD-3-Clause
// rig_config.json, which COLMAP's rig_configurator reads (colmap@5d968cf, scene/rig.cc, ReadRigConfig): a list of rigs, each a
// list "cameras". A camera has an image_prefix (the folder of its images), and one of each rig ref_sensor: true. The others may
// have a pose T_camera_reference as cam_from_rig_rotation [w, x, y, z] and cam_from_rig_translation [m], and all a lens:
// camera_model_name with camera_params. It specifies no image sizes.
#pragma once

#include "../fields.h"

#include <fca/diagnostics.h>
#include <fca/formats/format.h>
#include <fca/rig/rotation.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace fca::colmap {

/// T_sensor_rig of a quaternion w x y z and a translation [m]; nothing, with an error, where they are no pose.
[[nodiscard]] std::optional<Transform> read_pose(const std::vector<double>& wxyz, const std::vector<double>& translation,
                                                 const fields::Reader::Place& of_rotation,
                                                 const fields::Reader::Place& of_translation, fields::Reader& reader);
/// w x y z of the pose's rotation: of q and -q the one that is nearer to `alike`.
[[nodiscard]] std::array<double, 4> stated_quaternion(const Transform& T, const Quaternion& alike = {0.0, 0.0, 0.0, 1.0});

[[nodiscard]] ProbeResult probe_rig_config(const text::Document& document);
/// The cameras of all rigs, each named by the last folder of its prefix, or by all of it where another one's ends alike. Those
/// without a lens are in poses only.
[[nodiscard]] std::optional<Rig> read_rig_config(const text::Document& document, const ReadOptions& options,
                                                 Diagnostics& diagnostics);
/// A fresh one: the first camera that is in no rig yet is the reference of all whose poses to it are known. Nothing where a
/// camera would be alone.
[[nodiscard]] std::optional<std::string> composed_rig_config(const Rig& rig);
/// The base, which specifies `old`, with what `rig` says of the same cameras.
[[nodiscard]] text::Document edited_rig_config(const text::Document& base, const Rig& old, const Rig& rig);

}  // namespace fca::colmap
