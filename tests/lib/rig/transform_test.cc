// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/transform.h>

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "transforms.h"

namespace fca::test {
namespace {

/// Kalibr's T_cam_imu of TUM-VI's cam0 (camchain of the dataset), a rotation printed with all digits.
constexpr Transform kTumVi{{-0.9995250378696743, 0.029615343885863205, -0.008522328211654736, 0.04727988224914392,
                            0.0075019185074052044, -0.03439736061393144, -0.9993800792498829, -0.047443232143367084,
                            -0.02989013031643309, -0.998969345370175, 0.03415885127385616, -0.0681999605066297, 0.0, 0.0, 0.0,
                            1.0}};

/// A rotation (by a random unit quaternion) and a translation of up to `metres`.
Transform random_pose(std::mt19937_64& generator, double metres) {
  std::normal_distribution<double> normal;
  double w = normal(generator);
  double x = normal(generator);
  double y = normal(generator);
  double z = normal(generator);
  const double length = std::sqrt(w * w + x * x + y * y + z * z);
  w /= length, x /= length, y /= length, z /= length;
  std::uniform_real_distribution<double> uniform(-metres, metres);
  return {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), uniform(generator), 2 * (x * y + w * z),
           1 - 2 * (x * x + z * z), 2 * (y * z - w * x), uniform(generator), 2 * (x * z - w * y), 2 * (y * z + w * x),
           1 - 2 * (x * x + y * y), uniform(generator), 0, 0, 0, 1}};
}

TEST(Transform, DefaultIsTheIdentity) {
  EXPECT_EQ(Transform{} * kTumVi, kTumVi);
  EXPECT_EQ(kTumVi * Transform{}, kTumVi);
  EXPECT_EQ(inverse(Transform{}), Transform{});
}

TEST(Transform, IsStoredByRowsAndTakesPointsFromTheRight) {
  Transform T;
  T(0, 3) = 5.0;  // the translation's x
  T(1, 0) = 2.0;
  EXPECT_EQ(T.values[3], 5.0);
  EXPECT_EQ(T.values[4], 2.0);
  // Rotation by 90 degrees about z takes x to y; then a step along x.
  const Transform T_b_c{{0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
  const Transform T_a_b{{1, 0, 0, 7, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
  EXPECT_EQ(T_a_b * T_b_c, (Transform{{0, -1, 0, 7, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}));
}

TEST(Transform, InvertedTwiceIsItselfWithin1e12) {
  EXPECT_LE(element_difference(*inverse(*inverse(kTumVi)), kTumVi), 1e-12);
  std::mt19937_64 generator(5);
  for (int i = 0; i < 200; ++i) {
    Transform pose = random_pose(generator, 10.0);
    pose(0, 0) += 1e-4;  // as after printing with few digits: not quite a rotation
    EXPECT_LE(element_difference(*inverse(*inverse(pose)), pose), 1e-12);
    EXPECT_LE(element_difference(pose * *inverse(pose), Transform{}), 1e-12);
    EXPECT_LE(element_difference(*inverse(pose) * pose, Transform{}), 1e-12);
  }
}

TEST(Transform, InverseOfARotationIsItsTranspose) {
  const Transform T_b_a = *inverse(kTumVi);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) EXPECT_NEAR(T_b_a(row, column), kTumVi(column, row), 1e-12);
  }
}

TEST(Transform, SingularOrNotANumberHasNoInverse) {
  EXPECT_FALSE(inverse(Transform{{0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 1}}));
  EXPECT_FALSE(inverse(Transform{{1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 0, 0, 0, 1}}));
  EXPECT_FALSE(inverse(Transform{{.1, .2, .3, 0, .4, .5, .6, 0, .7, .8, .9, 0, 0, 0, 0, 1}}));  // singular up to rounding
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (std::size_t i = 0; i < 12; ++i) {
      Transform T = kTumVi;
      T.values[i] = value;
      EXPECT_FALSE(inverse(T)) << i;
    }
  }
}

// A matrix in millimetres is as invertible as one in metres.
TEST(Transform, SmallScalesAreNotSingular) {
  Transform T = kTumVi;
  for (std::size_t i = 0; i < 12; ++i) T.values[i] *= 1e-9;
  ASSERT_TRUE(inverse(T));
  EXPECT_LE(element_difference(T * *inverse(T), Transform{}), 1e-12);
}

TEST(Transform, DefectAndDeterminant) {
  EXPECT_LE(rotation_defect(kTumVi), 1e-12);
  EXPECT_NEAR(rotation_determinant(kTumVi), 1.0, 1e-12);
  EXPECT_NEAR(rotation_determinant(Transform{{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}), -1.0, 0.0);
  EXPECT_NEAR(rotation_defect(Transform{{1.01, 0, 0, 9, 0, 1, 0, 9, 0, 0, 1, 9, 0, 0, 0, 1}}), 0.0201, 1e-15);
  // Printed with four digits.
  Transform printed = kTumVi;
  for (std::size_t i = 0; i < 12; ++i) printed.values[i] = std::round(printed.values[i] * 1e4) / 1e4;
  EXPECT_GT(rotation_defect(printed), 1e-6);
  EXPECT_LT(rotation_defect(printed), 2e-4);
}

}  // namespace
}  // namespace fca::test
