// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/rig.h>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace fca::test {
namespace {

Transform shift(double x, double y, double z) { return {{1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z, 0, 0, 0, 1}}; }
constexpr Transform kQuarterTurn{{0, -1, 0, 0.1, 1, 0, 0, 0.2, 0, 0, 1, 0.3, 0, 0, 0, 1}};  // about z
constexpr Transform kOtherTurn{{1, 0, 0, -0.1, 0, 0, -1, 0.05, 0, 1, 0, 0, 0, 0, 0, 1}};    // about x

void expect_near(const std::optional<Transform>& actual, const Transform& expected) {
  ASSERT_TRUE(actual);
  for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(actual->values[i], expected.values[i], 1e-15) << i;
}

/// Kalibr's chain: T_cam_imu of cam0, and T_cn_cnm1 of cam1 (from cam0) and cam2 (from cam1).
Rig chain() {
  Rig rig;
  rig.poses = {{"cam0", "imu0", kQuarterTurn}, {"cam1", "cam0", kOtherTurn}, {"cam2", "cam1", shift(1, 2, 3)}};
  return rig;
}

TEST(Rig, ResolvesThroughAChain) {
  const Rig rig = chain();
  expect_near(rig.resolve("cam1", "imu0"), kOtherTurn * kQuarterTurn);
  expect_near(rig.resolve("cam2", "imu0"), shift(1, 2, 3) * kOtherTurn * kQuarterTurn);
}

TEST(Rig, ResolvesAgainstTheStatedDirection) {
  const Rig rig = chain();
  expect_near(rig.resolve("imu0", "cam0"), *inverse(kQuarterTurn));
  expect_near(rig.resolve("cam0", "cam2"), *inverse(shift(1, 2, 3) * kOtherTurn));
  expect_near(*rig.resolve("imu0", "cam2") * *rig.resolve("cam2", "imu0"), Transform{});
}

// A point of the IMU at (1, 0, 0), followed by hand: a quarter turn about z takes it to (0, 1, 0), plus the translation.
TEST(Rig, T_a_b_TakesPointsOfBToA) {
  const Transform T_cam0_imu = *chain().resolve("cam0", "imu0");
  EXPECT_DOUBLE_EQ(T_cam0_imu(0, 0) + T_cam0_imu(0, 3), 0.1);
  EXPECT_DOUBLE_EQ(T_cam0_imu(1, 0) + T_cam0_imu(1, 3), 1.2);
  EXPECT_DOUBLE_EQ(T_cam0_imu(2, 0) + T_cam0_imu(2, 3), 0.3);
}

TEST(Rig, StatedIsExactAndOneWay) {
  const Rig rig = chain();
  ASSERT_NE(rig.stated("cam1", "cam0"), nullptr);
  EXPECT_EQ(*rig.stated("cam1", "cam0"), kOtherTurn);
  EXPECT_EQ(rig.stated("cam0", "cam1"), nullptr);
  EXPECT_EQ(rig.stated("cam2", "cam0"), nullptr);
}

// A file that says both T_cam1_imu and the chain: the shorter path wins, so the stated one, exactly.
TEST(Rig, ShorterPathsWin) {
  Rig rig = chain();
  rig.poses.push_back({"cam1", "imu0", shift(9, 9, 9)});
  EXPECT_EQ(rig.resolve("cam1", "imu0"), shift(9, 9, 9));
}

TEST(Rig, AmongEqualPathsTheFirstReadWins) {
  Rig rig;
  rig.poses = {{"a", "b", shift(1, 0, 0)}, {"a", "b", shift(2, 0, 0)}};
  EXPECT_EQ(rig.resolve("a", "b"), shift(1, 0, 0));
}

TEST(Rig, NothingIfNotConnected) {
  Rig rig = chain();
  rig.poses.push_back({"cam7", "imu7", shift(1, 0, 0)});
  EXPECT_FALSE(rig.resolve("cam0", "cam7"));
  EXPECT_FALSE(rig.resolve("cam0", "nobody"));
  EXPECT_FALSE(rig.resolve("nobody", "cam0"));
  EXPECT_FALSE(Rig{}.resolve("cam0", "imu0"));
}

TEST(Rig, ToItselfIsTheIdentity) { EXPECT_EQ(chain().resolve("cam1", "cam1"), Transform{}); }

// An edge without an inverse is usable in its own direction only, and does not hide a longer way.
TEST(Rig, SingularEdgesAreNotInverted) {
  Rig rig;
  Transform singular;
  singular(2, 2) = 0.0;
  rig.poses = {{"a", "b", singular}};
  EXPECT_EQ(rig.resolve("a", "b"), singular);
  EXPECT_FALSE(rig.resolve("b", "a"));
  rig.poses.push_back({"b", "c", shift(1, 0, 0)});
  rig.poses.push_back({"c", "a", shift(0, 1, 0)});
  expect_near(rig.resolve("b", "a"), shift(1, 1, 0));
}

TEST(Rig, CyclesEnd) {
  Rig rig = chain();
  rig.poses.push_back({"imu0", "cam2", shift(0, 0, 0)});
  rig.poses.push_back({"cam0", "cam0", shift(1, 1, 1)});
  EXPECT_TRUE(rig.resolve("cam1", "imu0"));
  EXPECT_FALSE(rig.resolve("cam1", "nobody"));
}

TEST(Rig, FindsCamerasByName) {
  Rig rig;
  rig.cameras.resize(2);
  rig.cameras[0].name = "cam0";
  rig.cameras[1].name = "left";
  EXPECT_EQ(rig.find_camera("left"), &rig.cameras[1]);
  EXPECT_EQ(rig.find_camera("cam1"), nullptr);
}

TEST(Rig, ComparesByValue) {
  EXPECT_EQ(chain(), chain());
  Rig changed = chain();
  changed.poses[0].T_a_b(0, 3) = std::nextafter(changed.poses[0].T_a_b(0, 3), 1.0);
  EXPECT_NE(changed, chain());
}

}  // namespace
}  // namespace fca::test
