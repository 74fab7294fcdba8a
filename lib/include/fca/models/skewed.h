// SPDX-License-Identifier: BSD-3-Clause
// A model on an image whose columns are not at right angles to its rows: OpenCV's camera matrix with K(0, 1) != 0.
//
//   p      = M's (fx fy cx cy ...)  skew [px]
//   (u, v) = M's pixel
//   pixel  = (u + skew (v - cy) / fy, v)
//   domain : M's
//
// A fit holds the skew.
//
// Called: cv::omnidir's camera matrix (mei); alpha = skew / fx of cv::fisheye (kb4); MATLAB's K (radtan). cv::projectPoints
// does not read K(0, 1).
#pragma once

#include <fca/models/kb4.h>
#include <fca/models/mei.h>
#include <fca/models/model_traits.h>
#include <fca/models/opencv14.h>
#include <fca/models/radtan.h>
#include <fca/models/rational.h>

#include <algorithm>

namespace fca {

/// The id of M with skew, and its title.
template <class M>
struct SkewedName;
template <>
struct SkewedName<Radtan> {
  static constexpr std::string_view kId = "radtan-skew";
  static constexpr std::string_view kTitle = "Pinhole with radial-tangential distortion and skew";
};
template <>
struct SkewedName<Rational> {
  static constexpr std::string_view kId = "rational-skew";
  static constexpr std::string_view kTitle = "Pinhole with rational radial-tangential distortion and skew";
};
template <>
struct SkewedName<Opencv14> {
  static constexpr std::string_view kId = "opencv14-skew";
  static constexpr std::string_view kTitle = "OpenCV's model with 14 coefficients and skew";
};
template <>
struct SkewedName<Kb4> {
  static constexpr std::string_view kId = "kb4-skew";
  static constexpr std::string_view kTitle = "Kannala-Brandt with four coefficients and skew";
};
template <>
struct SkewedName<Mei> {
  static constexpr std::string_view kId = "mei-skew";
  static constexpr std::string_view kTitle = "Mei (unified model with radial-tangential distortion) with skew";
};

namespace internal {
/// What M says of its starts.
template <class M>
struct StartsOf {};
template <class M>
requires requires { M::kStartsFindCentre; }
struct StartsOf<M> {
  static constexpr bool kStartsFindCentre = M::kStartsFindCentre;
};
}  // namespace internal

template <CameraModelType M>
struct Skewed : internal::RayMap<Skewed<M>>, internal::StartsOf<M> {
  using Straight = M;
  static constexpr std::string_view kId = SkewedName<M>::kId;
  static constexpr std::string_view kTitle = SkewedName<M>::kTitle;
  static constexpr std::string_view kContains = M::kId;
  static constexpr std::array<std::string_view, 0> kAliases = {};
  static constexpr std::size_t kSkew = kParameterCount<M>;  ///< Its place.
  static constexpr std::array kParameters = [] {
    std::array<Parameter, kSkew + 1> parameters{};
    std::ranges::copy(M::kParameters, parameters.begin());
    parameters[kSkew] = {"skew", "px", -common_parameter::kInfinity, common_parameter::kInfinity, ParameterGroup::kLens};
    return parameters;
  }();
  /// The parameters of M among those with the skew.
  static std::array<double, kSkew> straight(const std::array<double, kSkew + 1>& values) {
    std::array<double, kSkew> result{};
    std::copy_n(values.begin(), kSkew, result.begin());
    return result;
  }
  static constexpr std::array<std::string_view, 1> kHeldInFits = {"skew"};
  static constexpr bool kKeptOnly = true;
  static constexpr bool kPerspective = requires { requires M::kPerspective; };
  static constexpr bool kHasPoles = requires { requires M::kHasPoles; };

  static bool unproject(const double* p, const double* pixel, double* ray) {
    const double straight[2] = {pixel[0] - p[kSkew] * ((pixel[1] - p[3]) / p[1]), pixel[1]};
    return M::unproject(p, straight, ray);
  }

  static double max_angle(const double* p) { return M::max_angle(p); }
  static std::array<double, 2> principal_point(const double* p) { return M::principal_point(p); }
  static std::array<double, 2> central_focal_lengths(const double* p) { return M::central_focal_lengths(p); }

  static constexpr int kStarts = M::kStarts;
  static void initialise(std::span<const Correspondence> samples, const LensCentre& centre, int start, double* p) {
    M::initialise(samples, centre, start, p);
    p[kSkew] = 0.0;
  }

  // In lib/models/skewed.
  static void polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form);

 private:
  friend struct internal::RayMap<Skewed>;
  template <bool kWithinDomain, class T>
  static bool map(const T* p, const T* ray, T* pixel) {
    if (!(kWithinDomain ? M::template project<T>(p, ray, pixel) : M::template formula<T>(p, ray, pixel))) return false;
    pixel[0] += p[kSkew] * ((pixel[1] - p[3]) / p[1]);
    return true;
  }
};

template <class M>
inline constexpr bool kIsSkewed = false;
template <class M>
inline constexpr bool kIsSkewed<Skewed<M>> = true;

static_assert(CameraModelType<Skewed<Mei>>);

}  // namespace fca
