// SPDX-License-Identifier: BSD-3-Clause
// stella_vslam's configuration and OpenVSLAM's: what their numbers mean, what is written comes back, edits keep every other
// byte.
#include "formats/lost_facts.h"
#include "formats/rigs.h"
#include "formats/test_files.h"

#include <fca/code.h>
#include <fca/formats/proof.h>
#include <fca/rig/rotation.h>

namespace fca::test {
namespace {

const Format& stella() { return *find_format("stella"); }
std::string good(const std::string& name) { return read_file(testdata_dir() / "stella" / name); }

Written written_of(const text::Document* base, const Rig& rig, const WriteOptions& options = {}) {
  Diagnostics diagnostics;
  std::optional<Written> written = write_calibration(stella(), base, rig, options, diagnostics);
  EXPECT_TRUE(written);
  return written ? *std::move(written) : Written();
}

void expect_proven(const Written& written, const Rig& rig, const std::string& program) {
  ASSERT_EQ(written.files.size(), 1U);
  const Written::File& file = written.files.front();
  ASSERT_EQ(file.programs, std::vector<std::string>{program});
  const ProofResult proof = prove(*consumers::find_consumer(program), file.document.bytes(), {}, rig, file.cameras, 0.9);
  EXPECT_TRUE(proof.agrees()) << (proof.loads ? "other numbers" : "refused") << "\n" << file.document.bytes();
}

/// The base with the change.
std::string with_change(const std::string& bytes, const std::function<void(Rig&)>& change) {
  Rig rig = calibration_of(bytes, "stella.yaml").rig;
  change(rig);
  const text::Document base = document_of(bytes, "stella.yaml");
  return written_of(&base, rig).files.front().document.bytes();
}

// A ray of the division model is (x, y, 1 + distortion r^2): by hand, of the pixel 400 to the right and 200 below the centre.
TEST(Stella, ADivisionLensBendsAsTheProgramSays) {
  const Camera camera = calibration_of(good("good/division.yaml"), "gopro.yaml").rig.cameras.front();
  ASSERT_EQ(model_info(camera.model).id, "division");
  const double x = 400.0 / 981.5;
  const double y = 200.0 / 981.5;
  const double z = 1.0 - 0.30625 * (x * x + y * y);
  const std::optional<Ray> ray = unproject(camera.model, {1350.75, 917.5});
  ASSERT_TRUE(ray);
  EXPECT_NEAR((*ray)[0] / (*ray)[2], x / z, 1e-14);
  EXPECT_NEAR((*ray)[1] / (*ray)[2], y / z, 1e-14);
}

// Columns are longitudes from -180 to 180 degrees, rows latitudes from 90 up to 90 down.
TEST(Stella, APanoramaIsATableAndStaysInItsFile) {
  const std::string bytes = good("good/equirectangular.yaml");
  const Rig rig = calibration_of(bytes, "panorama.yaml").rig;
  const Camera& camera = rig.cameras.front();
  ASSERT_GE(camera.rays.size(), 2000U);
  for (const Correspondence& entry : camera.rays) {
    EXPECT_NEAR(entry.pixel[0], 960.0 + std::atan2(entry.ray[0], entry.ray[2]) * 960.0 / std::acos(-1.0), 1e-9);
    EXPECT_NEAR(entry.pixel[1], 480.0 + std::asin(entry.ray[1]) * 960.0 / std::acos(-1.0), 1e-9);
  }
  const text::Document base = document_of(bytes, "panorama.yaml");
  EXPECT_EQ(written_of(&base, rig).files.front().document.bytes(), bytes);
  Rig faster = rig;
  faster.cameras.front().frame_rate_hz = 25.0;
  std::string expected = bytes;
  expected.replace(expected.find("30.0"), 4, "25.0");
  EXPECT_EQ(written_of(&base, faster).files.front().document.bytes(), expected);
  expect_proven(written_of(&base, rig), rig, "stella");
}

TEST(Stella, FocalTimesBaselineIsInPixelsTimesMetres) {
  const Rig pair = calibration_of(good("good/stereo.yaml"), "stereo.yaml").rig;
  ASSERT_EQ(pair.cameras.size(), 1U);
  EXPECT_DOUBLE_EQ(pair.baseline_m.value(), 386.25 / 718.5);
  const Rig depth = calibration_of(good("good/depth.yaml"), "depth.yaml").rig;
  EXPECT_DOUBLE_EQ(depth.baseline_m.value(), 40.0 / 517.25);
  EXPECT_EQ(depth.find_extra_field("", "Camera.setup")->value, "RGBD");
  EXPECT_EQ(depth.cameras.front().frame_rate_hz, 30.0);
}

/// A pair of good/raw-pair.yaml with other rotations.
Rig pair_with(const std::string& R_left, const std::string& R_right) {
  std::string bytes = good("good/raw-pair.yaml");
  for (const auto& [key, R] : {std::pair("R_left: ", R_left), std::pair("R_right: ", R_right)}) {
    const std::size_t at = bytes.find(key) + std::string(key).size();
    bytes.replace(at, bytes.find('\n', at) - at, R);
  }
  return calibration_of(bytes, "pair.yaml").rig;
}

// p_rectified = R p_camera; the right camera is a baseline to the right: 47.875 / 435.125 m.
TEST(Stella, APairThatIsNotRectifiedIsTwoCameras) {
  const std::string none = "[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]";
  const Rig level = pair_with(none, none);
  ASSERT_EQ(level.cameras.size(), 2U);
  EXPECT_FALSE(level.baseline_m);
  EXPECT_EQ(parameter(level.cameras[0].model, "cx"), 367.25) << "of the raw image, not 367.5";
  EXPECT_EQ(parameter(level.cameras[1].model, "k1"), -0.28375);
  std::optional<Transform> T = level.resolve("cam0", "cam1");
  ASSERT_TRUE(T);
  EXPECT_NEAR((*T)(0, 3), 47.875 / 435.125, 1e-15);
  EXPECT_EQ((*T)(1, 3), 0.0);
  // The left camera's z axis is the rectified x axis: what is to the right in the rectified images is ahead of it.
  T = pair_with("[0.0, 0.0, 1.0, 0.0, 1.0, 0.0, -1.0, 0.0, 0.0]", none).resolve("cam0", "cam1");
  ASSERT_TRUE(T);
  EXPECT_NEAR((*T)(2, 3), 47.875 / 435.125, 1e-15);
  EXPECT_EQ((*T)(0, 3), 0.0);
}

TEST(Stella, OpenVslamsDottedKeysSayTheSame) {
  const Rig dotted = calibration_of(good("dialect/dotted.yaml"), "mono.yaml").rig;
  const Rig nested = calibration_of(good("good/monocular.yaml"), "mono.yaml").rig;
  EXPECT_EQ(dotted.cameras, nested.cameras);
  const Rig pair = calibration_of(good("dialect/dotted-pair.yaml"), "pair.yaml").rig;
  const Rig nested_pair = calibration_of(good("good/raw-pair.yaml"), "pair.yaml").rig;
  EXPECT_EQ(pair.cameras, nested_pair.cameras);
  EXPECT_EQ(pair.poses, nested_pair.poses);
}

TEST(Stella, AnEditKeepsEveryOtherByte) {
  const auto set_fx = [](Rig& rig) { EXPECT_TRUE(set_parameter(rig.cameras.front().model, "fx", 430.5)); };
  for (const std::string name : {"good/monocular.yaml", "dialect/dotted.yaml"}) {
    const std::string bytes = good(name);
    EXPECT_EQ(with_change(bytes, [](Rig&) {}), bytes) << name;
    EXPECT_EQ(with_change(bytes, set_fx), with_replaced(bytes, "fx: 421.375", "fx: 430.5")) << name;
  }
  const std::string pair = good("dialect/dotted-pair.yaml");
  EXPECT_EQ(with_change(pair, set_fx), with_replaced(pair, "[458.625,", "[430.5,"));
  const std::string depth = good("good/depth.yaml");
  const std::string edited = with_change(depth, [](Rig& rig) { rig.baseline_m = 0.08; });
  EXPECT_EQ(edited, with_replaced(depth, "focal_x_baseline: 40.0", "focal_x_baseline: 41.38"));
}

// Another lens has other keys; the rest of the file stays.
TEST(Stella, AnotherLensIsWrittenIntoTheFile) {
  const std::string edited = with_change(good("good/monocular.yaml"), [](Rig& rig) {
    rig.cameras.front().model = model_of("kb4", {421.375, 420.125, 319.25, 238.625, 0.01, 0.002, -0.0003, 0.00004});
  });
  EXPECT_NE(edited.find("model: \"fisheye\""), std::string::npos);
  EXPECT_NE(edited.find("  k4: 4.0e-05\n"), std::string::npos) << edited;
  EXPECT_EQ(edited.find("p1"), std::string::npos);
  EXPECT_NE(edited.find("scale_factor: 1.25"), std::string::npos);
  const Rig back = calibration_of(edited, "stella.yaml").rig;
  EXPECT_EQ(parameter(back.cameras.front().model, "k3"), -0.0003);
}

TEST(Stella, WhatIsWrittenIsReadBack) {
  for (const std::string id : {"radtan", "kb4", "pinhole"}) {
    SCOPED_TRACE(id);
    const Rig rig = sample_rig(id, {true, true});
    const Written written = written_of(nullptr, rig);
    expect_proven(written, rig, "stella");
    const Rig back = calibration_of(written.files.front().document.bytes(), "stella.yaml").rig;
    ASSERT_EQ(back.cameras.size(), 2U);
    const std::optional<Transform> before = rig.resolve("cam1", "cam0");
    const std::optional<Transform> after = back.resolve("cam1", "cam0");
    ASSERT_TRUE(before && after);
    EXPECT_LT(largest_difference(*before, *after).distance, 1e-9);
  }
}

TEST(Stella, ALensThatIsNoPairsIsWrittenAlone) {
  Rig rig;
  rig.cameras = calibration_of(good("good/division.yaml"), "gopro.yaml").rig.cameras;
  rig.cameras.push_back(rig.cameras.front());
  rig.cameras.back().name = "cam1";
  rig.poses.push_back({"cam1", "cam0", pose_of({0.0, 0.0, 0.0, 1.0}, {-0.1, 0.0, 0.0})});
  const Written written = written_of(nullptr, rig);
  expect_proven(written, rig, "stella");
  EXPECT_EQ(written.files.front().cameras, std::vector<std::string>{"cam0"});
  EXPECT_EQ(stella().cameras_held(rig, "", ""), 2U) << "their lenses may be fitted by others";
  const auto dropped = std::ranges::find(written.losses, Code::kOrbslam3SecondCameraDropped, &Loss::kind);
  ASSERT_NE(dropped, written.losses.end());
  EXPECT_EQ(dropped->owner, "cam1");
}

TEST(Stella, WhatTheInputDoesNotSayIsListed) {
  Rig rig = sample_rig("radtan", {});
  rig.cameras.resize(1);
  rig.cameras.front().frame_rate_hz.reset();
  const Written written = written_of(nullptr, rig);
  std::vector<std::string> keys;
  for (const DefaultedValue& value : written.defaults) keys.push_back(value.key);
  EXPECT_EQ(keys, (std::vector<std::string>{"Camera.fps", "Camera.color_order"}));
  EXPECT_NE(written.files.front().document.bytes().find("setup: \"monocular\""), std::string::npos);
}

TEST(Stella, AFreshFileInABasesPlaceKeepsItsTuning) {
  const text::Document base = document_of(good("good/monocular.yaml"), "base.yaml");
  const Rig pair = calibration_of(good("good/raw-fisheyes-crlf.yaml"), "pair.yaml").rig;
  const Written written = written_of(&base, pair);
  expect_proven(written, pair, "stella");
  const std::string bytes = written.files.front().document.bytes();
  EXPECT_NE(bytes.find("mask_rectangles:\n    - [0.0, 1.0, 0.0, 0.1]"), std::string::npos) << bytes;
  EXPECT_NE(bytes.find("num_levels: 7"), std::string::npos);
}

// A pair in the file's own rectification: nothing is chosen again.
TEST(Stella, TheRectificationOfAFileIsKept) {
  const std::string bytes = good("good/raw-pair.yaml");
  const Rig rig = calibration_of(bytes, "pair.yaml").rig;
  const std::string fresh = written_of(nullptr, rig).files.front().document.bytes();
  EXPECT_NE(fresh.find("  fx: 435.125\n  fy: 435.125\n  cx: 367.5\n  cy: 252.25\n"), std::string::npos) << fresh;
  EXPECT_NE(fresh.find("focal_x_baseline: 47.875"), std::string::npos) << fresh;
}

TEST(Stella, OpenVslamAndStellaEachReadTheirOwnKeys) {
  const auto loads = [](const char* program, const std::string& bytes) {
    return consumers::find_consumer(program)->load(bytes, {}).loads();
  };
  EXPECT_TRUE(loads("openvslam", good("dialect/dotted.yaml")));
  EXPECT_TRUE(loads("openvslam", good("dialect/dotted-pair.yaml")));
  EXPECT_FALSE(loads("stella", good("dialect/dotted.yaml")));
  EXPECT_TRUE(loads("stella", good("good/raw-pair.yaml")));
  EXPECT_FALSE(loads("openvslam", good("good/raw-pair.yaml")));
}

TEST(Stella, OpenVslamsLayoutIsWrittenAfresh) {
  WriteOptions options;
  options.layout = "openvslam";
  for (const char* file : {"good/monocular.yaml", "good/fisheye.yaml", "good/stereo.yaml", "good/raw-pair.yaml"}) {
    SCOPED_TRACE(file);
    const text::Document base = document_of(good(file), "stella.yaml");
    const Rig rig = calibration_of(good(file), "stella.yaml").rig;
    for (const text::Document* from : {static_cast<const text::Document*>(nullptr), &base}) {
      const Written written = written_of(from, rig, options);
      expect_proven(written, rig, "openvslam");
      EXPECT_EQ(written.files.front().document.bytes().find("\n  "), std::string::npos);  // no level below another
    }
  }
  // It is no layout of files that have it already.
  const std::string dotted = good("dialect/dotted.yaml");
  const text::Document base = document_of(dotted, "stella.yaml");
  EXPECT_EQ(written_of(&base, calibration_of(dotted, "stella.yaml").rig, options).files.front().document.bytes(), dotted);
}

}  // namespace
}  // namespace fca::test
