// SPDX-License-Identifier: BSD-3-Clause
#include <fca/models/polynomial_fit.h>

#include <cmath>

#include <gtest/gtest.h>

namespace fca::test {
namespace {

double largest_error(const std::vector<double>& c, const std::vector<double>& x, const std::vector<double>& y) {
  double worst = 0.0;
  for (std::size_t j = 0; j < x.size(); ++j) {
    double value = 0.0;
    for (std::size_t i = c.size(); i-- > 0;) value = value * x[j] + c[i];
    worst = std::max(worst, std::abs(value - y[j]));
  }
  return worst;
}

std::vector<double> points(double from, double to, std::size_t count) {
  std::vector<double> x;
  for (std::size_t j = 0; j < count; ++j)
    x.push_back(from +
                (to - from) * 0.5 * (1.0 - std::cos(M_PI * (static_cast<double>(j) + 0.5) / static_cast<double>(count))));
  return x;
}

TEST(PolynomialFit, FindsAPolynomial) {
  const std::vector<double> x = points(-1.5, 0.5, 40);
  std::vector<double> y;
  for (const double v : x) y.push_back(3.0 - 2.0 * v + 0.25 * v * v * v);
  const std::vector<double> c = fit_powers(x, y, 4);
  const std::vector<double> expected = {3.0, -2.0, 0.0, 0.25};
  ASSERT_EQ(c.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(c[i], expected[i], 1e-13);
}

// 64 powers over [-1.5, -0.6] are dependent many times over; the fit stays as good as a double allows.
TEST(PolynomialFit, ManyDependentPowers) {
  const std::vector<double> x = points(-1.5, -0.6, 300);
  std::vector<double> y;
  for (const double v : x) y.push_back(100.0 * std::exp(v));
  for (const std::size_t count : {20U, 40U, 64U}) EXPECT_LE(largest_error(fit_powers(x, y, count), x, y), 1e-10) << count;
}

TEST(PolynomialFit, RefusesWhatCannotBe) {
  const std::vector<double> x = {0.0, 1.0};
  EXPECT_TRUE(fit_powers(x, x, 3).empty());
  EXPECT_TRUE(fit_powers(x, x, 0).empty());
  EXPECT_TRUE(fit_powers(std::vector<double>{0.0, 0.0}, x, 1).empty());
}

}  // namespace
}  // namespace fca::test
