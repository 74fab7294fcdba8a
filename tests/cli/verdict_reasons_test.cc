// SPDX-License-Identifier: BSD-3-Clause
// What lowers a verdict and what does not: a defect counts where the written file has the fact, and for the program that reads
// it.
#include "cli/read_rig.h"
#include "cli/run_program.h"
#include "cli/told.h"

#include <algorithm>
#include <set>

namespace fca::test {
namespace {

/// Of a conversion, or of the one file that was checked.
const rapidjson::Value& verdict_in(const Told& run) {
  const auto& json = run.json();
  return json.HasMember("files") ? json["files"][0]["verdict"] : json["verdict"];
}

std::string word_of(const Told& run) { return verdict_in(run)["word"].GetString(); }

std::set<std::string> codes_of(const Told& run) {
  std::set<std::string> codes;
  for (const auto& reason : verdict_in(run)["reasons"].GetArray()) codes.insert(reason["code"].GetString());
  return codes;
}

/// A camera_info without the matrices that ROS's parser wants.
const std::string kWithoutMatrices =
    "image_width: 752\n"
    "image_height: 480\n"
    "camera_name: cam0\n"
    "camera_matrix:\n"
    "  rows: 3\n"
    "  cols: 3\n"
    "  data: [458.1, 0.0, 367.2, 0.0, 457.3, 248.4, 0.0, 0.0, 1.0]\n"
    "distortion_model: plumb_bob\n"
    "distortion_coefficients:\n"
    "  rows: 1\n"
    "  cols: 5\n"
    "  data: [-0.28, 0.07, 0.0002, 0.00002, 0.0]\n";

/// Two cameras of 100 degrees, the second at `translation` of the first, turned by nothing.
std::string pair_at(const std::string& translation) {
  const std::string camera =
      "  camera_model: pinhole\n"
      "  distortion_coeffs: [0.01, -0.002, 0.001, -0.0003]\n"
      "  distortion_model: equidistant\n"
      "  intrinsics: [300.0, 300.0, 319.5, 239.5]\n"
      "  resolution: [640, 480]\n";
  return "cam0:\n" + camera + "  rostopic: /cam0/image_raw\ncam1:\n" + camera +
         "  rostopic: /cam1/image_raw\n  T_cn_cnm1:\n  - [1.0, 0.0, 0.0, " + translation +
         "]\n  - [0.0, 1.0, 0.0, 0.0]\n  - [0.0, 0.0, 1.0, 0.0]\n  - [0.0, 0.0, 0.0, 1.0]\n";
}

TEST(VerdictReasons, WhatTheInputsOwnReaderWantsCountsForThatReaderAlone) {
  const TemporaryFolder folder;
  const std::string file = folder.write("cam0.yaml", kWithoutMatrices);
  const Told to_kalibr({"convert", file, "--to", "kalibr"});
  EXPECT_EQ(word_of(to_kalibr), "ready") << to_kalibr.text();
  const Told kept({"convert", file, "--to", "ros"});
  EXPECT_EQ(kept.code(), 1) << kept.text();
  EXPECT_EQ(codes_of(kept).count("program-refuses"), 1U) << kept.text();
  const Told rewritten({"convert", file, "--to", "ros", "--rewrite"});
  EXPECT_EQ(word_of(rewritten), "ready") << rewritten.text();
}

// ORB-SLAM2's settings and a fork's are none for stock ORB-SLAM3, whoever says it.
TEST(VerdictReasons, WhatOnlyAnotherProgramReadsNeedsThat) {
  const TemporaryFolder folder;
  const std::string radtan = folder.write("radtan.yaml",
                                          "cam0:\n  camera_model: pinhole\n  distortion_model: radtan\n"
                                          "  distortion_coeffs: [-0.28, 0.07, 0.0002, 0.00002]\n"
                                          "  intrinsics: [458.6, 457.3, 367.2, 248.4]\n"
                                          "  resolution: [752, 480]\n  rostopic: /cam0\n");
  const std::string of_orbslam2 = folder / "orbslam2.yaml";
  const std::string of_fork = folder / "fork.yaml";
  EXPECT_EQ(run_program({"convert", radtan, "--to", "orbslam2", "-o", of_orbslam2}).code, 0);
  EXPECT_EQ(run_program({"convert", kTumvi, "--camera", "cam0", "--to", "slam_no_opt", "--model", "eucm", "-o", of_fork}).code,
            0);
  for (const std::string& file : {of_orbslam2, of_fork}) {
    const Told check({"check", file});
    EXPECT_EQ(word_of(check), "use-with-care") << check.text();
    EXPECT_EQ(codes_of(check).count("needs-program"), 1U) << check.text();
  }
  // Whoever names ORB-SLAM3 wants a file that it reads, and is told how to get one.
  const Told written({"convert", of_orbslam2, "--to", "orbslam3"});
  EXPECT_EQ(word_of(written), "do-not-use") << written.text();
  EXPECT_EQ(codes_of(written).count("needs-program"), 1U) << written.text();
  EXPECT_TRUE(contains(verdict_in(written)["reasons"][0]["fix"].GetString(), "--rewrite")) << written.text();
  const Told fresh({"convert", of_orbslam2, "--to", "orbslam3", "--rewrite"});
  EXPECT_EQ(word_of(fresh), "ready") << fresh.text();
  EXPECT_EQ(word_of(Told({"convert", of_orbslam2, "--to", "orbslam3", "--accept", "needs-program"})), "use-with-care");
  const Told asked({"convert", of_orbslam2, "--to", "orbslam2"});
  EXPECT_EQ(codes_of(asked).count("needs-program"), 0U) << asked.text();
}

// COLMAP's files have no place for an IMU: what is wrong with its pose is no reason against them.
TEST(VerdictReasons, ThePoseOfAnImuCountsWhereItIsWritten) {
  const TemporaryFolder folder;
  const std::string chain = folder.write(
      "sheared.yaml", with_replaced(pair_at("-0.1"), "  rostopic: /cam0/image_raw\n",
                                    "  rostopic: /cam0/image_raw\n  T_cam_imu:\n  - [1.0, 0.03, 0.0, 0.01]\n"
                                    "  - [0.0, 1.0, 0.0, 0.0]\n  - [0.0, 0.0, 1.0, 0.0]\n  - [0.0, 0.0, 0.0, 1.0]\n"));
  const std::string out = (folder.path() / "out").string() + "/";
  const Told to_colmap({"convert", chain, "--to", "colmap", "-o", out});
  EXPECT_EQ(codes_of(to_colmap).count("not-a-rotation"), 0U) << to_colmap.text();
  EXPECT_NE(word_of(to_colmap), "do-not-use");
  const Told to_openvins({"convert", chain, "--to", "openvins", "-o", out});
  EXPECT_EQ(codes_of(to_openvins).count("not-a-rotation"), 1U) << to_openvins.text();
  EXPECT_EQ(word_of(to_openvins), "do-not-use");
}

/// Four cameras in a row, each with its pose in the one before it and in the IMU; the second pose of cam2 is off by `metres`.
std::string row_with_wrong_pose(double metres) {
  const auto pose = [](const std::string& key, double x, double y) {
    return "  " + key + ":\n  - [1.0, 0.0, 0.0, " + std::to_string(x) + "]\n  - [0.0, 1.0, 0.0, " + std::to_string(y) +
           "]\n  - [0.0, 0.0, 1.0, 0.0]\n  - [0.0, 0.0, 0.0, 1.0]\n";
  };
  std::string chain;
  for (int i = 0; i < 4; ++i) {
    chain += "cam" + std::to_string(i) +
             ":\n  camera_model: pinhole\n  intrinsics: [400.0, 400.0, 319.5, 239.5]\n  distortion_model: radtan\n"
             "  distortion_coeffs: [0.0, 0.0, 0.0, 0.0]\n  resolution: [640, 480]\n";
    if (i > 0) chain += pose("T_cn_cnm1", -0.1, i == 2 ? metres : 0.0);
    chain += pose("T_cam_imu", -0.1 * i, 0.0);
  }
  return chain;
}

// Two paths agree against one pose: a fresh file specifies what they say.
TEST(VerdictReasons, APoseThatTheOthersOutvoteIsLeftOut) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("row.yaml", row_with_wrong_pose(0.03));
  const std::string out = folder / "basalt.json";
  const Told run({"convert", chain, "--to", "basalt", "--accept", "pixels-off", "-o", out});
  EXPECT_EQ(codes_of(run).count("poses-contradict"), 1U) << run.text();
  EXPECT_NE(word_of(run), "do-not-use") << run.text();
  EXPECT_TRUE(contains(run.text(), "T_cam2_cam1")) << run.text();
  const Rig written = rig_in(read_file(out));
  ASSERT_EQ(written.cameras.size(), 4U);
  const std::optional<Transform> T = written.resolve(written.cameras[2].name, written.cameras[1].name);
  ASSERT_TRUE(T);
  EXPECT_NEAR((*T)(0, 3), -0.1, 1e-9);
  EXPECT_NEAR((*T)(1, 3), 0.0, 1e-9);
  // The file itself is as wrong as it was: Kalibr reads both.
  EXPECT_EQ(word_of(Told({"check", chain})), "do-not-use");
}

// Where nobody can tell which is wrong, the numbers decide.
TEST(VerdictReasons, ContradictionsThatNoRuleDecidesCountByTheirSize) {
  const TemporaryFolder folder;
  const std::string camera =
      "  camera_model: pinhole\n  distortion_coeffs: [0.0, 0.0, 0.0, 0.0]\n  distortion_model: radtan\n"
      "  intrinsics: [400.0, 400.0, 319.5, 239.5]\n  resolution: [640, 480]\n";
  const auto pose = [](const std::string& key, const std::string& x, const std::string& y) {
    return "  " + key + ":\n  - [1.0, 0.0, 0.0, " + x + "]\n  - [0.0, 1.0, 0.0, " + y +
           "]\n  - [0.0, 0.0, 1.0, 0.0]\n  - [0.0, 0.0, 0.0, 1.0]\n";
  };
  for (const auto& [metres, word] : {std::pair("0.005", "use-with-care"), std::pair("0.03", "do-not-use")}) {
    const std::string chain =
        folder.write("pair.yaml", "cam0:\n" + camera + pose("T_cam_imu", "0.0", "0.0") + "cam1:\n" + camera +
                                      pose("T_cn_cnm1", "-0.1", metres) + pose("T_cam_imu", "-0.1", "0.0"));
    const Told run({"convert", chain, "--to", "openvins", "-o", (folder.path() / "out").string() + "/"});
    EXPECT_EQ(codes_of(run).count("poses-contradict"), 1U) << run.text();
    EXPECT_EQ(word_of(run), word) << run.text();
  }
}

// VINS-Fusion uses poses and the IMU's noise, and its camera files have no place for them.
TEST(VerdictReasons, WhatVinsReadsElsewhereIsLost) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string() + "/";
  const Told with_poses({"convert", kTumvi, "--with", kImu, "--to", "vins", "-o", out});
  EXPECT_EQ(word_of(with_poses), "use-with-care") << with_poses.text();
  EXPECT_EQ(codes_of(with_poses).count("pose-dropped"), 1U) << with_poses.text();
  const Told alone({"convert", kTumvi, "--camera", "cam0", "--to", "ocamcalib"});
  EXPECT_EQ(codes_of(alone).count("pose-dropped"), 0U) << alone.text();
}

// A configuration counts the cameras, whatever the input calls them.
TEST(VerdictReasons, TheOrderOfCamerasIsTheConfigurations) {
  const TemporaryFolder folder;
  const std::string config = folder.write("config.yaml", read_file(testdata("formats/vins/good/config.yaml")));
  for (const char* order : {"cam0,cam1", "cam1,cam0"}) {
    const std::string out = (folder.path() / order).string() + "/";
    const Told run({"convert", kTumvi, "--camera", order, "--with", kImu, "--to", "vins", "--into", config, "-o", out});
    EXPECT_EQ(codes_of(run).count("proof-failed"), 0U) << order << ": " << run.text();
    EXPECT_EQ(codes_of(run).count("pose-dropped"), 0U) << order << ": " << run.text();
    EXPECT_TRUE(fs::exists(out + "config.yaml")) << order << ": " << run.text();
  }
}

// cuVSLAM takes the coefficients of a sensor.yaml for its Brown model, whatever the file says.
TEST(VerdictReasons, TheNameOfAFileDecidesWhatCuvslamReads) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string() + "/";
  const Told written({"convert", kTumvi, "--camera", "cam0", "--to", "cuvslam", "-o", out});
  EXPECT_EQ(codes_of(written).count("pixels-off"), 0U) << written.text();
  const std::string bytes = read_file(out + "mav0/cam0/sensor_recalibrated.yaml");
  EXPECT_EQ(Told({"show", out}).json()["files"][0]["cameras"].Size(), 1U);
  const Told check({"check", folder.write("sensor.yaml", bytes), "--for", "cuvslam"});
  EXPECT_EQ(word_of(check), "do-not-use") << check.text();
  const Told renamed({"check", folder.write("sensor_recalibrated.yaml", bytes), "--for", "cuvslam"});
  EXPECT_EQ(codes_of(renamed).count("pixels-off"), 0U) << renamed.text();
  // Who gives the right name gets the file.
  const Told named({"convert", kTumvi, "--camera", "cam0", "--to", "cuvslam", "-o", folder / "sensor_recalibrated.yaml"});
  EXPECT_EQ(codes_of(named).count("pixels-off"), 0U) << named.text();
}

// A lens that it reads as meant goes by the usual name.
TEST(VerdictReasons, OnlyAnEquidistantLensHasCuvslamsOtherName) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string() + "/";
  const std::string euroc = testdata("formats/euroc/good/cam0.yaml");
  const Told written({"convert", euroc, "--to", "cuvslam", "--rewrite", "-o", out});
  EXPECT_EQ(word_of(written), "ready") << written.text();
  EXPECT_TRUE(fs::exists(out + "mav0/cam0/sensor.yaml"));
}

// Where a camera stands on its vehicle is nothing to a file that does not say it.
TEST(VerdictReasons, APoseOnAVehicleThatIsNotWrittenDoesNotCount) {
  const TemporaryFolder folder;
  std::string text = read_file(testdata("formats/woodscape/good/crlf-tabs.json"));
  for (const char* number : {"3.7125", "0.015", "0.655"}) text = with_replaced(text, number, "0.0");
  const std::string camera = folder.write("camera.json", text);
  const Told checked({"check", camera});
  EXPECT_EQ(codes_of(checked).count("pose-implausible"), 1U) << checked.text();
  const Told written({"convert", camera, "--to", "opencv"});
  EXPECT_EQ(codes_of(written).count("pose-implausible"), 0U) << written.text();
}

// ROS' pair of files specifies how its cameras sit to each other.
TEST(VerdictReasons, APoseThatAPairOfFilesFollowsFromCounts) {
  const TemporaryFolder folder;
  std::vector<std::string> words = {"convert"};
  for (const auto& [name, y] : {std::pair("front.json", "515.0"), std::pair("crlf-tabs.json", "15.0")}) {
    std::string text = read_file(testdata("formats/woodscape/good/" + std::string(name)));
    for (const auto& [from, to] : {std::pair("3.7125", "3712.5"), std::pair("0.015", y), std::pair("0.655", "655.0")})
      text = with_replaced(text, from, to);
    words.push_back(folder.write(name, text));
  }
  words.insert(words.end(), {"--join", "--to", "ros"});
  const Told run(words);
  EXPECT_EQ(codes_of(run).count("translation-in-mm"), 1U) << run.text();
}

// One sample's noise is no density, and a program with an IMU misses it.
TEST(VerdictReasons, NoiseOfAnUnknownRateIsLost) {
  const std::string config = testdata("formats/vins/good/config.yaml");
  const std::vector<std::string> words = {"convert", kTumvi, "--camera", "cam0", "--with", config, "--to", "kalibr"};
  const Told without(words);
  EXPECT_EQ(codes_of(without).count("imu-dropped"), 1U) << without.text();
  std::vector<std::string> with_rate = words;
  with_rate.insert(with_rate.end(), {"--imu-rate", "200"});
  EXPECT_EQ(codes_of(Told(with_rate)).count("imu-dropped"), 0U);
  // An OpenCV file has no place for an IMU, and its programs do not miss it.
  std::vector<std::string> to_opencv = words;
  to_opencv.back() = "opencv";
  EXPECT_EQ(codes_of(Told(to_opencv)).count("imu-dropped"), 0U);
}

// instant-ngp does not read k3.
TEST(VerdictReasons, AParameterThatTheProgramDoesNotReadIsFittedAway) {
  const TemporaryFolder folder;
  const std::string camera = folder.write("camera.yml",
                                          "%YAML:1.0\nimage_width: 1280\nimage_height: 720\n"
                                          "camera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
                                          "   data: [ 1450., 0., 640., 0., 1450., 360., 0., 0., 1. ]\n"
                                          "distortion_coefficients: !!opencv-matrix\n   rows: 1\n   cols: 5\n   dt: d\n"
                                          "   data: [ 0.011, 0.28, 0., 0., 4.4 ]\n");
  const std::vector<std::string> words = {"convert", camera, "--to", "instant-ngp"};
  const Told chosen(words);
  EXPECT_EQ(word_of(chosen), "ready") << chosen.text();
  std::vector<std::string> as_radtan = words;
  as_radtan.insert(as_radtan.end(), {"--model", "radtan"});
  const Told asked(as_radtan);
  ASSERT_NE(asked.json()["cameras"].Size(), 0U) << asked.text();
  EXPECT_EQ(codes_of(asked).count("proof-failed"), 0U) << asked.text();
  EXPECT_FALSE(contains(asked.bytes(), "\"k3\"")) << asked.bytes();
}

// The base's images have a size, and nobody says that the input's have the same.
TEST(VerdictReasons, ABaseWithASizeWantsOneOfTheInput) {
  const TemporaryFolder folder;
  const std::string base = folder / "settings.yaml";
  ASSERT_EQ(run_program({"convert", kTumvi, "--camera", "cam0", "--to", "orbslam3", "-o", base}).code, 0);
  const std::string input = folder.write("camera.yml",
                                         "%YAML:1.0\ncamera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
                                         "   data: [ 191., 0., 255., 0., 191., 256., 0., 0., 1. ]\n"
                                         "distortion_coefficients: !!opencv-matrix\n   rows: 1\n   cols: 4\n   dt: d\n"
                                         "   data: [ 0.003, 0.0007, -0.002, 0.0002 ]\n");
  const std::vector<std::string> words = {"convert", input, "--opencv-model",   "fisheye", "--into",
                                          base,      "-o",  folder / "out.yaml"};
  const Told run(words);
  EXPECT_EQ(run.code(), 2) << run.text();
  EXPECT_TRUE(run.says("image-size-missing", "--size")) << run.text();
  std::vector<std::string> sized = words;
  sized.insert(sized.end(), {"--size", "512x512"});
  EXPECT_EQ(run_program(sized).code, 0);
}

TEST(VerdictReasons, AnIgnoredCodeIsNoReason) {
  const std::string file = testdata("checks/poses-contradict-thrice.yaml");
  EXPECT_EQ(word_of(Told({"check", file})), "do-not-use");
  const Told run({"check", file, "--ignore", "poses-contradict"});
  EXPECT_EQ(codes_of(run).count("poses-contradict"), 0U) << run.text();
  EXPECT_NE(word_of(run), "do-not-use") << run.text();
  // A file that cannot be read is none, whatever is ignored.
  const Told unread({"check", testdata("formats/opencv/bad/six-coefficients.yaml"), "--ignore", "wrong-length"});
  EXPECT_EQ(word_of(unread), "do-not-use") << unread.text();
}

// Whoever sets a key that only one of the layouts has means that layout.
TEST(VerdictReasons, ASettingChoosesTheLayoutThatHasIt) {
  const std::vector<std::string> words = {"convert", kTumvi, "--with", kImu, "--to", "orbslam3", "--set"};
  for (const char* setting : {"ThDepth=35.0", "Stereo.ThDepth=35.0"}) {
    std::vector<std::string> each = words;
    each.emplace_back(setting);
    const RunResult run = run_program(each);
    EXPECT_EQ(run.code, 0) << run.err;
    const std::string key = std::string(setting).substr(0, std::string(setting).find('='));
    EXPECT_TRUE(contains(run.out, "\n" + key + ": 35.0")) << run.out;
  }
  // Never a fork's layout, and with the model that goes with the stock program's.
  const TemporaryFolder folder;
  std::string radtan = pair_at("-0.1");
  for (const char* lens : {"equidistant", "equidistant"}) radtan = with_replaced(radtan, lens, "radtan");
  const std::vector<std::string> pair = {"convert", folder.write("pair.yaml", radtan), "--to", "orbslam3"};
  const Told plain(pair);
  std::vector<std::string> set = pair;
  set.insert(set.end(), {"--set", "ThDepth=35.0"});
  const Told run(set);
  const bool has_key = contains(plain.bytes(), "\nThDepth");
  EXPECT_EQ(run.code() == 0, has_key) << run.text();
  EXPECT_TRUE(!has_key || word_of(run) == word_of(plain)) << run.text();
}

// Nearly nothing of the image was looked at.
TEST(VerdictReasons, AnAngleThatLeavesNearlyAllOutAsksForCare) {
  const Told run({"convert", kTumvi, "--camera", "cam0", "--to", "kalibr", "--model", "ds", "--max-angle", "5"});
  EXPECT_EQ(codes_of(run).count("little-compared"), 1U) << run.text();
  EXPECT_EQ(word_of(run), "use-with-care");
}

// Beyond 90 degrees, too, a fit's error is a distance.
TEST(VerdictReasons, TheWholeImageIsMeasuredWhereTheProgramDoesNotMirror) {
  const Told run({"convert", kTumvi, "--camera", "cam0", "--to", "kalibr", "--model", "eucm"});
  const auto& camera = run.json()["cameras"][0];
  const double fit = camera["error_px"]["rms"].GetDouble();
  EXPECT_NEAR(camera["in_image_px"]["rms"].GetDouble(), fit, 0.05 * fit) << run.text();
  EXPECT_LT(camera["in_circle_px"]["rms"].GetDouble(), 0.9 * fit);
}

// Who writes one T_cam_imu the wrong way round writes all of them so.
TEST(VerdictReasons, PosesOfAnImuThatAreAllInvertedAreNamed) {
  const TemporaryFolder folder;
  const auto pose = [](const std::string& key, const std::string& first, const std::string& second, const std::string& x) {
    return "  " + key + ":\n  - [" + first + ", 0.0, " + x + "]\n  - [" + second + ", 0.0, 0.02]\n" +
           "  - [0.0, 0.0, 1.0, -0.01]\n  - [0.0, 0.0, 0.0, 1.0]\n";
  };
  const std::string camera =
      "  camera_model: pinhole\n  distortion_coeffs: [0.0, 0.0, 0.0, 0.0]\n  distortion_model: radtan\n"
      "  intrinsics: [400.0, 400.0, 319.5, 239.5]\n  resolution: [640, 480]\n";
  // T_cam0_imu and T_cam1_imu = shifted by (-0.1, 0, 0) from it, written the wrong way round: a turn by 90 deg about z.
  const std::string chain = folder.write(
      "inverted.yaml", "cam0:\n" + camera + pose("T_cam_imu", "0.0, 1.0", "-1.0, 0.0", "0.05") + "cam1:\n" + camera +
                           "  T_cn_cnm1:\n  - [1.0, 0.0, 0.0, -0.1]\n  - [0.0, 1.0, 0.0, 0.0]\n  - [0.0, 0.0, 1.0, 0.0]\n"
                           "  - [0.0, 0.0, 0.0, 1.0]\n" +
                           "  T_cam_imu:\n  - [0.0, 1.0, 0.0, 0.05]\n  - [-1.0, 0.0, 0.0, -0.08]\n  - [0.0, 0.0, 1.0, -0.01]\n"
                           "  - [0.0, 0.0, 0.0, 1.0]\n");
  const Told run({"check", chain});
  EXPECT_EQ(word_of(run), "do-not-use") << run.text();
  int inverted = 0;
  for (const auto& finding : run.json()["files"][0]["findings"].GetArray())
    inverted += std::string(finding["code"].GetString()) == "pose-inverted" ? 1 : 0;
  EXPECT_EQ(inverted, 2) << run.text();
}

// A file of keys that are nobody's: the program that wrote it may read it.
TEST(VerdictReasons, KeysOfNoKnownProgramAreNotProven) {
  const std::string file = testdata("formats/opencv/good/cameras.yml");
  const Told check({"check", file});
  const Told written({"convert", file, "--to", "opencv"});
  EXPECT_EQ(codes_of(check).count("not-proven"), codes_of(written).count("not-proven")) << check.text() << written.text();
  const TemporaryFolder folder;
  const std::string own =
      folder.write("own.yml",
                   "%YAML:1.0\n---\nIntrisic: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
                   "   data: [ 500., 0., 320., 0., 500., 240., 0., 0., 1. ]\n"
                   "distortion: !!opencv-matrix\n   rows: 1\n   cols: 5\n   dt: d\n   data: [ -0.1, 0.01, 0., 0., 0.001 ]\n");
  const Told own_check({"check", own});
  EXPECT_EQ(word_of(own_check), "use-with-care") << own_check.text();
  EXPECT_EQ(codes_of(own_check).count("not-proven"), 1U) << own_check.text();
  const Told own_written({"convert", own, "--to", "opencv"});
  EXPECT_EQ(codes_of(own_written).count("not-proven"), 1U) << own_written.text();
  EXPECT_EQ(Told({"check", own, "--for", "opencv"}).code(), 1) << "who asks for OpenCV has OpenCV";
}

TEST(VerdictReasons, AnIdentityBetweenTwoCamerasAsksForCare) {
  const TemporaryFolder folder;
  for (const auto& [translation, word] : {std::pair("0.0", "use-with-care"), {"-0.11", "ready"}}) {
    const Told run({"convert", folder.write("pair.yaml", pair_at(translation)), "--to", "orbslam3"});
    EXPECT_EQ(word_of(run), word) << run.text();
  }
}

/// The pair without its pose.
std::string unrelated_pair() {
  const std::string pair = pair_at("-0.11");
  return pair.substr(0, pair.find("  T_cn_cnm1"));
}

// Kalibr's chain may leave the pose out; OpenVINS wants one, and two cameras at one place are none.
TEST(VerdictReasons, CamerasThatNothingRelatesAreNoRig) {
  const TemporaryFolder folder;
  const std::string file = folder.write("pair.yaml", unrelated_pair());
  for (const auto& [format, word] :
       {std::pair("kalibr", "use-with-care"), {"openvins", "do-not-use"}, {"basalt", "do-not-use"}}) {
    const Told run({"convert", file, "--to", format});
    EXPECT_EQ(word_of(run), word) << run.text();
    EXPECT_EQ(codes_of(run).count("pose-missing"), 1U) << run.text();
  }
  // A file for each camera says nothing of the other.
  const Told apart({"convert", file, "--to", "ros", "-o", folder / "out/"});
  EXPECT_EQ(codes_of(apart).count("pose-missing"), 0U) << apart.text();
}

TEST(VerdictReasons, DsoUsesNeitherPosesNorAnImu) {
  const Told run({"convert", kTumvi, "--with", kImu, "--to", "dso", "--camera", "cam0"});
  EXPECT_EQ(codes_of(run).count("imu-dropped"), 0U) << run.text();
  EXPECT_EQ(codes_of(run).count("pose-dropped"), 0U) << run.text();
}

TEST(VerdictReasons, WhoeverAsksForAProgramHasThatOne) {
  const Told own({"check", kTumvi});
  const Told other({"check", kTumvi, "--for", "openvins"});
  EXPECT_STREQ(own.json()["files"][0]["verdict"]["word"].GetString(), "ready");
  EXPECT_STREQ(other.json()["files"][0]["verdict"]["word"].GetString(), "do-not-use");
}

TEST(VerdictReasons, TheBaselineOfARectifiedPairIsAFact) {
  const Told run({"convert", testdata("formats/orbslam3/good/v1-rectified.yaml"), "--to", "kalibr"});
  EXPECT_TRUE(run.lost("baseline-dropped")) << run.text();
  EXPECT_EQ(word_of(run), "use-with-care") << run.text();
}

TEST(VerdictReasons, PosesCountWhereTheyAreWritten) {
  const std::string file = testdata("checks/pose-inverted-between-cameras.yaml");
  const Told pair({"convert", file, "--to", "kalibr"});
  EXPECT_EQ(word_of(pair), "do-not-use") << pair.text();
  EXPECT_EQ(codes_of(pair).count("stereo-order"), 0U) << "it follows from the wrong pose: " << pair.text();
  for (const char* format : {"opencv", "orbslam3"}) {
    const Told alone({"convert", file, "--camera", "cam0", "--to", format});
    EXPECT_EQ(word_of(alone), "ready") << format << ": " << alone.text();
  }
}

TEST(VerdictReasons, AUnitThatNobodySaidHasItsRemedy) {
  const std::vector<std::string> words = {"convert", testdata("formats/opencv/good/stereo-14.yml"), "--size", "640x480", "--to",
                                          "kalibr"};
  const Told run(words);
  const auto reasons = run.json()["verdict"]["reasons"].GetArray();
  const auto invented = std::ranges::find_if(
      reasons, [](const auto& reason) { return reason["code"].GetString() == std::string("invented-value"); });
  ASSERT_NE(invented, reasons.end()) << run.text();
  EXPECT_TRUE(contains((*invented)["fix"].GetString(), "--unit m")) << run.text();
  std::vector<std::string> told = words;
  told.insert(told.end(), {"--unit", "m"});
  EXPECT_EQ(codes_of(Told(told)).count("invented-value"), 0U);
}

TEST(VerdictReasons, TheSameDefectOfTwoCamerasIsOneLine) {
  const RunResult run = run_program({"convert", kTumvi, "--to", "opencv", "--model", "radtan"}, {.in_full = false});
  const auto count = [&run](const std::string& part) {
    std::size_t times = 0;
    for (std::size_t at = run.err.find(part); at != std::string::npos; at = run.err.find(part, at + 1)) ++times;
    return times;
  };
  EXPECT_EQ(count("cannot describe"), 1U) << run.err;
  EXPECT_TRUE(contains(run.err, "cam1 likewise")) << run.err;
}

// ORB-SLAM2 has no fisheye: neither a model of ORB-SLAM3's nor a camera that is not written is spoken of.
TEST(VerdictReasons, ALayoutIsAdvisedByItsOwnModels) {
  const Told run({"convert", kTumvi, "--to", "orbslam2"});
  for (const auto& entry : run.json()["diagnostics"].GetArray()) {
    EXPECT_FALSE(contains(entry["message"].GetString(), "cam1: ")) << run.text();
    EXPECT_FALSE(entry.HasMember("fix") && contains(entry["fix"].GetString(), "reads kb4")) << run.text();
  }
}

// A pose that mirrors is in no file's power to state: nobody can accept it.
TEST(VerdictFirst, APoseThatMirrorsIsNotToBeUsed) {
  const Told told({"convert", testdata("checks/left-handed.yaml"), "--to", "opencv", "--accept", "left-handed"});
  EXPECT_EQ(told.code(), 1) << told.text();
  EXPECT_TRUE(contains(told.text(), "\"word\":\"do-not-use\"") || contains(told.text(), "\"word\": \"do-not-use\""))
      << told.text();
}

// Rotations of five digits become quaternions, which is no fault of the file.
TEST(VerdictFirst, ARotationOfFewDigitsIsNoFaultOfCOLMAPsFiles) {
  const TemporaryFolder folder;
  std::string chain = read_file(kTumvi);
  const std::size_t at = chain.find("T_cn_cnm1");
  ASSERT_NE(at, std::string::npos);
  const std::string rotated =
      "T_cn_cnm1:\n  - [1.00000, -0.00082, -0.00066, -0.10106]\n  - [0.00079, 0.99890, -0.04690, -0.00198]\n"
      "  - [0.00069, 0.04690, 0.99890, -0.00118]\n  - [0.0, 0.0, 0.0, 1.0]\n";
  std::size_t end = chain.find('\n', at);
  for (int row = 0; row < 4; ++row) end = chain.find('\n', end + 1);
  chain = chain.substr(0, at) + rotated + chain.substr(end + 1);
  const RunResult run =
      run_program({"convert", folder.write("chain.yaml", chain), "--to", "colmap", "-o", (folder / "out") + "/"});
  EXPECT_EQ(run.code, 0) << chain << run.out << run.err;
}

/// EuRoC's lens twice, the second camera at `translation` of the first.
std::string radtan_pair_at(const std::string& translation) {
  std::string pair = pair_at(translation);
  for (const auto& [from, to] : {std::pair("equidistant", "radtan"),
                                 {"[0.01, -0.002, 0.001, -0.0003]", "[-0.28, 0.07, 0.0, 0.0]"},
                                 {"[300.0, 300.0, 319.5, 239.5]", "[458.6, 457.2, 319.5, 239.5]"}}) {
    for (std::size_t at = pair.find(from); at != std::string::npos; at = pair.find(from, at + 1))
      pair.replace(at, std::string_view(from).size(), to);
  }
  return pair;
}

/// One camera above the other.
std::string upright(std::string pair) {
  const std::string beside = "[1.0, 0.0, 0.0, -0.11]\n  - [0.0, 1.0, 0.0, 0.0]";
  return pair.replace(pair.find(beside), beside.size(), "[1.0, 0.0, 0.0, 0.0]\n  - [0.0, 1.0, 0.0, -0.11]");
}

// ORB-SLAM3 looks for a pair's matches along rows; fisheyes it matches by descriptors.
TEST(VerdictReasons, AVerticalPairOfPlanesIsNoStereoPair) {
  const TemporaryFolder folder;
  const std::string file = folder.write("vertical.yaml", upright(radtan_pair_at("-0.11")));
  EXPECT_EQ(word_of(Told({"convert", file, "--to", "orbslam3", "-o", folder / "mono.yaml"})), "ready");
  EXPECT_FALSE(contains(read_file(folder.path() / "mono.yaml"), "Camera2.fx"));
  const Told stereo({"convert", file, "--to", "orbslam3", "--sensor", "stereo", "-o", folder / "stereo.yaml"});
  EXPECT_EQ(word_of(stereo), "do-not-use");
  EXPECT_TRUE(codes_of(stereo).contains("stereo-vertical"));
  const Told forced(
      {"convert", file, "--to", "orbslam3", "--sensor", "stereo", "-o", folder / "stereo.yaml", "--accept", "stereo-vertical"});
  const Told checked({"check", folder / "stereo.yaml"});
  EXPECT_EQ(word_of(checked), "do-not-use");
  const std::string fisheyes = folder.write("fisheyes.yaml", upright(pair_at("-0.11")));
  EXPECT_EQ(word_of(Told({"convert", fisheyes, "--to", "orbslam3", "-o", folder / "kb4.yaml"})), "ready");
}

// The pair that counts is the one that is written, not the file's first two cameras.
TEST(VerdictReasons, OfThreeCamerasTheWrittenPairCounts) {
  const TemporaryFolder folder;
  const std::string two = radtan_pair_at("-0.11");
  const std::string third = two.substr(two.find("cam1:"));
  const auto of_three = [&](const std::string& x, const std::string& y) {
    std::string cam2 = third;
    cam2.replace(0, 4, "cam2");
    const std::string beside = "[1.0, 0.0, 0.0, -0.11]\n  - [0.0, 1.0, 0.0, 0.0]";
    cam2.replace(cam2.find(beside), beside.size(), "[1.0, 0.0, 0.0, " + x + "]\n  - [0.0, 1.0, 0.0, " + y + "]");
    return two + cam2;
  };
  // cam1 next to cam0, and cam2 below it, as T_cam2_cam1 has it.
  const std::string file = folder.write("three.yaml", of_three("0.11", "-0.11"));
  const auto verdict = [&](const std::string& cameras) {
    return Told(
        {"convert", file, "--camera", cameras, "--to", "orbslam3", "--sensor", "stereo", "-o", folder / (cameras + ".yaml")});
  };
  EXPECT_FALSE(codes_of(verdict("cam0,cam1")).contains("stereo-vertical"));
  EXPECT_TRUE(codes_of(verdict("cam0,cam2")).contains("stereo-vertical"));
}

}  // namespace
}  // namespace fca::test
