// SPDX-License-Identifier: BSD-3-Clause
// How Basalt's names and ours map onto each other.
#pragma once

#include <fca/formats/text/dialect.h>
#include <fca/rig/rig.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fca::basalt {

/// cereal looks a key up from the front: of equal ones the first counts, as in cv::FileStorage.
inline constexpr text::Dialect kDialect = text::Dialect::kOpenCv;
inline constexpr std::string_view kImu = "imu0";

/// Ours for a camera_type; empty if there is none.
[[nodiscard]] std::string_view model_of(std::string_view camera_type);
/// The camera_type for one of ours; empty if there is none.
[[nodiscard]] std::string_view type_of(std::string_view model);

/// pinhole-radtan8's largest radius x^2 + y^2 = rpmax^2; it has no place in our model.
inline constexpr std::string_view kMaxRadius = "rpmax";
inline constexpr double kNoMaxRadius = -1.0;

/// A noise of the IMU: Basalt's key, and what its Calibration has before it reads one (calibration.hpp, "reasonable defaults").
struct Noise {
  std::string_view key;
  std::optional<double> Imu::*member;
  double initial;
};
inline constexpr std::array kNoises = {Noise{"accel_noise_std", &Imu::accelerometer_noise_density, 0.016},
                                       Noise{"gyro_noise_std", &Imu::gyroscope_noise_density, 0.000282},
                                       Noise{"accel_bias_std", &Imu::accelerometer_random_walk, 0.001},
                                       Noise{"gyro_bias_std", &Imu::gyroscope_random_walk, 0.0001}};
inline constexpr std::string_view kRate = "imu_update_rate";
inline constexpr double kInitialRate = 200.0;

/// A list of numbers that a Rig has no member for.
struct Bias {
  std::string_view key;
  std::size_t count;
};
inline constexpr std::array kBiases = {Bias{"calib_accel_bias", 9}, Bias{"calib_gyro_bias", 12}};
inline constexpr std::string_view kVignette = "vignette";

/// All that Basalt stops without.
inline constexpr std::array<std::string_view, 12> kRequired = {
    "T_imu_cam",       "intrinsics",     "resolution",     "calib_accel_bias", "calib_gyro_bias",    "imu_update_rate",
    "accel_noise_std", "gyro_noise_std", "accel_bias_std", "gyro_bias_std",    "cam_time_offset_ns", "vignette"};

/// The time offset as Basalt counts it.
[[nodiscard]] std::int64_t nanoseconds(double seconds);
[[nodiscard]] double seconds(double nanoseconds);

[[nodiscard]] std::string camera_name(std::size_t index);

}  // namespace fca::basalt
