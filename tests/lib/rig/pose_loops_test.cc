// SPDX-License-Identifier: BSD-3-Clause
// Where poses that are specified twice contradict each other, and by how much.
#include <fca/rig/pose_loops.h>
#include <fca/rig/rotation.h>

#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace fca::test {
namespace {

/// Turned about z by an angle, and moved.
Transform pose(double angle, double x, double y = 0.0, double z = 0.0) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {{c, -s, 0, x, s, c, 0, y, 0, 0, 1, z, 0, 0, 0, 1}};
}

/// Four cameras as a camchain specifies them: the pose of each in the IMU, and in the camera before it. The latter are off by
/// `angles` and `shifts`.
Rig quad(const std::array<double, 3>& angles, const std::array<double, 3>& shifts) {
  Rig rig;
  const auto in_imu = [](std::size_t i) {
    const auto number = static_cast<double>(i);
    return pose(0.7 * number, 0.1 * number, -0.2, 0.05 * number);
  };
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string name = "cam" + std::to_string(i);
    if (i > 0) {
      const Transform chain = in_imu(i) * inverse(in_imu(i - 1)).value();
      rig.poses.push_back({name, "cam" + std::to_string(i - 1), pose(angles.at(i - 1), shifts.at(i - 1)) * chain});
    }
    rig.poses.push_back({name, "imu0", in_imu(i)});
  }
  return rig;
}

TEST(PoseLoops, AllOfAQuadRig) {
  const Rig rig = quad({0.03, 0.04, 0.05}, {0.0, 0.0, 0.0});
  const std::vector<PoseLoop> found = contradicting_loops(rig);
  ASSERT_EQ(found.size(), 3U);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const PoseLoop& loop = found[i];
    EXPECT_EQ(rig.poses[loop.edge].a, "cam" + std::to_string(i + 1));
    EXPECT_EQ(rig.poses[loop.edge].b, "imu0");
    EXPECT_EQ(loop.path, (std::vector<std::size_t>{2 * i + 1, 2 * i}));
    EXPECT_NEAR(loop.difference.angle_rad, 0.03 + 0.01 * static_cast<double>(i), 1e-12);
  }
}

TEST(PoseLoops, SayByHowManyMetres) {
  const std::vector<PoseLoop> found = contradicting_loops(quad({0.0, 0.0, 0.0}, {0.0, 0.02, 0.0}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].difference.distance_m, 0.02, 1e-12);
  EXPECT_NEAR(found[0].difference.largest_element, 0.02, 1e-12);
  EXPECT_NEAR(found[0].difference.angle_rad, 0.0, 1e-7);
}

TEST(PoseLoops, NoneWhereBothSayTheSame) {
  const Rig rig = quad({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0});
  EXPECT_EQ(pose_loops(rig).size(), 3U);
  EXPECT_TRUE(contradicting_loops(rig).empty());
  EXPECT_TRUE(contradicting_loops(quad({9e-4, 0.0, 0.0}, {0.0, 9e-4, 0.0})).empty()) << "what printed digits do";
}

TEST(PoseLoops, OfTwoStatementsOfOnePose) {
  Rig rig;
  rig.poses = {
      {"cam1", "cam0", pose(0.1, 0.2)}, {"cam0", "cam1", inverse(pose(0.1, 0.2)).value()}, {"cam1", "cam0", pose(0.1, 0.3)}};
  const std::vector<PoseLoop> found = contradicting_loops(rig);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].edge, 2U);
  EXPECT_EQ(found[0].path, std::vector<std::size_t>{0});
  EXPECT_NEAR(found[0].difference.distance_m, 0.1, 1e-12);
}

TEST(PoseLoops, NoLoopInAChainOrBetweenRigs) {
  Rig rig;
  EXPECT_TRUE(pose_loops(rig).empty());
  rig.poses = {{"cam1", "cam0", pose(0.1, 0.2)}, {"cam2", "cam1", pose(0.2, 0.2)}, {"b", "a", pose(0.3, 0.2)}};
  EXPECT_TRUE(pose_loops(rig).empty());
}

TEST(PoseLoops, APoseThatHasNoInverseClosesNoLoopBackwards) {
  Rig rig;
  Transform flat;
  flat(2, 2) = 0.0;
  rig.poses = {{"cam0", "imu0", flat}, {"imu0", "cam0", pose(0.0, 0.1)}, {"cam0", "imu0", pose(0.0, -0.1)}};
  const std::vector<PoseLoop> found = contradicting_loops(rig);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].edge, 2U);
}

// As many loops as edges beyond a tree, and none of them contradicts where every pose comes from one estimate.
RC_GTEST_PROP(PoseLoops, OneEstimateNeverContradictsItself, ()) {
  const int frames = *rc::gen::inRange(2, 7);
  std::vector<Transform> in_world;
  const auto number = [](double scale) { return scale * 0.001 * *rc::gen::inRange(-1000, 1000); };
  for (int i = 0; i < frames; ++i) in_world.push_back(pose(number(3.0), number(1.0), number(1.0), number(1.0)));
  Rig rig;
  for (int i = 1; i < frames; ++i) {
    const int j = *rc::gen::inRange(0, i);
    rig.poses.push_back({std::to_string(i), std::to_string(j),
                         inverse(in_world.at(static_cast<std::size_t>(i))).value() * in_world.at(static_cast<std::size_t>(j))});
  }
  const auto extra = *rc::gen::inRange<std::size_t>(0, 5);
  for (std::size_t k = 0; k < extra; ++k) {
    const auto i = *rc::gen::inRange<std::size_t>(0, static_cast<std::size_t>(frames));
    const auto j = (i + *rc::gen::inRange<std::size_t>(1, static_cast<std::size_t>(frames))) % static_cast<std::size_t>(frames);
    rig.poses.push_back({std::to_string(i), std::to_string(j), inverse(in_world.at(i)).value() * in_world.at(j)});
  }
  RC_ASSERT(pose_loops(rig).size() == extra);
  RC_ASSERT(contradicting_loops(rig).empty());
  if (extra == 0) return;
  rig.poses.back().T_a_b = pose(0.0, 0.5) * rig.poses.back().T_a_b;
  const std::vector<PoseLoop> found = contradicting_loops(rig);
  RC_ASSERT(found.size() == 1U);
  RC_ASSERT(found.front().edge == rig.poses.size() - 1);
}

}  // namespace
}  // namespace fca::test
