// SPDX-License-Identifier: BSD-3-Clause
// What `show` says: poses as sentences, the three fields of view, and what a given program would make of the file.
#include "cli/read_rig.h"
#include "cli/run_program.h"
#include "cli/told.h"
#include "formats/complaints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include <rapidjson/document.h>

namespace fca::test {
namespace {

const std::string kTumvi = testdata("formats/kalibr/good/tumvi.yaml");
const std::string kImu = testdata("formats/kalibr/good/imu.yaml");

/// A pinhole of 200 x 100 px and 100 px focal length with its centre at (`cx`, 49.5), and what follows it.
std::string pinhole_chain(double cx, const std::string& more) {
  std::ostringstream text;
  text << "cam0:\n  camera_model: pinhole\n  intrinsics: [100.0, 100.0, " << cx
       << ", 49.5]\n  distortion_model: none\n  distortion_coeffs: []\n  resolution: [200, 100]\n"
       << more;
  return text.str();
}

std::string shown(const std::string& bytes) {
  const RunResult run = run_program({"show", "-"}, {.input = bytes});
  EXPECT_EQ(run.code, 0) << run.err;
  return run.out;
}

// An IMU with x ahead, y to the left and z up, and a camera that looks ahead, 2 cm ahead, 4.5 cm to the left and 3 cm above it:
// x of the camera is -y, its y is -z and its z is +x of the IMU.
TEST(Show, PosesAreSentences) {
  const std::string T_cam_imu =
      "  T_cam_imu:\n  - [0.0, -1.0, 0.0, 0.045]\n  - [0.0, 0.0, -1.0, 0.03]\n  - [1.0, 0.0, 0.0, -0.02]\n"
      "  - [0.0, 0.0, 0.0, 1.0]\n";
  const std::string text = shown(pinhole_chain(99.5, T_cam_imu));
  for (const char* value :
       {"T_cam0_imu0: imu0 -> cam0", "2.00 cm towards +x", "4.50 cm towards +y", "3.00 cm towards +z of imu0", "along +x\n"})
    EXPECT_TRUE(contains(text, value)) << value << " is not in\n" << text;
}

/// A second camera 10 cm to the right of the first, whose axes are the columns of `axes` (of T_cam0_cam1), row by row.
std::string turned_camera(const std::array<int, 9>& axes) {
  std::ostringstream text;
  text << "cam1:\n  camera_model: pinhole\n  intrinsics: [100.0, 100.0, 99.5, 49.5]\n  distortion_model: none\n"
          "  distortion_coeffs: []\n  resolution: [200, 100]\n  T_cn_cnm1:\n";
  for (std::size_t row = 0; row < 3; ++row) {  // the inverse: the rotation transposed, the position turned back
    text << "  - [" << axes.at(row) << ".0, " << axes.at(3 + row) << ".0, " << axes.at(6 + row) << ".0, " << -0.1 * axes.at(row)
         << "]\n";
  }
  text << "  - [0.0, 0.0, 0.0, 1.0]\n";
  return pinhole_chain(99.5, text.str());
}

// Two cameras may look along one direction and yet see the world turned. x of a camera is right and y down: with x of the
// second pointing down, it is turned as a clock's hand from 12 to 3, seen from behind.
TEST(Show, ATurnAboutTheAxisIsSaid) {
  struct Case {
    std::array<int, 9> axes;
    const char* words;
  };
  for (const Case& c :
       {Case{{1, 0, 0, 0, 1, 0, 0, 0, 1}, "the same way\n"}, Case{{-1, 0, 0, 0, -1, 0, 0, 0, 1}, "180 deg about its axis\n"},
        Case{{0, -1, 0, 1, 0, 0, 0, 0, 1}, " 90 deg clockwise"}, Case{{0, 1, 0, -1, 0, 0, 0, 0, 1}, " 90 deg counterclockwise"},
        Case{{-1, 0, 0, 0, 1, 0, 0, 0, -1}, "backwards\n"}, Case{{1, 0, 0, 0, -1, 0, 0, 0, -1}, "backwards, turned 180 deg"},
        Case{{0, 0, 1, 0, 1, 0, -1, 0, 0}, "to its right\n"}, Case{{1, 0, 0, 0, 0, 1, 0, -1, 0}, "down\n"}}) {
    const std::string text = shown(turned_camera(c.axes));
    EXPECT_TRUE(contains(text, "10.00 cm to the right of cam0")) << text;
    EXPECT_TRUE(contains(text, c.words)) << text;
  }
}

// OpenCV's T is in the unit of the calibration board, which no file states.
TEST(Show, APositionWithoutAUnitIsNoFact) {
  const std::string file = testdata("formats/opencv/good/extrinsics.yml");
  const std::string unit = "if the unit of its position is the metre";  // golden/show.txt has the whole sentence
  const RunResult alone = run_program({"show", file});
  EXPECT_TRUE(contains(alone.out, " cm ")) << alone.out;
  EXPECT_TRUE(contains(alone.out, unit)) << alone.out;
  const RunResult beside = run_program({"show", testdata("formats/opencv/good/stereo-14.yml"), "--with", file});
  EXPECT_TRUE(contains(beside.out, unit)) << beside.out << beside.err;
  EXPECT_FALSE(contains(shown(turned_camera({1, 0, 0, 0, 1, 0, 0, 0, 1})), unit));
}

// 2 atan(99.5 / 100), 2 atan(49.5 / 100) and 2 atan(|(99.5, 49.5)| / 100).
TEST(Show, FieldsOfViewOfAPinhole) {
  for (const char* angle : {"horizontal 89.7 deg", "vertical 52.7 deg", "diagonal 96.0 deg"})
    EXPECT_TRUE(contains(shown(pinhole_chain(99.5, "")), angle)) << angle;
  // The axis outside the image, as in a crop: atan(299 / 100) - atan(100 / 100).
  EXPECT_TRUE(contains(shown(pinhole_chain(-100.0, "")), "horizontal 26.5 deg"));
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
  EXPECT_TRUE(contains(run.out, "fca-io convert " + kTumvi + " --to orbslam3")) << run.out;
}

TEST(Show, ForWantsAProgramAndAFileAsItStands) {
  const RunResult unknown = run_program({"show", kTumvi, "--for", "orbslam4"});
  EXPECT_EQ(unknown.code, 3);
  EXPECT_TRUE(contains(unknown.err, "orbslam3")) << unknown.err;
  EXPECT_EQ(run_program({"show", kTumvi, "--for", "kalibr", "--resize", "256x256"}).code, 3);
}

// The second camera of TUM VI's pair stands on the right of the first.
TEST(Show, PosesAreThoseOfTheFirstCameraAskedFor) {
  const std::string pair = testdata("formats/kalibr/good/tumvi.yaml");
  EXPECT_TRUE(contains(run_program({"show", pair}).out, "10.11 cm to the right"));
  const std::string swapped = run_program({"show", pair, "--camera", "1,0"}).out;
  EXPECT_TRUE(contains(swapped, "T_cam0_cam1: cam1 -> cam0")) << swapped;
  EXPECT_TRUE(contains(swapped, "10.11 cm to the left")) << swapped;
  EXPECT_TRUE(contains(swapped, "T_cam1_imu0: imu0 -> cam1")) << swapped;
  EXPECT_FALSE(contains(swapped, "T_cam1_cam0")) << swapped;
}

}  // namespace
}  // namespace fca::test
