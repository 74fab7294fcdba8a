// SPDX-License-Identifier: BSD-3-Clause
#include "pair_errors.h"

#include <fca/rig/contradictions.h>
#include <fca/rig/stereo_pair.h>

#include <algorithm>

namespace fca {

std::optional<PairError> pair_error_of(const Rig& input, const ConvertResult& result) {
  Rig rig;
  rig.poses = input.poses;
  for (const ConvertedCamera& camera : result.cameras) {
    if (camera.source.rays.empty() && camera.source.image_size) rig.cameras.push_back(camera.source);
  }
  const auto places = stereo_pair(rig);
  if (!places) return std::nullopt;
  const Camera& first = rig.cameras[places->first];
  const Camera& second = rig.cameras[places->second];
  const auto written = [&result](const Camera& source) -> const CameraModel& {
    const auto found = std::ranges::find_if(result.cameras,
                                            [&source](const ConvertedCamera& each) { return each.source.name == source.name; });
    return found->target.model;
  };
  Rig files;
  files.poses = result.poses;
  const std::optional<Transform> T = rig.resolve(second.name, first.name);
  const std::optional<Transform> T_written = files.resolve(second.name, first.name);
  if (!T || !T_written) return std::nullopt;
  // Which of two statements is the pose, the verdict on contradictions says.
  const bool is_doubtful = !contradictions(input).empty();
  return pair_error({first, written(first)}, {second, written(second)}, is_doubtful ? *T_written : *T, *T_written);
}

}  // namespace fca
