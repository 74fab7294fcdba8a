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
// A model of the list without polar_form() is one whose conversions have no bound.
#pragma once

#include "series.h"

#include <fca/models/camera_model.h>

#include <array>
#include <type_traits>

namespace fca::internal {

/// The harmonics, in this order: 1, cos phi, sin phi, cos 2phi, sin 2phi, ...
inline constexpr std::size_t kHarmonics = 5;
/// n of cos n phi or sin n phi.
constexpr std::size_t frequency_of(std::size_t harmonic) { return (harmonic + 1) / 2; }
/// Those of a tilted image plane.
inline constexpr std::size_t kTiltedHarmonics = 17;

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
using PolarSeries = PolarSeriesOf<kHarmonics>;

/// centre + A (cos phi, sin phi) R, A row by row.
void set_radial(PolarSeries& form, const std::array<double, 2>& centre, const std::array<double, 4>& a, const Series& radius);

/// One overload per model: its formula with the angle as the variable.
void polar_form(const Intrinsics<Pinhole>& model, const AngleSeries& angle, PolarSeries& form);
void polar_form(const Intrinsics<Radtan>& model, const AngleSeries& angle, PolarSeries& form);
void polar_form(const Intrinsics<Rational>& model, const AngleSeries& angle, PolarSeries& form);
void polar_form(const Intrinsics<Kb4>& model, const AngleSeries& angle, PolarSeries& form);
void polar_form(const Intrinsics<Ucm>& model, const AngleSeries& angle, PolarSeries& form);
void polar_form(const Intrinsics<Eucm>& model, const AngleSeries& angle, PolarSeries& form);
void polar_form(const Intrinsics<Ds>& model, const AngleSeries& angle, PolarSeries& form);
void polar_form(const Intrinsics<Mei>& model, const AngleSeries& angle, PolarSeries& form);
void polar_form(const Intrinsics<Fov>& model, const AngleSeries& angle, PolarSeries& form);
void polar_form(const Intrinsics<Ocamcalib>& model, const AngleSeries& angle, PolarSeries& form);
void polar_form(const Intrinsics<Woodscape>& model, const AngleSeries& angle, PolarSeries& form);
/// Without its tilt: that of the plane.
void polar_form(const Intrinsics<Opencv14>& model, const AngleSeries& angle, PolarSeries& form);
/// With it.
void polar_form(const Intrinsics<Opencv14>& model, const AngleSeries& angle, PolarSeriesOf<kTiltedHarmonics>& form);

/// Moves the column by `skew_px` times how far the row is from `centre_v`, over `focal_v`.
void add_skew(double skew_px, double focal_v, double centre_v, PolarSeries& form);

template <class M>
void polar_form(const Intrinsics<Skewed<M>>& model, const AngleSeries& angle, PolarSeries& form) {
  polar_form(Intrinsics<M>{Skewed<M>::straight(model.values)}, angle, form);
  add_skew(model.values[Skewed<M>::kSkew], model.values[1], model.values[3], form);
}

/// True if the image plane is tilted.
template <class M>
bool is_tilted(const Intrinsics<M>& model) {
  if constexpr (std::is_same_v<M, Opencv14>) return M::is_tilted(model.values.data());
  return false;
}

template <class M>
concept HasPolarForm = requires(const Intrinsics<M>& model, const AngleSeries& angle, PolarSeries& form) {
  polar_form(model, angle, form);
};

}  // namespace fca::internal
