// SPDX-License-Identifier: BSD-3-Clause
// What is written is proven, fixed, refused, or said to be unproven: never written in silence.
#include "cli/run_program.h"
#include "cli/told.h"

#include <fca/formats/consumers/consumer.h>

#include <rapidjson/document.h>
#include <opencv2/core.hpp>

#include <cmath>
#include <numbers>

namespace fca::test {
namespace {

const std::string kBom = "\xEF\xBB\xBF";
const std::string kCalibration = testdata("formats/opencv/good/calibration.yml");
const std::string kCameras = testdata("formats/opencv/good/cameras.yml");
const std::string kSettings = testdata("formats/orbslam3/good/v1-stereo-inertial.yaml");

bool opens(const std::string& path) {
  try {
    return cv::FileStorage(path, cv::FileStorage::READ).isOpened();
  } catch (const std::exception&) {
    return false;
  }
}

rapidjson::Document json_of(const RunResult& run) {
  rapidjson::Document document;
  document.Parse(run.out.c_str());
  EXPECT_FALSE(document.HasParseError()) << run.out << run.err;
  return document;
}

TEST(Proof, AByteOrderMarkIsNoFileOfOpenCvs) {
  const TemporaryFolder folder;
  const std::string yml = folder.write("bom.yml", kBom + read_file(kCalibration));
  EXPECT_FALSE(opens(yml));
  const Told shown({"show", yml, "--for", "opencv"});
  EXPECT_FALSE(shown.json()["files"][0]["for"]["as"][0]["loads"].GetBool()) << shown.text();
  // Written into, the mark goes and the rest stays.
  const RunResult run = run_program({"convert", yml, "--to", "opencv", "--model", "rational", "-o", folder / "out.yml"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(says(run.err, "mended", "bom.yml:1:1")) << run.err;
  EXPECT_TRUE(opens(folder / "out.yml"));
  EXPECT_TRUE(contains(read_file(folder / "out.yml"), "# As OpenCV's camera_calibration sample")) << "comments stay";
}

// KannalaBrandt8::unproject cuts the distorted angle off at pi/2 and takes the tangent of the angle that has it: a little more
// than 90 degrees for TUM-VI's lens, so that the corner's ray comes out turned round, at about as many degrees less.
TEST(Proof, WrongRaysAreToldInPixels) {
  const TemporaryFolder folder;
  const RunResult run =
      run_program({"convert", kTumvi, "--camera", "cam0", "--to", "orbslam3", "--json", "-o", folder / "s.yaml"});
  EXPECT_EQ(run.code, 0) << run.err;
  const rapidjson::Document json = json_of(run);
  // TUM-VI's cam0: the corner farthest from the principal point is that at (511, 0).
  const double corner = std::hypot(511.0 - 254.93, 0.0 - 256.90);
  const double circle = 190.976 * std::numbers::pi / 2.0;
  EXPECT_NEAR(json["proof"][0]["wrong_ray_px"].GetDouble(), corner + circle, 10.0) << "k1 to k4 move it by some pixels";
  const RunResult narrow = run_program(
      {"convert", kTumvi, "--camera", "cam0", "--to", "orbslam3", "--max-angle", "80", "--json", "-o", folder / "n.yaml"});
  EXPECT_EQ(json_of(narrow)["proof"][0]["wrong_ray_px"].GetDouble(), 0.0) << narrow.out;
}

// --opencv-model says how the input is meant; the output says itself what it is, or is told as what it was written.
TEST(Proof, HowTheInputIsMeantIsNoReadingOfTheOutput) {
  const TemporaryFolder folder;
  std::string four = read_file(testdata("formats/opencv/good/fisheye.json"));
  const std::string key = "    \"fisheye_model\": 1,\n";
  four.erase(four.find(key), key.size());
  const std::string input = folder.write("four.json", four);
  for (const char* meant : {"pinhole", "fisheye"}) {
    for (const char* model : {"kb4", "radtan", "pinhole"}) {
      const RunResult run =
          run_program({"convert", input, "--to", "opencv", "--opencv-model", meant, "--model", model, "-o", folder / "out.json",
                       "--force", "--accept", "pixels-off", "--accept", "no-right-rays"});
      EXPECT_EQ(run.code, 0) << meant << " " << model << ": " << run.err;
      EXPECT_FALSE(says(run.err, "proof-failed")) << run.err;
    }
    // Unchanged, it does not say what it is.
    const RunResult run =
        run_program({"convert", input, "--to", "opencv", "--opencv-model", meant, "-o", folder / "o.json", "--force"});
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(read_file(folder / "o.json"), four);
    EXPECT_TRUE(says(run.err, "ambiguous-model", std::string("--opencv-model ") + meant)) << run.err;
    EXPECT_FALSE(says(run.err, "not-proven")) << run.err;
  }
}

TEST(Proof, SettingsLoseTheirByteOrderMark) {
  const TemporaryFolder folder;
  const std::string base = folder.write("settings.yaml", kBom + read_file(kSettings));
  const Told run({"convert", kSettings, "--into", base, "--in-place"});
  EXPECT_EQ(run.code(), 0) << run.text();
  EXPECT_TRUE(run.loads()) << run.text();
  EXPECT_EQ(read_file(base), read_file(kSettings));
}

// The input's own defect, kept byte by byte: said as such in the proof's line.
TEST(Proof, AnUnchangedFileIsRefusedForItsOwnDefect) {
  const std::string file = testdata("formats/kalibr/good/opencv-header.yaml");
  EXPECT_EQ(Told({"convert", file, "--to", "kalibr"}).code(), 1);
  const Told run({"convert", file, "--to", "kalibr", "--accept", "program-refuses"});
  EXPECT_EQ(run.code(), 0) << run.text();
  EXPECT_FALSE(run.loads()) << run.text();
  EXPECT_EQ(run.bytes(), read_file(file));
}

TEST(Proof, ACameraAddedToMcCalibsMapsIsProven) {
  const TemporaryFolder folder;
  const Told two({"convert", kCameras, "--camera", "0,1", "--to", "opencv", "-o", folder / "two.yml"});
  EXPECT_EQ(two.code(), 0) << two.text();
  EXPECT_TRUE(two.loads()) << two.text();
  const RunResult run = run_program({"convert", kCameras, "--into", folder / "two.yml", "--json", "-o", folder / "three.yml"});
  EXPECT_EQ(run.code, 0) << run.err << run.out;
  const rapidjson::Document json = json_of(run);
  ASSERT_EQ(json["proof"].Size(), 1U) << run.out;
  EXPECT_TRUE(json["proof"][0]["agrees"].GetBool());
  EXPECT_TRUE(opens(folder / "three.yml"));
  // Without the first camera the others are counted again.
  const RunResult last = run_program({"convert", kCameras, "--camera", "1,2", "--to", "opencv", "--json"});
  EXPECT_EQ(json_of(last)["proof"].Size(), 1U) << last.out;
}

TEST(Proof, WhatNoProgramReadsIsSaidToBeUnproven) {
  const TemporaryFolder folder;
  const std::string keys = with_replaced(read_file(kCalibration), "camera_matrix:", "Intrisic:");
  const std::string input = folder.write("keys.yml", with_replaced(keys, "distortion_coefficients:", "Distorsion:"));
  const RunResult run = run_program({"convert", input, "--to", "opencv", "-o", folder / "out.yml"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(says(run.err, "not-proven")) << run.err;
  const Told json({"convert", input, "--to", "opencv"});
  EXPECT_EQ(json.json()["proof"].Size(), 0U);
  EXPECT_TRUE(json.says("not-proven")) << json.text();
}

TEST(Proof, WithoutASizeNoPixelsAreCompared) {
  const TemporaryFolder folder;
  std::string bytes = read_file(kCalibration);
  bytes = with_replaced(with_replaced(bytes, "image_width: 752\n", ""), "image_height: 480\n", "");
  const Told run({"convert", folder.write("in.yml", bytes), "--to", "opencv", "-o", folder / "out.yml"});
  EXPECT_EQ(run.code(), 0) << run.text();
  EXPECT_TRUE(run.loads()) << run.text();
  EXPECT_EQ(run.json()["proof"][0]["compared_share"].GetDouble(), 0.0) << run.text();
}

// A pair that is not rectified: V1.0 gives both cameras the first one's coefficients, and there is a way out.
TEST(Proof, AMisreadPinholePairHasAWayOut) {
  const std::vector<std::string> words = {
      "convert", testdata("formats/opencv/good/k1d1.yml"), "--size", "640x400", "--to", "orbslam3", "--max-angle", "40"};
  const Told run(words);
  EXPECT_EQ(run.code(), 0) << run.text();
  EXPECT_GT(run.json()["proof"][0]["misread_px"].GetDouble(), 0.0) << run.text();
  EXPECT_FALSE(run.json()["other_writings"].Empty()) << run.text();
}

}  // namespace
}  // namespace fca::test
