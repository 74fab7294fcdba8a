// SPDX-License-Identifier: BSD-3-Clause
// How the cameras of a rig are rectified: what R and P of their files are to say.
#pragma once

#include "layout.h"

#include <map>
#include <string>
#include <vector>

namespace fca::ros {

/// R and P of one camera; R the identity and P [K | 0] where nothing else is known.
struct Rectified {
  Matrix3 R = kIdentity;
  Projection P{};
  bool stated = false;  ///< P's image is one that a file stated for this camera, next to K.
};

struct Rectification {
  std::vector<Rectified> cameras;  ///< As in the rig.
  /// The first two cameras are a pair whose rectified image nobody stated: it was chosen here.
  bool chosen = false;
  /// They are Rig::rectified's.
  bool stated = false;
  /// They stand one above the other, and nobody stated that they are a pair: stereo_image_proc matches along rows.
  bool is_vertical = false;
  /// The pose of a chosen pair is no exact rotation; the nearest one was taken: T_second_first as the files say it.
  std::optional<PoseEdge> restated;
};

/// R and P are those of the pair that the rig specifies (Rig::rectified), or its files (`extra_fields` and poses in rectified
/// frames), where these still agree with the poses of the rig; else of two cameras next to each other that see something in
/// common: both turned by half the rotation between them, and then so that their rows lie along the baseline. Further cameras
/// are rectified alone.
[[nodiscard]] Rectification rectification_of(const Rig& rig);

/// Of a rig whose files are all read: two cameras in one rectified frame, the first of them its origin, are a rectified pair.
void find_rectified_pair(Rig& rig);

}  // namespace fca::ros
