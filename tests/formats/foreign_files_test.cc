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
    Foreign{
        "ocam_param.txt",
        "-70.5 0.0 5.5e-4 2.1e-5 -8.8e-9 320.0 240.0 1.0 0.0 0.0 142.7 104.8 7.4 17.5 12.6 -4.4 6.9 11.0 -0.6 -3.9 -1.1 0.0\n",
        Code::kLooksLikeOmniCam},
    Foreign{"aria.json", R"({"CameraCalibrations": [{"Label": "a", "Projection": {"Name": "Fisheye62", "Params": [1.5]}}]})",
            Code::kLooksLikeAria},
    Foreign{"wmr.json", R"({"CalibrationInformation": {"Cameras": [{"Intrinsics": {"ModelParameters": [0.5]}}]}})",
            Code::kLooksLikeWmr},
    Foreign{"rig.json", R"({"rig": {"sensors": [{"properties": {"Model": "ftheta", "bw-poly": "0 0.0005"}}]}})",
            Code::kLooksLikeDriveWorks},
    Foreign{"scene.usda", "#usda 1.0\ndef Camera \"x\" (\n  prepend apiSchemas = [\"OmniLensDistortionFthetaAPI\"]\n)\n{\n}\n",
            Code::kLooksLikeIsaac},
    Foreign{"rig.edex", R"([{"cameras": [{"intrinsics": {"focal": [1.5], "principal": [2.5], "distortion_params": [0.1]}}]}])",
            Code::kLooksLikeEdex},
    Foreign{"calibration.json", R"({"cameras": [{"model": "pinhole", "focalLengthX": 500.5, "imuToCamera": [[1.0]]}]})",
            Code::kLooksLikeSpectacular},
    Foreign{"matlab.json", R"({"RadialDistortion": [0.1, 0.2], "ImageSize": [480, 640], "K": [[500.5]]})",
            Code::kLooksLikeMatlab},
    Foreign{"fisheye.json", R"({"MappingCoefficients": [500.5, 0.1, 0.2, 0.3], "DistortionCenter": [320.5, 240.5]})",
            Code::kLooksLikeMatlabFisheye},
    Foreign{"sensor_kit_calibration.yaml",
            "sensor_kit_base_link:\n  camera0/camera_link: {x: 1.0, y: 0.0, z: 0.0, roll: 0.0, pitch: 0.0, yaw: 0.0}\n",
            Code::kLooksLikeAutoware},
    Foreign{"photon.json", R"({"cameraIntrinsics": {"data": [500.5]}, "distCoeffs": {"data": [0.1]}})",
            Code::kLooksLikePhotonVision},
    Foreign{"r3live_config.yaml", "r3live_vio:\n  image_width: 1280\n  camera_intrinsic: [863.5, 0.0, 640.5]\n",
            Code::kLooksLikeR3live},
    Foreign{"metadata.json", R"({"K": [1.5], "poses": [[0.5]], "perFrameIntrinsicCoeffs": [[1.5]]})", Code::kLooksLikePhone},
    Foreign{"keyframe.json", R"({"fx": 700.5, "fy": 700.5, "t_00": 1.0})", Code::kLooksLikePhone},
    Foreign{"calib.json", R"({"left_intrinsics": [[1.5]], "right_intrinsics": [[1.5]]})", Code::kLooksLikeOwnDump},
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
    Foreign{"calib_cam_to_velo.txt", "0 0 1 0.75 -1 0 0 0.25 0 -1 0 -0.125\n", Code::kLooksLikePoseAlone},
    Foreign{"calib_velo_to_cam.txt",
            "calib_time: 01-Jan-2020 10:00:00\nR: 0 -1 0 0 0 -1 1 0 0\nT: 0.125 -0.0625 -0.25\ndelta_f: 0 0\ndelta_c: 0 0\n",
            Code::kLooksLikeKittiRawPose},
    Foreign{"calib_imu_to_velo.txt", "calib_time: 01-Jan-2020 10:00:00\r\nR: 1 0 0 0 1 0 0 0 1\r\nT: -0.75 0.25 -0.75\r\n",
            Code::kLooksLikeKittiRawPose},
    Foreign{"rig.json", R"({"rig": {"sensors": [{"properties": {"polynomial-type": "angle-to-pixeldistance"}}]}})",
            Code::kLooksLikeDriveWorksForward},
    Foreign{"pinhole.usda",
            "#usda 1.0\ndef Camera \"x\" (\n  prepend apiSchemas = [\"OmniLensDistortionOpenCvPinholeAPI\"]\n)\n{\n}\n",
            Code::kLooksLikeIsaacOpenCv},
    Foreign{"fisheye.usda",
            "#usda 1.0\ndef Camera \"x\" (\n  prepend apiSchemas = [\"OmniLensDistortionOpenCvFisheyeAPI\"]\n)\n{\n}\n",
            Code::kLooksLikeIsaacOpenCv},
    Foreign{"prism.usda",
            "#usda 1.0\ndef Camera \"x\" (\n  prepend apiSchemas = [\"OmniLensDistortionRadTanThinPrismAPI\"]\n)\n{\n}\n",
            Code::kLooksLikeIsaacLens},
    Foreign{
        "older.usda",
        "#usda 1.0\ndef Camera \"x\"\n{\n  token cameraProjectionType = \"fisheyePolynomial\"\n  float fthetaPolyA = 0\n}\n",
        Code::kLooksLikeIsaac},
    Foreign{"color.json",
            R"({"width": 640, "height": 480, "ppx": 320.5, "ppy": 240.5, "fx": 610.5, "fy": 610.25,)"
            R"( "model": "distortion.inverse_brown_conrady", "coeffs": [0.0, 0.0, 0.0, 0.0, 0.0]})",
            Code::kLooksLikeRealsenseStream},
    Foreign{"printed.txt",
            "  cameraParameters with properties:\n\n   Camera Intrinsics\n     IntrinsicMatrix: [3x3 double]\n\n   Lens "
            "Distortion\n"
            "    RadialDistortion: [1x2 double]\n",
            Code::kLooksLikeMatlabPrint},
    Foreign{"printed.txt",
            "  cameraIntrinsics with properties:\n\n    FocalLength: [800.5 801.5]\n      ImageSize: [480 640]\n",
            Code::kLooksLikeMatlabPrint},
    Foreign{"printed.txt", "  fisheyeIntrinsics with properties:\n\n  MappingCoefficients: [880.5 -0.25 0.125 -0.5]\n",
            Code::kLooksLikeMatlabPrint},
    Foreign{"metadata.json", R"({"w": 720, "h": 960, "fps": 60, "K": [700.5], "poses": [[0, 0, 0, 1, 0, 0, 0]]})",
            Code::kLooksLikePhone},
    Foreign{"frame_00000.json", R"({"cameraPoseARFrame": [1, 0, 0, 0.5], "intrinsics": [1400.5, 0, 960.5], "time": 1.5})",
            Code::kLooksLikePhone},
    Foreign{"avia.yaml", "camera:\n  img_topic: /image\n  Rcl: [0, -1, 0, 0, 0, -1, 1, 0, 0]\n  Pcl: [0.1, 0.2, 0.3]\n",
            Code::kLooksLikeFastLivoPoses},
    Foreign{"rovio.info", "Camera0\n{\n\tCalibrationFile ;\n\tqCM_x 0.5;\tX of a quaternion\n\tMrMC_x 0.125;\n}\n",
            Code::kLooksLikeRovio},
    Foreign{"rtabmap.ini", "[Core]\nVersion = 0.21\nMem\\STMSize = 10\n", Code::kLooksLikeRtabMap},
    Foreign{"rtabmap.ini", "[Core]\nKp\\MaxFeatures=500\nVis\\MinInliers=20\n", Code::kLooksLikeRtabMap},
    Foreign{"sfm_data.json", R"({"sfm_data_version": "0.3", "views": [], "intrinsics": [], "extrinsics": []})",
            Code::kLooksLikeOpenMvg},
    Foreign{"images.txt", "# IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME\n1 1 0 0 0 0.5 0 0 1 a.png\n\n",
            Code::kLooksLikeColmapImages},
    Foreign{
        "results-cam.txt",
        "Done.\nCalibration results \n====================\nCamera-system parameters:\n\tcam0 (/image):\n"
        "\t distortion: [0.125 0.25 0. 0.] +- [0.5 0.5 0.5 0.5]\n\t projection: [500.5 500.5 320.5 240.5] +- [1. 1. 1. 1.]\n",
        Code::kLooksLikeKalibrReport},
    Foreign{"results-imucam.txt",
            "Done.\nCalibration results\n===================\nNormalized Residuals\n----------------------------\n"
            "Transformation (cam0):\nT_ci:  (imu0 to cam0): \n[[1. 0. 0. 0.5]\n",
            Code::kLooksLikeKalibrReport},
    Foreign{"april.yaml", "target_type: 'aprilgrid'\ntagCols: 6\ntagRows: 6\ntagSize: 0.0625\ntagSpacing: 0.25\n",
            Code::kLooksLikeKalibrTarget},
    Foreign{"board.yaml", "target_type: 'checkerboard'\ntargetCols: 6\ntargetRows: 7\n", Code::kLooksLikeKalibrTarget},
    Foreign{"kb.yaml",
            "cam0:\n  camera_model: kannala_brandt\n  intrinsics: [190.5, 190.5, 254.5, 256.5]\n"
            "  distortion: [0.25, 0.125, -0.25, 0.125]\n  resolution: [512, 512]\n",
            Code::kLooksLikeApex},
    Foreign{"ds.yaml", "cam0:\n  camera_model: double_sphere\n  intrinsics: [348.5, 347.5, 365.5, 249.5, 0.5625, -0.25]\n",
            Code::kLooksLikeApex},
    Foreign{"camera.yaml",
            "%YAML:1.0\n\n{{ metadata }}\n\ncamera_id: {{ camera_id }}\nT_BS:\n  data: {{ T_BS }}\n"
            "camera_model: {{ camera_model }}\n",
            Code::kLooksLikeKimeraTemplate},
    Foreign{"calib.json",
            R"({"boardName": "a", "boardConf": "b", "cameraData": {"CAM_A": {"intrinsicMatrix": [[500.5, 0, 320.5]]}}})",
            Code::kLooksLikeDepthaiByName},
};

TEST(ForeignFiles, EachIsNamed) {
  for (const Foreign& foreign : kForeign) {
    SCOPED_TRACE(foreign.bytes);
    const std::optional<Message> said = refusal(foreign.bytes, foreign.name);
    ASSERT_TRUE(said);
    EXPECT_EQ(said->code, foreign.code);
  }
}

/// What is wrong with the file is said where it has a syntax: a ROS file with a mistake is not another program's.
TEST(ForeignFiles, AMistakeInOneOfOursIsReportedAsSuch) {
  const std::optional<Message> said = refusal("camera_matrix: {data: [1, 2\ndistortion_coefficients: 3\n", "ost.yaml");
  ASSERT_TRUE(said);
  EXPECT_FALSE(same_id(said->code, Code::kFormatUnknown));
}

/// Kalibr has lenses of these names, too: what lacks is told as of a chain.
TEST(ForeignFiles, AChainWithoutItsDistortionIsAChain) {
  for (const std::string lens : {"pinhole", "eucm"}) {
    const std::string chain = "cam0:\n  camera_model: " + lens + "\n  intrinsics: [190.5, 190.5, 254.5, 256.5]\n";
    EXPECT_FALSE(refusal(chain, "camchain.yaml")) << lens;
  }
}

TEST(ForeignFiles, TwelveNumbersWithoutARotationAreNoPose) {
  const std::optional<Message> said = refusal("500.5 0 320.5 0 0 500.5 240.5 0 0 0 1 0\n", "P.txt");
  ASSERT_TRUE(said);
  EXPECT_EQ(said->code, Code::kFormatUnknown);
}

/// Longer than fca-io reads, as real ones are.
TEST(ForeignFiles, LongListsOfImagesAreNamed) {
  const std::string line(3U << 20U, ' ');
  const std::optional<Message> said = refusal("# IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME\n" + line, "images.txt");
  ASSERT_TRUE(said);
  EXPECT_EQ(said->code, Code::kLooksLikeColmapImages);
}

TEST(ForeignFiles, NoneOfTheCorpusIsUnknown) {
  const fs::path extra = shared_dir() / "corpus" / "extra";
  if (!fs::exists(extra)) GTEST_SKIP() << extra << " is not there";
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(extra)) {
    if (!entry.is_regular_file()) continue;
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
