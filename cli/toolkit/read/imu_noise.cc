// SPDX-License-Identifier: BSD-3-Clause
#include "imu_noise.h"

#include <fca/code.h>

#include <array>
#include <cmath>

namespace fca {

namespace {

bool is_discrete(NoiseKind kind) { return kind == NoiseKind::kDiscrete || kind == NoiseKind::kDiscreteVariance; }
bool is_variance(NoiseKind kind) { return kind == NoiseKind::kVariance || kind == NoiseKind::kDiscreteVariance; }

constexpr std::array kNoiseDensities = {&Imu::gyroscope_noise_density, &Imu::accelerometer_noise_density};
constexpr std::array kRandomWalks = {&Imu::gyroscope_random_walk, &Imu::accelerometer_random_walk};

/// Replaces those of the given members of an IMU that are set by their changed values.
template <class Members, class Change>
void change_values(Imu& imu, const Members& members, const Change& changed) {
  for (const auto member : members) {
    if (imu.*member) imu.*member = changed(*(imu.*member));
  }
}

}  // namespace

std::string_view name_of(NoiseKind kind) {
  constexpr std::array<std::string_view, 4> kNames = {"continuous", "discrete", "variance", "discrete-variance"};
  return kNames.at(static_cast<std::size_t>(kind));
}

bool set_imu_rate(double rate_hz, const std::string& input, Rig& rig, Diagnostics& diagnostics) {
  if (rig.imus.empty()) diagnostics.add(Code::kRateWithoutImu, {}, {input, 0, 0});
  for (Imu& imu : rig.imus) {
    if (imu.rate_hz.value_or(rate_hz) != rate_hz) {
      diagnostics.add(Code::kRateContradicts, {imu.name, *imu.rate_hz, rate_hz}, {input, 0, 0});
      return false;
    }
    imu.rate_hz = rate_hz;
  }
  return !rig.imus.empty();
}

bool make_densities(NoiseKind kind, const std::string& input, Rig& rig, Diagnostics& diagnostics) {
  if (kind == NoiseKind::kContinuous) return true;
  if (rig.imus.empty()) {
    diagnostics.add(Code::kNoiseWithoutImu, {}, {input, 0, 0});
    return false;
  }
  for (Imu& imu : rig.imus) {
    if (is_discrete(kind) && !imu.rate_hz) {
      diagnostics.add(Code::kNoiseWithoutRate, {name_of(kind), imu.name}, {input, 0, 0});
      return false;
    }
    Message steps;
    if (is_variance(kind)) {
      const auto root = [](double variance) { return std::sqrt(variance); };
      change_values(imu, kNoiseDensities, root);
      change_values(imu, kRandomWalks, root);
      steps = {Code::kRootsOfVariances};
    }
    // The density of white noise is sigma_d / sqrt(rate), and the density of a random walk is sigma_bd * sqrt(rate). Source:
    // Kalibr's wiki, "IMU Noise Model" (sigma_d = sigma / sqrt(dt), sigma_bd = sigma_b sqrt(dt)).
    if (is_discrete(kind)) {
      const double root = std::sqrt(*imu.rate_hz);
      change_values(imu, kNoiseDensities, [root](double sigma) { return sigma / root; });
      change_values(imu, kRandomWalks, [root](double sigma) { return sigma * root; });
      const Message by_rate = {Code::kByRate, {*imu.rate_hz}};
      steps = steps.is_said() ? Message{Code::kRootsThenRate, {by_rate}} : by_rate;
    }
    diagnostics.add(Code::kDensitiesMade, {imu.name, steps});
  }
  return true;
}

}  // namespace fca
