// SPDX-License-Identifier: BSD-3-Clause
// What the options do to a rig: --camera and the side of a stereo pair, --set, overlapping columns.
#include "cli/read_rig.h"
#include "cli/run_program.h"
#include "cli/told.h"

#include <fca/formats/calibration.h>

#include <algorithm>
#include <cmath>

namespace fca::test {
namespace {

const std::string kSettings = testdata("formats/orbslam3/good/v1-stereo-inertial.yaml");

/// The value of a top-level key, as spelled; "" if there is none.
std::string value_of(const std::string& bytes, const std::string& key) {
  const std::size_t at = bytes.find("\n" + key + ": ");
  if (at == std::string::npos) return "";
  const std::size_t begin = at + key.size() + 3;
  return bytes.substr(begin, bytes.find('\n', begin) - begin);
}

void expect_close(const Transform& a, const Transform& b) {
  for (std::size_t i = 0; i < a.values.size(); ++i) EXPECT_NEAR(a.values[i], b.values[i], 1e-6);
}

// TUM VI: p_c1 = T p_c2 is the inverse of Kalibr's T_cn_cnm1, p_imu = T p_c1 that of T_cam_imu (FORMATS.md, last section;
// ORB-SLAM3's Examples/Stereo-Inertial/TUM-VI.yaml prints the same numbers).
TEST(RigOptions, TumViPosesAreTheInverses) {
  const Rig kalibr = rig_in(read_file(kTumvi));
  const RunResult run = run_program({"convert", kTumvi, "--with", kImu, "--to", "orbslam3"});
  const Rig settings = rig_in(run.out);
  ASSERT_NE(settings.stated("cam0", "cam1"), nullptr) << run.err;
  ASSERT_NE(settings.stated("imu0", "cam0"), nullptr) << run.err;
  expect_close(*settings.stated("cam0", "cam1"), inverse(*kalibr.stated("cam1", "cam0")).value());
  expect_close(*settings.stated("imu0", "cam0"), inverse(*kalibr.stated("cam0", "imu0")).value());
}

// Kalibr's T_cam_imu is about imu0: another IMU's noise does not make it that one's pose.
TEST(RigOptions, AnotherImuHasNoPose) {
  const TemporaryFolder folder;
  const std::string noise =
      "  accelerometer_noise_density: 0.0028\n  accelerometer_random_walk: 0.00086\n"
      "  gyroscope_noise_density: 0.00016\n  gyroscope_random_walk: 0.000022\n  update_rate: 200.0\n";
  const std::string chain = testdata("formats/kalibr/good/tumvi.yaml");
  const auto converted = [&](const std::string& imu) {
    return run_program({"convert", chain, "--with", folder.write(imu + ".yaml", imu + ":\n" + noise), "--to", "orbslam3"});
  };
  EXPECT_EQ(converted("imu0").code, 0);
  const RunResult other = converted("imu1");
  EXPECT_EQ(other.code, 2) << other.out;
  EXPECT_EQ(other.out, "");
  EXPECT_TRUE(says(other.err, "imu-without-pose")) << other.err;
}

TEST(RigOptions, EveryPoseIsThatOfTheNewFirstCamera) {
  const Rig kalibr = rig_in(read_file(kTumvi));
  const RunResult run = run_program({"convert", kTumvi, "--with", kImu, "--camera", "1,0", "--to", "orbslam3"});
  const Rig settings = rig_in(run.out);
  ASSERT_NE(settings.stated("cam0", "cam1"), nullptr) << run.err;
  ASSERT_NE(settings.stated("imu0", "cam0"), nullptr) << run.err;
  expect_close(*settings.stated("cam0", "cam1"), *kalibr.stated("cam1", "cam0"));
  expect_close(*settings.stated("imu0", "cam0"), inverse(*kalibr.stated("cam1", "imu0")).value());
}

// The same in the file's own text.
TEST(RigOptions, SettingsInAnotherOrder) {
  const Rig before = rig_in(read_file(kSettings));
  const RunResult run = run_program({"convert", kSettings, "--camera", "1,0", "--to", "orbslam3"});
  const Rig after = rig_in(run.out);
  ASSERT_EQ(after.cameras.size(), 2U) << run.err;
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) EXPECT_EQ(after.cameras[i].model, before.cameras[1 - i].model);
  expect_close(after.resolve("cam0", "cam1").value(), before.resolve("cam1", "cam0").value());
  expect_close(after.resolve("imu0", "cam0").value(), before.resolve("imu0", "cam1").value());
}

TEST(RigOptions, ASecondCameraOnTheLeftIsWarnedOfWithTheCommand) {
  const RunResult right = run_program({"convert", kTumvi, "--to", "orbslam3"});
  EXPECT_FALSE(says(right.err, "stereo-order")) << right.err;
  const RunResult left = run_program({"convert", kTumvi, "--camera", "1,0", "--to", "orbslam3"});
  EXPECT_TRUE(says(left.err, "stereo-order", "convert " + kTumvi + " --to orbslam3 --verbose --camera 0,1")) << left.err;
  // The command that is proposed has nothing to propose.
  EXPECT_FALSE(says(run_program({"convert", kTumvi, "--camera", "0,1", "--to", "orbslam3"}).err, "stereo-order"));
  const RunResult mono = run_program({"convert", kTumvi, "--camera", "1,0", "--to", "orbslam3", "--sensor", "mono"});
  EXPECT_FALSE(says(mono.err, "stereo-order")) << mono.err;
}

/// A chain of two equal cameras and that T_cn_cnm1, row by row.
std::string pair_posed(const std::string& distortion_model, const std::vector<std::string>& rows) {
  const std::string camera = "  camera_model: pinhole\n  distortion_model: " + distortion_model +
                             "\n  intrinsics: [400.0, 400.0, 320.0, 240.0]\n  distortion_coeffs: [-0.1, 0.01, 0.0, 0.0]\n"
                             "  resolution: [640, 480]\n  rostopic: /c\n";
  std::string text = "cam0:\n" + camera + "cam1:\n" + camera + "  T_cn_cnm1:\n";
  for (const std::string& row : rows) text += "  - [" + row + "]\n";
  return text + "  - [0.0, 0.0, 0.0, 1.0]\n";
}

// Turned by a quarter about the optical axis, a pair stands one above the other.
TEST(RigOptions, APairOneAboveTheOtherIsNone) {
  const TemporaryFolder folder;
  const std::vector<std::string> below = {"1.0, 0.0, 0.0, 0.0", "0.0, 1.0, 0.0, -0.12", "0.0, 0.0, 1.0, 0.0"};
  const std::string plane = folder.write("plane.yaml", pair_posed("radtan", below));
  EXPECT_EQ(run_program({"convert", plane, "--to", "orbslam3"}).code, 0);
  EXPECT_EQ(run_program({"convert", plane, "--to", "orbslam3", "--sensor", "stereo"}).code, 1);
  // ORB-SLAM3 matches fisheye pairs without rectifying them, and so does the fork that knows double spheres.
  const std::string fisheye = folder.write("fisheye.yaml", pair_posed("equidistant", below));
  for (const char* model : {"kb4", "ds"}) {
    const RunResult unrectified = run_program({"convert", fisheye, "--model", model, "--to", "orbslam3"});
    EXPECT_FALSE(says(unrectified.err, "stereo-vertical")) << unrectified.err;
  }
  EXPECT_FALSE(says(run_program({"convert", kTumvi, "--to", "orbslam3"}).err, "stereo-vertical"));
}

// cv::stereoRectify and the matchers behind it have a left and a right image, too; MC-Calib's files are of no pair.
TEST(RigOptions, AnOpenCvPairWithTheSecondCameraOnTheLeft) {
  const TemporaryFolder folder;
  const auto converted = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"convert", kTumvi, "--to", "opencv", "--dry-run"});
    const RunResult run = run_program(options);
    EXPECT_EQ(run.code, 0) << run.err;
    return run.err;
  };
  EXPECT_FALSE(says(converted({}), "stereo-order"));
  const std::string left = converted({"--camera", "cam1,cam0"});
  EXPECT_TRUE(says(left, "stereo-order", "10.11 cm")) << left;
  EXPECT_TRUE(says(left, "stereo-order", "--camera cam0,cam1")) << left;
  EXPECT_FALSE(says(converted({"--camera", "1,0", "--opencv-layout", "cameras"}), "stereo-order"));
  EXPECT_TRUE(says(converted({"--camera", "1,0", "--opencv-layout", "left-right"}), "stereo-order"));
}

// With the second camera upside down each stands to the left of the other: no order is right, and none is proposed.
TEST(RigOptions, APairOfWhichEachIsLeftOfTheOther) {
  const TemporaryFolder folder;
  const std::string pair =
      folder.write("pair.yaml", pair_posed("radtan", {"-1.0, 0.0, 0.0, -0.12", "0.0, -1.0, 0.0, 0.0", "0.0, 0.0, 1.0, 0.0"}));
  for (const char* order : {"0,1", "1,0"}) {
    const RunResult run = run_program({"convert", pair, "--camera", order, "--to", "orbslam3"});
    EXPECT_TRUE(says(run.err, "stereo-order")) << run.err;
    EXPECT_FALSE(says(run.err, "stereo-order", "fca-io convert")) << run.err;
  }
}

// Who shifts the time stamps looks into the file written.
TEST(RigOptions, LossesNameCamerasAsTheFileWrittenDoes) {
  const TemporaryFolder folder;
  const std::string text = with_replaced(read_file(kTumvi), "cam0:\n", "cam0:\n  timeshift_cam_imu: 0.0021\n");
  const Told run({"convert", folder.write("chain.yaml", text), "--camera", "1,0", "--to", "orbslam3"});
  EXPECT_EQ(run.code(), 0) << run.text();
  bool told_offset = false;
  bool told_topic = false;
  for (const auto& loss : run.json()["losses"].GetArray()) {
    const std::string what = loss["what"].GetString();
    const std::string remedy = loss["do"].GetString();
    if (loss["code"] == "time-offset-dropped") {
      told_offset = true;
      for (const std::string& said : {what, remedy}) {
        EXPECT_TRUE(contains(said, "cam0")) << said;
        EXPECT_LT(said.find("cam1"), said.find("cam0")) << said << ": the file's name first, then the input's";
      }
    }
    if (loss["code"] == "topic-dropped" && what.ends_with(" /cam0/image_raw")) {
      told_topic = true;
      EXPECT_TRUE(what.starts_with("cam1 ")) << what;
      EXPECT_LT(what.find("cam0"), what.find(" /cam0")) << what << ": the input's name, too";
    }
  }
  EXPECT_TRUE(told_offset && told_topic) << run.text();
}

TEST(RigOptions, TheProposedCommandIsOneThatAShellTakes) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a b.yaml", read_file(kTumvi));
  const RunResult run = run_program({"convert", path, "--camera", "1,0", "--to", "orbslam3"});
  EXPECT_TRUE(says(run.err, "stereo-order", "convert '" + path + "' --to orbslam3 --verbose --camera 0,1")) << run.err;
}

/// Is the line above that top-level key a comment, such as that on a default?
bool has_comment(const std::string& bytes, const std::string& key) {
  const std::size_t end = bytes.find("\n" + key + ": ");
  EXPECT_NE(end, std::string::npos) << key;
  return end != std::string::npos && end > 0 && bytes.at(bytes.rfind('\n', end - 1) + 1) == '#';
}

TEST(RigOptions, SetWritesAValueInItsType) {
  const RunResult run = run_program({"convert", kTumvi, "--camera", "0", "--to", "orbslam3", "--set", "Viewer.PointSize=3",
                                     "--set", "ORBextractor.nFeatures=1500", "--set", "Camera.RGB=0"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(value_of(run.out, "Viewer.PointSize"), "3.0");
  EXPECT_EQ(value_of(run.out, "ORBextractor.nFeatures"), "1500");
  EXPECT_EQ(value_of(run.out, "Camera.RGB"), "0");
  // What was set is no default any more.
  EXPECT_FALSE(contains(run.err, "Camera.RGB")) << run.err;
  const RunResult not_set = run_program({"convert", kTumvi, "--camera", "0", "--to", "orbslam3"});
  EXPECT_TRUE(has_comment(not_set.out, "Camera.RGB")) << not_set.out;
  EXPECT_FALSE(has_comment(run.out, "Camera.RGB")) << run.out;
  const RunResult nested = run_program({"convert", kTumvi, "--to", "kalibr", "--set", "cam1/rostopic=/right"});
  EXPECT_EQ(rig_in(nested.out).cameras.at(1).topic, "/right") << nested.err;
}

TEST(RigOptions, SetDoesNotChangeTheCalibration) {
  const auto refusal = [](const std::string& setting) {
    const RunResult run = run_program({"convert", kTumvi, "--with", kImu, "--to", "orbslam3", "--set", setting});
    EXPECT_NE(run.code, 0) << setting;
    EXPECT_EQ(run.out, "") << setting;
    return run.err;
  };
  for (const char* fact : {"Camera1.fx=200.0", "Camera.width=1024", "IMU.NoiseGyro=0.1", "IMU.Frequency=100.0"})
    EXPECT_TRUE(says(refusal(fact), "set-contradicts")) << fact;
  EXPECT_TRUE(says(refusal("Viewer.PointSise=3"), "set-unknown-key", "Viewer.PointSize"));
  EXPECT_TRUE(says(refusal("ORBextractor.nFeatures=10.5"), "set-wrong-type", "10.5"));
  EXPECT_TRUE(says(refusal("Viewer.PointSize=big"), "set-wrong-type", "big"));
  EXPECT_TRUE(contains(refusal("Camera.RGB"), "KEY=VALUE"));
}

TEST(RigOptions, SetKnowsWhatAValueMayBe) {
  const auto refusal = [](const std::vector<std::string>& options) {
    std::vector<std::string> words = {"convert", kTumvi, "--to", "orbslam3"};
    words.insert(words.end(), options.begin(), options.end());
    const RunResult run = run_program(words);
    EXPECT_NE(run.code, 0) << options.back();
    EXPECT_EQ(run.out, "") << options.back();
    return run.err;
  };
  for (const char* setting :
       {"Camera.fps=-5", "Camera.fps=0", "Camera.RGB=7", "ORBextractor.nLevels=0", "ORBextractor.scaleFactor=1.0",
        "Stereo.ThDepth=-3", "Viewer.PointSize=0", "Camera1.overlappingEnd=512", "Camera1.overlappingBegin=-1"})
    EXPECT_TRUE(says(refusal({"--set", setting}), "set-out-of-range")) << setting;
  EXPECT_TRUE(contains(refusal({"--set", "Camera.fps=20", "--set", "Camera.fps=30"}), "Camera.fps"));
  EXPECT_TRUE(says(refusal({"--fps", "20", "--set", "Camera.fps=30"}), "set-contradicts", "--fps 20"));
  EXPECT_TRUE(says(refusal({"--set", "Stereo.T_c1_c2/dt=d"}), "set-contradicts", "Stereo.T_c1_c2/dt"));
  // What agrees is no contradiction.
  const RunResult run =
      run_program({"convert", kTumvi, "--to", "orbslam3", "--fps", "30", "--set", "Camera.fps=30", "--orbslam3-layout", "v1"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(value_of(run.out, "Camera.fps"), "30");
}

/// Two cameras without a pose.
std::string chain_without_poses() {
  std::string chain;
  for (const char* camera : {"cam0", "cam1"}) {
    chain += std::string(camera) +
             ":\n  camera_model: pinhole\n  intrinsics: [200.0, 200.0, 256.0, 256.0]\n  distortion_model: equidistant\n"
             "  distortion_coeffs: [0.0, 0.0, 0.0, 0.0]\n  resolution: [512, 512]\n";
  }
  return chain;
}

const std::string kExtrinsics = testdata("formats/opencv/good/extrinsics.yml");

/// The line of the comment on where a file comes from that begins with the camera.
std::string comment_on(const std::string& camera, const std::string& bytes) {
  const std::size_t at = bytes.find("\n# " + camera);
  return at == std::string::npos ? std::string() : bytes.substr(at + 1, bytes.find('\n', at + 1) - at - 1);
}

// A chain counts its cameras: the second alone, or first, is cam0 there, and so it is called next to the file.
TEST(RigOptions, CamerasAreCalledAsTheFileWrittenCallsThem) {
  const TemporaryFolder folder;
  const std::vector<std::string> words = {"convert",  kTumvi, "--to",        "kalibr", "--model",     "ds",
                                          "--camera", "1,0",  "--max-angle", "90",     "--provenance"};
  const Told run(words);
  ASSERT_EQ(run.code(), 0) << run.text();
  const auto& cameras = run.json()["cameras"];
  const auto& written = run.json()["outputs"][0]["cameras"];
  ASSERT_EQ(cameras.Size(), 2U);
  ASSERT_EQ(written.Size(), 2U);
  for (const auto& [i, name, input_name] : {std::tuple{0U, "cam0", "cam1"}, {1U, "cam1", "cam0"}}) {
    const std::string comment = comment_on(name, run.bytes());
    EXPECT_TRUE(contains(comment, input_name) && contains(comment, "kb4 -> ds")) << run.bytes();
    EXPECT_STREQ(written[i].GetString(), name);
    EXPECT_STREQ(cameras[i]["name"].GetString(), name);
    EXPECT_STREQ(cameras[i]["input_name"].GetString(), input_name);
    EXPECT_STREQ(cameras[i]["from_model"].GetString(), "kb4");
    EXPECT_STREQ(cameras[i]["to_model"].GetString(), "ds");
  }
  const Told kept({"convert", kTumvi, "--to", "kalibr", "--model", "ds", "--max-angle", "90", "--provenance"});
  for (const auto& [name, other] : {std::pair{"cam0", "cam1"}, {"cam1", "cam0"}}) {
    const std::string comment = comment_on(name, kept.bytes());
    EXPECT_TRUE(contains(comment, "kb4 -> ds") && !contains(comment, other)) << kept.bytes();
  }
  for (const auto& camera : kept.json()["cameras"].GetArray()) EXPECT_EQ(camera["name"], camera["input_name"]);
}

// Wherever the pose without a unit comes from.
TEST(RigOptions, AnAssumedUnitIsListedWhateverTheMainFile) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("chain.yaml", chain_without_poses());
  const Told run({"convert", chain, "--with", kExtrinsics, "--to", "orbslam3", "--sensor", "stereo"});
  EXPECT_EQ(run.code(), 0) << run.text();
  EXPECT_TRUE(run.made_up("translation unit")) << run.text();
  EXPECT_FALSE(Told({"convert", kTumvi, "--to", "orbslam3"}).made_up("translation unit"));
  // It goes as it came.
  EXPECT_FALSE(Told({"convert", chain, "--with", kExtrinsics, "--to", "opencv"}).made_up("translation unit"));
}

TEST(RigOptions, TwoStatementsOfAPoseAreNamedByTheirFiles) {
  const TemporaryFolder folder;
  const std::string pose =
      "  T_cn_cnm1:\n  - [1.0, 0.0, 0.0, -0.5]\n  - [0.0, 1.0, 0.0, 0.0]\n  - [0.0, 0.0, 1.0, 0.0]\n"
      "  - [0.0, 0.0, 0.0, 1.0]\n";
  const std::string chain = folder.write("chain.yaml", chain_without_poses() + pose);
  const RunResult run = run_program(
      {"convert", chain, "--with", kExtrinsics, "--to", "orbslam3", "--sensor", "stereo", "--accept", "poses-contradict"});
  for (const std::string& named : {std::string("T_cam1_cam0"), kExtrinsics, chain})
    EXPECT_TRUE(says(run.err, "poses-contradict", named)) << run.err;
  const Transform T = rig_in(run.out).resolve("cam1", "cam0").value();
  EXPECT_NEAR(T(0, 3), -0.5, 1e-6);
}

// What is not written as it stood is said with what is written.
TEST(RigOptions, ARoundedRateIsSaidWithItsValue) {
  const Told run({"convert", kTumvi, "--to", "orbslam3", "--fps", "29.97", "--orbslam3-layout", "v1"});
  EXPECT_EQ(value_of(run.bytes(), "Camera.fps"), "30");
  EXPECT_TRUE(run.lost("frame-rate-rounded", "29.97 Hz")) << run.text();
}

TEST(RigOptions, AKeyOfKalibrsOwnIsLostForTheTrueReason) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("chain.yaml", chain_without_poses() + "  line_delay: 3.0e-05\n");
  const Told run({"convert", chain, "--to", "kalibr", "--rewrite"});
  EXPECT_EQ(run.code(), 0) << run.text();
  EXPECT_TRUE(run.lost("not-carried", "line_delay")) << run.text();
  // Not because the format has no place for it: that sentence is in golden/convert.txt.
}

// --fps is an edit of the file that --set edits further; what is not about the rate contradicts nothing.
TEST(RigOptions, SetAndFpsBothEditOneFile) {
  const TemporaryFolder folder;
  const std::string bare = folder.write("ds.yaml",
                                        "cam0:\n  camera_model: pinhole\n  intrinsics: [200.0, 200.0, 256.0, 256.0]\n"
                                        "  distortion_model: equidistant\n  distortion_coeffs: [0.0, 0.0, 0.0, 0.0]\n"
                                        "  resolution: [512, 512]\n");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{kSettings, "--to", "orbslam3"}, {bare, "--into", kSettings}}) {
    std::vector<std::string> all = {"convert", "--fps", "25", "--set", "ORBextractor.nFeatures=1567"};
    all.insert(all.end(), words.begin(), words.end());
    const RunResult run = run_program(all);
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(value_of(run.out, "Camera.fps"), "25");
    EXPECT_EQ(value_of(run.out, "ORBextractor.nFeatures"), "1567");
    all.insert(all.end(), {"--set", "Camera.fps=30"});
    const RunResult other = run_program(all);
    EXPECT_EQ(other.out, "");
    EXPECT_TRUE(says(other.err, "set-contradicts", "--fps 25")) << other.err;
  }
}

// Kalibr stops without a topic as soon as it opens a bag, and no other format specifies one. --help has it as its example.
TEST(RigOptions, SetAddsWhatAProgramReadsAndTheFileLacks) {
  const TemporaryFolder folder;
  const std::string chain =
      folder.write("chain.yaml", std::string("# mine\n") +
                                     "cam0:\n  camera_model: pinhole\n  intrinsics: [200.0, 200.0, 256.0, 256.0]\n"
                                     "  distortion_model: radtan\n  distortion_coeffs: [0.0, 0.0, 0.0, 0.0]\n"
                                     "  resolution: [512, 512]\n# the end\n");
  const Told without({"convert", chain, "--to", "kalibr"});
  EXPECT_TRUE(without.proof_warns("cam0/rostopic")) << without.text();
  const RunResult run = run_program(
      {"convert", chain, "--to", "kalibr", "--set", "cam0/rostopic=/cam0/image_raw", "--set", "cam0/timeshift_cam_imu=0.5"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_FALSE(contains(run.err, "cam0/rostopic")) << run.err;
  const Camera camera = rig_in(run.out).cameras.at(0);
  EXPECT_EQ(camera.topic, "/cam0/image_raw") << run.out;
  EXPECT_EQ(camera.time_offset_s, 0.5) << run.out;
  EXPECT_EQ(camera.model, rig_in(read_file(chain)).cameras.at(0).model);
  // Into a file composed here, too.
  const RunResult fresh = run_program({"convert", kSettings, "--to", "kalibr", "--set", "cam1/rostopic=/right"});
  ASSERT_EQ(fresh.code, 0) << fresh.err;
  EXPECT_EQ(rig_in(fresh.out).cameras.at(1).topic, "/right") << fresh.out;
  const RunResult settings =
      run_program({"convert", kTumvi, "--camera", "0", "--to", "orbslam3", "--set", "System.thFarPoints=20", "--set",
                   "Viewer.imageViewScale=0.5", "--set", "System.SaveAtlasToFile=atlas"});
  ASSERT_EQ(settings.code, 0) << settings.err;
  EXPECT_EQ(value_of(settings.out, "System.thFarPoints"), "20.0");
  EXPECT_EQ(value_of(settings.out, "Viewer.imageViewScale"), "0.5");
  EXPECT_EQ(value_of(settings.out, "System.SaveAtlasToFile"), "\"atlas\"");
}

TEST(RigOptions, SetAddsNothingElse) {
  const auto refusal = [](const std::string& format, const std::string& setting) {
    const RunResult run = run_program({"convert", kTumvi, "--to", format, "--set", setting});
    EXPECT_NE(run.code, 0) << setting;
    EXPECT_EQ(run.out, "") << setting;
    return run.err;
  };
  EXPECT_TRUE(says(refusal("kalibr", "cam7/rostopic=/seven"), "set-unknown-key"));
  EXPECT_TRUE(says(refusal("kalibr", "cam0/rostopics=/zero"), "set-unknown-key"));
  EXPECT_TRUE(says(refusal("kalibr", "imu0/rostopic=/imu"), "set-unknown-key"));
  EXPECT_TRUE(says(refusal("orbslam3", "System.thFarPoints=far"), "set-wrong-type"));
  EXPECT_TRUE(says(refusal("orbslam3", "System.thFarPoints=-1"), "set-out-of-range"));
  EXPECT_TRUE(says(refusal("orbslam3", "thNearPoints=20"), "set-unknown-key"));
  // One camera's settings have V1.0's keys, whatever those before had.
  const RunResult mono = run_program({"convert", kTumvi, "--camera", "cam0", "--to", "orbslam3", "--set", "thFarPoints=20"});
  EXPECT_TRUE(says(mono.err, "set-unknown-key")) << mono.err;
  // What stands there and is no single value is not said to be missing.
  const std::string list = refusal("kalibr", "cam1/resolution=512");
  EXPECT_TRUE(says(list, "set-unknown-key", kTumvi + ":33:15")) << list;
}

// Columns are of the images that they were counted in.
TEST(RigOptions, OverlappingColumnsFollowTheImages) {
  const auto columns = [](const std::string& bytes) {
    return std::vector{value_of(bytes, "Camera1.overlappingBegin"), value_of(bytes, "Camera1.overlappingEnd"),
                       value_of(bytes, "Camera2.overlappingBegin"), value_of(bytes, "Camera2.overlappingEnd")};
  };
  const std::string settings =
      with_replaced(read_file(kSettings), "Camera1.overlappingBegin: 0", "Camera1.overlappingBegin: 7");
  const TemporaryFolder folder;
  const std::string path = folder.write("settings.yaml", settings);
  EXPECT_EQ(columns(run_program({"convert", path, "--to", "orbslam3"}).out), columns(settings));
  const RunResult half = run_program({"convert", path, "--to", "orbslam3", "--binning", "2"});
  EXPECT_EQ(columns(half.out), (std::vector<std::string>{"0", "255", "0", "255"})) << half.err;
  EXPECT_TRUE(says(half.err, "columns-computed", "Camera1.overlappingBegin 7")) << half.err;
  // Swapped cameras have each other's columns.
  const RunResult swapped = run_program({"convert", path, "--to", "orbslam3", "--camera", "1,0"});
  EXPECT_EQ(columns(swapped.out), (std::vector<std::string>{"0", "511", "7", "511"})) << swapped.err;
  // Other lenses in the same images: kept, and said.
  const std::string narrower = folder.write("narrower.yaml", with_replaced(read_file(kTumvi), "190.978", "290.978"));
  const RunResult into = run_program({"convert", narrower, "--into", path});
  EXPECT_EQ(columns(into.out), columns(settings)) << into.err;
  EXPECT_TRUE(says(into.err, "columns-kept", "Camera1.overlappingBegin 7 (")) << into.err;
  EXPECT_FALSE(contains(run_program({"convert", path, "--to", "orbslam3", "--set", "Camera.fps=30"}).err, "columns-"));
  // A cone of 40 degrees around axes that lie 2.7 degrees apart: both see its middle.
  const RunResult narrow = run_program({"convert", kTumvi, "--to", "orbslam3", "--max-angle", "40"});
  const int begin = std::stoi(columns(narrow.out).at(0));
  const int end = std::stoi(columns(narrow.out).at(1));
  EXPECT_NEAR(begin, 254.9 - 191.0 * 0.698, 12) << narrow.out;
  EXPECT_NEAR(end, 254.9 + 191.0 * 0.698, 12) << narrow.out;
}

TEST(RigOptions, WhatAModeLacksIsSaidWithTheOptionThatGivesIt) {
  const auto error = [](std::vector<std::string> words) {
    words.insert(words.begin(), "convert");
    words.insert(words.end(), {"--to", "orbslam3"});
    const RunResult run = run_program(words);
    EXPECT_EQ(run.code, 2) << run.err;
    EXPECT_EQ(run.out, "");
    return run.err;
  };
  EXPECT_TRUE(says(error({kTumvi, "--sensor", "stereo-inertial"}), "sensor-not-served", "--with imu.yaml"));
  EXPECT_TRUE(says(error({kTumvi, "--camera", "0", "--sensor", "rgbd"}), "sensor-not-served", "--baseline"));
  // Of two cameras one is meant, and both options are needed.
  EXPECT_TRUE(says(error({kTumvi, "--sensor", "rgbd"}), "sensor-not-served", "--camera cam0 --baseline METRES"));
  EXPECT_TRUE(says(error({kTumvi, "--camera", "0", "--sensor", "stereo"}), "sensor-not-served", "--join"));
  // The same chain without its poses to the IMU.
  const RunResult bare =
      run_program({"convert", "-", "--with", kImu, "--to", "orbslam3", "--sensor", "mono-inertial"},
                  {.input = "cam0:\n  camera_model: pinhole\n  intrinsics: [200.0, 200.0, 320.0, 240.0]\n"
                            "  distortion_model: none\n  distortion_coeffs: []\n  resolution: [640, 480]\n"});
  EXPECT_TRUE(says(bare.err, "sensor-not-served", "camchain-imucam.yaml")) << bare.err;
  // A baseline makes a pair of rectified images only: not to be proposed, and not to be proposed again.
  EXPECT_FALSE(contains(error({kTumvi, "--camera", "0", "--sensor", "stereo"}), "--baseline"));
  const std::string bent = error({kTumvi, "--camera", "0", "--sensor", "stereo", "--baseline", "0.1"});
  EXPECT_TRUE(says(bent, "sensor-not-served", "kb4")) << bent;
  EXPECT_FALSE(contains(bent, "--baseline")) << bent;
}

/// The keys at the beginning of lines, ORBextractor's and Viewer's left out: every mode has them.
std::vector<std::string> keys_in(const std::string& bytes) {
  std::vector<std::string> keys;
  std::istringstream stream(bytes);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos || line[0] == ' ' || line[0] == '#' || line[0] == '%') continue;
    const std::string key = line.substr(0, colon);
    if (!key.starts_with("ORBextractor.") && !key.starts_with("Viewer.")) keys.push_back(key);
  }
  std::ranges::sort(keys);
  return keys;
}

// Settings.cc of V1.0: what its constructor reads for each sensor.
TEST(RigOptions, EveryModeHasExactlyTheKeysItNeeds) {
  using Keys = std::vector<std::string>;
  const Keys common = {"File.version", "Camera.type", "Camera.width", "Camera.height", "Camera.fps",
                       "Camera.RGB",   "Camera1.fx",  "Camera1.fy",   "Camera1.cx",    "Camera1.cy",
                       "Camera1.k1",   "Camera1.k2",  "Camera1.k3",   "Camera1.k4"};
  const Keys stereo = {"Camera2.fx",
                       "Camera2.fy",
                       "Camera2.cx",
                       "Camera2.cy",
                       "Camera2.k1",
                       "Camera2.k2",
                       "Camera2.k3",
                       "Camera2.k4",
                       "Stereo.T_c1_c2",
                       "Stereo.ThDepth",
                       "Camera1.overlappingBegin",
                       "Camera1.overlappingEnd",
                       "Camera2.overlappingBegin",
                       "Camera2.overlappingEnd"};
  const Keys imu = {"IMU.T_b_c1", "IMU.NoiseGyro", "IMU.NoiseAcc", "IMU.GyroWalk", "IMU.AccWalk", "IMU.Frequency"};
  const Keys depth = {"Stereo.b", "Stereo.ThDepth", "RGBD.DepthMapFactor"};
  struct Mode {
    const char* name;
    std::vector<const Keys*> groups;
    std::vector<std::string> options;
  };
  for (const Mode& mode : {Mode{"mono", {&common}, {}}, Mode{"stereo", {&common, &stereo}, {}},
                           Mode{"rgbd", {&common, &depth}, {"--camera", "0", "--baseline", "0.05", "--accept", "pixels-off"}},
                           Mode{"mono-inertial", {&common, &imu}, {}}, Mode{"stereo-inertial", {&common, &stereo, &imu}, {}}}) {
    std::vector<std::string> words = {"convert",           kTumvi, "--with", kImu, "--to", "orbslam3", "--sensor", mode.name,
                                      "--orbslam3-layout", "v1"};
    words.insert(words.end(), mode.options.begin(), mode.options.end());
    const RunResult run = run_program(words);
    ASSERT_EQ(run.code, 0) << mode.name << run.err;
    Keys expected;
    for (const Keys* group : mode.groups) expected.insert(expected.end(), group->begin(), group->end());
    std::ranges::sort(expected);
    EXPECT_EQ(keys_in(run.out), expected) << mode.name;
    // The same of settings that had the keys of every mode.
    if (mode.groups.size() > 1 && mode.groups[1] == &depth) continue;
    const Told edited({"convert", "-", "--to", "orbslam3", "--sensor", mode.name},
                      {.input = read_file(kSettings) + "RGBD.DepthMapFactor: 5000.0\n"});
    ASSERT_EQ(edited.code(), 0) << mode.name << edited.text();
    EXPECT_EQ(keys_in(edited.bytes()), expected) << mode.name;
    EXPECT_TRUE(edited.lost("not-carried", "RGBD.DepthMapFactor 5000.0")) << edited.text();
  }
}

// Kalibr's imu.yaml wants densities. What was measured per sample is converted when that is said, and only then.
TEST(RigOptions, ImuNoiseOfSingleSamples) {
  const auto imu = [](const std::vector<std::string>& options) {
    std::vector<std::string> words = {"convert", kTumvi, "--with", kImu, "--to", "orbslam3"};
    words.insert(words.end(), options.begin(), options.end());
    const RunResult run = run_program(words);
    EXPECT_EQ(run.code, 0) << run.err;
    return rig_in(run.out).imus.at(0);
  };
  const Imu stated = imu({});
  EXPECT_EQ(imu({"--imu-noise", "continuous"}), stated);
  const Imu converted = imu({"--imu-noise", "discrete"});
  const double root = std::sqrt(200.0);
  EXPECT_DOUBLE_EQ(*converted.gyroscope_noise_density, *stated.gyroscope_noise_density / root);
  EXPECT_DOUBLE_EQ(*converted.accelerometer_noise_density, *stated.accelerometer_noise_density / root);
  EXPECT_DOUBLE_EQ(*converted.gyroscope_random_walk, *stated.gyroscope_random_walk * root);
  EXPECT_DOUBLE_EQ(*converted.accelerometer_random_walk, *stated.accelerometer_random_walk * root);
  const RunResult none = run_program({"convert", kTumvi, "--to", "orbslam3", "--imu-noise", "discrete"});
  EXPECT_EQ(none.code, 2);
  EXPECT_TRUE(says(none.err, "imu-missing", "--with imu.yaml")) << none.err;
  EXPECT_EQ(run_program({"show", kImu, "--imu-noise", "squares"}).code, 3);
}

TEST(RigOptions, ImuNoiseAsVariances) {
  const TemporaryFolder folder;
  const std::string squares =
      "accelerometer_noise_density: 4.0e-06\naccelerometer_random_walk: 9.0e-06\ngyroscope_noise_density: 1.6e-07\n"
      "gyroscope_random_walk: 2.5e-09\nupdate_rate: 100.0\nrostopic: /imu0\n";
  const auto imu = [&](const std::string& kind) {
    const RunResult run =
        run_program({"convert", kTumvi, "--with", folder.write("imu.yaml", squares), "--imu-noise", kind, "--to", "orbslam3"});
    EXPECT_EQ(run.code, 0) << run.err;
    return rig_in(run.out).imus.at(0);
  };
  const Imu densities = imu("variance");
  EXPECT_DOUBLE_EQ(*densities.accelerometer_noise_density, 2e-3);
  EXPECT_DOUBLE_EQ(*densities.accelerometer_random_walk, 3e-3);
  EXPECT_DOUBLE_EQ(*densities.gyroscope_noise_density, 4e-4);
  EXPECT_DOUBLE_EQ(*densities.gyroscope_random_walk, 5e-5);
  const Imu samples = imu("discrete-variance");
  EXPECT_DOUBLE_EQ(*samples.accelerometer_noise_density, 2e-4);
  EXPECT_DOUBLE_EQ(*samples.accelerometer_random_walk, 3e-2);
}

}  // namespace
}  // namespace fca::test
