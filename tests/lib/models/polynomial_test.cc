// SPDX-License-Identifier: BSD-3-Clause
// polynomial.h against polynomials whose roots are known because they are made from them.
#include <fca/models/polynomial.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace fca::test {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

using Sextic = std::array<double, 7>;

/// scale * product of (1 - x / root) and (1 + ((x - a) / b)^2): p(0) > 0, real roots as given.
struct MadePolynomial {
  std::array<long double, 7> coefficients = {1};
  int degree = 0;
  void times(const std::vector<long double>& factor) {
    std::array<long double, 7> product = {};
    for (int i = 0; i <= degree; ++i) {
      for (std::size_t j = 0; j < factor.size(); ++j)
        product[static_cast<std::size_t>(i) + j] += coefficients[static_cast<std::size_t>(i)] * factor[j];
    }
    coefficients = product;
    degree += static_cast<int>(factor.size()) - 1;
  }
  void root(double x) { times({1, -1 / static_cast<long double>(x)}); }
  void no_root_near(double a, double b) { times({1 + (a / b) * (a / b), -2 * a / (b * b), 1 / (b * b)}); }
  [[nodiscard]] Sextic rounded() const {
    Sextic c;
    std::ranges::transform(coefficients, c.begin(), [](long double x) { return static_cast<double>(x); });
    return c;
  }
};

TEST(Polynomial, HornerIsTheSum) {
  EXPECT_EQ(evaluate_polynomial(std::array{1.0, 2.0, 3.0}, 10.0), 321.0);
  EXPECT_EQ(evaluate_polynomial(std::array{7.0}, 10.0), 7.0);
}

TEST(Polynomial, FirstRootOfMadePolynomials) {
  std::mt19937_64 generator(4);
  std::uniform_real_distribution<double> uniform(0.1, 3.0);
  std::uniform_int_distribution<int> count(0, 3);
  for (int i = 0; i < 2000; ++i) {
    MadePolynomial p;
    double first = kInf;
    std::vector<double> roots;
    for (int n = count(generator); n > 0; --n) {
      const double root = uniform(generator);
      // Roots apart from each other: close ones are as uncertain as the rounding of the coefficients makes them.
      if (std::ranges::any_of(roots, [root](double other) { return std::abs(other - root) < 0.05; })) continue;
      roots.push_back(root);
      p.root(root);
      first = std::min(first, root);
    }
    if (count(generator) == 0) p.root(-uniform(generator));
    if (count(generator) == 0) p.no_root_near(uniform(generator), 0.3);
    const Sextic c = p.rounded();
    SCOPED_TRACE(::testing::PrintToString(c));
    const double until = positive_until(c, kInf);
    if (std::isinf(first)) {
      EXPECT_EQ(until, kInf);
    } else {
      EXPECT_NEAR(until, first, 1e-11 * (1.0 + first));
    }
    EXPECT_NEAR(positive_until(c, 4.0), std::min(first, 4.0), 1e-11);
    for (const double upper : {0.0, 0.05, 0.5, 1.0, 2.0, 4.0}) EXPECT_EQ(positive_on(c, upper), upper < first) << upper;
  }
}

// Against values on a fine lattice: no on the lattice means no; yes means yes on the lattice; and the answers fit together.
RC_GTEST_PROP(Polynomial, AgreesWithALattice, ()) {
  Sextic c;
  for (double& x : c) x = 1e-3 * *rc::gen::inRange(-1000, 1001);
  const double upper = 1e-2 * *rc::gen::inRange(0, 400);
  const bool positive = positive_on(c, upper);
  const double until = positive_until(c, upper);
  RC_ASSERT(until >= 0.0 && until <= upper);
  RC_ASSERT(positive == (until == upper && c[0] > 0.0 && (upper == 0.0 || evaluate_polynomial(c, upper) > 0.0)));
  constexpr int kPoints = 500;
  for (int i = 0; i <= kPoints; ++i) {
    const double x = upper * i / kPoints;
    const double value = evaluate_polynomial(c, x);
    if (positive) RC_ASSERT(value > 0.0);
    if (x < until) RC_ASSERT(value > -1e-12);
  }
  if (until < upper && c[0] > 0.0) RC_ASSERT(std::abs(evaluate_polynomial(c, until)) < 1e-8 * std::pow(1.0 + until, 6));
  RC_ASSERT(positive_until(c, kInf) + 1e-9 >= until);
}

TEST(Polynomial, DoubleRootsCountAsZero) {
  const std::array<double, 3> touches = {1.0, -2.0, 1.0};  // (1 - x)^2
  EXPECT_FALSE(positive_on(touches, 2.0));
  EXPECT_FALSE(positive_on(touches, 1.0));
  EXPECT_TRUE(positive_on(touches, 0.999));
  EXPECT_NEAR(positive_until(touches, 2.0), 1.0, 1e-7);
  EXPECT_NEAR(positive_until(touches, kInf), 1.0, 1e-7);
  const std::array<double, 3> nearly = {1.0 + 1e-9, -2.0, 1.0};  // 1e-9 above zero at its lowest
  EXPECT_TRUE(positive_on(nearly, 2.0));
  EXPECT_EQ(positive_until(nearly, kInf), kInf);
  const std::array<double, 3> below = {1.0 - 1e-9, -2.0, 1.0};
  EXPECT_FALSE(positive_on(below, 2.0));
  EXPECT_NEAR(positive_until(below, kInf), 1.0 - std::sqrt(1e-9), 1e-9);
}

TEST(Polynomial, NothingIsPositiveFromZeroOrNotANumber) {
  EXPECT_EQ(positive_until(std::array{0.0, 1.0}, 1.0), 0.0);
  EXPECT_EQ(positive_until(std::array{-1.0, 2.0}, kInf), 0.0);
  EXPECT_FALSE(positive_on(std::array{0.0, 1.0}, 1.0));
  for (const std::size_t index : {0U, 1U, 2U}) {
    std::array<double, 3> c = {1.0, 0.5, 0.25};
    c[index] = kNaN;
    EXPECT_FALSE(positive_on(c, 1.0)) << index;
    EXPECT_LT(positive_until(c, 1.0), 1.0) << index;
    EXPECT_LT(positive_until(c, kInf), kInf) << index;
  }
  EXPECT_FALSE(positive_on(std::array{1.0, -kInf}, 1.0));
}

TEST(Polynomial, NeverEndingStretches) {
  EXPECT_EQ(positive_until(std::array{1.0, 0.0, 0.0}, kInf), kInf);
  EXPECT_EQ(positive_until(std::array{1.0, -1.9, 1.0}, kInf), kInf);
  EXPECT_EQ(positive_until(std::array{1.0, 0.0, 1e-20, 0.0}, kInf), kInf);
  EXPECT_NEAR(positive_until(std::array{1.0, -1e-6}, kInf), 1e6, 1e-3);
  EXPECT_NEAR(positive_until(std::array{1.0, 0.0, -1e6}, kInf), 1e-3, 1e-12);
}

TEST(InvertIncreasing, FindsTheValueFromAnyGuess) {
  const auto cubic = [](double x, double& value, double& derivative) {
    value = x + x * x * x;
    derivative = 1.0 + 3.0 * x * x;
  };
  for (const double upper : {5.0, kInf}) {
    for (const double expected : {0.0, 1e-12, 0.1, 1.0, 4.999}) {
      for (const double guess : {0.0, 1e-30, 0.5, 4.9, 100.0, -3.0, kNaN}) {
        double x = guess;
        ASSERT_TRUE(invert_increasing(cubic, expected + expected * expected * expected, upper, x)) << expected << ' ' << guess;
        EXPECT_NEAR(x, expected, 4e-16 * (1.0 + expected)) << guess;
      }
    }
  }
  double x = 1.0;
  EXPECT_FALSE(invert_increasing(cubic, 131.0, 5.0, x));  // f(5) = 130
  EXPECT_FALSE(invert_increasing(cubic, kNaN, 5.0, x));
  x = 1.0;
  ASSERT_TRUE(invert_increasing(cubic, 1e30, kInf, x));
  EXPECT_NEAR(x, 1e10, 1e-5);
}

// Where the derivative ends at 0 the value is known to rounding, so the place to its square root.
TEST(InvertIncreasing, ConvergesWhereTheDerivativeEnds) {
  const auto folding = [](double x, double& value, double& derivative) {
    value = x - x * x * x / 3.0;
    derivative = 1.0 - x * x;
  };
  for (const double distance : {1e-2, 1e-4, 1e-6, 1e-7}) {
    const double expected = 1.0 - distance;
    double x = 0.3;
    ASSERT_TRUE(invert_increasing(folding, expected - expected * expected * expected / 3.0, 1.0, x)) << distance;
    EXPECT_NEAR(x, expected, 4e-16 / distance) << distance;
  }
}

// From this guess Newton's method goes back and forth between two places, each time a little nearer: for thousands of steps.
TEST(InvertIncreasing, FindsTheValueWhereNewtonsMethodAlternates) {
  const std::array lens = {1.0, 0.036914, 0.0132654, 0.00651276, -0.00335524};  // a kb4's radius over the angle, by its square
  const auto radius = [&](double angle, double& value, double& derivative) {
    const double t = angle * angle;
    value = angle * evaluate_polynomial(lens, t);
    derivative = evaluate_polynomial(std::array{1.0, 3.0 * lens[1], 5.0 * lens[2], 7.0 * lens[3], 9.0 * lens[4]}, t);
  };
  const double wanted = 1.8218903378962639;
  double angle = wanted;
  ASSERT_TRUE(invert_increasing(radius, wanted, 1.8331, angle));
  double value = 0.0;
  double derivative = 0.0;
  radius(angle, value, derivative);
  EXPECT_NEAR(value, wanted, 1e-14);
}

}  // namespace
}  // namespace fca::test
