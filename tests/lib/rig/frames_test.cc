// SPDX-License-Identifier: BSD-3-Clause
// What a frame is the rig knows; names say nothing.
#include <fca/rig/rig.h>

#include <gtest/gtest.h>

namespace fca::test {
namespace {

TEST(Frames, AreWhatTheRigHolds) {
  Rig rig;
  rig.cameras.emplace_back().name = "imu_camera";
  rig.imus.emplace_back().name = "xsens";
  rig.add_frame("car", FrameKind::kVehicle);
  rig.add_frame("gyro", FrameKind::kImu);
  EXPECT_EQ(rig.kind_of("imu_camera"), FrameKind::kCamera);
  EXPECT_EQ(rig.kind_of("xsens"), FrameKind::kImu);
  EXPECT_EQ(rig.kind_of("gyro"), FrameKind::kImu);
  EXPECT_EQ(rig.kind_of("car"), FrameKind::kVehicle);
  for (const char* name : {"imu0", "vehicle", "cam0", "body", ""}) EXPECT_EQ(rig.kind_of(name), FrameKind::kOther) << name;
}

TEST(Frames, AreListedOnce) {
  Rig rig;
  rig.add_frame("imu0", FrameKind::kImu);
  rig.add_frame("imu0", FrameKind::kImu);
  EXPECT_EQ(rig.frames, (std::vector<Frame>{{"imu0", FrameKind::kImu}}));
}

TEST(ExtraFields, AreFoundByOwnerAndKey) {
  Rig rig;
  rig.extra_fields = {{"", "line_delay", "1"}, {"cam0", "line_delay", "2"}, {"cam0 left", "line_delay", "3"}};
  ASSERT_NE(rig.find_extra_field("cam0", "line_delay"), nullptr);
  EXPECT_EQ(rig.find_extra_field("cam0", "line_delay")->value, "2");
  EXPECT_EQ(rig.find_extra_field("", "line_delay")->value, "1");
  EXPECT_EQ(rig.find_extra_field("cam0", "left line_delay"), nullptr) << "no owner is cut at a blank";
  EXPECT_EQ(with_owner(rig.extra_fields[0]), "line_delay");
  EXPECT_EQ(with_owner(rig.extra_fields[1]), "cam0 line_delay");
}

}  // namespace
}  // namespace fca::test
