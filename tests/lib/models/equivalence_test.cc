// SPDX-License-Identifier: BSD-3-Clause
// Models that contain each other: the same pixels and the same domain, to 1e-12 relative.
#include "model_test_support.h"

namespace fca::test {
namespace {

template <CameraModelType A, CameraModelType B>
void expect_same(const Intrinsics<A>& a, const Intrinsics<B>& b) {
  const double end = A::max_angle(a.values.data());
  EXPECT_NEAR(end, B::max_angle(b.values.data()), 1e-7);  // acos and atan2 differ by sqrt(eps) at 180 degrees
  // Close to a pole of the formula the rounding of alpha alone moves the pixel by a share of eps / distance.
  constexpr double kMargin = 1e-2;
  for (const double angle : angles_up_to(end - kMargin)) {
    for (const double azimuth : some_azimuths()) {
      const auto pixel_a = project(a, ray_at(angle, azimuth));
      const auto pixel_b = project(b, ray_at(angle, azimuth));
      ASSERT_TRUE(pixel_a && pixel_b) << angle;
      const double scale = 1e-12 * std::hypot((*pixel_a)[0], (*pixel_a)[1]);
      EXPECT_NEAR((*pixel_a)[0], (*pixel_b)[0], scale) << angle;
      EXPECT_NEAR((*pixel_a)[1], (*pixel_b)[1], scale) << angle;
      const auto ray = unproject(b, *pixel_a);
      ASSERT_TRUE(ray) << angle;
      EXPECT_LE(angle_between(*ray, ray_at(angle, azimuth)), 1e-10) << angle;
    }
  }
}

const std::vector<double> kAlphas = {0.0, 0.2, 0.45, 0.5, 0.55, 0.8, 0.99};

TEST(Equivalence, MeiWithoutDistortionIsUcm) {
  for (const double xi : {0.0, 0.3, 0.9, 1.0, 1.2, 2.5}) {
    SCOPED_TRACE(xi);
    expect_same(Intrinsics<Mei>{{500, 510, 320, 240, xi, 0, 0, 0, 0}},
                Intrinsics<Ucm>{{500 / (1 + xi), 510 / (1 + xi), 320, 240, xi / (1 + xi)}});
  }
}

TEST(Equivalence, MeiWithXi0IsRadtan) {
  expect_same(Intrinsics<Mei>{{458, 457, 367, 248, 0, -0.28, 0.07, 0.0002, 0.00002}},
              Intrinsics<Radtan>{{458, 457, 367, 248, -0.28, 0.07, 0.0002, 0.00002, 0}});
}

TEST(Equivalence, RationalWithoutDenominatorIsRadtan) {
  expect_same(Intrinsics<Rational>{{458, 457, 367, 248, -0.28, 0.07, 0.0002, 0.00002, 0.01, 0, 0, 0}},
              Intrinsics<Radtan>{{458, 457, 367, 248, -0.28, 0.07, 0.0002, 0.00002, 0.01}});
}

// N = D cancels: the same lens in other words.
TEST(Equivalence, RationalWithEqualPolynomialsIsPinhole) {
  expect_same(Intrinsics<Pinhole>{{300, 310, 320, 240}},
              Intrinsics<Rational>{{300, 310, 320, 240, 0.5, 0.2, 0, 0, 0.1, 0.5, 0.2, 0.1}});
}

// f = a0 is a plane: tan(angle) = rho / |a0|.
TEST(Equivalence, OcamcalibOfDegree0IsPinhole) {
  expect_same(Intrinsics<Pinhole>{{300, 330, 320, 240}},
              Intrinsics<Ocamcalib>{{320, 240, 1.1, 0, 0, -300, 0, 0, 0, 0, 0, 0, 0, 0}});
}

// f = (rho^2 - r0^2) / (2 r0) is a paraboloid with its focus in the origin: rho = r0 tan(angle / 2), the stereographic lens.
TEST(Equivalence, OcamcalibParaboloidIsStereographic) {
  const double focal = 200.0;
  const double r0 = 2.0 * focal;
  expect_same(Intrinsics<Ocamcalib>{{320, 240, 1, 0, 0, -0.5 * r0, 0, 0.5 / r0, 0, 0, 0, 0, 0, 0}},
              Intrinsics<Ucm>{{0.5 * r0, 0.5 * r0, 320, 240, 0.5}});
}

TEST(Equivalence, EquidistantLenses) {
  expect_same(Intrinsics<Kb4>{{200, 210, 320, 240, 0, 0, 0, 0}}, Intrinsics<Woodscape>{{200, 0, 0, 0, 1.05, 320, 240}});
  expect_same(Intrinsics<Kb4>{{200, 210, 320, 240, 0.05, 0, 0, 0}}, Intrinsics<Woodscape>{{200, 0, 10, 0, 1.05, 320, 240}});
}

TEST(Equivalence, FthetaWithoutShearIsWoodscape) {
  expect_same(Intrinsics<Woodscape>{{330, -20, 40, -6, 1.05, 650, 470}},
              Intrinsics<Ftheta>{{330 * 1.05, -20 * 1.05, 40 * 1.05, -6 * 1.05, 0, 1 / 1.05, 0, 0, 650, 470}});
}

TEST(Equivalence, EucmWithBeta1IsUcm) {
  for (const double alpha : kAlphas) {
    SCOPED_TRACE(alpha);
    expect_same(Intrinsics<Eucm>{{300, 310, 320, 240, alpha, 1}}, Intrinsics<Ucm>{{300, 310, 320, 240, alpha}});
  }
}

TEST(Equivalence, DsWithXi0IsUcm) {
  for (const double alpha : kAlphas) {
    SCOPED_TRACE(alpha);
    expect_same(Intrinsics<Ds>{{300, 310, 320, 240, alpha, 0}}, Intrinsics<Ucm>{{300, 310, 320, 240, alpha}});
  }
}

// With alpha = 0 the second sphere is not used: m = (x, y) / (z + xi |ray|).
TEST(Equivalence, DsWithAlpha0IsMei) {
  for (const double xi : {0.0, 0.3, 0.9}) {
    SCOPED_TRACE(xi);
    expect_same(Intrinsics<Ds>{{300, 310, 320, 240, 0, xi}}, Intrinsics<Mei>{{300, 310, 320, 240, xi, 0, 0, 0, 0}});
  }
}

TEST(Equivalence, WithoutDistortionEverythingIsPinhole) {
  const Intrinsics<Pinhole> pinhole{{300, 310, 320, 240}};
  expect_same(pinhole, Intrinsics<Radtan>{{300, 310, 320, 240, 0, 0, 0, 0, 0}});
  expect_same(pinhole, Intrinsics<Rational>{{300, 310, 320, 240, 0, 0, 0, 0, 0, 0, 0, 0}});
  expect_same(pinhole, Intrinsics<Ucm>{{300, 310, 320, 240, 0}});
  expect_same(pinhole, Intrinsics<Eucm>{{300, 310, 320, 240, 0, 1.7}});
  expect_same(pinhole, Intrinsics<Ds>{{300, 310, 320, 240, 0, 0}});
  expect_same(pinhole, Intrinsics<Mei>{{300, 310, 320, 240, 0, 0, 0, 0, 0}});
}

// Stereographic, 2 tan(angle / 2), and orthographic, sin(angle), are UCM with alpha = 1/2 and 1: closed formulas.
TEST(Equivalence, StereographicAndOrthographic) {
  const Intrinsics<Ucm> stereographic{{1, 1, 0, 0, 0.5}};
  for (const double angle : angles_up_to(std::numbers::pi - 1e-3)) {
    const double expected = 2.0 * std::tan(0.5 * angle);
    EXPECT_NEAR((*project(stereographic, ray_at(angle, 0.0)))[0], expected, 1e-12 * expected) << angle;
  }
  const Intrinsics<Ucm> orthographic{{1, 1, 0, 0, 1.0}};
  for (const double angle : angles_up_to(0.5 * std::numbers::pi - 1e-6)) {
    EXPECT_NEAR((*project(orthographic, ray_at(angle, 0.0)))[0], std::sin(angle), 1e-15) << angle;
  }
}

}  // namespace
}  // namespace fca::test
