// SPDX-License-Identifier: BSD-3-Clause
// A frame taken out of a rig: nobody speaks of it any more, and the others sit to each other as before.
#include <fca/rig/remove_frame.h>

#include <gtest/gtest.h>

namespace fca::test {
namespace {

Transform moved(double x, double y) {
  Transform T;
  T(0, 3) = x;
  T(1, 3) = y;
  return T;
}

TEST(RemoveFrame, TheMiddleOfAChainLeavesItsEndsTogether) {
  Rig rig;
  rig.poses = {{"cam0", "imu0", moved(1, 0)}, {"cam1", "cam0", moved(0, 1)}, {"cam2", "cam1", moved(2, 3)}};
  const Transform before = rig.resolve("cam2", "cam0").value();
  remove_frame("cam1", rig);
  EXPECT_EQ(rig.poses.size(), 2U);
  EXPECT_FALSE(rig.resolve("cam1", "cam0"));
  ASSERT_NE(rig.stated("cam2", "cam0"), nullptr);
  EXPECT_EQ(*rig.stated("cam2", "cam0"), before);
}

TEST(RemoveFrame, WhatIsStatedOtherwiseIsNotStatedTwice) {
  Rig rig;
  rig.poses = {{"cam0", "imu0", moved(1, 0)}, {"cam1", "imu0", moved(1, 1)}, {"cam1", "cam0", moved(0, 1)}};
  remove_frame("cam1", rig);
  EXPECT_EQ(rig.poses, (std::vector<PoseEdge>{{"cam0", "imu0", moved(1, 0)}}));
}

TEST(RemoveFrame, AFrameAtTheEndOrUnknownChangesNothingElse) {
  Rig rig;
  rig.poses = {{"cam1", "cam0", moved(0, 1)}, {"vehicle", "cam0", moved(5, 1)}};
  remove_frame("cam7", rig);
  EXPECT_EQ(rig.poses.size(), 2U);
  remove_frame("vehicle", rig);
  EXPECT_EQ(rig.poses, (std::vector<PoseEdge>{{"cam1", "cam0", moved(0, 1)}}));
}

}  // namespace
}  // namespace fca::test
