// SPDX-License-Identifier: BSD-3-Clause
// IMU noise is continuous-time densities. What people write instead (discrete deviations, variances, the walk in the noise's
// place) is told by its size: MEMS IMUs of all prices lie within two powers of ten.
#include "topics.h"

#include <fca/code.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fca::checks {

namespace {

using Member = std::optional<double> Imu::*;

/// People multiply the data sheet's numbers for SLAM, by up to as much.
constexpr double kInflation = 20.0;

/// A density and between what values those of real sensors lie, inflated ones included.
struct Density {
  Member member;
  std::string_view name;
  std::string_view unit;
  double smallest;
  double largest;
};

// From 5e-6 (navigation grade gyroscopes, 0.02 deg/s/sqrt(Hz) is 3.5e-4) to a phone's 1e-3 times 20; accelerometers from 1e-5
// to 5e-3 (500 ug/sqrt(Hz)) times 20.
constexpr std::array kNoises = {
    Density{&Imu::gyroscope_noise_density, "gyroscope noise", "rad/s/sqrt(Hz)", 2e-6, 2e-2},
    Density{&Imu::accelerometer_noise_density, "accelerometer noise", "m/s^2/sqrt(Hz)", 2e-5, 2e-1},
};

struct Swap {
  Member noise;
  Member walk;
  std::string_view sensor;
};
// An accelerometer's walk may reach its noise (EuRoC: 3e-3 over 2e-3), a gyroscope's stays ten times below it.
constexpr Swap kGyroscope = {&Imu::gyroscope_noise_density, &Imu::gyroscope_random_walk, "gyroscope"};

void check_size(const Subject& subject, const Imu& imu, const Density& density, Findings& findings) {
  const std::optional<double>& value = imu.*density.member;
  if (!value) return;
  if (*value < density.smallest) {
    findings.add(Code::kImuNoiseTooSmall, {imu.name, density.name, *value, density.unit, std::sqrt(*value)},
                 subject.places.imu(density.member));
  } else if (*value > density.largest) {
    std::vector<Message> discrete;
    if (imu.rate_hz) discrete = {{Code::kImuNoiseOfSamples, {*imu.rate_hz, *value / std::sqrt(*imu.rate_hz)}}};
    findings.add(Code::kImuNoiseTooLarge, {imu.name, density.name, *value, density.unit, discrete},
                 subject.places.imu(density.member));
  }
}

/// In the range of inflated densities a deviation looks like one.
void doubt_unit(const Subject& subject, const Imu& imu, const Density& density, Findings& findings) {
  const std::optional<double>& value = imu.*density.member;
  if (!value || !imu.rate_hz || *value > density.largest || *value <= density.largest / kInflation) return;
  if (findings.has(Code::kAnyImuSensorsSwapped, [&] { return subject.places.imu(density.member); })) return;
  findings.undecided(Code::kImuNoiseOfUnknownKind,
                     {imu.name, density.name, *value, *imu.rate_hz, *value / std::sqrt(*imu.rate_hz)});
}

void check_swapped(const Subject& subject, const Imu& imu, Findings& findings) {
  const std::optional<double>& noise = imu.*kGyroscope.noise;
  const std::optional<double>& walk = imu.*kGyroscope.walk;
  if (!noise || !walk || *walk <= *noise) return;
  findings.add(Code::kImuWalkAboveNoise, {imu.name, kGyroscope.sensor, *walk, *noise}, subject.places.imu(kGyroscope.walk));
}

void check_sensors(const Subject& subject, const Imu& imu, Findings& findings) {
  if (!imu.gyroscope_noise_density || !imu.accelerometer_noise_density) return;
  if (*imu.gyroscope_noise_density <= *imu.accelerometer_noise_density) return;
  const SourceRange where = subject.places.imu(&Imu::gyroscope_noise_density);
  if (findings.has(Code::kAnyImuNoiseTooLarge, where)) return;  // told
  findings.add(Code::kImuSensorsSwapped, {imu.name, *imu.gyroscope_noise_density, *imu.accelerometer_noise_density}, where);
}

void check_rate(const Subject& subject, const Imu& imu, Findings& findings) {
  if (!imu.rate_hz) return findings.undecided(Code::kImuNoiseOfUnknownRate, {imu.name});
  constexpr double kSlowest = 20.0;
  constexpr double kFastest = 10'000.0;
  if (*imu.rate_hz >= kSlowest && *imu.rate_hz <= kFastest) return;
  findings.add(Code::kImuRate, {imu.name, *imu.rate_hz}, subject.places.imu(&Imu::rate_hz));
}

}  // namespace

bool check_imu(const Subject& subject, Findings& findings) {
  for (const Imu& imu : subject.rig().imus) {
    if (&imu != &subject.rig().imus.front()) break;  // places are the first one's
    for (const Density& density : kNoises) check_size(subject, imu, density, findings);
    check_swapped(subject, imu, findings);
    check_sensors(subject, imu, findings);
    check_rate(subject, imu, findings);
    for (const Density& density : kNoises) doubt_unit(subject, imu, density, findings);
  }
  return !subject.rig().imus.empty();
}

bool check_time(const Subject& subject, Findings& findings) {
  bool any = false;
  for (const Camera& camera : subject.rig().cameras) {
    if (!camera.time_offset_s) continue;
    any = true;
    constexpr double kSlowFrameRate = 10.0;
    const double frame = 1.0 / camera.frame_rate_hz.value_or(kSlowFrameRate);
    const double offset = std::abs(*camera.time_offset_s);
    constexpr double kFastFrame = 1.0 / 30.0;
    if (!camera.frame_rate_hz && offset > kFastFrame && offset <= frame) {
      findings.undecided(Code::kTimeOffsetUndecided, {camera.name, *camera.time_offset_s});
    }
    if (offset <= frame) continue;
    constexpr double kMilliseconds = 1.0;
    std::vector<Message> even;
    if (!camera.frame_rate_hz) even = {{Code::kTimeOffsetOfUnknownRate}};
    std::vector<Message> unit;
    if (offset > kMilliseconds) unit = {{Code::kTimeOffsetOfMilliseconds}};
    findings.add(Code::kTimeOffsetLarge, {camera.name, *camera.time_offset_s, frame, even, unit},
                 subject.places.time_offset(camera));
  }
  return any;
}

}  // namespace fca::checks

namespace fca {

bool has_usual_noise(const Imu& imu) {
  const auto is_usual = [&imu](const checks::Density& density) {
    const std::optional<double>& value = imu.*density.member;
    return !value || (*value >= density.smallest && *value <= density.largest);
  };
  return std::ranges::all_of(checks::kNoises, is_usual);
}

}  // namespace fca
