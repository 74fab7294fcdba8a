// SPDX-License-Identifier: BSD-3-Clause
// The camera models in polar coordinates of the ray, angle from the axis and azimuth phi (from x towards y). Seen so, each one
// is a trigonometric polynomial of degree 2 in phi whose coefficients are functions of the angle alone:
//
//   pixel = centre + A (cos phi, sin phi) R(angle)  +  r(angle)^2 (b + B (cos 2phi, sin 2phi))
//
// with A the focal lengths (and ocamcalib's shear), R the image radius; the last term is the tangential distortion of radtan,
// rational and mei, with 2xy = r^2 sin 2phi and r^2 + 2x^2 = r^2 (2 + cos 2phi). So is the difference of any two models, and
// that is why a bound needs enclosures of functions of one variable only.
//
// A tilted image plane (opencv14) divides by 1 + w(angle, phi), small: the series 1 - w + w^2 - w^3 leaves a rest below
// |w|^4 / (1 - |w|), and makes harmonics up to 8 phi of it.
//
// A model of the list without polar_form() (lib/models/<id>/polar.cc) is one whose conversions have no bound.
#pragma once

#include "series.h"

#include <fca/models/camera_model.h>

#include <array>
#include <cstddef>

namespace fca::internal {

/// n of cos n phi or sin n phi, the harmonics in the order of kHarmonics.
constexpr std::size_t frequency_of(std::size_t harmonic) { return (harmonic + 1) / 2; }

/// Both components of a pixel, one series per harmonic; those that are not `used` are 0.
template <std::size_t N>
struct PolarSeriesOf {
  std::array<std::array<Series, N>, 2> of{};
  std::array<std::array<bool, N>, 2> used{};
  std::array<double, 2> series_rest_px{};  ///< How far the pixel may be from them, at most.

  void set(std::size_t component, std::size_t harmonic, const Series& series) {
    of[component][harmonic] = series;
    used[component][harmonic] = true;
  }
};
template <class M>
concept HasPolarForm = requires(const double* p, const AngleSeries& angle, PolarSeries& form) {
  M::polar_form(p, angle, form);
};

/// Has the camera a form with the harmonics of a tilted image plane only?
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
