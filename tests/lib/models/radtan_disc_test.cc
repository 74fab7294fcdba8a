// SPDX-License-Identifier: BSD-3-Clause
// The domain of the radial-tangential distortion: a disc on which its Jacobian is positive definite (radial_tangential.h), so
// that no two points share an image. Checked with a Jacobian by differences of a formula written down again here.
#include "model_test_support.h"
#include "plane_jacobian.h"

namespace fca::test {
namespace {

using Coefficients = std::array<double, 5>;  // k1 k2 p1 p2 k3
using Real = long double;

std::array<Real, 2> distorted(const Coefficients& q, Real x, Real y) {
  const Real r2 = x * x + y * y;
  const Real radial = 1 + q[0] * r2 + q[1] * r2 * r2 + q[4] * r2 * r2 * r2;
  return {x * radial + 2 * q[2] * x * y + q[3] * (r2 + 2 * x * x), y * radial + q[2] * (r2 + 2 * y * y) + 2 * q[3] * x * y};
}

/// The smaller eigenvalue of the distortion's (symmetric) Jacobian at a point in polar coordinates.
Real smaller_eigenvalue(const Coefficients& q, Real r, Real azimuth) {
  const auto [a, b, c, d] = plane_jacobian([&q](Real x, Real y) { return distorted(q, x, y); }, r, azimuth);
  EXPECT_LE(std::abs(b - c), 1e-9L * (1 + std::abs(a) + std::abs(b) + std::abs(d)));  // the distortion is a gradient
  return (a + d) / 2 - std::sqrt((a - d) * (a - d) / 4 + c * c);
}

Real smallest_on_circle(const Coefficients& q, Real r) {
  // The extremes lie at and opposite to the azimuth of (p2, p1), or symmetrically about that line.
  const Real line = std::atan2(static_cast<Real>(q[2]), static_cast<Real>(q[3]));
  Real smallest = std::numeric_limits<Real>::infinity();
  constexpr int kDirections = 180;
  for (int i = 0; i < kDirections; ++i) {
    smallest = std::min(smallest, smaller_eigenvalue(q, r, line + 2 * std::numbers::pi_v<Real> * i / kDirections));
  }
  return smallest;
}

constexpr double kLargestRadius = 4.0;  // 76 degrees; the step of the differences is made for it

/// Lenses with tangential terms from none to a thousand times the usual.
std::vector<Coefficients> lenses() {
  std::vector<Coefficients> result;
  for (const TestCamera<Radtan>& camera : cameras_of<Radtan>()) {
    const auto& v = camera.intrinsics.values;
    result.push_back({v[4], v[5], v[6], v[7], v[8]});
  }
  std::mt19937_64 generator(3);
  std::normal_distribution<double> normal;
  for (const double tangential : {1e-3, 1e-2, 0.1, 0.5}) {
    for (int i = 0; i < 50; ++i) {
      result.push_back({0.3 * normal(generator), 0.1 * normal(generator), tangential * normal(generator),
                        tangential * normal(generator), 0.05 * normal(generator)});
    }
  }
  return result;
}

TEST(RadtanDisc, JacobianIsPositiveDefiniteInsideAndReachesZeroAtTheEdge) {
  int finite = 0;
  for (const Coefficients& q : lenses()) {
    SCOPED_TRACE(::testing::PrintToString(q));
    const double edge = internal::RadialTangential::max_radius(q.data());
    const double inner = std::min(edge, kLargestRadius);
    for (int i = 1; i < 100; ++i) EXPECT_GT(smallest_on_circle(q, inner * i / 100), 0) << i;
    if (edge > kLargestRadius) continue;
    ++finite;
    EXPECT_GT(smallest_on_circle(q, edge * (1 - 1e-6L)), 0);
    EXPECT_LE(smallest_on_circle(q, edge * (1 + 1e-6L)), 0);
  }
  EXPECT_GT(finite, 100);
}

// Every point of the disc comes back from its image as itself, not as another point: the disc does not fold onto itself.
TEST(RadtanDisc, NoPointInsideFolds) {
  for (const Coefficients& q : lenses()) {
    SCOPED_TRACE(::testing::PrintToString(q));
    const double edge = std::min(internal::RadialTangential::max_radius(q.data()), kLargestRadius);
    for (const double share : {0.1, 0.5, 0.9, 0.99, 0.9999, 0.999999}) {
      for (int i = 0; i < 36; ++i) {
        const double azimuth = 2.0 * std::numbers::pi * i / 36;
        const double point[2] = {share * edge * std::cos(azimuth), share * edge * std::sin(azimuth)};
        double image[2];
        double back[2];
        ASSERT_TRUE(internal::RadialTangential::distort<true>(q.data(), point[0], point[1], image));
        ASSERT_TRUE(internal::RadialTangential::undistort(q.data(), image, back)) << share << ' ' << azimuth;
        const double derivative = static_cast<double>(smaller_eigenvalue(q, share * edge, azimuth));
        const double tolerance = 1e-14 * (1.0 + edge) / std::min(1.0, derivative);
        EXPECT_LE(std::hypot(back[0] - point[0], back[1] - point[1]), tolerance) << share << ' ' << azimuth;
      }
    }
  }
}

}  // namespace
}  // namespace fca::test
