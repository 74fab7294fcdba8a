// SPDX-License-Identifier: BSD-3-Clause
#include "fact_comparison.h"

#include <fca/code.h>
#include <fca/rig/rotation.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fca::internal {

namespace {

struct Density {
  std::optional<double> Imu::*member;
  const char* name;
  const char* unit;
  bool walk;  ///< Its step per sample shrinks with the rate, where white noise grows.
};
constexpr std::array kDensities = {
    Density{&Imu::gyroscope_noise_density, "gyroscope noise", "rad/s/sqrt(Hz)", false},
    Density{&Imu::gyroscope_random_walk, "gyroscope random walk", "rad/s^2/sqrt(Hz)", true},
    Density{&Imu::accelerometer_noise_density, "accelerometer noise", "m/s^2/sqrt(Hz)", false},
    Density{&Imu::accelerometer_random_walk, "accelerometer random walk", "m/s^3/sqrt(Hz)", true},
};

struct Fact {
  std::string owner;  ///< The reference's name.
  std::string name;
  std::string unit;
  std::optional<double> reference;
  std::optional<double> other;
};

void add(const Fact& fact, RigComparison& result) {
  if (fact.reference && fact.other) {
    result.facts.push_back({fact.owner, fact.name, fact.unit, *fact.reference, *fact.other});
  } else if (fact.reference || fact.other) {
    (fact.reference ? result.only_in_reference : result.only_in_other)
        .push_back(fact.owner.empty() ? Message{Code::kOnlyThing, {fact.name}}
                                      : Message{Code::kOnlyFact, {fact.owner, fact.name}});
  }
}

/// Is b as near to a as a number that was printed with three digits is to itself?
bool near(double a, double b) {
  constexpr double kPrinted = 0.005;
  return std::abs(a - b) <= kPrinted * std::abs(a);
}

void find_wrong_sign(const Camera& reference, const Camera& other, RigComparison& result) {
  if (!reference.time_offset_s || !other.time_offset_s || *reference.time_offset_s == 0.0) return;
  if (!near(*reference.time_offset_s, -*other.time_offset_s)) return;
  result.mistakes.push_back({{Code::kTimeOffsetOfOtherSign, {other.name}}});
}

/// The mistake by which the reference's density becomes the other's.
struct NoiseMistake {
  Code code;
  double (*made)(double density, double root_rate, bool walk);
};
constexpr std::array kNoiseMistakes = {
    NoiseMistake{Code::kNoiseDiscrete,
                 [](double density, double root_rate, bool walk) { return walk ? density / root_rate : density * root_rate; }},
    NoiseMistake{Code::kNoiseDividedByRate,
                 [](double density, double root_rate, bool walk) { return walk ? density * root_rate : density / root_rate; }},
    NoiseMistake{Code::kNoiseVariance, [](double density, double, bool) { return density * density; }},
    NoiseMistake{Code::kNoiseOfVariances, [](double density, double, bool) { return std::sqrt(density); }},
};

/// A mistake that explains every density that differs.
void find_noise_mistake(const Imu& reference, const Imu& other, RigComparison& result) {
  const std::optional<double> rate = other.rate_hz ? other.rate_hz : reference.rate_hz;
  for (const NoiseMistake& mistake : kNoiseMistakes) {
    bool explains = true;
    std::vector<std::string> which;
    for (const Density& density : kDensities) {
      const std::optional<double>& right = reference.*density.member;
      const std::optional<double>& left = other.*density.member;
      if (!right || !left || near(*right, *left)) continue;
      // sqrt(NaN) explains nothing: a mistake that asks for the rate needs one.
      const double made = mistake.made(*right, std::sqrt(rate.value_or(std::nan(""))), density.walk);
      explains = explains && near(made, *left);
      which.emplace_back(density.name);
    }
    if (!explains || which.empty()) continue;
    result.mistakes.push_back({{mistake.code, {other.name, which}}});
    return;
  }
}

/// Of a rectified pair, or how far the second camera is from the first.
std::optional<double> baseline_of(const Rig& rig) {
  if (rig.baseline_m || rig.cameras.size() != 2) return rig.baseline_m;
  const std::optional<Transform> T = rig.resolve(rig.cameras[0].name, rig.cameras[1].name);
  return T ? std::optional(distance_of(*T)) : std::nullopt;
}

void compare_baselines(const Rig& reference, const Rig& other, RigComparison& result) {
  if (!reference.baseline_m && !other.baseline_m) return;
  const Fact fact = {"", "baseline", "m", baseline_of(reference), baseline_of(other)};
  add(fact, result);
  if (!fact.reference || !fact.other) return;
  constexpr double kMillimetres = 1000.0;
  if (near(*fact.reference * kMillimetres, *fact.other)) {
    result.mistakes.push_back({{Code::kBaselineInMillimetres, {"the baseline"}}});
  } else if (near(*fact.reference, *fact.other * kMillimetres)) {
    result.mistakes.push_back({{Code::kBaselineTooSmall, {"the baseline"}}});
  }
}

}  // namespace

void compare_facts(const Rig& reference, const Rig& other, const Matching& matching, RigComparison& result) {
  for (const Match& match : matching.cameras) {
    const Camera& right = reference.cameras[match.reference];
    const Camera& left = other.cameras[match.other];
    add({right.name, "time offset", "s", right.time_offset_s, left.time_offset_s}, result);
    add({right.name, "frame rate", "Hz", right.frame_rate_hz, left.frame_rate_hz}, result);
    find_wrong_sign(right, left, result);
  }
  for (const Match& match : matching.imus) {
    const Imu& right = reference.imus[match.reference];
    const Imu& left = other.imus[match.other];
    for (const Density& density : kDensities)
      add({right.name, density.name, density.unit, right.*density.member, left.*density.member}, result);
    add({right.name, "rate", "Hz", right.rate_hz, left.rate_hz}, result);
    find_noise_mistake(right, left, result);
  }
  compare_baselines(reference, other, result);
}

}  // namespace fca::internal
