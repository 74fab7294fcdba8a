// SPDX-License-Identifier: BSD-3-Clause
// Every pose of a rig is in the files written from it, follows from what they specify, or is a loss "pose-dropped": for every
// writer by one rule.
#include "formats/rigs.h"
#include "formats/test_files.h"

#include <fca/convert/convert.h>
#include <fca/formats/wording.h>

#include <initializer_list>

namespace fca::test {
namespace {

/// The rig with cameras that the format holds; which ones does not matter here.
Rig for_format(Rig rig, const Format& format) {
  const std::string model(format.models.front().model);
  for (Camera& camera : rig.cameras) {
    camera.image_size = ImageSize{640, 480};
    if (model == "ocamcalib") {
      camera.model = model_of(model, {320, 240, 1, 0, 0, -200, 0, 1.25e-3, 0, 0, 0, 0, 0, 0});
    } else if (model == "woodscape") {
      camera.model = model_of(model, {338.5, -30.25, 46.75, -6.875, 1.0, 319.5, 239.5});
    } else {
      camera.model = sample_model("kb4");
    }
  }
  return rig;
}

/// What is lost of the rig's poses: each loss's poses.
std::vector<std::string> lost(const Rig& rig, const std::string& to, const WriteOptions& options = {}) {
  const Format& format = *find_format(to);
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(format, nullptr, for_format(rig, format), options, diagnostics);
  EXPECT_TRUE(written) << to << (diagnostics.entries().empty() ? "" : message_of(diagnostics.entries().front()));
  std::vector<std::string> result;
  if (!written) return result;
  for (const Loss& loss : written->losses) {
    if (id_of(loss) != "pose-dropped") continue;
    EXPECT_FALSE(why_of(loss).empty());
    result.push_back(what_of(loss));
  }
  return result;
}

using Names = std::vector<std::string>;

Rig rig_with(std::initializer_list<std::string> cameras, std::vector<PoseEdge> poses) {
  Rig rig;
  for (const std::string& name : cameras) {
    rig.cameras.push_back({name, ImageSize{640, 480}, sample_model("kb4"), std::nullopt, std::nullopt, ""});
  }
  rig.poses = std::move(poses);
  return rig;
}

Transform T_vehicle_front() { return T_cam0_imu(); }
Transform T_vehicle_rear() { return T_cam1_cam0() * T_cam0_imu(); }

TEST(LostPoses, TheVehicleIsNamedByEveryWriterThatHasNoPlaceForIt) {
  const Rig rig = rig_with({"FV"}, {{"vehicle", "FV", T_vehicle_front()}});
  for (const char* to : {"kalibr", "opencv", "ocamcalib", "tumvi", "orbslam3"})
    EXPECT_EQ(lost(rig, to), Names{"T_vehicle_FV"}) << to;
  EXPECT_EQ(lost(rig, "woodscape"), Names{});
}

TEST(LostPoses, CamerasThatKeepTheirPosesToEachOtherLoseThatInTheVehicleOnce) {
  const Rig rig = rig_with({"FV", "RV"}, {{"vehicle", "FV", T_vehicle_front()}, {"vehicle", "RV", T_vehicle_rear()}});
  for (const char* to : {"kalibr", "opencv", "tumvi", "orbslam3"})
    EXPECT_EQ(lost(rig, to), Names{"T_vehicle_FV and T_vehicle_RV"}) << to;
  EXPECT_EQ(lost(rig, "ocamcalib"), Names{"T_vehicle_FV and T_vehicle_RV"});
  EXPECT_EQ(lost(rig, "woodscape"), Names{});
}

TEST(LostPoses, TheReasonSaysWhatIsKept) {
  const Rig rig = rig_with({"FV", "RV"}, {{"vehicle", "FV", T_vehicle_front()}, {"vehicle", "RV", T_vehicle_rear()}});
  Diagnostics diagnostics;
  const Written written = write_calibration(*find_format("kalibr"), nullptr, rig, {}, diagnostics).value();
  const Loss& loss = written.losses.back();
  EXPECT_EQ(loss.kind, Code::kPoseDropped);
  const Message group = {Code::kPosesOfGroup, {std::vector<std::string>{"FV", "RV"}}};
  const Message kept = {Code::kPosesOfGroupsKept, {std::vector<Message>{group}}};
  EXPECT_EQ(loss.values.at(2), Argument(std::vector<Message>{kept}));
}

TEST(LostPoses, OfAnImu) {
  const Rig rig = sample_rig("kb4", {true, true});
  EXPECT_EQ(lost(rig, "kalibr"), Names{});
  EXPECT_EQ(lost(rig, "tumvi"), Names{});
  EXPECT_EQ(lost(rig, "orbslam3"), Names{});
  EXPECT_EQ(lost(rig, "opencv"), Names{"T_cam0_imu0"});
  EXPECT_EQ(lost(rig, "ocamcalib"), Names{"T_cam1_cam0 and T_cam0_imu0"});
  EXPECT_EQ(lost(rig, "woodscape"), Names{"T_cam0_imu0"});
  WriteOptions stereo;
  stereo.sensor = "stereo";
  EXPECT_EQ(lost(rig, "orbslam3", stereo), Names{"T_cam0_imu0"});
}

// The camera is the loss, and not its pose as well; what was known by way of it stays known.
TEST(LostPoses, OfACameraThatIsDroppedAreNotListed) {
  Rig rig = rig_with({"cam0", "cam1", "cam2"}, {{"cam1", "cam0", T_cam1_cam0()}, {"cam2", "cam1", T_cam1_cam0()}});
  EXPECT_EQ(lost(rig, "orbslam3"), Names{});
  rig = rig_with({"cam0", "cam1"}, {{"cam1", "cam0", T_cam1_cam0()}, {"cam1", "imu0", T_cam0_imu()}});
  WriteOptions mono;
  mono.sensor = "mono";
  EXPECT_EQ(lost(rig, "orbslam3", mono), Names{"T_imu0_cam0"});
}

TEST(LostPoses, AFrameThatIsTheFirstCamerasIsThatCamera) {
  Rig rig = rig_with({"cam0", "cam1"}, {{"reference", "cam0", Transform{}}, {"reference", "cam1", T_cam1_cam0()}});
  EXPECT_EQ(lost(rig, "kalibr"), Names{});
  rig.poses.front().T_a_b = T_cam0_imu();
  EXPECT_EQ(lost(rig, "kalibr"), Names{"T_reference_cam0 and T_reference_cam1"});
}

TEST(LostPoses, AnIdentityThatIsOnlyAPlaceholderIsNoPose) {
  // FV sits nowhere, and the others' poses to each other would be read as identities.
  const Rig rig = rig_with({"FV", "MVL", "MVR"}, {{"MVL", "MVR", T_cam1_cam0()}});
  EXPECT_EQ(lost(rig, "woodscape"), Names{"T_MVL_MVR"});
}

TEST(LostPoses, NothingGoesWithinAFormat) {
  for (const char* name :
       {"kalibr/good/tumvi.yaml", "opencv/good/cameras.yml", "opencv/good/extrinsics.yml",
        "orbslam3/good/v1-stereo-inertial.yaml", "orbslam3/good/slam-no-opt-eucm.yaml", "woodscape/good/front.json"}) {
    const fs::path path = testdata_dir() / name;
    const Calibration calibration = calibration_of(read_file(path), path.string());
    Diagnostics diagnostics;
    const std::optional<Written> written =
        write_calibration(*calibration.format, &calibration.documents.front(), calibration.rig, {}, diagnostics);
    ASSERT_TRUE(written) << name;
    EXPECT_TRUE(written->losses.empty()) << name << ": " << what_of(written->losses.front());
  }
}

}  // namespace
}  // namespace fca::test
