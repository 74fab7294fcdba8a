// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/opencv14.h>

#include "../../convert/bound/polar_terms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fca {

namespace internal {
namespace {

/// A trigonometric polynomial of the azimuth: a series for each of 1, cos phi, sin phi, cos 2phi, ..., none beyond
/// kTiltedHarmonics.
class Waves {
 public:
  Waves() = default;
  Waves(const std::array<Series, kHarmonics>& of, const std::array<bool, kHarmonics>& used) {
    for (std::size_t j = 0; j < kHarmonics; ++j) {
      if (used[j]) add(j, of[j]);
    }
  }

  void add(std::size_t harmonic, const Series& series) {
    of_[harmonic] = used_[harmonic] ? of_[harmonic] + series : series;
    used_[harmonic] = true;
  }

  friend Waves operator*(const Ball& a, Waves b) {
    for (std::size_t j = 0; j < kTiltedHarmonics; ++j) {
      if (b.used_[j]) b.of_[j] = a * b.of_[j];
    }
    return b;
  }
  friend Waves operator+(Waves a, const Waves& b) {
    for (std::size_t j = 0; j < kTiltedHarmonics; ++j) {
      if (b.used_[j]) a.add(j, b.of_[j]);
    }
    return a;
  }
  friend Waves operator*(const Waves& a, const Waves& b) {
    Waves product;
    for (std::size_t i = 0; i < kTiltedHarmonics; ++i) {
      for (std::size_t j = 0; j < kTiltedHarmonics; ++j) {
        if (a.used_[i] && b.used_[j]) product.add_product(i, j, a.of_[i] * b.of_[j]);
      }
    }
    return product;
  }

  /// No value for any azimuth, and any angle of the ball, is larger.
  [[nodiscard]] double magnitude() const {
    const auto size = [this](std::size_t harmonic) { return used_[harmonic] ? of_[harmonic][0].magnitude() : 0.0; };
    double sum = size(0);
    for (std::size_t j = 1; j < kTiltedHarmonics; j += 2) sum += std::hypot(size(j), size(j + 1));
    return sum * (1.0 + 1e-12);
  }

  void store(std::array<Series, kTiltedHarmonics>& of, std::array<bool, kTiltedHarmonics>& used) const {
    of = of_;
    used = used_;
  }

 private:
  static bool is_sine(std::size_t harmonic) { return harmonic > 0 && harmonic % 2 == 0; }

  /// cos a cos b = (cos(a - b) + cos(a + b)) / 2 and its like.
  void add_product(std::size_t i, std::size_t j, const Series& series) {
    if (i == 0 || j == 0) return add(std::max(i, j), series);
    const std::size_t a = frequency_of(i);
    const std::size_t b = frequency_of(j);
    const std::size_t difference = a > b ? a - b : b - a;
    const Series half = exactly(0.5) * series;
    const Series minus = exactly(-0.5) * series;
    if (is_sine(i) == is_sine(j)) {
      add(difference == 0 ? 0 : 2 * difference - 1, half);
      add(2 * (a + b) - 1, is_sine(i) ? minus : half);
      return;
    }
    add(2 * (a + b), half);
    // sin(a - b), of the sine's frequency first
    const bool is_negative = (is_sine(i) ? a : b) < (is_sine(i) ? b : a);
    if (difference > 0) add(2 * difference, is_negative ? minus : half);
  }

  std::array<Series, kTiltedHarmonics> of_{};
  std::array<bool, kTiltedHarmonics> used_{};
};

}  // namespace
}  // namespace internal

void Opencv14::polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form) {
  using internal::Series;
  Rational::polar_form(p, angle, form);
  const Series r = angle.sine / angle.cosine;
  add_prism(form, p, {p[12], p[13]}, {p[14], p[15]}, r * r);
}

void Opencv14::polar_form(const double* p, const internal::AngleSeries& angle, internal::TiltedPolarSeries& form) {
  using internal::Ball;
  using internal::exactly;
  using internal::from_library;
  using internal::PolarSeries;
  using internal::Waves;
  std::array<double, kParameters.size()> plane = {1.0, 1.0, 0.0, 0.0};
  std::copy(p + 4, p + plane.size(), plane.begin() + 4);
  PolarSeries distorted;
  polar_form(plane.data(), angle, distorted);
  const Waves mx(distorted.of[0], distorted.used[0]);
  const Waves my(distorted.of[1], distorted.used[1]);
  const Ball sx = from_library(std::sin(p[16]));
  const Ball cx = from_library(std::cos(p[16]));
  const Ball sy = from_library(std::sin(p[17]));
  const Ball cy = from_library(std::cos(p[17]));
  const Ball at_centre = inverse(cx * cy);
  const Waves x = (cx * at_centre) * mx;
  const Waves y = (cy * at_centre) * my + (exactly(-1.0) * sx * sy * at_centre) * mx;
  const Waves w = (sy * at_centre) * mx + (exactly(-1.0) * sx * cy * at_centre) * my;
  Waves one;
  one.add(0, constant(exactly(1.0)));
  // 1 - w (1 - w (1 - w))
  const Waves minus_w = exactly(-1.0) * w;
  const Waves inverse_plane = one + minus_w * (one + minus_w * (one + minus_w));
  const double largest = w.magnitude();
  const double rest = largest < 1.0 ? std::pow(largest, 4) / (1.0 - largest) : std::numeric_limits<double>::infinity();
  for (const std::size_t component : {std::size_t{0}, std::size_t{1}}) {
    const Waves& of_plane = component == 0 ? x : y;
    Waves pixel = exactly(p[component]) * (of_plane * inverse_plane);
    pixel.add(0, constant(exactly(p[2 + component])));
    pixel.store(form.of[component], form.used[component]);
    constexpr double kRounding = 1.0 + 1e-12;
    form.series_rest_px[component] = std::abs(p[component]) * of_plane.magnitude() * rest * kRounding;
  }
}

}  // namespace fca
