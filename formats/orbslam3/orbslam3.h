// SPDX-License-Identifier: BSD-3-Clause
// ORB-SLAM3 settings: V1.0, the older style of ORB-SLAM2 and early ORB-SLAM3, and the dialects of two forks for EUCM and Double
// Sphere. Layout of the keys: layout.h. Which parser runs and what it demands: consumers/orbslam3*.cc.
#pragma once

#include <fca/formats/format.h>

namespace fca::orbslam3 {

extern const Format kFormat;

[[nodiscard]] std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options,
                                      Diagnostics& diagnostics);
/// In a fresh file: two in the modes with two cameras. Mode "": the richest that the rig serves; layout "": V1.0's.
[[nodiscard]] std::size_t cameras_held(const Rig& rig, std::string_view mode, std::string_view layout);
[[nodiscard]] std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                                           Diagnostics& diagnostics);

}  // namespace fca::orbslam3
