// SPDX-License-Identifier: BSD-3-Clause
// What a camera_info specifies and where, whatever its syntax. Reading takes its numbers, editing its nodes.
#pragma once

#include "layout.h"

#include "../fields.h"

#include <map>
#include <vector>

namespace fca::ros {

/// A matrix with the places of its numbers.
struct Numbers {
  const text::Node* place = nullptr;  ///< Of the whole, for messages.
  std::vector<const text::Node*> nodes;
  std::vector<double> values;
  [[nodiscard]] bool all_zero() const;
};

/// Null, or nothing, where the file does not say.
struct CameraInfo {
  std::string name;  ///< Empty: it says none.
  const text::Node* width = nullptr;
  const text::Node* height = nullptr;
  const text::Node* model = nullptr;
  bool counted = false;      ///< The number of coefficients says the model (.ini, which has no key for it).
  std::optional<Numbers> K;  ///< 9
  std::optional<Numbers> D;  ///< Any count; none where the file says none.
  std::optional<Numbers> R;  ///< 9
  std::optional<Numbers> P;  ///< 12
  const text::Node* roi = nullptr;
  Reduction reduction;
  std::optional<ImageSize> part;   ///< Of the roi, before binning.
  std::vector<ExtraField> extras;  ///< What it says beyond that; keys without an owner.
};

/// Is it a sensor_msgs/CameraInfo as `rostopic echo` or `ros2 topic echo` prints it (K, D, R, P in plain lists)?
[[nodiscard]] bool is_message(const text::Document& document);

/// The keys of a YAML file; nothing, with errors, where what stands under them is not what ROS's parser reads.
[[nodiscard]] std::optional<CameraInfo> find_in_yaml(fields::Reader& reader);

/// The sections of an .ini; calibrators write both cameras of a pair into one (ost.txt).
[[nodiscard]] std::optional<std::vector<CameraInfo>> find_in_ini(fields::Reader& reader);

/// Whatever the syntax is. Not empty.
[[nodiscard]] std::optional<std::vector<CameraInfo>> find_camera_infos(fields::Reader& reader);

}  // namespace fca::ros
