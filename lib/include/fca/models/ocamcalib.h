// SPDX-License-Identifier: BSD-3-Clause
// OCamCalib (Scaramuzza, Martinelli, Siegwart 2006, "A toolbox for easily calibrating omnidirectional cameras", eq. 3-5; the
// toolbox's cam2world and world2cam): a polynomial from the image radius to the height of the ray.
//
//   p      = cx cy [px]  c d e  a0 .. a8 [px, 1, 1/px, 1/px^2 ...]
//   (X, Y) = rho (y, x) / |(x, y)|                 X along rows (down), Y along columns (right), in pixels
//   v      = c X + d Y + cy
//   u      = e X +   Y + cx
//   rho    : the smallest positive root of  f(rho) |(x, y)| + z rho = 0,  f(rho) = a0 + a1 rho + ... + a8 rho^8
//   ray    = (Y, X, -f(rho)), so that the angle from the axis is atan2(rho, -f(rho))
//   domain : rho < rho_max, where that angle stops growing: h(rho) = -f + rho f' = -a0 + a2 rho^2 + 2 a3 rho^3 + ... reaches 0
//
// The parameters are those of calib_results.txt, signs and all, so that they survive to the last bit. The file counts in (row,
// column) from 0: its centre "xc yc" is our (cy, cx), its x our X, its y our Y, and its z points to the back of the lens, which
// is why a0 is negative and f has the opposite sign of our z. a1 is 0 in files of the toolbox (the lens is smooth on its axis),
// but stored, and used here. The file's inverse polynomial is no part of the model: projection is the exact inverse of f.
//
// The paper of fisheye-calib-adapter (Lee, sec. II-E) writes it in (u, v) with z ahead: c' = 1/c, d' = e/c, e' = d/c,
// a'_k = -c^(1 - k) a_k (ERRATA, OCamCalib conventions).
//
// Degree 8 holds every polynomial known from files (the toolbox's default is 4); a shorter one ends in zeros. A fit has a1 = 0
// and chooses the degree: see kHeldInFits.
//
// Called: "Scaramuzza", "omnidirectional polynomial"; MATLAB fisheyeParameters (its MappingCoefficients are -a0, -a2, -a3,
// -a4); camodocal SCARAMUZZA.
#pragma once

#include <fca/models/linear_fit.h>
#include <fca/models/model_traits.h>
#include <fca/models/polynomial.h>

#include <algorithm>
#include <numbers>

namespace fca {

struct Ocamcalib : internal::RayMap<Ocamcalib> {
  static constexpr std::string_view kId = "ocamcalib";
  static constexpr std::string_view kTitle = "OCamCalib (Scaramuzza's polynomial)";
  static constexpr std::string_view kContains = "pinhole";
  static constexpr std::array<std::string_view, 4> kAliases = {"ocam", "scaramuzza", "omnidirectional-polynomial", "occ"};
  static constexpr double kInfinity = common_parameter::kInfinity;
  static constexpr std::array kParameters = {common_parameter::kCx,
                                             common_parameter::kCy,
                                             Parameter{"c", "", 0.0, kInfinity, ParameterGroup::kLens, true},
                                             common_parameter::coefficient("d"),
                                             common_parameter::coefficient("e"),
                                             Parameter{"a0", "px", -kInfinity, 0.0, ParameterGroup::kFocalLength, true},
                                             common_parameter::coefficient("a1"),
                                             Parameter{"a2", "1/px", -kInfinity, kInfinity, ParameterGroup::kLens},
                                             Parameter{"a3", "1/px^2", -kInfinity, kInfinity, ParameterGroup::kLens},
                                             Parameter{"a4", "1/px^3", -kInfinity, kInfinity, ParameterGroup::kLens},
                                             Parameter{"a5", "1/px^4", -kInfinity, kInfinity, ParameterGroup::kLens},
                                             Parameter{"a6", "1/px^5", -kInfinity, kInfinity, ParameterGroup::kLens},
                                             Parameter{"a7", "1/px^6", -kInfinity, kInfinity, ParameterGroup::kLens},
                                             Parameter{"a8", "1/px^7", -kInfinity, kInfinity, ParameterGroup::kLens}};

  /// Held by fits. a1 = 0, as the toolbox has it: any other lens has a kink on its axis. Degree 4 is what some programs hold
  /// (camodocal and MATLAB: five coefficients with a1).
  static constexpr std::array<std::string_view, 5> kHeldInFits = {"a1", "a5", "a6", "a7", "a8"};
  static constexpr int kLeastDegree = 4;
  static constexpr std::array<std::string_view, 4> kHigherTerms = {"a5", "a6", "a7", "a8"};

  static bool formula_and_derivatives(const double* p, const double* ray, double* pixel, double* du, double* dv) {
    if (!(p[kC] > p[kD] * p[kE]) || !(p[kA] < 0.0)) return false;
    const double r = std::sqrt(ray[0] * ray[0] + ray[1] * ray[1]);
    if (!(r > 0.0) && !(ray[2] > 0.0)) return false;
    // rho (down, right) / r; by a_k, rho moves by rho^k r over the residual's derivative.
    double rho = 0.0;
    double down = 0.0;
    double right = 0.0;
    double rho_by_a0 = 0.0;
    if (r > 0.0) {
      const Polynomial g = ahead(p + kA);
      if (!radius_of_ray<false>(g, growth(p + kA), r, ray[2], radius_of_pixel(p, pixel), rho)) return false;
      down = ray[1] / r;
      right = ray[0] / r;
      rho_by_a0 = r / residual_derivative(g, r, ray[2], rho);
    }
    pixel[0] = (p[kE] * down + right) * rho + p[kCx];
    pixel[1] = (p[kC] * down + p[kD] * right) * rho + p[kCy];
    std::fill_n(du, kA, 0.0);
    std::fill_n(dv, kA, 0.0);
    du[kCx] = 1.0;
    dv[kCy] = 1.0;
    du[kE] = rho * down;
    dv[kC] = rho * down;
    dv[kD] = rho * right;
    const double u_by_rho = p[kE] * down + right;
    const double v_by_rho = p[kC] * down + p[kD] * right;
    for (std::size_t k = 0; k < kTerms; ++k, rho_by_a0 *= rho) {
      du[kA + k] = u_by_rho * rho_by_a0;
      dv[kA + k] = v_by_rho * rho_by_a0;
    }
    return true;
  }

  static bool unproject(const double* p, const double* pixel, double* ray) {
    const double determinant = p[kC] - p[kD] * p[kE];
    if (!(determinant > 0.0)) return false;
    const double du = pixel[0] - p[kCx];
    const double dv = pixel[1] - p[kCy];
    const double down = (dv - p[kD] * du) / determinant;
    const double right = (p[kC] * du - p[kE] * dv) / determinant;
    const double rho = std::sqrt(down * down + right * right);
    if (!std::isfinite(rho) || !positive_on(growth(p + kA), rho)) return false;
    ray[0] = right;
    ray[1] = down;
    ray[2] = evaluate_polynomial(ahead(p + kA), rho);
    return internal::normalise(ray);
  }

  /// The angle of rho_max; if the angle always grows, its limit for large rho, where the highest power decides.
  static double max_angle(const double* p) {
    const Polynomial g = ahead(p + kA);
    const double rho = positive_until(growth(p + kA), kInfinity);
    if (std::isfinite(rho)) return std::atan2(rho, evaluate_polynomial(g, rho));
    for (std::size_t k = kTerms - 1; k > 1; --k) {
      if (g[k] != 0.0) return std::numbers::pi;
    }
    return std::atan2(1.0, g[1]);
  }

  static std::array<double, 2> principal_point(const double* p) { return {p[kCx], p[kCy]}; }
  /// rho = |a0| angle at the centre; the shear d, e is left out.
  static std::array<double, 2> central_focal_lengths(const double* p) { return {-p[kA], -p[kC] * p[kA]}; }

  /// Given the centre, a2..a4 are linear in the residual across the ray, (-f) sin(angle) - rho cos(angle), which vanishes past
  /// 90 degrees as well as before; divided by its derivative by rho it is in pixels (ERRATA). That derivative is -(angle / sin)
  /// for an equidistant lens, from where the rounds begin. Radii in units of |a0|.
  static constexpr int kStarts = 1;
  static void initialise(std::span<const Correspondence> samples, const LensCentre& centre, int /*start*/, double* p) {
    const double focal = centre.focal[0];
    std::fill_n(p, kParameters.size(), 0.0);
    p[kCx] = centre.point[0];
    p[kCy] = centre.point[1];
    p[kC] = centre.focal[1] / focal;
    p[kA] = -focal;
    std::array<double, 3> g{};  // of rho^2, rho^3, rho^4
    constexpr int kRounds = 3;
    for (int round = 0; round < kRounds; ++round) {
      internal::LinearFit<3> fit;
      for (const Correspondence& s : samples) {
        const double sine = std::hypot(s.ray[0], s.ray[1]);
        const double cosine = s.ray[2];
        const double rho = std::hypot(s.pixel[0] - p[kCx], (s.pixel[1] - p[kCy]) / p[kC]) / focal;
        const double rho2 = rho * rho;
        const double derivative = round == 0 ? (sine > 0.0 ? std::atan2(sine, cosine) / sine : 1.0)
                                             : (rho * (2.0 * g[0] + rho * (3.0 * g[1] + rho * 4.0 * g[2]))) * sine - cosine;
        constexpr double kSmallest = 0.05;
        const double weight = s.weight / std::max(kSmallest, derivative * derivative);
        fit.add({sine * rho2, sine * rho2 * rho, sine * rho2 * rho2}, rho * cosine - sine, weight);
      }
      fit.solve(g.data());
    }
    for (std::size_t k = 2; k < 5; ++k) p[kA + k] = -g[k - 2] * std::pow(focal, 1.0 - static_cast<double>(k));
  }

  // In lib/models/ocamcalib.
  static void polar_form(const double* p, const internal::AngleSeries& angle, internal::PolarSeries& form);
  static std::span<const internal::ExactStep> exact_steps();
  static void map_pixels(double* p, const PixelMap& map);

 private:
  friend struct internal::RayMap<Ocamcalib>;
  enum Index : std::size_t { kCx, kCy, kC, kD, kE, kA };
  static constexpr std::size_t kTerms = 9;
  using Polynomial = std::array<double, kTerms>;

  /// g = -f, ascending: the height of the ray ahead of the camera.
  template <class T>
  static Polynomial ahead(const T* a) {
    Polynomial g;
    for (std::size_t k = 0; k < kTerms; ++k) g[k] = -internal::value_of(a[k]);
    return g;
  }
  /// h = g - rho g': the angle's derivative by rho, times rho^2 + g^2.
  template <class T>
  static Polynomial growth(const T* a) {
    Polynomial h = ahead(a);
    for (std::size_t k = 0; k < kTerms; ++k) h[k] *= 1.0 - static_cast<double>(k);
    return h;
  }

  template <bool kWithinDomain, class T>
  static bool map(const T* p, const T* ray, T* pixel) {
    using internal::value_of;
    using std::sqrt;
    if (!(value_of(p[kC]) > value_of(p[kD]) * value_of(p[kE])) || !(value_of(p[kA]) < 0.0)) return false;
    const T r2 = ray[0] * ray[0] + ray[1] * ray[1];
    T scale;  // rho / r
    if (value_of(r2) > 0.0) {
      const T r = sqrt(r2);
      double root = 0.0;
      if (!radius_of_ray<kWithinDomain>(ahead(p + kA), growth(p + kA), value_of(r), value_of(ray[2]), 0.0, root)) return false;
      // One more step of Newton's method in T, from a constant: its derivatives are those of the implicit function.
      T f = p[kA + kTerms - 1];
      for (std::size_t k = kTerms - 1; k-- > 0;) f = f * T(root) + p[kA + k];
      const double derivative = residual_derivative(ahead(p + kA), value_of(r), value_of(ray[2]), root);
      scale = (T(root) + (f * r + ray[2] * T(root)) / T(derivative)) / r;
    } else {  // on the axis, where r has no derivative
      if (!(value_of(ray[2]) > 0.0)) return false;
      scale = -p[kA] / ray[2];
    }
    const T down = scale * ray[1];
    const T right = scale * ray[0];
    pixel[0] = p[kE] * down + right + p[kCx];
    pixel[1] = p[kC] * down + p[kD] * right + p[kCy];
    return true;
  }

  /// d/drho of g r - z rho.
  static double residual_derivative(const Polynomial& g, double r, double z, double rho) {
    double derivative = 0.0;
    for (std::size_t k = kTerms - 1; k > 0; --k) derivative = derivative * rho + static_cast<double>(k) * g[k];
    return derivative * r - z;
  }

  static double radius_of_pixel(const double* p, const double* pixel) {
    const double determinant = p[kC] - p[kD] * p[kE];
    const double du = pixel[0] - p[kCx];
    const double dv = pixel[1] - p[kCy];
    return std::hypot(dv - p[kD] * du, p[kC] * du - p[kE] * dv) / determinant;
  }

  /// The rho of a ray: g(rho) r = z rho. Newton's method from an equidistant lens, nearly always enough, then from a guess if
  /// there is one (not 0); else the first root, searched for.
  template <bool kWithinDomain>
  static bool radius_of_ray(const Polynomial& g, const Polynomial& h, double r, double z, double guess, double& rho) {
    const double length = std::sqrt(r * r + z * z);
    const double sine = r / length;
    const double cosine = z / length;
    if (found_by_newton<kWithinDomain>(g, h, sine, cosine, g[0] * std::atan2(r, z), rho)) return true;
    if (guess != 0.0 && found_by_newton<kWithinDomain>(g, h, sine, cosine, guess, rho)) return true;
    // g r - z rho is positive up to its first root; inside the domain it has no other.
    Polynomial residual = g;
    for (double& coefficient : residual) coefficient *= sine;
    residual[1] -= cosine;
    rho = positive_until(residual, kInfinity);
    if (!std::isfinite(rho) || !(rho > 0.0)) return false;
    return evaluate_polynomial(h, rho) > 0.0 && (!kWithinDomain || positive_on(h, rho));
  }

  template <bool kWithinDomain>
  static bool found_by_newton(const Polynomial& g, const Polynomial& h, double sine, double cosine, double start, double& rho) {
    rho = start;
    constexpr int kMaxSteps = 12;
    for (int i = 0; i < kMaxSteps; ++i) {
      const double derivative = residual_derivative(g, sine, cosine, rho);
      const double step = (evaluate_polynomial(g, rho) * sine - cosine * rho) / derivative;
      rho -= step;
      if (!(std::abs(step) <= 1e-9 * rho)) continue;  // the next step would be about the square of this one
      // The angle grows with rho at the root that is meant.
      if (kWithinDomain ? positive_on(h, rho) : evaluate_polynomial(h, rho) > 0.0) return true;
      break;
    }
    return false;
  }
};

static_assert(CameraModelType<Ocamcalib>);

}  // namespace fca
