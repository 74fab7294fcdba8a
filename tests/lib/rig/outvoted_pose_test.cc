// SPDX-License-Identifier: BSD-3-Clause
// Which one pose is wrong where poses contradict each other.
#include <fca/rig/contradictions.h>
#include <fca/rig/outvoted_pose.h>

#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace fca::test {
namespace {

Transform shifted(double x, double y = 0.0, double z = 0.0) { return {{1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z, 0, 0, 0, 1}}; }

/// Cameras in a row, 0.1 m apart, each with its pose in the one before it and in the IMU.
Rig row_of(std::size_t cameras) {
  Rig rig;
  for (std::size_t i = 0; i < cameras; ++i) {
    Camera camera;
    camera.name = "cam" + std::to_string(i);
    rig.cameras.push_back(camera);
    if (i > 0) rig.poses.push_back({camera.name, "cam" + std::to_string(i - 1), shifted(-0.1)});
    rig.poses.push_back({camera.name, "imu0", shifted(-0.1 * static_cast<double>(i))});
  }
  return rig;
}

std::size_t place_of(const Rig& rig, const std::string& name) {
  std::size_t place = 0;
  while (name_of(rig.poses.at(place)) != name) ++place;
  return place;
}

TEST(OutvotedPose, NoneWhereAllAgree) { EXPECT_FALSE(outvoted_pose(row_of(4))); }

TEST(OutvotedPose, TwoPathsOutvoteOnePose) {
  for (const char* wrong : {"T_cam1_imu0", "T_cam2_imu0", "T_cam2_cam1"}) {
    Rig rig = row_of(4);
    const std::size_t place = place_of(rig, wrong);
    const Transform right = rig.poses[place].T_a_b;
    rig.poses[place].T_a_b = shifted(0.0, 0.02) * right;
    const auto found = outvoted_pose(rig);
    ASSERT_TRUE(found) << wrong;
    EXPECT_EQ(found->edge, place) << wrong;
    EXPECT_FALSE(found->by_order);
    EXPECT_NEAR(difference_of(found->T_a_b, right).distance_m, 0.0, 1e-12);
    EXPECT_TRUE(contradictions(without_pose(found->edge, rig)).empty());
  }
}

// Three statements of one pose.
TEST(OutvotedPose, TwoStatementsOutvoteAThird) {
  Rig rig;
  rig.poses = {{"cam1", "cam0", shifted(-0.2)}, {"cam1", "cam0", shifted(-0.1)}, {"cam0", "cam1", shifted(0.1)}};
  const auto found = outvoted_pose(rig);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->edge, 0U);
}

// Of the last camera either statement may be wrong; of a triangle any.
TEST(OutvotedPose, NobodyKnowsWhichOfTwo) {
  Rig end = row_of(3);
  end.poses[place_of(end, "T_cam2_cam1")].T_a_b = shifted(-0.1, 0.02);
  EXPECT_FALSE(outvoted_pose(end));
  Rig triangle = row_of(2);
  triangle.poses[place_of(triangle, "T_cam1_cam0")].T_a_b = shifted(-0.1, 0.02);
  EXPECT_FALSE(outvoted_pose(triangle));
}

// A stereo pair has its second camera on the right: the statement that says otherwise is the wrong one.
TEST(OutvotedPose, TheOrderOfThePairDecides) {
  Rig rig = row_of(2);
  const std::size_t place = place_of(rig, "T_cam1_cam0");
  rig.poses[place].T_a_b = shifted(0.1);
  const auto found = outvoted_pose(rig);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->edge, place);
  EXPECT_TRUE(found->by_order);
}

// Cameras that look away from each other are no pair, and stand on either side.
TEST(OutvotedPose, TheOrderOfNoPairDecidesNothing) {
  Rig rig = row_of(2);
  for (Camera& camera : rig.cameras) {
    camera.image_size = ImageSize{640, 480};
    camera.model = Intrinsics<Pinhole>{{400.0, 400.0, 319.5, 239.5}};
  }
  const Transform backwards = {{-1, 0, 0, -0.1, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1}};
  rig.poses[place_of(rig, "T_cam1_imu0")].T_a_b = backwards;
  rig.poses[place_of(rig, "T_cam1_cam0")].T_a_b = shifted(2.0) * backwards;
  EXPECT_FALSE(outvoted_pose(rig));
}

// Nor has a pair of which one stands above the other a usual order.
TEST(OutvotedPose, TheOrderOfAVerticalPairDecidesNothing) {
  for (const double wrong : {-0.1, 0.2}) {
    Rig rig;
    rig.cameras = row_of(2).cameras;
    rig.poses = {{"cam0", "imu0", shifted(0.0)}, {"cam1", "imu0", shifted(0.0, 0.1)}, {"cam1", "cam0", shifted(0.0, wrong)}};
    EXPECT_FALSE(outvoted_pose(rig));
  }
}

TEST(OutvotedPose, TwoWrongPosesAreNotDecided) {
  Rig rig = row_of(5);
  for (const char* wrong : {"T_cam1_imu0", "T_cam3_imu0"}) {
    Transform& T = rig.poses[place_of(rig, wrong)].T_a_b;
    T = shifted(0.0, 0.02) * T;
  }
  EXPECT_FALSE(outvoted_pose(rig));
}

// A mirror is no statement of a pose, and has findings of its own.
TEST(OutvotedPose, NoneAmongMatricesThatAreNoRotations) {
  Rig rig = row_of(4);
  rig.poses[place_of(rig, "T_cam2_imu0")].T_a_b(0, 0) = -1.0;
  EXPECT_FALSE(outvoted_pose(rig));
}

// Whichever of the poses in the middle of a row is wrong, and by however much.
RC_GTEST_PROP(OutvotedPose, IsTheOneThatWasMoved, ()) {
  Rig rig = row_of(*rc::gen::inRange<std::size_t>(4, 8));
  const std::size_t place = *rc::gen::suchThat(rc::gen::inRange<std::size_t>(0, rig.poses.size()), [&rig](std::size_t i) {
    const std::string last = rig.cameras.back().name;
    const PoseEdge& edge = rig.poses[i];
    return edge.a != last && edge.a != "cam0" && edge.b != "cam0";
  });
  const double metres = 0.001 * *rc::gen::inRange(2, 5000);
  rig.poses[place].T_a_b = shifted(0.0, metres) * rig.poses[place].T_a_b;
  const auto found = outvoted_pose(rig);
  RC_ASSERT(found.has_value());
  RC_ASSERT(found->edge == place);
}

}  // namespace
}  // namespace fca::test
