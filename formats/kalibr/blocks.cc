// SPDX-License-Identifier: BSD-3-Clause
#include "blocks.h"
#include "layout.h"
#include "poses.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>

namespace fca::kalibr {

namespace {

std::vector<double> slot_values(const CameraModel& model, std::span<const Slot> slots) {
  std::vector<double> values;
  for (const Slot& slot : slots) {
    values.push_back(slot.parameter ? parameter(model, *slot.parameter).value() : slot.constant);
  }
  return values;
}

}  // namespace

std::vector<fields::Field> camera_fields(const Rig& rig, std::size_t index, const std::optional<fields::Field>& overlaps) {
  std::vector<fields::Field> result;
  const auto add_pose = [&](std::string_view key, const std::string& to) {
    if (const std::optional<Transform> T = pose_in(rig, rig.cameras[index].name, to))
      result.push_back(fields::rows(std::string(key), *T));
  };
  add_pose("T_cam_imu", "imu0");
  if (index > 0) add_pose("T_cn_cnm1", rig.cameras[index - 1].name);
  if (overlaps) result.push_back(*overlaps);
  const std::vector<fields::Field> lens = lens_fields(rig.cameras[index]);
  result.insert(result.end(), lens.begin(), lens.end());
  return result;
}

std::vector<fields::Field> lens_fields(const Camera& camera) {
  const Layout& layout = *layout_for(camera.model);
  std::vector<fields::Field> result;
  result.push_back(fields::scalar("camera_model", std::string(layout.camera_model)));
  result.push_back(fields::list("distortion_coeffs", slot_values(camera.model, layout.coefficients)));
  result.push_back(fields::scalar("distortion_model", std::string(layout.distortion_model)));
  result.push_back(fields::list("intrinsics", slot_values(camera.model, layout.intrinsics)));
  if (camera.image_size) {
    fields::Field size{"resolution", fields::Shape::kList, {}, 0, {}};
    size.tokens = {std::to_string(camera.image_size->width), std::to_string(camera.image_size->height)};
    result.push_back(std::move(size));
  }
  // Kalibr asks for the topic as soon as it opens a bag; a plain path needs no quotes, anything else gets them.
  const bool plain = !camera.topic.empty() && std::ranges::all_of(camera.topic, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '/' || c == '_';
  });
  if (!camera.topic.empty())
    result.push_back(fields::scalar("rostopic", plain && camera.topic[0] == '/' ? camera.topic : fields::quote(camera.topic)));
  if (camera.time_offset_s) result.push_back(fields::real("timeshift_cam_imu", *camera.time_offset_s));
  return result;
}

std::vector<fields::Field> imu_fields(const Imu& imu) {
  std::vector<fields::Field> result;
  const auto add = [&result](std::string_view key, const std::optional<double>& value) {
    if (value) result.push_back(fields::real(std::string(key), *value));
  };
  add("accelerometer_noise_density", imu.accelerometer_noise_density);
  add("accelerometer_random_walk", imu.accelerometer_random_walk);
  add("gyroscope_noise_density", imu.gyroscope_noise_density);
  add("gyroscope_random_walk", imu.gyroscope_random_walk);
  if (!imu.topic.empty()) result.push_back(fields::quoted("rostopic", imu.topic));
  add("update_rate", imu.rate_hz);
  return result;
}

}  // namespace fca::kalibr
