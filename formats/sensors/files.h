// SPDX-License-Identifier: BSD-3-Clause
// What EuRoC's and Kimera's formats share: a YAML file for each camera and one for the IMU, each a table.
#pragma once

#include "../schema/schema.h"

#include <fca/formats/format.h>

#include <string>
#include <string_view>

namespace fca::sensors {

/// A format of such files.
struct Files {
  const Format& format;
  const schema::Schema& camera;
  const schema::Schema& imu;
  const schema::Schema& whole;  ///< The keys of both.
  std::string_view file_of;     ///< Whose files they are, for people: "EuRoC".
  Code wrote = {};              ///< Headlines: of cameras, and of an IMU alone.
  Code wrote_imu = {};
  /// Of the camera of a document, of an IMU's document.
  std::string (*camera_name)(const text::Document& document);
  std::string (*imu_name)(const text::Document& document);
  /// Where a file lies in a folder of the program's own: "mav0/cam0/sensor.yaml". `base`: null where it is fresh.
  std::string (*camera_place)(const Rig& rig, std::size_t camera, const text::Document* base);
  std::string_view imu_place;
  std::string_view camera_program;  ///< Ids of the consumers that read them.
  std::string_view imu_program;
  bool demands_imu = false;  ///< Fresh files have that of an IMU, whether the input specifies one or not.
  Code imu_demands = {};     ///< Else: why an IMU has no file that lacks numbers. {0} which
};

/// The first line and the next: the one header that cv::FileStorage, PyYAML and yaml-cpp all take.
inline constexpr std::string_view kHeader = "%YAML 1.0\n---\n";

/// Noise densities at the top, and no lens.
[[nodiscard]] bool is_imu(const text::Node& root);

[[nodiscard]] std::optional<Rig> read(const Files& files, std::span<const text::Document> documents, const ReadOptions& options,
                                      Diagnostics& diagnostics);
/// Losses are listed but for what only one of the formats has.
[[nodiscard]] std::optional<Written> write(const Files& files, const text::Document* base, const Rig& rig,
                                           const WriteOptions& options, Diagnostics& diagnostics);

}  // namespace fca::sensors
