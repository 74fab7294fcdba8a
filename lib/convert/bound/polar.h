// SPDX-License-Identifier: BSD-3-Clause
// Camera models as functions of a ray's polar coordinates: its angle from the axis and its azimuth phi (from x towards y). The
// pixel is a trigonometric polynomial of degree 2 in phi, whose coefficients are functions of the angle alone:
//
//  pixel = centre + A (cos phi, sin phi) R(angle)  +  r(angle)^2 (b + B (cos 2phi, sin 2phi))
//
// A has the focal lengths (and ocamcalib's shear), and R is the image radius. The last term is the tangential distortion of
// radtan, rational and mei, with 2xy = r^2 sin 2phi and r^2 + 2x^2 = r^2 (2 + cos 2phi). The difference of two models has the
// same form, so that a bound only needs bounds of functions of one variable.
//
// A tilted image plane (opencv14) divides by 1 + w(angle, phi) with a small w. The factor 1 / (1 + w) is replaced by the series
// 1 - w + w^2 - w^3, whose error is at most |w|^4 / (1 - |w|). The pixel then has harmonics up to 8 phi.
//
// The models' forms are in lib/models/<id>/polar.cc. A conversion has no bound if one of its models has no polar_form().
#pragma once

#include "series.h"

#include <fca/models/camera_model.h>

#include <array>
#include <cstddef>

namespace fca::internal {

/// The n of the harmonic with this index. The harmonics are 1, cos phi, sin phi, cos 2 phi, sin 2 phi and so on.
constexpr std::size_t frequency_of(std::size_t harmonic) { return (harmonic + 1) / 2; }

/// Both components of a pixel: a series in the angle for each component and harmonic. A series that is not `used` is 0.
template <std::size_t N>
struct PolarSeriesOf {
  std::array<std::array<Series, N>, 2> of{};
  std::array<std::array<bool, N>, 2> used{};
  std::array<double, 2> series_rest_px{};  ///< An upper bound of the distance of each component from the sum of the series.

  void set(std::size_t component, std::size_t harmonic, const Series& series) {
    of[component][harmonic] = series;
    used[component][harmonic] = true;
  }
};

/// True for models with a polar form.
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
