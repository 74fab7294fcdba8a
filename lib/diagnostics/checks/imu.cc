// SPDX-License-Identifier: BSD-3-Clause
// What a check finds about an IMU's numbers and about time.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

constexpr std::string_view kTooLarge = "imu-noise-too-large";
constexpr std::string_view kOffset = "time-offset-large";

}  // namespace

std::span<const CodeInfo> imu_codes() {
  static constexpr std::array kRows = {
      warning(Code::kImuNoiseTooSmall, "imu-noise-too-small",
              "{0}: {1} {2:.3} {3} is smaller than any such sensor's; it may be a variance, the square of the density {4:.3}",
              "write the density, not its square"),
      warning(Code::kImuNoiseTooLarge, kTooLarge, "{0}: {1} {2:.3} {3} is more than 20 times a cheap sensor's{4}",
              "if it is the standard deviation of one sample, divide it by sqrt(rate); if it is in degrees, multiply it by pi "
              "/ 180"),
      warning(Code::kImuNoiseOfSamples, kTooLarge,
              "; as the standard deviation of one sample at {0:.3} Hz it would be the density {1:.3}"),
      question(Code::kImuNoiseOfUnknownKind, kTooLarge,
               "{0}: whether the {1} {2:.3} is a density or the standard deviation of one sample",
               "many people enlarge a cheap sensor's density for SLAM; it then looks like the standard deviation of one sample "
               "at {3:.3} Hz, of a sensor with the density {4:.3}"),
      question(Code::kImuNoiseOfUnknownRate, kTooLarge,
               "{0}: whether the noise is densities or standard deviations of single samples", "the file contains no rate"),
      warning(Code::kImuWalkAboveNoise, "imu-walk-above-noise",
              "{0}: the {1}'s random walk {2:.3} is larger than its noise density {3:.3}; real random walks are at least ten "
              "times smaller",
              "if the two numbers are exchanged, exchange them back; otherwise compare both with the data sheet"),
      warning(
          Code::kImuSensorsSwapped, "imu-sensors-swapped",
          "{0}: the gyroscope's noise {1:.3} is larger than the accelerometer's {2:.3}; in SI units it is ten times smaller",
          "if the two sensors' numbers are exchanged, exchange them back; if the gyroscope's is in degrees, multiply it by pi "
          "/ 180"),
      warning(Code::kImuRate, "imu-rate", "{0}: no IMU has a rate of {1:.3} Hz",
              "write the rate in Hz (200.0), not the period"),
      warning(Code::kTimeOffsetLarge, kOffset, "{0}: a time offset of {1:.3} s is longer than a frame ({2:.3} s{3}){4}",
              "write it in seconds: t_imu = t_cam + offset; remove a real offset of that length from the time stamps"),
      warning(Code::kTimeOffsetOfUnknownRate, kOffset, " even at 10 Hz; the file contains no rate"),
      warning(Code::kTimeOffsetOfMilliseconds, kOffset, "; are these milliseconds?"),
      question(Code::kTimeOffsetUndecided, kOffset, "{0}: whether a time offset of {1:.3} s is longer than a frame",
               "the file contains no frame rate"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
