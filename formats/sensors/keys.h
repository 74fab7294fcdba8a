// SPDX-License-Identifier: BSD-3-Clause
// Rows that EuRoC's and Kimera's files share, and how they are one table.
#pragma once

#include "../schema/keys.h"

#include <fca/code.h>

#include <array>

namespace fca::sensors {

/// T_imu_camera: the body is the IMU.
inline constexpr schema::PoseLayout kPoseInBody = {.frame = schema::kImu,
                                                   .kind = FrameKind::kImu,
                                                   .translation = {},
                                                   .rotation = {},
                                                   .in_frame = Code::kTablePoseInFrame,
                                                   .identity = Code::kTableIdentity};

inline constexpr std::array kPoseKeys = {schema::side_of_four("cols"), schema::side_of_four("rows"), schema::unread("dt"),
                                         schema::required(schema::matrix("data", "T_BS", kPoseInBody))};
inline constexpr schema::Mapping kPose = {.keys = kPoseKeys};

/// That of the IMU.
inline constexpr std::array kIdentityKeys = {schema::side_of_four("cols"), schema::side_of_four("rows"), schema::unread("dt"),
                                             schema::required(schema::identity("data"))};
inline constexpr schema::Mapping kIdentity = {.keys = kIdentityKeys};

inline constexpr std::array<ParameterId, 4> kRadtan = {"k1", "k2", "p1", "p2"};
inline constexpr std::array<ParameterId, 4> kEquidistant = {"k1", "k2", "k3", "k4"};
inline constexpr std::array<ParameterId, 1> kNoK3 = {"k3"};
inline constexpr std::array kNoK3Range = {ParameterRange{"k3", 0.0, 0.0}};

/// The noise of an IMU; what a fresh file says of numbers that nothing specifies.
struct Noise {
  double gyroscope = 0.0;
  double gyroscope_walk = 0.0;
  double accelerometer = 0.0;
  double accelerometer_walk = 0.0;
};
constexpr std::array<schema::Key, 4> noise_keys(const Noise& initial) {
  return {schema::imu_number("gyroscope_noise_density", &Imu::gyroscope_noise_density, initial.gyroscope),
          schema::imu_number("gyroscope_random_walk", &Imu::gyroscope_random_walk, initial.gyroscope_walk),
          schema::imu_number("accelerometer_noise_density", &Imu::accelerometer_noise_density, initial.accelerometer),
          schema::imu_number("accelerometer_random_walk", &Imu::accelerometer_random_walk, initial.accelerometer_walk)};
}

/// Lists of rows, one after the other.
template <std::size_t... kSizes>
constexpr auto joined(const std::array<schema::Key, kSizes>&... lists) {
  std::array<schema::Key, (kSizes + ...)> keys{};
  auto* at = keys.data();
  const auto append = [&at](const auto& list) {
    for (const schema::Key& key : list) *at++ = key;
  };
  (append(lists), ...);
  return keys;
}

inline constexpr schema::Codes kCodes = {.wrong_syntax = Code::kTableWrongSyntax,
                                         .no_object = Code::kTableNoObject,
                                         .unknown_lens = Code::kTableUnknownLens,
                                         .coefficient_count = Code::kTableCoefficientCount,
                                         .not_four = Code::kTableSideNotFour,
                                         .no_identity = Code::kTableNoIdentity,
                                         .no_size = Code::kTableNoSize,
                                         .initial_value = Code::kKimeraInitialValue,
                                         .one_offset = Code::kKimeraOneOffset,
                                         .further_imu = Code::kTableFurtherImu};

}  // namespace fca::sensors
