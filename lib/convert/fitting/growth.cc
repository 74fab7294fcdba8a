// SPDX-License-Identifier: BSD-3-Clause
#include "growth.h"

#include <fca/models/radtan.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fca::internal {

namespace {

/// 1 + sum over i = 1, 2, 3 of factor_i k_i r^(2 i) - tangential P r, with P = |(p1, p2)|. Both of radtan's conditions have
/// this form.
double radtan_condition(const std::array<double, 3>& factors, double tangential, const double* p, double r,
                        double* derivatives) {
  constexpr std::array<std::size_t, 3> kRadial = {4, 5, 8};  // k1, k2, k3
  constexpr std::size_t kP1 = 6;
  constexpr std::size_t kP2 = 7;
  const double r2 = r * r;
  const double length_of_p = length(p[kP1], p[kP2]);
  if (derivatives != nullptr) std::fill_n(derivatives, kParameterCount<Radtan>, 0.0);
  double value = 1.0 - tangential * length_of_p * r;
  double power = 1.0;
  for (std::size_t i = 0; i < kRadial.size(); ++i) {
    power *= r2;
    value += factors[i] * p[kRadial[i]] * power;
    if (derivatives != nullptr) derivatives[kRadial[i]] = factors[i] * power;
  }
  // At P = 0 the condition has a peak and no derivative. The derivatives with respect to p1 and p2 are then 0: a plane with
  // these derivatives touches the peak from above.
  if (derivatives != nullptr && length_of_p > 0.0) {
    for (const std::size_t i : {kP1, kP2}) derivatives[i] = -tangential * r * p[i] / length_of_p;
  }
  return value;
}

/// The condition A - 6 P r > 0, with A = d(r L) / dr and the radial factor L (radial_tangential.h).
double radial_condition(const double* p, double r, double* derivatives) {
  return radtan_condition({3.0, 5.0, 7.0}, 6.0, p, r, derivatives);
}

/// The condition (A + 3 L - 16 P r) / 4 > 0, with the same A and L. If it fails, the Jacobian may become singular at another
/// azimuth than the one that radial_condition() is about.
double azimuth_condition(const double* p, double r, double* derivatives) {
  return radtan_condition({1.5, 2.0, 2.5}, 4.0, p, r, derivatives);
}

/// Finds the x between `low` and `high` at which value_at(x) is smallest, by golden-section search. The function must have one
/// local minimum there.
template <class Function>
double minimum_between(double low, double high, const Function& value_at) {
  constexpr int kSections = 60;
  constexpr double kGoldenRatio = 0.6180339887498949;
  double left = high - kGoldenRatio * (high - low);
  double right = low + kGoldenRatio * (high - low);
  double value_at_left = value_at(left);
  double value_at_right = value_at(right);
  for (int i = 0; i < kSections; ++i) {
    if (value_at_left < value_at_right) {
      high = right;
      right = left;
      value_at_right = value_at_left;
      value_at_left = value_at(left = high - kGoldenRatio * (high - low));
    } else {
      low = left;
      left = right;
      value_at_left = value_at_right;
      value_at_right = value_at(right = low + kGoldenRatio * (high - low));
    }
  }
  return 0.5 * (low + high);
}

}  // namespace

std::span<const GrowthCondition> growth_conditions(std::string_view model) {
  static constexpr std::array<GrowthCondition, 2> kOfRadtan = {radial_condition, azimuth_condition};
  return model == Radtan::kId ? std::span<const GrowthCondition>(kOfRadtan) : std::span<const GrowthCondition>();
}

std::vector<double> minima_below(double limit, GrowthCondition condition, const double* p, double largest_r) {
  constexpr int kSteps = 64;        // dense enough to separate the minima of a polynomial of degree 6
  constexpr double kMaxFall = 0.1;  // the condition changes by less between two steps
  const auto value_at = [&](double r) { return condition(p, r, nullptr); };
  const auto r_of_step = [&](int i) { return largest_r * std::clamp(i, 0, kSteps) / kSteps; };
  std::vector<double> minima;
  for (int i = 0; i <= kSteps; ++i) {
    const double value = value_at(r_of_step(i));
    if (value > limit + kMaxFall || value_at(r_of_step(i - 1)) < value || value_at(r_of_step(i + 1)) < value) continue;
    double lowest = minimum_between(r_of_step(i - 1), r_of_step(i + 1), value_at);
    // At an end of the interval the minimum may be the end itself.
    if (value < value_at(lowest)) lowest = r_of_step(i);
    if (value_at(lowest) < limit) minima.push_back(lowest);
  }
  return minima;
}

}  // namespace fca::internal
