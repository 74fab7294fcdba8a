// SPDX-License-Identifier: BSD-3-Clause
// IMU noise is continuous-time densities. What people write instead (discrete deviations, variances, the walk in the noise's
// place) is told by its size: MEMS IMUs of all prices lie within two powers of ten.
#include "topics.h"

#include <fca/formats/text/numbers.h>

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

std::string number(double value) { return text::format_short(value, 3); }

void check_size(const Subject& subject, const Imu& imu, const Density& density, Findings& findings) {
  const std::optional<double>& value = imu.*density.member;
  if (!value) return;
  const std::string what = imu.name + ": " + std::string(density.name) + " " + number(*value) + " " + std::string(density.unit);
  if (*value < density.smallest) {
    findings.add({Severity::kWarning,
                  "imu-noise-too-small",
                  what + " is smaller than any such sensor's; a variance (the square of the density, " +
                      number(std::sqrt(*value)) + ") would look so",
                  {},
                  "write the density, not its square",
                  subject.places.imu(density.member)});
  } else if (*value > density.largest) {
    const std::string discrete = imu.rate_hz ? ": a discrete deviation at " + number(*imu.rate_hz) +
                                                   " Hz would be the density " + number(*value / std::sqrt(*imu.rate_hz))
                                             : "";
    findings.add({Severity::kWarning,
                  "imu-noise-too-large",
                  what + " is larger than a cheap sensor's times 20" + discrete,
                  {},
                  "if it is a discrete deviation, divide it by sqrt(rate); if it is in degrees, multiply by pi / 180",
                  subject.places.imu(density.member)});
  }
}

/// In the range of inflated densities a deviation looks like one.
void doubt_unit(const Subject& subject, const Imu& imu, const Density& density, Findings& findings) {
  const std::optional<double>& value = imu.*density.member;
  if (!value || !imu.rate_hz || *value > density.largest || *value <= density.largest / kInflation) return;
  if (findings.has("imu-sensors-swapped", subject.places.imu(density.member))) return;
  findings.undecided("imu-noise-too-large",
                     imu.name + ": whether the " + std::string(density.name) + " " + number(*value) +
                         " is a density or one sample's deviation",
                     "a cheap sensor's density made larger for SLAM, as people do, looks the same as a deviation at " +
                         number(*imu.rate_hz) + " Hz, whose density would be " + number(*value / std::sqrt(*imu.rate_hz)));
}

void check_swapped(const Subject& subject, const Imu& imu, Findings& findings) {
  const std::optional<double>& noise = imu.*kGyroscope.noise;
  const std::optional<double>& walk = imu.*kGyroscope.walk;
  if (!noise || !walk || *walk <= *noise) return;
  findings.add({Severity::kWarning,
                "imu-walk-above-noise",
                imu.name + ": the " + std::string(kGyroscope.sensor) + "'s random walk " + number(*walk) +
                    " is larger than its noise density " + number(*noise) + "; real ones are ten times smaller and more",
                {},
                "if they stand at each other's keys, exchange them; else compare both with the data sheet",
                subject.places.imu(kGyroscope.walk)});
}

void check_sensors(const Subject& subject, const Imu& imu, Findings& findings) {
  if (!imu.gyroscope_noise_density || !imu.accelerometer_noise_density) return;
  if (*imu.gyroscope_noise_density <= *imu.accelerometer_noise_density) return;
  const SourceRange where = subject.places.imu(&Imu::gyroscope_noise_density);
  if (findings.has("imu-noise-too-large", where)) return;  // told
  findings.add(
      {Severity::kWarning,
       "imu-sensors-swapped",
       imu.name + ": the gyroscope's noise " + number(*imu.gyroscope_noise_density) + " is larger than the accelerometer's " +
           number(*imu.accelerometer_noise_density) + "; in SI units it is ten times smaller",
       {},
       "exchange the two sensors' numbers if they are exchanged; multiply by pi / 180 if the gyroscope's is in degrees",
       where});
}

void check_rate(const Subject& subject, const Imu& imu, Findings& findings) {
  if (!imu.rate_hz) {
    findings.undecided("imu-noise-too-large", imu.name + ": noise densities against discrete deviations",
                       "the file states no rate");
    return;
  }
  constexpr double kSlowest = 20.0;
  constexpr double kFastest = 10'000.0;
  if (*imu.rate_hz >= kSlowest && *imu.rate_hz <= kFastest) return;
  findings.add({Severity::kWarning,
                "imu-rate",
                imu.name + ": a rate of " + number(*imu.rate_hz) + " Hz is no IMU's",
                {},
                "it is in Hz (200.0), not a period",
                subject.places.imu(&Imu::rate_hz)});
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
      findings.undecided(
          "time-offset-large",
          camera.name + ": whether a time offset of " + number(*camera.time_offset_s) + " s is longer than a frame",
          "the file states no frame rate");
    }
    if (offset <= frame) continue;
    constexpr double kMilliseconds = 1.0;
    findings.add({Severity::kWarning,
                  "time-offset-large",
                  camera.name + ": a time offset of " + number(*camera.time_offset_s) + " s is longer than a frame (" +
                      number(frame) + " s" + (camera.frame_rate_hz ? ")" : " even at 10 Hz; the file states no rate)") +
                      (offset > kMilliseconds ? "; are these milliseconds?" : ""),
                  {},
                  "it is in seconds: t_imu = t_cam + offset; one as long as that should be taken out of the time stamps",
                  subject.places.time_offset(camera)});
  }
  return any;
}

}  // namespace fca::checks
