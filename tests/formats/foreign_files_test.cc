// SPDX-License-Identifier: BSD-3-Clause
// Files of other programs that share a key or a word with one of ours are not taken for it.
#include "formats/rigs.h"
#include "formats/test_files.h"

#include <fca/code.h>
#include <fca/formats/calibration.h>

#include <array>
#include <filesystem>

namespace fca::test {
namespace {

/// What is said of a file whose format nobody knows; nothing if it is taken for one of ours.
std::optional<Message> refusal(const std::string& bytes, const std::string& name) {
  Diagnostics diagnostics;
  const std::optional<text::Document> document = parse_calibration({name, bytes}, diagnostics);
  if (document && detect_format(*document, diagnostics)) return std::nullopt;
  return diagnostics.entries().front().facts;
}

struct Foreign {
  const char* name;
  const char* bytes;
  Code code;
};

const std::array kForeign = {
    Foreign{"ocam_param.txt",
            "640 480 -70.5 0.0 5.5e-4 2.1e-5 -8.8e-9 320.0 240.0 1.0 0.0 0.0 142.7 104.8 7.4 17.5 12.6 -4.4 6.9 11.0 -0.6 -3.9 "
            "-1.1 0.0\n",
            Code::kLooksLikeOmniCam},
    Foreign{"orbit.yaml", "%YAML:1.0\nCamera.nrpol: 5\nCamera.nrinvpol: 12\nCamera.a0: -210.5\n", Code::kLooksLikeMultiCol},
    Foreign{"rig.yaml", "%YAML:1.0\nCameraSystem.nrCams: 2\nCameraSystem.cam1_1: 0.1\n", Code::kLooksLikeMultiColRig},
    Foreign{"quad.yaml", "estimation_mode: 1\nself_id: 2\n", Code::kLooksLikeD2Slam},
    Foreign{"single.yaml",
            "%YAML:1.0\nestimation_mode: 0\ndouble_counting_common_feature: 0\nimage0_topic: a\nacc_n: 0.1\n"
            "body_T_cam0: 1\n",
            Code::kLooksLikeD2Slam},
    Foreign{"larvio.yaml",
            "%YAML:1.0\nif_FEJ: 1\nT_cam_imu: !!opencv-matrix\n   rows: 1\n   cols: 1\n   dt: d\n   data: [ 1. ]\n",
            Code::kLooksLikeLarvio},
    Foreign{"avia.yaml", "extrin_calib:\n  Rcl: [1.0, 0.0]\n  Pcl: [0.1, 0.2, 0.3]\n", Code::kLooksLikeFastLivoPoses},
    Foreign{"rig.yaml", "stereo_cameras:\n  - left_camera: {x: 1}\n", Code::kLooksLikeCuvslamRig},
    Foreign{"board.json", "{\"board_config\": {\"cameras\": {}}}", Code::kLooksLikeDepthaiBoard},
    Foreign{"priors.json", "{\"priors\": [{\"CameraIntrinsicsPrior\": {\"focal_length\": 300.5}}]}", Code::kLooksLikeTheia},
    Foreign{"fisheye.json", "{\"taylor_coefficient\": [1.0], \"distortion_center\": [1.0, 2.0]}", Code::kLooksLikePyOcamCalib},
    Foreign{"ocam.yml", "parameter:\n  coefficients:\n    projection: [2.0]\n    unprojection: [1.0]\n",
            Code::kLooksLikeAdapterOcam},
    Foreign{"lists.yaml", "camera_matrix: [[500.5, 0.0, 320.0]]\ndist_coeff: [0.1]\n", Code::kLooksLikePlainLists},
    Foreign{"rtabmap.ini", "[Core]\nVersion = 0.21\nRtabmap\\DetectionRate = 1\n", Code::kLooksLikeRtabMap},
    Foreign{"in_VID5.xml",
            "<?xml version=\"1.0\"?>\n<opencv_storage>\n<Settings>\n<BoardSize_Width>9</BoardSize_Width>\n"
            "<Calibrate_Pattern>\"CHESSBOARD\"</Calibrate_Pattern>\n</Settings>\n</opencv_storage>\n",
            Code::kLooksLikeCalibrationInput},
    Foreign{"list.xml",
            "<?xml version=\"1.0\"?>\n<opencv_storage>\n<imagelist>\n\"left01.png\"\n</imagelist>\n</opencv_storage>\n",
            Code::kLooksLikeImageList},
};

TEST(ForeignFiles, EachIsNamed) {
  for (const Foreign& foreign : kForeign) {
    SCOPED_TRACE(foreign.bytes);
    const std::optional<Message> said = refusal(foreign.bytes, foreign.name);
    ASSERT_TRUE(said);
    EXPECT_EQ(said->code, foreign.code);
  }
}

/// What is wrong with the file is said where it has a syntax: a ROS file with a slip is not another program's.
TEST(ForeignFiles, ASlipInOneOfOursIsToldAsSuch) {
  const std::optional<Message> said = refusal("camera_matrix: {data: [1, 2\ndistortion_coefficients: 3\n", "ost.yaml");
  ASSERT_TRUE(said);
  EXPECT_FALSE(same_id(said->code, Code::kFormatUnknown));
}

TEST(ForeignFiles, NoneOfTheCorpusIsUnknown) {
  const fs::path extra = shared_dir() / "corpus" / "extra";
  if (!fs::exists(extra)) GTEST_SKIP() << extra << " is not there";
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(extra)) {
    // A line of numbers; somebody's own JSON.
    constexpr std::array kOfNobody = {"omni_cam_flat", "depthai_json_like"};
    const bool is_unnamed = std::ranges::find(kOfNobody, entry.path().parent_path().filename()) != kOfNobody.end();
    if (!entry.is_regular_file() || is_unnamed) continue;
    const std::optional<Message> said = refusal(read_file(entry.path()), entry.path().filename().string());
    EXPECT_TRUE(!said || said->code != Code::kFormatUnknown) << entry.path();
  }
}

TEST(ForeignFiles, Ov2SlamIsNoVins) {
  const std::string settings =
      "%YAML:1.0\nCamera.model_left: pinhole\nCamera.fxl: 450.5\nCamera.fyl: 451.25\nCamera.k1l: -0.25\n"
      "body_T_cam0: !!opencv-matrix\n   rows: 4\n   cols: 4\n   dt: d\n"
      "   data: [ 1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1. ]\n";
  const std::optional<Message> said = refusal(settings, "stereo.yaml");
  ASSERT_TRUE(said);
  EXPECT_EQ(said->code, Code::kLooksLikeOv2Slam);
}

TEST(ForeignFiles, AReadmeIsNoCalibResults) {
  std::string readme =
      "Calibration\n\nThe file has the polynomial coefficients of the direct mapping function:\n5 -100 0 0.002 0 0\n";
  for (int i = 0; i < 20; ++i) readme += "Then run the program with the file and look at the affine parameters.\n";
  EXPECT_TRUE(refusal(readme, "README.txt"));
}

TEST(ForeignFiles, SettingsOfAnotherProgramAreNoIniOfRos) {
  EXPECT_TRUE(refusal("[Camera]\nimgRate=30\ndriver=2\n\n[Core]\nversion=1\n", "settings.ini"));
}

}  // namespace
}  // namespace fca::test
