// SPDX-License-Identifier: BSD-3-Clause
// The domain of the distortion with a thin prism: a disc on which the symmetric part of its Jacobian is positive definite
// (radial_tangential.h), so that no two points share an image. Checked with a Jacobian by differences of a formula written down
// again here.
#include "model_test_support.h"
#include "plane_jacobian.h"

namespace fca::test {
namespace {

using Coefficients = std::array<double, 12>;  // k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4
using Real = long double;
using Distortion = internal::TangentialOver<internal::PrismFactor>;

std::array<Real, 2> distorted(const Coefficients& q, Real x, Real y) {
  const Real r2 = x * x + y * y;
  const Real radial =
      (1 + q[0] * r2 + q[1] * r2 * r2 + q[4] * r2 * r2 * r2) / (1 + q[5] * r2 + q[6] * r2 * r2 + q[7] * r2 * r2 * r2);
  return {x * radial + 2 * q[2] * x * y + q[3] * (r2 + 2 * x * x) + q[8] * r2 + q[9] * r2 * r2,
          y * radial + q[2] * (r2 + 2 * y * y) + 2 * q[3] * x * y + q[10] * r2 + q[11] * r2 * r2};
}

/// The smaller eigenvalue of the symmetric part of the Jacobian at a point in polar coordinates.
Real smaller_eigenvalue(const Coefficients& q, Real r, Real azimuth) {
  const auto [a, b, c, d] = plane_jacobian([&q](Real x, Real y) { return distorted(q, x, y); }, r, azimuth);
  const Real mixed = (b + c) / 2;
  return (a + d) / 2 - std::sqrt((a - d) * (a - d) / 4 + mixed * mixed);
}

constexpr double kLargestRadius = 4.0;  // 76 degrees; the step of the differences is made for it

std::vector<Coefficients> lenses() {
  std::vector<Coefficients> result;
  for (const TestCamera<Opencv14>& camera : cameras_of<Opencv14>()) {
    Coefficients& q = result.emplace_back();
    std::copy_n(camera.intrinsics.values.begin() + 4, q.size(), q.begin());
  }
  // A lens whose distortion grows faster along the radius than across it: here the conditions are nearest to each other.
  result.push_back({0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0});
  result.push_back({1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.1, 0.0});
  std::mt19937_64 generator(4);
  std::normal_distribution<double> normal;
  for (const double prism : {1e-3, 1e-2, 0.1}) {
    for (int i = 0; i < 40; ++i) {
      Coefficients& q = result.emplace_back();
      const std::array<double, 12> sizes = {0.3, 0.1, 0.01, 0.01, 0.05, 0.2, 0.05, 0.01, prism, prism, prism, prism};
      for (std::size_t j = 0; j < q.size(); ++j) q[j] = sizes[j] * normal(generator);
    }
  }
  return result;
}

TEST(PrismDisc, JacobianIsPositiveDefiniteInside) {
  int finite = 0;
  for (const Coefficients& q : lenses()) {
    SCOPED_TRACE(::testing::PrintToString(q));
    const double edge = Distortion::max_radius(q.data());
    finite += edge < kLargestRadius ? 1 : 0;
    const double inner = std::min(edge * (1.0 - 1e-6), kLargestRadius);
    for (int i = 1; i <= 50; ++i) {
      for (int k = 0; k < 60; ++k) {
        const Real azimuth = 2 * std::numbers::pi_v<Real> * k / 60;
        EXPECT_GT(smaller_eigenvalue(q, inner * i / 50, azimuth), -1e-9L) << i << ' ' << k;
      }
    }
  }
  EXPECT_GT(finite, 60);
}

// A prism shortens the disc, and by little where it is weak.
TEST(PrismDisc, AWeakPrismChangesTheDiscByLittle) {
  Coefficients q = {-0.28, 0.02, 4e-4, -3e-4, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  const double without = Distortion::max_radius(q.data());
  q[8] = 1e-4;
  q[11] = -1e-4;
  const double with = Distortion::max_radius(q.data());
  EXPECT_LE(with, without);
  EXPECT_GT(with, 0.99 * without);
}

// Every point of the disc comes back from its image as itself, not as another point.
TEST(PrismDisc, NoPointInsideFolds) {
  for (const Coefficients& q : lenses()) {
    SCOPED_TRACE(::testing::PrintToString(q));
    const double edge = std::min(Distortion::max_radius(q.data()), kLargestRadius);
    for (const double share : {0.1, 0.5, 0.9, 0.99, 0.9999}) {
      for (int i = 0; i < 36; ++i) {
        const double azimuth = 2.0 * std::numbers::pi * i / 36;
        const double point[2] = {share * edge * std::cos(azimuth), share * edge * std::sin(azimuth)};
        double image[2];
        double back[2];
        ASSERT_TRUE(Distortion::distort<true>(q.data(), point[0], point[1], image));
        ASSERT_TRUE(Distortion::undistort(q.data(), image, back)) << share << ' ' << azimuth;
        const double derivative = static_cast<double>(smaller_eigenvalue(q, share * edge, azimuth));
        const double tolerance = 1e-12 * (1.0 + edge) / std::min(1.0, derivative);
        EXPECT_LE(std::hypot(back[0] - point[0], back[1] - point[1]), tolerance) << share << ' ' << azimuth;
      }
    }
  }
}

}  // namespace
}  // namespace fca::test
