// SPDX-License-Identifier: BSD-3-Clause
// Polynomials with ascending coefficients, p(x) = c[0] + c[1] x + ... + c[N-1] x^(N-1), and functions of one variable:
// where is p positive, and where does an increasing function take a value?
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace fca {

/// Horner's rule.
template <class T, std::size_t N>
[[nodiscard]] T evaluate_polynomial(const std::array<T, N>& coefficients, const T& x) {
  T value = coefficients[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) value = value * x + coefficients[i];
  return value;
}

namespace internal {

/// A polynomial over an interval in Bernstein form: its values at the ends are the first and the last coefficient, and all its
/// values lie between the smallest and the largest one.
template <std::size_t N>
struct Bernstein {
  std::array<double, N> coefficients{};
  std::size_t degree = N - 1;

  /// p over [0, upper], mapped to [0, 1]: b_i = sum_j C(i, j) / C(n, j) c_j upper^j.
  static Bernstein over(const std::array<double, N>& c, double upper) {
    Bernstein result;
    std::array<double, N>& b = result.coefficients;
    double scale = 1.0;
    for (std::size_t j = 0; j < N; ++j) {
      b[j] = c[j] * scale;
      if (j + 1 < N) scale *= upper * static_cast<double>(j + 1) / static_cast<double>(N - 1 - j);
    }
    for (std::size_t level = 1; level < N; ++level) {
      for (std::size_t i = N - 1; i >= level; --i) b[i] += b[i - 1];
    }
    return result;
  }

  /// (1 - t)^n p(t / (1 - t)) over [0, 1]: p over [0, infinity). Here b_i = c_i / C(n, i).
  static Bernstein over_half_line(const std::array<double, N>& c) {
    Bernstein result;
    while (result.degree > 0 && c[result.degree] == 0.0) --result.degree;
    double binomial = 1.0;
    for (std::size_t i = 0; i <= result.degree; ++i) {
      result.coefficients[i] = c[i] / binomial;
      binomial *= static_cast<double>(result.degree - i) / static_cast<double>(i + 1);
    }
    return result;
  }

  [[nodiscard]] bool all_positive() const {
    for (std::size_t i = 0; i <= degree; ++i) {
      if (!(coefficients[i] > 0.0)) return false;
    }
    return true;
  }

  /// The halves of the interval (de Casteljau): this becomes the left one, the right one is returned.
  Bernstein split() {
    Bernstein right = *this;
    for (std::size_t level = 0; level < degree; ++level) {
      right.coefficients[degree - level] = coefficients[degree];
      for (std::size_t i = degree; i > level; --i) coefficients[i] = 0.5 * (coefficients[i] + coefficients[i - 1]);
    }
    right.coefficients[0] = coefficients[degree];
    return right;
  }

  /// First positive, then negative coefficients: by the rule of signs there is one root, and a simple one.
  [[nodiscard]] bool has_one_root() const {
    std::size_t i = 0;
    while (i <= degree && coefficients[i] > 0.0) ++i;
    if (i == 0 || i > degree) return false;
    for (; i <= degree; ++i) {
      if (!(coefficients[i] < 0.0)) return false;
    }
    return true;
  }

  /// That root, by Newton's method inside a shrinking bracket.
  [[nodiscard]] double only_root() const {
    double low = 0.0;
    double high = 1.0;
    double t = 0.5;
    constexpr int kMaxSteps = 100;
    for (int step = 0; step < kMaxSteps; ++step) {
      std::array<double, N> b = coefficients;
      for (std::size_t level = degree; level > 1; --level) {
        for (std::size_t i = 0; i < level; ++i) b[i] += t * (b[i + 1] - b[i]);
      }
      const double rise = b[1] - b[0];
      const double value = b[0] + t * rise;
      (value > 0.0 ? low : high) = t;
      double next = t - value / (static_cast<double>(degree) * rise);
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      const bool converged = std::abs(next - t) <= std::numeric_limits<double>::epsilon() * t;
      t = next;
      if (converged) break;
    }
    return t;
  }

  /// The first place in [0, 1] where the polynomial is not positive; 2 if there is none. A polynomial that stays undecided
  /// after `depth` halvings comes so close to 0 that it counts as touching it.
  [[nodiscard]] double first_root(int depth) const {
    if (!(coefficients[0] > 0.0)) return 0.0;
    if (all_positive()) return 2.0;
    if (has_one_root()) return only_root();
    if (depth == 0) return 0.0;
    Bernstein left = *this;
    const Bernstein right = left.split();
    const double in_left = left.first_root(depth - 1);
    if (in_left <= 1.0) return 0.5 * in_left;
    const double in_right = right.first_root(depth - 1);
    return in_right <= 1.0 ? 0.5 + 0.5 * in_right : 2.0;
  }
};

inline constexpr int kMaxHalvings = 52;

}  // namespace internal

/// The end of the stretch [0, x) on which p > 0: p's first positive root, or `upper` if that comes first. 0 if p(0) <= 0.
/// Exact up to rounding, however many roots there are; NaN coefficients count as a root. `upper` may be infinite.
template <std::size_t N>
[[nodiscard]] double positive_until(const std::array<double, N>& coefficients, double upper) {
  using Form = internal::Bernstein<N>;
  if (std::isinf(upper)) {
    const double t = Form::over_half_line(coefficients).first_root(internal::kMaxHalvings);
    return t < 1.0 ? t / (1.0 - t) : upper;
  }
  const double t = Form::over(coefficients, upper).first_root(internal::kMaxHalvings);
  return t < 1.0 ? t * upper : upper;
}

/// Is p > 0 on all of [0, upper]? `upper` is finite.
template <std::size_t N>
[[nodiscard]] bool positive_on(const std::array<double, N>& coefficients, double upper) {
  // Nearly always enough: the negative terms at their largest, alone against c[0]. (!>= also keeps a NaN.)
  double lower_bound = 0.0;
  for (std::size_t i = N - 1; i > 0; --i) {
    lower_bound = (lower_bound + (!(coefficients[i] >= 0.0) ? coefficients[i] : 0.0)) * upper;
  }
  if (coefficients[0] + lower_bound > 0.0) return true;
  const auto form = internal::Bernstein<N>::over(coefficients, upper);
  return form.coefficients[N - 1] > 0.0 && form.first_root(internal::kMaxHalvings) > 1.0;
}

/// The x in [0, upper) with f(x) = y, for an f that increases there from f(0) = 0. Newton's method kept inside a shrinking
/// bracket, which every other step halves if Newton's goes back and forth: it always ends, and converges to the last digits.
/// False if f stays below y. `upper` may be infinite. f(x, value, derivative) gives both at once; `x` enters as a guess.
template <class F>
[[nodiscard]] bool invert_increasing(const F& f, double y, double upper, double& x) {
  double value = 0.0;
  double derivative = 0.0;
  double low = 0.0;
  double high = upper;
  if (std::isinf(upper)) {
    for (high = 1.0; f(high, value, derivative), value < y; high *= 2.0) low = high;
    if (!std::isfinite(high)) return false;
  } else {
    f(upper, value, derivative);
    if (!(y < value)) return false;
  }
  if (!(x >= low && x < high)) x = 0.5 * (low + high);
  constexpr int kMaxSteps = 200;
  constexpr int kNewtonAlone = 50;
  for (int i = 0; i < kMaxSteps; ++i) {
    f(x, value, derivative);
    const double error = value - y;
    if (error == 0.0) return true;
    (error > 0.0 ? high : low) = x;
    double next = x - error / derivative;
    const bool halve = i >= kNewtonAlone && i % 2 == 0;
    if (halve || !(next >= low && next < high)) next = 0.5 * (low + high);
    const bool converged = std::abs(next - x) <= 2.0 * std::numeric_limits<double>::epsilon() * x;
    x = next;
    if (converged) return true;
  }
  return false;
}

/// The same for an f whose derivative is positive where `inside` holds, between 0 and limit(): Newton's method from `guess`,
/// which nearly always ends inside after a few steps and asks for no limit; else the search.
template <class F, class Inside, class Limit>
[[nodiscard]] bool invert_inside(const F& f, double y, double guess, const Inside& inside, const Limit& limit, double& x) {
  constexpr int kMaxSteps = 10;
  x = guess;
  for (int i = 0; i < kMaxSteps; ++i) {
    double value = 0.0;
    double derivative = 0.0;
    f(x, value, derivative);
    const double step = (value - y) / derivative;
    x -= step;
    if (!(std::abs(step) <= 1e-10 * x)) continue;  // the next step would be about the square of this one
    if (inside(x)) return true;
    break;
  }
  x = guess;
  return invert_increasing(f, y, limit(), x);
}

}  // namespace fca
