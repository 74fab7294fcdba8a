// SPDX-License-Identifier: BSD-3-Clause
#include "camera_losses.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <iterator>

namespace fca {

void list_camera_losses(const Rig& rig, std::string_view program, std::string_view kept_frame, std::vector<Loss>& losses) {
  const std::string no_place = "files of " + std::string(program) + " have no place for it";
  for (const Camera& camera : rig.cameras) {
    if (camera.time_offset_s.value_or(0.0) != 0.0) {
      const std::string shift = text::format_short(*camera.time_offset_s);
      losses.push_back({"time-offset-dropped", camera.name + " time offset " + shift + " s", no_place,
                        "add " + shift + " s to every image time stamp of " + camera.name});
    }
    if (!camera.topic.empty()) losses.push_back({"topic-dropped", camera.name + " " + camera.topic, no_place, ""});
    if (camera.frame_rate_hz) {
      losses.push_back(
          {"frame-rate-dropped", camera.name + " " + text::format_short(*camera.frame_rate_hz) + " Hz", no_place, ""});
    }
  }
  for (const Imu& imu : rig.imus) losses.push_back({"imu-dropped", imu.name + " noise and rate", no_place, ""});
  for (const PoseEdge& edge : rig.poses) {
    const auto is_camera = [&rig](const std::string& name) { return rig.find_camera(name) != nullptr; };
    if (!is_camera(edge.a) && !is_camera(edge.b)) continue;  // of cameras that nobody asked for
    const auto is_kept = [&](const std::string& name) { return name == kept_frame || is_camera(name); };
    if (!kept_frame.empty() && is_kept(edge.a) && is_kept(edge.b)) continue;
    losses.push_back({"pose-dropped", "T_" + edge.a + "_" + edge.b,
                      kept_frame.empty() ? no_place
                                         : "files of " + std::string(program) + " hold poses in the frame of " +
                                               std::string(kept_frame) + " alone",
                      ""});
  }
  if (rig.baseline_m) {
    losses.push_back({"baseline-dropped", "baseline " + text::format_short(*rig.baseline_m) + " m", no_place, ""});
  }
}

}  // namespace fca
