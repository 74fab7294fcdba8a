// SPDX-License-Identifier: BSD-3-Clause
// What every camera model is: a struct of statics over a plain array of parameters, so that values copy and compare, fits are
// templates over the concept below.
//
// Conventions of all models. Rays are 3-vectors of any positive length, x right, y down, z forward (never z = 1: 90 degrees
// from the axis and beyond must work). Pixels are (u, v) with the centre of the top-left pixel at (0, 0). "Angle" is the angle
// from the optical axis.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>
#include <utility>

namespace fca {

struct PixelMap;

namespace internal {
struct AngleSeries;
struct ExactStep;
template <std::size_t N>
struct PolarSeriesOf;
/// Of a pixel as a trigonometric polynomial of the azimuth: 1, cos phi, sin phi, cos 2phi, sin 2phi.
inline constexpr std::size_t kHarmonics = 5;
using PolarSeries = PolarSeriesOf<kHarmonics>;
/// Those of a tilted image plane, up to 8 phi.
inline constexpr std::size_t kTiltedHarmonics = 17;
using TiltedPolarSeries = PolarSeriesOf<kTiltedHarmonics>;
}  // namespace internal

/// What a parameter belongs to: the groups a fit may hold fixed, and the headings under which they are shown.
enum class ParameterGroup { kFocalLength, kPrincipalPoint, kLens };

/// One parameter of a model: its name in our files' and reports' language, unit, and the range in which the model is a camera.
struct Parameter {
  std::string_view name;
  std::string_view unit;  ///< "px" or "" (no unit)
  double lower;
  double upper;
  ParameterGroup group;
  bool open = false;  ///< Are the bounds themselves excluded?
  /// A fit takes it no further, although what lies beyond is a camera.
  double furthest = std::numeric_limits<double>::infinity();
  /// Where those of published cameras lie. A fit stays inside if that costs next to nothing.
  std::array<double, 2> usual = {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
};

/// No lens has larger numbers than this, and their powers would overflow a projection.
inline constexpr double kLargestParameter = 1e12;

/// A pixel of the source and its ray: what a fit works on.
struct Correspondence {
  std::array<double, 3> ray{};  ///< Unit length.
  std::array<double, 2> pixel{};
  double weight = 1.0;  ///< Share of the domain's area; the weights of a fit sum to 1.
  bool operator==(const Correspondence&) const = default;
};

/// What is seen at the optical axis, whatever a model's parameters are: the pivot between models, and all a fit is given of the
/// lens it looks for.
struct LensCentre {
  std::array<double, 2> focal{};  ///< Radius per angle at the centre, in pixels per radian, along u and v.
  std::array<double, 2> point{};  ///< Principal point: the pixel of the axis.
};

/// Parameters that many models have.
namespace common_parameter {
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr Parameter kFx{"fx", "px", 0.0, kInfinity, ParameterGroup::kFocalLength, true};
inline constexpr Parameter kFy{"fy", "px", 0.0, kInfinity, ParameterGroup::kFocalLength, true};
inline constexpr Parameter kCx{"cx", "px", -kInfinity, kInfinity, ParameterGroup::kPrincipalPoint};
inline constexpr Parameter kCy{"cy", "px", -kInfinity, kInfinity, ParameterGroup::kPrincipalPoint};
/// A distortion coefficient without bounds.
constexpr Parameter coefficient(std::string_view name) { return {name, "", -kInfinity, kInfinity, ParameterGroup::kLens}; }
}  // namespace common_parameter

/// A camera model M: kId, kTitle, kAliases (other names people type, lower case with hyphens), kParameters, and functions over
/// p, an array of doubles laid out as kParameters.
///
///   project(p, ray, pixel)     ray -> pixel for double and for automatic differentiation (any T with the usual functions);
///                              false outside the model's domain: where its formula ends or its image radius stops growing.
///   formula(p, ray, pixel)     the same without the domain: false only where the formula has no value. Fits walk through
///                              parameters whose domain is too small for their rays on the way to ones whose is not.
///   unproject(p, pixel, ray)   pixel -> unit ray, double only; false where no ray of the domain has that pixel.
///   max_angle(p)               the domain's limit in radians from the axis (the smallest over all azimuths).
///   principal_point(p)         the pixel of the axis.
///   central_focal_lengths(p)   radius per angle at the centre along u and v, in pixels per radian.
///   kStarts, initialise(samples, centre, start, p)
///                              linear start for a fit, start = 0 .. kStarts - 1 (models with several local minima have
///                              several): all of p, a camera with that centre.
///   formula_and_derivatives(p, ray, pixel, du, dv)
///                              (optional) formula for double and a unit ray, and the derivatives of u and v by each parameter,
///                              where that is much faster than automatic differentiation. `pixel` enters as a guess. Where
///                              it returns false it may leave anything in them.
///   kTerms, terms(ray, along_u, along_v), from_terms(coefficients, aspect, point, p)
///                              (optional) for a model that is linear in all else once fy / fx is given:
///                              u = cx + c . along_u,  v = cy + aspect c . along_v; false where a ray has no pixel. Such a
///                              model is fitted without a start.
///   kShapes, terms(shape, ray, along_u, along_v), from_terms(shape, coefficients, aspect, point, p)
///                              (optional) the same for a model that is linear in all else once fy / fx and one parameter,
///                              its shape, are given. kShapes: values to begin a search with, ascending.
///   kFolded                    (optional) the index of a parameter along which a fit has two minima with nearly the same
///                              pixels.
///   kStartsFindCentre          (optional) true: initialise finds focal lengths and principal point, too, and takes the given
///                              ones as a unit and an origin only.
///   kPerspective               (optional) true: whatever the parameters, no ray at 90 degrees from the axis or beyond has a
///                              pixel. Nobody then tries to fit it to such rays.
///   kRound                     (optional) true: but for the two focal lengths, pixels at one radius from the centre have rays
///   at
///                              one angle, and that grows with the radius up to the domain's limit.
///   kHasPoles                  (optional) true: its pixels may leave for infinity at an angle inside an image. A fit that
///                              misses any sample, of however little weight, then does not reach all of them.
///   kBendsBack                 (optional) the name of a coefficient that may bend the radius back before the edge of a wide
///                              lens; a fit that does not reach the edge gets only as much of it as lets it.
///   kHeldInFits                (optional) names of parameters that a fit leaves at their start, unless its caller gives them
///                              a range.
///   kKeptOnly                  (optional) true: no search for the best model tries it, only who asks for it by name: few
///                              programs read it, or a fit to it equals a fit of another model.
///   kLeastDegree, kHigherTerms (optional) of a polynomial of any degree: the lowest that a fit has, and the names of the
///                              coefficients beyond it, held in fits; each raises the degree by one.
///   kContains                  (optional) the id of the largest model of the list of which it describes every camera.
///   polar_form(p, angle, form) (optional) the formula as the bound needs it (lib/convert/bound/polar.h). Without it, no error
///                              of the model has a bound.
///   exact_steps()              (optional) closed forms between it and models before it in the list
///                              (lib/models/exact_steps.h).
///   map_pixels(p, map)         (but of FocalLengthsFirst) the parameters whose pixels are the map's of p's.
///
/// Nothing is assumed of the order or the names of the parameters.
template <class M>
concept CameraModelType = requires(const double* p, double* out, const double* in, std::span<const Correspondence> samples,
                                   const LensCentre& centre) {
  { M::kId } -> std::convertible_to<std::string_view>;
  { M::kTitle } -> std::convertible_to<std::string_view>;
  { M::kAliases.size() } -> std::convertible_to<std::size_t>;
  { M::kParameters.size() } -> std::convertible_to<std::size_t>;
  { M::template project<double>(p, in, out) } -> std::same_as<bool>;
  { M::template formula<double>(p, in, out) } -> std::same_as<bool>;
  { M::unproject(p, in, out) } -> std::same_as<bool>;
  { M::max_angle(p) } -> std::same_as<double>;
  { M::kStarts } -> std::convertible_to<int>;
  { M::initialise(samples, centre, int{}, out) } -> std::same_as<void>;
  { M::principal_point(p) } -> std::same_as<std::array<double, 2>>;
  { M::central_focal_lengths(p) } -> std::same_as<std::array<double, 2>>;
};

/// Whether fits leave that parameter at its start unless they are told otherwise.
template <CameraModelType M>
[[nodiscard]] constexpr bool held_in_fits(std::string_view parameter) {
  if constexpr (requires { M::kHeldInFits.size(); }) {
    for (const std::string_view held : M::kHeldInFits) {
      if (held == parameter) return true;
    }
  }
  return false;
}

/// Number of parameters of a model.
template <CameraModelType M>
inline constexpr std::size_t kParameterCount = M::kParameters.size();

namespace internal {

/// The number inside a differentiated scalar: domain decisions are made on values, never on derivatives.
template <class T>
[[nodiscard]] double value_of(const T& x) {
  if constexpr (requires { x.a; }) {
    return x.a;
  } else {
    return x;
  }
}

/// Reads p[0..3] = fx fy cx cy and applies them to a point on the normalised image plane.
///
/// to_pixel, to_plane and FocalLengthsFirst are shared by the models that begin with these four parameters.
template <class T>
void to_pixel(const T* p, const T& mx, const T& my, T* pixel) {
  pixel[0] = p[0] * mx + p[2];
  pixel[1] = p[1] * my + p[3];
}

/// The ray as a point of the plane whose distance from the centre is its angle in radians; false for the ray straight back.
template <class T>
bool equidistant(const T* ray, T* plane) {
  using std::atan2;
  using std::sqrt;
  const T r2 = ray[0] * ray[0] + ray[1] * ray[1];
  if (!(value_of(r2) > 0.0)) {  // on the axis, where r has no derivative
    if (!(value_of(ray[2]) > 0.0)) return false;
    plane[0] = ray[0] / ray[2];
    plane[1] = ray[1] / ray[2];
    return true;
  }
  const T r = sqrt(r2);
  const T scale = atan2(r, ray[2]) / r;
  plane[0] = scale * ray[0];
  plane[1] = scale * ray[1];
  return true;
}

/// project() and formula() of a model with one private map<kWithinDomain>(p, ray, pixel) for both, for whom RayMap is a friend.
template <class M>
struct RayMap {
  template <class T>
  static bool project(const T* p, const T* ray, T* pixel) {
    return M::template map<true>(p, ray, pixel);
  }
  template <class T>
  static bool formula(const T* p, const T* ray, T* pixel) {
    return M::template map<false>(p, ray, pixel);
  }
};

/// What a model inherits that begins with fx fy cx cy, applied as to_pixel does (fits rely on it), where fx and fy are the
/// central focal lengths.
struct FocalLengthsFirst {
  static std::array<double, 2> principal_point(const double* p) { return {p[2], p[3]}; }
  static std::array<double, 2> central_focal_lengths(const double* p) { return {p[0], p[1]}; }

  /// Where a start begins: the four parameters of that centre, if fx and fy are `scale` times the central focal lengths.
  static void begin(const LensCentre& centre, double* p, double scale = 1.0) {
    p[0] = scale * centre.focal[0];
    p[1] = scale * centre.focal[1];
    p[2] = centre.point[0];
    p[3] = centre.point[1];
  }
};

/// a d + b z, for d^2 = r2 + z^2 and a, b >= 0, without cancellation where z is near -d (as far from the axis as a ray can be).
template <class T>
T unified_sum(const T& a, const T& d, const T& b, const T& z, const T& r2) {
  if (value_of(z) >= 0.0) return a * d + b * z;
  return (a * a * r2 + (a - b) * (a + b) * z * z) / (a * d - b * z);
}

/// Writes N numbers, one by one: of a copy of memory a compiler makes no SIMD.
template <std::size_t N>
void store(const std::array<double, N>& from, double* to) {
  [&]<std::size_t... I>(std::index_sequence<I...>) { ((to[I] = from[I]), ...); }
  (std::make_index_sequence<N>());
}

/// What formula_and_derivatives returns for pixel = (fx x, fy y) / denominator + (cx, cy), given the derivatives of the
/// denominator by the parameters after the first four.
template <std::size_t N>
void radial_derivatives(const double* p, const double* ray, double denominator, const std::array<double, N>& derivatives,
                        double* pixel, double* du, double* dv) {
  const double inverse = 1.0 / denominator;
  const double mx = ray[0] * inverse;
  const double my = ray[1] * inverse;
  pixel[0] = p[0] * mx + p[2];
  pixel[1] = p[1] * my + p[3];
  du[0] = mx;
  dv[0] = 0.0;
  du[1] = 0.0;
  dv[1] = my;
  du[2] = 1.0;
  dv[2] = 0.0;
  du[3] = 0.0;
  dv[3] = 1.0;
  for (std::size_t i = 0; i < N; ++i) {
    const double change = -derivatives[i] * inverse;
    du[4 + i] = p[0] * mx * change;
    dv[4 + i] = p[1] * my * change;
  }
}

/// The inverse of to_pixel; false if the focal lengths or the pixel cannot be used.
inline bool to_plane(const double* p, const double* pixel, double& mx, double& my) {
  mx = (pixel[0] - p[2]) / p[0];
  my = (pixel[1] - p[3]) / p[1];
  return std::isfinite(mx) && std::isfinite(my);
}

/// The ray at `angle` from the axis in the direction of (mx, my), whose length is `radius`.
inline void ray_at_angle(double angle, double mx, double my, double radius, double* ray) {
  const double s = radius > 0.0 ? std::sin(angle) / radius : 0.0;
  ray[0] = s * mx;
  ray[1] = s * my;
  ray[2] = std::cos(angle);
}

inline bool normalise(double* ray) {
  const double length = std::sqrt(ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2]);
  if (!(length > 0.0) || !std::isfinite(length)) return false;
  for (int i = 0; i < 3; ++i) ray[i] /= length;
  return true;
}

}  // namespace internal
}  // namespace fca
