// SPDX-License-Identifier: BSD-3-Clause
// What `show` says: the poses (in words: golden/show.txt), the three fields of view, and what a given program would read from
// the file.
#include "cli/read_rig.h"
#include "cli/run_program.h"
#include "cli/told.h"
#include "formats/complaints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

#include <rapidjson/document.h>

namespace fca::test {
namespace {

/// A pinhole of 200 x 100 px and 100 px focal length with its centre at (`cx`, 49.5).
std::string pinhole_chain(double cx) {
  std::ostringstream text;
  text << "cam0:\n  camera_model: pinhole\n  intrinsics: [100.0, 100.0, " << cx
       << ", 49.5]\n  distortion_model: none\n  distortion_coeffs: []\n  resolution: [200, 100]\n";
  return text.str();
}

// 2 atan(99.5 / 100), 2 atan(49.5 / 100) and 2 atan(|(99.5, 49.5)| / 100).
TEST(Show, FieldsOfViewOfAPinhole) {
  const auto fields_of_view = [](double cx) {
    const Told run({"show", "-"}, {.input = pinhole_chain(cx)});
    EXPECT_EQ(run.code(), 0) << run.text();
    const auto& camera = run.json()["files"][0]["cameras"][0];
    return std::array{camera["horizontal_fov_deg"].GetDouble(), camera["vertical_fov_deg"].GetDouble(),
                      camera["diagonal_fov_deg"].GetDouble()};
  };
  const auto degrees = [](double tangent) { return std::atan(tangent) / std::numbers::pi * 180.0; };
  const auto [horizontal, vertical, diagonal] = fields_of_view(99.5);
  EXPECT_NEAR(horizontal, 2.0 * degrees(0.995), 1e-6);
  EXPECT_NEAR(vertical, 2.0 * degrees(0.495), 1e-6);
  EXPECT_NEAR(diagonal, 2.0 * degrees(std::hypot(0.995, 0.495)), 1e-6);
  // The axis outside the image, as in a crop.
  EXPECT_NEAR(fields_of_view(-100.0)[0], degrees(2.99) - degrees(1.0), 1e-6);
  const std::string said = run_program({"show", "-"}, {.input = pinhole_chain(99.5)}).out;
  for (const char* angle : {"89.7 deg", "52.7 deg", "96.0 deg"}) EXPECT_TRUE(contains(said, angle)) << said;
}

std::string settings() {
  const RunResult run = run_program({"convert", kTumvi, "--with", kImu, "--to", "orbslam3", "--orbslam3-layout", "v1"});
  EXPECT_EQ(run.code, 0) << run.err;
  return run.out;
}

/// The reading of one of the program's modes ("": it has none) under show --for --json.
rapidjson::Document json_of(const std::string& bytes, const std::vector<std::string>& options) {
  std::vector<std::string> words = {"show", "-", "--json"};
  words.insert(words.end(), options.begin(), options.end());
  const RunResult run = run_program(words, {.input = bytes});
  EXPECT_EQ(run.code, 0) << run.err;
  rapidjson::Document document;
  document.Parse(run.out.c_str());
  EXPECT_FALSE(document.HasParseError());
  return document;
}

const rapidjson::Value* mode_of(const rapidjson::Document& document, const std::string& mode) {
  for (const rapidjson::Value& each : document["files"][0]["for"]["as"].GetArray()) {
    const auto names = each["modes"].GetArray();
    if (names.Empty() && mode.empty()) return &each;
    for (const rapidjson::Value& name : names) {
      if (name.GetString() == mode) return &each;
    }
  }
  return nullptr;
}

// A file that does not say which lens its four coefficients are means two things: both are shown, and what decides.
TEST(Show, BothReadingsOfAFileThatLeavesTheLensOpen) {
  const std::string file =
      "%YAML:1.0\nimage_width: 640\nimage_height: 480\ncamera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
      "   data: [ 300., 0., 319.5, 0., 300., 239.5, 0., 0., 1. ]\ndistortion_coefficients: !!opencv-matrix\n   rows: 4\n"
      "   cols: 1\n   dt: d\n   data: [ -0.1, 0.02, -0.001, 0.0005 ]\n";
  const Told run({"show", "-"}, {.input = file});
  EXPECT_EQ(run.code(), 0) << run.text();
  const auto& shown = run.json()["files"][0];
  ASSERT_EQ(shown["readings"].Size(), 2U);
  const std::array<std::array<const char*, 2>, 2> expected = {{{"pinhole", "radtan"}, {"fisheye", "kb4"}}};
  for (rapidjson::SizeType i = 0; i < 2; ++i) {
    EXPECT_STREQ(shown["readings"][i]["opencv_model"].GetString(), expected[i][0]);
    EXPECT_STREQ(shown["readings"][i]["cameras"][0]["model"].GetString(), expected[i][1]);
  }
  EXPECT_FALSE(shown.HasMember("cameras"));
  EXPECT_STREQ(shown["diagnostics"][0]["code"].GetString(), "ambiguous-model");
  EXPECT_STREQ(shown["diagnostics"][0]["severity"].GetString(), "warning");
  EXPECT_EQ(run_program({"convert", "-", "--to", "kalibr"}, {.input = file}).code, 2);
}

// A factory's file that has a lens for each size of images is shown with each, and checked with the widest.
TEST(Show, EachSizeOfAFileThatHasSeveral) {
  std::string file = read_file(testdata("formats/zed/good/SN1.conf"));
  for (const char* camera : {"LEFT", "RIGHT"})
    file += "\n[" + std::string(camera) +
            "_CAM_FHD]\nfx=1400.5\nfy=1400.25\ncx=985.5\ncy=556.5\nk1=-0.175\nk2=0.0275\nk3=0\np1=0\np2=0\n";
  const Told run({"show", "-"}, {.input = file});
  EXPECT_EQ(run.code(), 0) << run.text();
  const auto& shown = run.json()["files"][0];
  ASSERT_EQ(shown["readings"].Size(), 2U);
  EXPECT_STREQ(shown["readings"][0]["size"].GetString(), "1920x1080");
  EXPECT_EQ(shown["readings"][1]["cameras"][0]["width_px"].GetInt(), 1280);
  EXPECT_STREQ(shown["diagnostics"][0]["code"].GetString(), "size-needed");
  EXPECT_EQ(run_program({"check", "-"}, {.input = file}).code, 0);
  EXPECT_EQ(run_program({"convert", "-", "--to", "kalibr"}, {.input = file}).code, 2);
}

// V1.0 gives the second fisheye camera the first one's k1..k4: what that costs is known without asking it.
TEST(Show, ForAProgramThatMisreadsACamera) {
  const std::string bytes = settings();
  const Rig rig = rig_in(bytes);
  Camera confused = rig.cameras.at(1);
  const std::vector<double> first(parameter_values(rig.cameras[0].model).begin(), parameter_values(rig.cameras[0].model).end());
  std::vector<double> values(parameter_values(confused.model).begin(), parameter_values(confused.model).end());
  std::copy(first.begin() + 4, first.end(), values.begin() + 4);
  confused.model = Intrinsics<Kb4>{{values[0], values[1], values[2], values[3], values[4], values[5], values[6], values[7]}};
  double cost = 0.0;
  for (int u = 0; u < 512; u += 7) {
    for (int v = 0; v < 512; v += 7) {
      const Pixel pixel = {static_cast<double>(u), static_cast<double>(v)};
      const std::optional<Ray> ray = unproject(rig.cameras[1].model, pixel);
      const std::optional<Pixel> theirs = ray ? project(confused.model, *ray) : std::nullopt;
      if (theirs) cost = std::max(cost, std::hypot((*theirs)[0] - pixel[0], (*theirs)[1] - pixel[1]));
    }
  }
  const rapidjson::Document json = json_of(bytes, {"--for", "orbslam3"});
  const rapidjson::Value* stereo = mode_of(json, "stereo-inertial");
  ASSERT_NE(stereo, nullptr);
  EXPECT_TRUE((*stereo)["loads"].GetBool());
  ASSERT_EQ((*stereo)["cameras"].Size(), 2U);
  EXPECT_STREQ((*stereo)["cameras"][0]["model"].GetString(), "KannalaBrandt8");
  EXPECT_TRUE((*stereo)["cameras"][0]["agrees"].GetBool());
  EXPECT_FALSE((*stereo)["cameras"][1]["agrees"].GetBool());
  EXPECT_NEAR((*stereo)["cameras"][1]["max_diff_px"].GetDouble(), cost, 0.05 * cost);
  // As mono it is told of one camera, and has nothing to confuse.
  const rapidjson::Value* mono = mode_of(json, "mono");
  ASSERT_NE(mono, nullptr);
  EXPECT_EQ((*mono)["cameras"].Size(), 1U);
  EXPECT_TRUE((*mono)["cameras"][0]["agrees"].GetBool());
  const rapidjson::Value* rgbd = mode_of(json, "rgbd");
  ASSERT_NE(rgbd, nullptr);
  EXPECT_FALSE((*rgbd)["loads"].GetBool());
  ASSERT_FALSE((*rgbd)["refusals"].Empty());
  EXPECT_TRUE(contains((*rgbd)["refusals"][0].GetString(), "RGBD.DepthMapFactor"));
  const consumers::ConsumerView view = consumers::find_consumer("orbslam3")->load(bytes, {"stereo-inertial"});
  expect_warning(view, Code::kOrbslamSecondFisheyeIgnored, "Camera2.k1/");
  const auto warnings = (*stereo)["warnings"].GetArray();
  EXPECT_TRUE(std::ranges::any_of(warnings, [](const auto& warning) { return contains(warning.GetString(), "Camera2.k1"); }));
  // The program's title is as good as its id.
  EXPECT_EQ(json_of(bytes, {"--for", "ORB-SLAM3"}), json);
}

TEST(Show, ForAProgramOfItsFormat) {
  const Told run({"show", kTumvi, "--with", kImu, "--for", "kalibr"});
  EXPECT_EQ(run.code(), 0) << run.text();
  const rapidjson::Value* kalibr = mode_of(run.json(), "");
  ASSERT_NE(kalibr, nullptr) << run.text();
  EXPECT_TRUE((*kalibr)["loads"].GetBool());
  ASSERT_EQ((*kalibr)["cameras"].Size(), 2U);
  EXPECT_STREQ((*kalibr)["cameras"][0]["model"].GetString(), "pinhole-equidistant");
  EXPECT_TRUE((*kalibr)["cameras"][0]["agrees"].GetBool());
  // The part without cameras has a reader of its own.
  const Told imu({"show", kImu, "--for", "kalibr"});
  EXPECT_STREQ(imu.json()["files"][0]["for"]["program"].GetString(), "Kalibr (imu.yaml)") << imu.text();
  EXPECT_TRUE((*mode_of(imu.json(), ""))["loads"].GetBool()) << imu.text();
}

TEST(Show, ForAProgramOfAnotherFormat) {
  const RunResult run = run_program({"show", kTumvi, "--for", "orbslam3"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "fca-io check " + kTumvi + " --for orbslam3")) << run.out;
}

TEST(Show, ForWantsAProgramAndAFileAsItStands) {
  const RunResult unknown = run_program({"show", kTumvi, "--for", "orbslam4"});
  EXPECT_EQ(unknown.code, 3);
  EXPECT_TRUE(contains(unknown.err, "orbslam3")) << unknown.err;
  EXPECT_EQ(run_program({"show", kTumvi, "--for", "kalibr", "--resize", "256x256"}).code, 3);
}

/// The poses of the file by "A_B", T_a_b.
std::map<std::string, Transform> poses_of(const Told& run) {
  std::map<std::string, Transform> poses;
  for (const auto& pose : run.json()["files"][0]["poses"].GetArray()) {
    Transform& T_a_b = poses[pose["a"].GetString() + (std::string("_") + pose["b"].GetString())];
    for (unsigned i = 0; i < 16; ++i) T_a_b.values.at(i) = pose["T_a_b"][i].GetDouble();
  }
  return poses;
}

// The second camera of TUM VI's pair stands on the right of the first.
TEST(Show, PosesAreThoseOfTheFirstCameraAskedFor) {
  std::map<std::string, Transform> poses = poses_of(Told({"show", kTumvi}));
  ASSERT_EQ(poses.size(), 3U);
  EXPECT_TRUE(poses.contains("cam0_imu0"));
  const Transform to_the_right = inverse(poses["cam1_cam0"]).value();  // the second in the first
  EXPECT_NEAR(to_the_right(0, 3), 0.1011, 5e-5);
  std::map<std::string, Transform> swapped = poses_of(Told({"show", kTumvi, "--camera", "1,0"}));
  ASSERT_EQ(swapped.size(), 2U);
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_NEAR(swapped["cam0_cam1"].values.at(i), to_the_right.values.at(i), 1e-12);
    EXPECT_EQ(swapped["cam1_imu0"].values.at(i), poses["cam1_imu0"].values.at(i));
  }
}

}  // namespace
}  // namespace fca::test
