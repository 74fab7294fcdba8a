// SPDX-License-Identifier: BSD-3-Clause
// The camera models as functions of the ray's polar coordinates: angle from the axis, and azimuth phi (from x towards y). Each
// one is a trigonometric polynomial of degree 2 in phi whose coefficients are functions of the angle alone:
//
//  pixel = centre + A (cos phi, sin phi) R(angle)  +  r(angle)^2 (b + B (cos 2phi, sin 2phi))
//
// with A the focal lengths (and ocamcalib's shear) and R the image radius. The last term is the tangential distortion of
// radtan, rational and mei, with 2xy = r^2 sin 2phi and r^2 + 2x^2 = r^2 (2 + cos 2phi). The difference of two models has the
// same form, so that a bound only needs enclosures of functions of one variable.
//
// A tilted image plane (opencv14) divides by 1 + w(angle, phi) with a small w. The series 1 - w + w^2 - w^3 replaces that; its
// rest is below |w|^4 / (1 - |w|), and it has harmonics up to 8 phi.
//
// Conversions of a listed model without polar_form() (lib/models/<id>/polar.cc) have no bound.
#pragma once

#include "series.h"

#include <fca/models/camera_model.h>

#include <array>
#include <cstddef>

namespace fca::internal {

/// The n of cos n phi or sin n phi for an index of kHarmonics.
constexpr std::size_t frequency_of(std::size_t harmonic) { return (harmonic + 1) / 2; }

/// Both components of a pixel, one series per harmonic; those that are not `used` are 0.
template <std::size_t N>
struct PolarSeriesOf {
  std::array<std::array<Series, N>, 2> of{};
  std::array<std::array<bool, N>, 2> used{};
  std::array<double, 2> series_rest_px{};  ///< Upper bound of how far the pixel may be from the series.

  void set(std::size_t component, std::size_t harmonic, const Series& series) {
    of[component][harmonic] = series;
    used[component][harmonic] = true;
  }
};
template <class M>
concept HasPolarForm = requires(const double* p, const AngleSeries& angle, PolarSeries& form) {
  M::polar_form(p, angle, form);
};

/// True if the camera's polar form needs the harmonics of a tilted image plane.
template <class M>
bool is_tilted(const Intrinsics<M>& model) {
  if constexpr (requires(const double* p, const AngleSeries& angle, TiltedPolarSeries& form) {
                  M::polar_form(p, angle, form);
                }) {
    return M::is_tilted(model.values.data());
  }
  return false;
}

}  // namespace fca::internal
