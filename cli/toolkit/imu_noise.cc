// SPDX-License-Identifier: BSD-3-Clause
#include "imu_noise.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fca::cli {

namespace {

constexpr std::array kKinds = {NoiseKind{"continuous", false, false}, NoiseKind{"discrete", true, false},
                               NoiseKind{"variance", false, true}, NoiseKind{"discrete-variance", true, true}};

constexpr std::array kWhite = {&Imu::gyroscope_noise_density, &Imu::accelerometer_noise_density};
constexpr std::array kWalks = {&Imu::gyroscope_random_walk, &Imu::accelerometer_random_walk};

template <class Numbers, class Change>
void change(Imu& imu, const Numbers& numbers, const Change& how) {
  for (const auto member : numbers) {
    if (imu.*member) imu.*member = how(*(imu.*member));
  }
}

}  // namespace

const NoiseKind* find_noise_kind(std::string_view name) {
  const auto* const found = std::ranges::find(kKinds, name, &NoiseKind::name);
  return found == kKinds.end() ? nullptr : found;
}

bool make_densities(const NoiseKind& kind, const std::string& input, Rig& rig, Diagnostics& diagnostics) {
  if (!kind.discrete && !kind.variance) return true;
  const std::string option = "--imu-noise " + std::string(kind.name);
  if (rig.imus.empty()) {
    diagnostics.error("imu-missing", "--imu-noise is about an IMU, and the input has none", {input, 0, 0}, "--with imu.yaml");
    return false;
  }
  for (Imu& imu : rig.imus) {
    if (kind.discrete && !imu.rate_hz) {
      diagnostics.error("imu-rate-missing", option + " needs the rate of " + imu.name + ", and nothing states it",
                        {input, 0, 0}, "add update_rate to the IMU's file");
      return false;
    }
    std::string how;
    if (kind.variance) {
      const auto root = [](double variance) { return std::sqrt(variance); };
      change(imu, kWhite, root);
      change(imu, kWalks, root);
      how = "square roots of the variances";
    }
    // White noise is sigma / sqrt(rate), a random walk's step sigma * sqrt(rate) (Kalibr's wiki, "IMU Noise Model":
    // sigma_d = sigma / sqrt(dt), sigma_bd = sigma_b sqrt(dt)).
    if (kind.discrete) {
      const double root = std::sqrt(*imu.rate_hz);
      change(imu, kWhite, [root](double sigma) { return sigma / root; });
      change(imu, kWalks, [root](double sigma) { return sigma * root; });
      how += std::string(how.empty() ? "" : ", then ") + "white noise / sqrt(rate), random walks * sqrt(rate), rate " +
             text::format_short(*imu.rate_hz) + " Hz";
    }
    diagnostics.note("imu-noise-converted", imu.name + ": made densities (" + how + ")");
  }
  return true;
}

}  // namespace fca::cli
