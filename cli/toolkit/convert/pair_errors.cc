// SPDX-License-Identifier: BSD-3-Clause
#include "pair_errors.h"

#include "stereo_cameras.h"

#include <fca/rig/contradictions.h>

namespace fca {

std::optional<PairError> pair_error_of(const Rig& input, const ConvertResult& result) {
  const std::optional<StereoCameras> pair = stereo_cameras(input, result.cameras);
  if (!pair) return std::nullopt;
  const ConvertedCamera& first = result.cameras[pair->first];
  const ConvertedCamera& second = result.cameras[pair->second];
  Rig files;
  files.poses = result.poses;
  const std::optional<Transform> T_written = files.resolve(second.source.name, first.source.name);
  if (!T_written) return std::nullopt;
  // If poses of the input contradict each other, its pose of the pair may be wrong: use the written pose for both.
  const bool is_doubtful = !contradictions(input).empty();
  return pair_error({first.source, first.target.model}, {second.source, second.target.model},
                    is_doubtful ? *T_written : pair->T_second_first, *T_written);
}

}  // namespace fca
