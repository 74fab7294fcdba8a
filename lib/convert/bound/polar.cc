// SPDX-License-Identifier: BSD-3-Clause
#include "polar.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace fca::internal {

namespace {

Ball exactly(double value) { return {value, 0.0}; }

/// fx fy cx cy, and an image radius.
void set_focal(PolarSeries& form, const double* p, const Series& radius) {
  set_radial(form, {p[2], p[3]}, {p[0], 0.0, 0.0, p[1]}, radius);
}

/// Adds the tangential distortion p1, p2 of a point at distance r from the centre of the plane; r2 is its square.
void add_tangential(PolarSeries& form, const double* p, double p1, double p2, const Series& r2) {
  if (p1 == 0.0 && p2 == 0.0) return;
  const Ball fx = exactly(p[0]);
  const Ball fy = exactly(p[1]);
  const Ball two{2.0, 0.0};
  // m_x = ... + r^2 (2 p2 + p2 cos 2phi + p1 sin 2phi),  m_y = ... + r^2 (2 p1 - p1 cos 2phi + p2 sin 2phi)
  form.set(0, 0, form.of[0][0] + two * fx * exactly(p2) * r2);
  form.set(0, 3, fx * exactly(p2) * r2);
  form.set(0, 4, fx * exactly(p1) * r2);
  form.set(1, 0, form.of[1][0] + two * fy * exactly(p1) * r2);
  form.set(1, 3, fy * exactly(-p1) * r2);
  form.set(1, 4, fy * exactly(p2) * r2);
}

/// The unified models on the unit sphere: sin / (a d + (1 - a) z).
Series unified_radius(const Ball& a, const Series& d, const Series& z, const Series& sine) {
  return sine / (a * d + (exactly(1.0) - a) * z);
}

/// theta (a_0 + a_1 theta + ...), by multiplications with the variable.
template <std::size_t N>
Series polynomial_of_angle(const std::array<double, N>& coefficients, const Ball& angle) {
  Series result = constant(exactly(coefficients[N - 1]));
  for (std::size_t k = N - 1; k-- > 0;) result = exactly(coefficients[k]) + times_variable(result, angle);
  return times_variable(result, angle);
}

/// The model without thin prism and tilt.
Intrinsics<Rational> rational_part(const Intrinsics<Opencv14>& model) {
  Intrinsics<Rational> part;
  std::copy_n(model.values.begin(), part.values.size(), part.values.begin());
  return part;
}

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

void set_radial(PolarSeries& form, const std::array<double, 2>& centre, const std::array<double, 4>& a, const Series& radius) {
  for (std::size_t row = 0; row < 2; ++row) {
    form.set(row, 0, constant(exactly(centre[row])));
    for (std::size_t column = 0; column < 2; ++column) {
      const double factor = a[2 * row + column];
      if (factor != 0.0) form.set(row, 1 + column, exactly(factor) * radius);
    }
  }
}

void polar_form(const Intrinsics<Pinhole>& model, const AngleSeries& angle, PolarSeries& form) {
  set_focal(form, model.values.data(), angle.sine / angle.cosine);
}

void polar_form(const Intrinsics<Radtan>& model, const AngleSeries& angle, PolarSeries& form) {
  const double* p = model.values.data();
  const Series r = angle.sine / angle.cosine;
  const Series r2 = r * r;
  set_focal(form, p, r * polynomial(std::array{1.0, p[4], p[5], p[8]}, r2));
  add_tangential(form, p, p[6], p[7], r2);
}

void polar_form(const Intrinsics<Rational>& model, const AngleSeries& angle, PolarSeries& form) {
  const double* p = model.values.data();
  const Series r = angle.sine / angle.cosine;
  const Series r2 = r * r;
  set_focal(form, p,
            r * polynomial(std::array{1.0, p[4], p[5], p[8]}, r2) / polynomial(std::array{1.0, p[9], p[10], p[11]}, r2));
  add_tangential(form, p, p[6], p[7], r2);
}

void polar_form(const Intrinsics<Kb4>& model, const AngleSeries& angle, PolarSeries& form) {
  const double* p = model.values.data();
  set_focal(form, p, polynomial_of_angle(std::array{1.0, 0.0, p[4], 0.0, p[5], 0.0, p[6], 0.0, p[7]}, angle.at));
}

void polar_form(const Intrinsics<Ucm>& model, const AngleSeries& angle, PolarSeries& form) {
  const double* p = model.values.data();
  set_focal(form, p, unified_radius(exactly(p[4]), constant(exactly(1.0)), angle.cosine, angle.sine));
}

void polar_form(const Intrinsics<Eucm>& model, const AngleSeries& angle, PolarSeries& form) {
  // Without alpha beta counts for nothing, and a fit may leave any number there.
  if (model.values[4] == 0.0) return set_focal(form, model.values.data(), angle.sine / angle.cosine);
  const double* p = model.values.data();
  // d^2 = beta sin^2 + cos^2 = beta + (1 - beta) cos^2
  const Series d = sqrt(exactly(p[5]) + (exactly(1.0) - exactly(p[5])) * (angle.cosine * angle.cosine));
  set_focal(form, p, unified_radius(exactly(p[4]), d, angle.cosine, angle.sine));
}

void polar_form(const Intrinsics<Ds>& model, const AngleSeries& angle, PolarSeries& form) {
  const double* p = model.values.data();
  const Ball xi = exactly(p[5]);
  // d2^2 = sin^2 + (xi + cos)^2 = 1 + xi^2 + 2 xi cos
  const Series d2 = sqrt((exactly(1.0) + xi * xi) + (exactly(2.0) * xi) * angle.cosine);
  set_focal(form, p, unified_radius(exactly(p[4]), d2, xi + angle.cosine, angle.sine));
}

void polar_form(const Intrinsics<Mei>& model, const AngleSeries& angle, PolarSeries& form) {
  const double* p = model.values.data();
  const Series r = angle.sine / (exactly(p[4]) + angle.cosine);
  const Series r2 = r * r;
  set_focal(form, p, r * polynomial(std::array{1.0, p[5], p[6]}, r2));
  add_tangential(form, p, p[7], p[8], r2);
}

void polar_form(const Intrinsics<Fov>& model, const AngleSeries& angle, PolarSeries& form) {
  const double* p = model.values.data();
  const Ball slope = exactly(2.0) * from_library(std::tan(0.5 * p[4]));
  // d/dangle atan2(k sin, cos) = k / (k^2 sin^2 + cos^2)
  const Series denominator = (slope * slope) + (exactly(1.0) - slope * slope) * (angle.cosine * angle.cosine);
  const Series derivative = constant(slope) / denominator;
  const double value = std::atan2(slope.mid * std::sin(angle.at.mid), std::cos(angle.at.mid));
  // At the centre, and by the largest derivative around it; rounding inside atan2 counts at most like a rotation of the ray.
  constexpr double kRotation = 8.0 * kRoundOff;
  const Ball start = from_library(value, derivative[0].magnitude() * angle.at.rad + kRotation);
  set_focal(form, p, inverse(exactly(p[4])) * integral(derivative, start));
}

void polar_form(const Intrinsics<Woodscape>& model, const AngleSeries& angle, PolarSeries& form) {
  const double* p = model.values.data();
  set_radial(form, {p[5], p[6]}, {1.0, 0.0, 0.0, p[4]}, polynomial_of_angle(std::array{p[0], p[1], p[2], p[3]}, angle.at));
}

void add_skew(double skew_px, double focal_v, double centre_v, PolarSeries& form) {
  const Ball shear = exactly(skew_px) / exactly(focal_v);
  for (std::size_t j = 0; j < kHarmonics; ++j) {
    if (!form.used[1][j]) continue;
    const Series moved = shear * (j == 0 ? exactly(-centre_v) + form.of[1][j] : form.of[1][j]);
    form.set(0, j, form.used[0][j] ? form.of[0][j] + moved : moved);
  }
  form.series_rest_px[0] += shear.magnitude() * form.series_rest_px[1];
}

void polar_form(const Intrinsics<Opencv14>& model, const AngleSeries& angle, PolarSeries& form) {
  const double* p = model.values.data();
  polar_form(rational_part(model), angle, form);
  const Series r = angle.sine / angle.cosine;
  const Series r2 = r * r;
  for (const std::size_t component : {std::size_t{0}, std::size_t{1}}) {
    const double* prism = p + 12 + 2 * component;
    form.set(component, 0,
             form.of[component][0] + exactly(p[component]) * (r2 * polynomial(std::array{prism[0], prism[1]}, r2)));
  }
}

void polar_form(const Intrinsics<Opencv14>& model, const AngleSeries& angle, PolarSeriesOf<kTiltedHarmonics>& form) {
  const double* p = model.values.data();
  Intrinsics<Opencv14> plane = model;
  std::ranges::copy(std::array{1.0, 1.0, 0.0, 0.0}, plane.values.begin());
  PolarSeries distorted;
  polar_form(plane, angle, distorted);
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

namespace {

/// F(rho, angle) = g(rho) sin - rho cos, whose root is ocamcalib's radius, and dF/drho.
struct ImplicitRadius {
  std::array<double, 9> g{};      ///< The height of the ray ahead of the camera, ascending.
  std::array<double, 8> slope{};  ///< dg/drho
  std::size_t degree = 0;

  explicit ImplicitRadius(const double* a) {
    for (std::size_t k = 0; k < g.size(); ++k) {
      g[k] = -a[k];
      if (k > 0) slope[k - 1] = static_cast<double>(k) * g[k];
      if (a[k] != 0.0) degree = k;
    }
  }

  /// Horner up to the last coefficient that is not 0.
  template <std::size_t N>
  static Ball at(const std::array<double, N>& coefficients, std::size_t last, const Ball& x) {
    Ball result;
    for (std::size_t k = std::min(last, N - 1) + 1; k-- > 0;) result = exactly(coefficients[k]) + result * x;
    return result;
  }
  [[nodiscard]] Ball value(const Ball& rho, const Ball& sine, const Ball& cosine) const {
    return at(g, degree, rho) * sine - rho * cosine;
  }
  [[nodiscard]] Ball derivative(const Ball& rho, const Ball& sine, const Ball& cosine) const {
    return at(slope, degree > 0 ? degree - 1 : 0, rho) * sine - cosine;
  }
};

/// The only rho near `guess` with F(rho, x) = 0, for every angle x of the ball: interval Newton (Moore 1966). If
/// guess - F(guess) / F'(X) lies inside X, X holds exactly one root for each x, and that is where it lies.
Ball enclose_root(const ImplicitRadius& f, double guess, const Ball& sine, const Ball& cosine) {
  const Ball centre = exactly(guess);
  const Ball residual = f.value(centre, sine, cosine);
  double rad = 2.0 * (residual / f.derivative(centre, sine, cosine)).magnitude();
  constexpr int kTries = 4;
  for (int i = 0; i < kTries; ++i, rad *= 2.0) {
    const Ball step = residual / f.derivative(Ball{guess, rad}, sine, cosine);
    const Ball next = centre - step;
    if (std::abs(next.mid - guess) + next.rad < rad) return next;
  }
  return unknown();
}

/// A polynomial of a series that becomes known coefficient by coefficient.
class PolynomialOf {
 public:
  using Coefficients = std::array<Ball, 9>;
  PolynomialOf(const Coefficients& c, std::size_t degree, const Series& x) : c_(c), degree_(degree), x_(x) {}

  /// Its coefficient number k, after all before it, once x is known up to that number: Horner's scheme.
  Ball coefficient(std::size_t k) {
    Ball result = k == 0 ? c_[degree_] : Ball{};
    for (std::size_t j = degree_; j-- > 0;) {
      sums_[j][k] = result;
      ProductSum product;
      for (std::size_t i = 0; i <= (j + 1 == degree_ ? 0 : k); ++i) product.add(sums_[j][i], x_[k - i]);
      result = k == 0 ? c_[j] + product.ball() : product.ball();
    }
    return result;
  }

 private:
  const Coefficients& c_;
  std::size_t degree_;
  const Series& x_;
  std::array<Series, std::tuple_size_v<Coefficients>> sums_;  ///< Before each multiplication with x.
};

/// The coefficients of rho(angle) behind the first one, from the differential equation rho' h(rho) = g(rho)^2 + rho^2,
/// h(rho) = g - rho dg/drho: what angle = atan2(rho, g(rho)) says of its derivative.
void continue_radius(const ImplicitRadius& f, Series& rho) {
  PolynomialOf::Coefficients g;
  PolynomialOf::Coefficients h;
  for (std::size_t k = 0; k < g.size(); ++k) {
    g[k] = exactly(f.g[k]);
    h[k] = exactly(1.0 - static_cast<double>(k)) * g[k];
  }
  PolynomialOf g_of_rho(g, f.degree, rho);
  PolynomialOf h_of_rho(h, f.degree, rho);
  Series g_series;
  Series h_series;
  Series slope;
  for (std::size_t k = 0; k < kOrder; ++k) {
    g_series[k] = g_of_rho.coefficient(k);
    h_series[k] = h_of_rho.coefficient(k);
    ProductSum heights;
    ProductSum radii;
    for (std::size_t i = 0; i <= k; ++i) {
      heights.add(g_series[i], g_series[k - i]);
      radii.add(rho[i], rho[k - i]);
    }
    ProductSum known;
    for (std::size_t i = 1; i <= k; ++i) known.add(h_series[i], slope[k - i]);
    slope[k] = (heights.ball() + radii.ball() - known.ball()) / h_series[0];
    rho[k + 1] = slope[k] / exactly(static_cast<double>(k + 1));
  }
}

}  // namespace

void polar_form(const Intrinsics<Ocamcalib>& model, const AngleSeries& angle, PolarSeries& form) {
  const double* p = model.values.data();
  constexpr std::size_t kA = 5;
  const ImplicitRadius f(p + kA);
  // The model's own root of the domain at the centre, in the image of a ray along x.
  const Ray ray = {std::sin(angle.at.mid), 0.0, std::cos(angle.at.mid)};
  double pixel[2];
  Series rho;
  if (angle.at.mid == 0.0 || Ocamcalib::project(p, ray.data(), pixel)) {
    const double guess = angle.at.mid == 0.0 ? 0.0 : pixel[0] - p[0];
    rho[0] = enclose_root(f, guess, angle.sine[0], angle.cosine[0]);
  } else {
    rho[0] = unknown();
  }
  continue_radius(f, rho);
  // u = cx + Y + e X, v = cy + c X + d Y with (X, Y) = rho (sin phi, cos phi)
  set_radial(form, {p[0], p[1]}, {1.0, p[4], p[3], p[2]}, rho);
}

}  // namespace fca::internal
