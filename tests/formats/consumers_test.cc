// SPDX-License-Identifier: BSD-3-Clause
// The typing rules, misreadings and limits of the programs, each on a small handwritten file.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "fca/formats/consumers/consumer.h"
#include "pyyaml.h"

#include <fca/formats/wording.h>

namespace fca::consumers {
namespace {

ConsumerView load(std::string_view id, const std::string& text, const std::string& sensor = "mono") {
  return find_consumer(id)->load(text, {sensor});
}

/// `text` with the first `from` replaced.
std::string edited(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

bool mentions(const std::vector<consumers::Complaint>& complaints, std::string_view part) {
  return std::any_of(complaints.begin(), complaints.end(),
                     [part](const consumers::Complaint& each) { return sentence_of(each).find(part) != std::string::npos; });
}

void expect_loads(const ConsumerView& view) { EXPECT_TRUE(view.loads()) << sentence_of(view.refusals.front()); }

void expect_refused(const ConsumerView& view, std::string_view part) {
  EXPECT_FALSE(view.loads()) << "expected: " << part;
  EXPECT_TRUE(mentions(view.refusals, part))
      << (view.loads() ? "no refusal" : sentence_of(view.refusals.front())) << " lacks: " << part;
  EXPECT_TRUE(view.cameras.empty());
}

std::array<double, 2> pixel(const ConsumerView& view, std::size_t camera, const std::array<double, 3>& ray) {
  const std::array<double, 2> none = {std::nan(""), std::nan("")};
  if (camera >= view.cameras.size()) return none;
  return view.cameras.at(camera).project(ray).value_or(none);
}

// --- table
// --------------------------------------------------------------------------------------------------------------------

TEST(Consumers, TableHasUniqueIds) {
  std::vector<std::string_view> ids;
  for (const Consumer& row : all_consumers()) {
    EXPECT_EQ(find_consumer(row.id), &row);
    EXPECT_EQ(std::count(ids.begin(), ids.end(), row.id), 0);
    ids.push_back(row.id);
  }
  EXPECT_GE(ids.size(), 6U);
  EXPECT_EQ(find_consumer("no such program"), nullptr);
}

// --- PyYAML
// -------------------------------------------------------------------------------------------------------------------

TEST(PyYaml, TypesOfPlainScalars) {
  using pyyaml::Kind;
  struct Case {
    const char* text;
    Kind kind;
    double number;
  };
  constexpr double kInf = std::numeric_limits<double>::infinity();
  const Case cases[] = {{"1e-5", Kind::kString, 0},       {"1.0e-05", Kind::kFloat, 1e-5}, {"1.0e5", Kind::kString, 0},
                        {"1.5E+3", Kind::kFloat, 1500},   {"017", Kind::kInt, 15},         {"08", Kind::kString, 0},
                        {"0x1F", Kind::kInt, 31},         {"0b101", Kind::kInt, 5},        {"1_000", Kind::kInt, 1000},
                        {"190:20", Kind::kInt, 11420},    {"1:30.5", Kind::kFloat, 90.5},  {".5", Kind::kFloat, 0.5},
                        {"-.5", Kind::kString, 0},        {"1.", Kind::kFloat, 1},         {"-2", Kind::kInt, -2},
                        {".inf", Kind::kFloat, kInf},     {"-.Inf", Kind::kFloat, -kInf},  {"inf", Kind::kString, 0},
                        {"nan", Kind::kString, 0},        {".Nan", Kind::kString, 0},      {"yes", Kind::kBool, 1},
                        {"Off", Kind::kBool, 0},          {"~", Kind::kNull, 0},           {"1,5", Kind::kString, 0},
                        {"1.0e+999", Kind::kFloat, kInf}, {"1.0e-999", Kind::kFloat, 0}};
  for (const Case& c : cases) {
    const pyyaml::Value value = pyyaml::resolve_plain_scalar(c.text);
    EXPECT_EQ(value.kind, c.kind) << c.text;
    EXPECT_EQ(value.number, c.number) << c.text;
  }
  EXPECT_TRUE(std::isnan(pyyaml::resolve_plain_scalar(".NaN").number));
}

TEST(PyYaml, RefusesWhatPyYamlRefuses) {
  for (const char* text :
       {"%YAML:1.0\na: 1\n", "%YAML 2.0\n---\na: 1\n", "%YAML 1.2\na: 1\n", "a: 1\nkey:2\n", "key:2\na: 1\n", "a:\t1\n",
        "\ta: 1\n", "a: 1\t# comment\n", "a: !!opencv-matrix\n  b: 1\n", "a: 1\n---\nb: 2\n", "a: [1,,2]\n", "? [1]\n: 2\n",
        "a: *nothing\n", "a: &x [*x]\n", "a: \x01\n", "a: \xFF\n", "a: \"open\n", "a: [1, 2\n", "a: 1\n<<<<<<< HEAD\nb: 1\n"}) {
    EXPECT_TRUE(pyyaml::safe_load(text).error.is_said()) << text;
  }
}

TEST(PyYaml, AcceptsWhatPyYamlAccepts) {
  for (const char* text : {"", "a: 1\n", "%YAML 1.2\n---\na: 1\n", "# comment\twith TAB\na: 'x\ty'\n", "a: |\n  x\ty\n",
                           "a: [1, 2, ]\n", "a:\n- 1\nb: 2\n", "a: 1\r\nb: 2\r\n",
                           "\xEF\xBB\xBF"
                           "a: 1\n",
                           "a: &x [1]\nb: *x\n", "b:\n"}) {
    EXPECT_FALSE(pyyaml::safe_load(text).error.is_said()) << text;
  }
}

TEST(PyYaml, LastDuplicateWinsAndMergeKeysDoNotOverride) {
  const pyyaml::Loaded duplicate = pyyaml::safe_load("a: 1\nb: 5\na: 2\n");
  ASSERT_TRUE(duplicate.root);
  EXPECT_EQ(duplicate.root->entries.size(), 2U);
  EXPECT_EQ(duplicate.root->find("a")->number, 2.0);
  const pyyaml::Loaded merged = pyyaml::safe_load("base: &b {x: 1, y: 2}\ntop:\n  <<: *b\n  x: 3\n");
  ASSERT_TRUE(merged.root);
  EXPECT_EQ(merged.root->find("top")->find("x")->number, 3.0);
  EXPECT_EQ(merged.root->find("top")->find("y")->number, 2.0);
}

// --- Kalibr
// -------------------------------------------------------------------------------------------------------------------

const std::string kChain =
    "cam0:\n"
    "  camera_model: pinhole\n"
    "  intrinsics: [200.0, 210.0, 320.0, 240.0]\n"
    "  distortion_model: radtan\n"
    "  distortion_coeffs: [0.1, 0.01, 0.001, 0.002]\n"
    "  resolution: [640, 480]\n"
    "  rostopic: /cam0/image\n"
    "  T_cam_imu:\n"
    "  - [0.0, 1.0, 0.0, 0.1]\n"
    "  - [1.0, 0.0, 0.0, 0.2]\n"
    "  - [0.0, 0.0, -1.0, 0.3]\n"
    "  - [0.0, 0.0, 0.0, 1.0]\n"
    "  timeshift_cam_imu: 0.005\n";
const std::string kSecondCamera =
    "cam1:\n"
    "  camera_model: omni\n"
    "  intrinsics: [1, 200.0, 210.0, 320.0, 240.0]\n"
    "  distortion_model: none\n"
    "  distortion_coeffs: []\n"
    "  resolution: [640, 480]\n"
    "  rostopic: /cam1/image\n"
    "  cam_overlaps: [0]\n"
    "  T_cn_cnm1:\n"
    "  - [1, 0, 0, -0.1]\n"
    "  - [0, 1, 0, 0]\n"
    "  - [0, 0, 1, 0]\n"
    "  - [0, 0, 0, 1]\n";

TEST(Kalibr, ReadsAChain) {
  const ConsumerView view = load("kalibr", kChain + kSecondCamera);
  expect_loads(view);
  EXPECT_TRUE(view.warnings.empty());
  ASSERT_EQ(view.cameras.size(), 2U);
  EXPECT_EQ(view.cameras[1].name, "cam1");
  EXPECT_EQ(view.cameras[0].width, 640);
  ASSERT_EQ(view.poses.size(), 2U);
  EXPECT_EQ(view.poses[0].a + "<-" + view.poses[0].b, "cam0<-imu0");
  EXPECT_EQ(view.poses[1].a + "<-" + view.poses[1].b, "cam1<-cam0");
  EXPECT_EQ(view.poses[0].T_a_b[1], 1.0);
  EXPECT_EQ(view.poses[1].T_a_b[3], -0.1);
}

TEST(Kalibr, ProjectsByItsFormulas) {
  // x = y = 1, z = 1: r2 = 2; radial 1 + 0.2 + 0.04; tangential 2 p1 + p2 4 and p1 4 + 2 p2.
  const ConsumerView radtan = load("kalibr", kChain);
  EXPECT_NEAR(pixel(radtan, 0, {1, 1, 1})[0], 200 * (1.24 + 0.002 + 0.008) + 320, 1e-9);
  EXPECT_NEAR(pixel(radtan, 0, {1, 1, 1})[1], 210 * (1.24 + 0.004 + 0.004) + 240, 1e-9);
  EXPECT_FALSE(radtan.cameras[0].project({1, 1, 0}));
  EXPECT_FALSE(radtan.cameras[0].project({1, 1, -1}));
  EXPECT_FALSE(radtan.cameras[0].project({1, 1, std::nan("")}));

  const std::string equi = edited(edited(kChain, "radtan", "equidistant"), "[0.1, 0.01, 0.001, 0.002]", "[0.1, 0.0, 0.0, 0.0]");
  const double theta = std::atan(1.0);
  EXPECT_NEAR(pixel(load("kalibr", equi), 0, {1, 0, 1})[0], 200 * theta * (1 + 0.1 * theta * theta) + 320, 1e-9);

  const std::string fov = edited(edited(kChain, "radtan", "fov"), "[0.1, 0.01, 0.001, 0.002]", "[0.9]");
  EXPECT_NEAR(pixel(load("kalibr", fov), 0, {0, 1, 1})[1], 210 * std::atan(2 * std::tan(0.45)) / 0.9 + 240, 1e-9);

  const ConsumerView omni = load("kalibr", kChain + kSecondCamera);
  EXPECT_NEAR(pixel(omni, 1, {1, 0, 0})[0], 200 * 1.0 + 320, 1e-9);  // beyond the reach of a pinhole
  EXPECT_FALSE(omni.cameras[1].project({0, 0, -1}));
}

std::string kalibr_none(const std::string& model, const std::string& intrinsics) {
  return "cam0:\n  camera_model: " + model + "\n  intrinsics: " + intrinsics +
         "\n  distortion_model: none\n  distortion_coeffs: []\n  resolution: [640, 480]\n  rostopic: /a\n";
}

TEST(Kalibr, EucmAndDoubleSphere) {
  const ConsumerView eucm = load("kalibr", kalibr_none("eucm", "[0.6, 1.2, 200.0, 210.0, 320.0, 240.0]"));
  const double d = std::sqrt(1.2 * 0.25 + 1);
  EXPECT_NEAR(pixel(eucm, 0, {0.5, 0, 1})[0], 200 * 0.5 / (0.6 * d + 0.4) + 320, 1e-9);
  EXPECT_TRUE(eucm.cameras[0].project({1, 0, -0.1}));
  EXPECT_FALSE(eucm.cameras[0].project({0.1, 0, -1}));

  const ConsumerView ds = load("kalibr", kalibr_none("ds", "[-0.2, 0.6, 200.0, 210.0, 320.0, 240.0]"));
  const double shifted = -0.2 * std::sqrt(1.25) + 1;
  const double denominator = 0.6 * std::sqrt(0.25 + shifted * shifted) + 0.4 * shifted;
  EXPECT_NEAR(pixel(ds, 0, {0, 0.5, 1})[1], 210 * 0.5 / denominator + 240, 1e-9);
  EXPECT_FALSE(ds.cameras[0].project({0.1, 0, -1}));

  expect_refused(load("kalibr", kalibr_none("ds", "[0.0, 1.0, 200.0, 210.0, 320.0, 240.0]")), "alpha");
  expect_refused(load("kalibr", kalibr_none("eucm", "[0.5, -1.0, 200.0, 210.0, 320.0, 240.0]")), "beta");
  expect_refused(load("kalibr", kalibr_none("omni", "[-0.1, 200.0, 210.0, 320.0, 240.0]")), "xi");
  EXPECT_TRUE(mentions(load("kalibr", kalibr_none("pinhole", "[200.0, 210.0, 320.0, 240.0]")).warnings, "four zeros"));
}

TEST(Kalibr, TypesAndRanges) {
  struct Case {
    const char* from;
    const char* to;
    const char* sentence;
  };
  const Case cases[] = {
      {"[200.0,", "[200,", "fu is the int 200"},
      {"320.0,", "320,", "write 320.0"},
      {"[200.0,", "[-200.0,", "refuses negative"},
      {"240.0]", "-0.5]", "pv is -0.5"},
      {"[200.0,", "[2e2,", "the string '2e2'"},
      {"240.0]", "240.0, 1.0]", "[fu, fv, pu, pv]"},
      {"0.002]", "0.002, 0.1]", "a list of 4"},
      {"0.001,", "1e-3,", "write 1.0e-05"},
      {"[640, 480]", "[640.0, 480]", "two ints"},
      {"timeshift_cam_imu: 0.005", "timeshift_cam_imu: 1e-5", "timeshift_cam_imu is the string '1e-5'"},
      {"timeshift_cam_imu: 0.005", "timeshift_cam_imu: 0", "the int 0"},
      {"radtan", "radial-tangential", "distortion_model"},
      {"pinhole", "pinhole-radtan", "Kalibr knows pinhole, omni, eucm, ds"},
      {"rostopic: /cam0/image", "rostopic: 5", "wants a string"},
      {"[0.0, 1.0, 0.0, 0.1]", "[0.0, 1.0, 0.0]", "four rows of four"},
      {"[0.0, 1.0, 0.0, 0.1]", "[0.0, 1.0, 1e-9, 0.1]", "four rows of four"},
      {"  camera_model: pinhole\n", "", "camera_model is missing"},
      {"  resolution: [640, 480]\n", "", "resolution is missing"},
      {"cam0:\n", "%YAML:1.0\ncam0:\n", "%YAML:1.0"},
  };
  for (const Case& c : cases) expect_refused(load("kalibr", edited(kChain, c.from, c.to)), c.sentence);
  expect_loads(load("kalibr", edited(kChain, "[0.1, 0.01,", "[1, 0,")));  // the coefficients may be ints
}

TEST(Kalibr, CombinationsAndChainKeys) {
  expect_refused(load("kalibr", kChain + "T_imu_body: 1\n"),
                 "counts every top-level key as a camera (2 here, with T_imu_body)");
  const std::string omni = edited(edited(kChain, "pinhole", "omni"), "[200.0", "[1.0, 200.0");
  expect_loads(load("kalibr", omni));
  expect_refused(load("kalibr", edited(omni, "radtan", "equidistant")), "no camera for omni with equidistant");
  expect_refused(load("kalibr", edited(kalibr_none("ds", "[0.1, 0.5, 200.0, 210.0, 320.0, 240.0]"),
                                       "none\n  distortion_coeffs: []", "radtan\n  distortion_coeffs: [0, 0, 0, 0]")),
                 "no camera for ds with radtan");
  expect_refused(load("kalibr", kSecondCamera), "cam0 is missing");
  expect_refused(load("kalibr", kChain + edited(kSecondCamera, "[0]", "[2]")), "cam_overlaps");
  expect_refused(load("kalibr", "cam0: 5\n"), "cam0 is the int 5");
  expect_refused(load("kalibr", "- 1\n"), "wants a map");
}

TEST(Kalibr, MissingBaselineOnlyWarns) {
  const ConsumerView view = load("kalibr", kChain + kSecondCamera.substr(0, kSecondCamera.find("  T_cn_cnm1")));
  expect_loads(view);
  EXPECT_TRUE(mentions(view.warnings, "no baseline"));
}

TEST(Kalibr, LastDuplicateWins) {
  const ConsumerView view =
      load("kalibr", edited(kChain, "  resolution", "  intrinsics: [100.0, 100.0, 50.0, 60.0]\n  resolution"));
  expect_loads(view);
  EXPECT_EQ(pixel(view, 0, {0, 0, 1})[0], 50.0);
}

TEST(KalibrImu, Rules) {
  const std::string imu =
      "accelerometer_noise_density: 0.01\naccelerometer_random_walk: 2.0e-4\ngyroscope_noise_density: 0.002\n"
      "gyroscope_random_walk: 1.0e-05\nrostopic: /imu\nupdate_rate: 200\n";
  expect_loads(load("kalibr-imu", imu));
  expect_refused(load("kalibr-imu", edited(imu, "1.0e-05", "1e-5")), "the string '1e-5'");
  expect_refused(load("kalibr-imu", edited(imu, "0.01", "0")), "accelerometer_noise_density is 0");
  expect_refused(load("kalibr-imu", edited(imu, "update_rate: 200\n", "")), "update_rate is missing");
  expect_refused(load("kalibr-imu", edited(imu, "/imu", "7")), "rostopic");
  expect_refused(load("kalibr-imu", "imu0:\n  update_rate: 200\n"), "inside imu0");
}

// --- ORB-SLAM3 V1.0
// -----------------------------------------------------------------------------------------------------------

const std::string kTail =
    "ORBextractor.nFeatures: 1000\nORBextractor.scaleFactor: 1.2\nORBextractor.nLevels: 8\nORBextractor.iniThFAST: 20\n"
    "ORBextractor.minThFAST: 7\nViewer.KeyFrameSize: 0.05\nViewer.KeyFrameLineWidth: 1.0\nViewer.GraphLineWidth: 0.9\n"
    "Viewer.PointSize: 2.0\nViewer.CameraSize: 0.08\nViewer.CameraLineWidth: 3.0\nViewer.ViewpointX: 0.0\nViewer.ViewpointY: "
    "-0.7\n"
    "Viewer.ViewpointZ: -1.8\nViewer.ViewpointF: 500.0\n";
const std::string kImage = "Camera.width: 640\nCamera.height: 480\nCamera.fps: 20\nCamera.RGB: 1\n";
const std::string kV1Pinhole =
    "%YAML:1.0\nFile.version: \"1.0\"\nCamera.type: \"PinHole\"\nCamera1.fx: 200.0\nCamera1.fy: 210.0\nCamera1.cx: 320.0\n"
    "Camera1.cy: 240.0\nCamera1.k1: 0.1\nCamera1.k2: 0.01\nCamera1.p1: 0.001\nCamera1.p2: 0.002\n" +
    kImage + kTail;
const std::string kV1Fisheye =
    "%YAML:1.0\nFile.version: \"1.0\"\nCamera.type: \"KannalaBrandt8\"\nCamera1.fx: 200.0\nCamera1.fy: 210.0\nCamera1.cx: "
    "320.0\n"
    "Camera1.cy: 240.0\nCamera1.k1: 0.1\nCamera1.k2: 0.0\nCamera1.k3: 0.0\nCamera1.k4: 0.0\n" +
    kImage + kTail;
const std::string kMatrix =
    "!!opencv-matrix\n   rows: 4\n   cols: 4\n   dt: f\n   data: [1., 0., 0., 0.25, 0., 1., 0., 0., 0., 0., 1., 0., 0., 0., "
    "0., 1.]\n";
const std::string kImu =
    "IMU.NoiseGyro: 0.01\nIMU.NoiseAcc: 0.01\nIMU.GyroWalk: 0.01\nIMU.AccWalk: 0.01\nIMU.Frequency: 200.0\nIMU.T_b_c1: " +
    kMatrix;
const std::string kSecondIntrinsics = "Camera2.fx: 201.0\nCamera2.fy: 211.0\nCamera2.cx: 321.0\nCamera2.cy: 241.0\n";
const std::string kStereo = "Stereo.ThDepth: 40.0\nStereo.T_c1_c2: " + kMatrix;
const std::string kOverlaps =
    "Camera1.overlappingBegin: 0\nCamera1.overlappingEnd: 639\nCamera2.overlappingBegin: 0\nCamera2.overlappingEnd: 639\n";

TEST(OrbSlam3, ReadsPinhole) {
  const ConsumerView view = load("orbslam3", kV1Pinhole);
  expect_loads(view);
  EXPECT_TRUE(view.warnings.empty());
  EXPECT_NEAR(pixel(view, 0, {1, 1, 1})[0], 200 * 1.25 + 320, 2e-4);
  EXPECT_FALSE(view.cameras.at(0).project({1, 1, 0}));
}

TEST(OrbSlam3, StrictTypes) {
  struct Case {
    const char* from;
    const char* to;
    const char* sentence;
  };
  const Case cases[] = {
      {"Camera.fps: 20", "Camera.fps: 20.0", "Camera.fps is 20.0; ORB-SLAM3 V1.0 wants an int and exits: write 20"},
      {"Camera1.fx: 200.0", "Camera1.fx: 200",
       "Camera1.fx is 200; ORB-SLAM3 V1.0 wants a number with a '.' and exits: write 200.0"},
      {"Camera1.k1: 0.1", "Camera1.k1: 0", "Camera1.k1 is 0;"},
      {"Camera1.k2: 0.01\n", "", "Camera1.k2 is missing"},
      {"Camera1.p2: 0.002", "Camera1.p2: 0.002\nCamera1.k3: 0", "Camera1.k3 is 0;"},
      {"\"PinHole\"", "\"EUCM\"", "PinHole, Rectified, KannalaBrandt8"},
      {"\"PinHole\"", "PinHole # the type", "use quotes"},
      {"Viewer.PointSize: 2.0", "Viewer.PointSize: 2", "Viewer.PointSize is 2;"},
      {"Viewer.ViewpointF: 500.0\n", "", "Viewer.ViewpointF is missing"},
      {"ORBextractor.nFeatures: 1000", "ORBextractor.nFeatures: 1000.", "write 1000"},
      {"Camera.RGB: 1", "Camera.RGB: \"1\"", "the string \"1\""},
      {"Camera.RGB: 1", "Camera.RGB: 1\nSystem.thFarPoints: 20", "System.thFarPoints is 20"},
      {"Camera.RGB: 1", "Camera.RGB: 1\nSystem.LoadAtlasFromFile: 3", "wants a string"},
      {"Camera.RGB: 1", "Camera.RGB: 1\nCamera.newWidth: 320.", "Camera.newWidth is 320.0"},
      {"%YAML:1.0\n", "# mine\n%YAML:1.0\n", "first bytes"},
      {"Camera.fps: 20", "Camera.fps:\t20", "OpenCV's reader"},
  };
  for (const Case& c : cases) expect_refused(load("orbslam3", edited(kV1Pinhole, c.from, c.to)), c.sentence);
  expect_refused(load("orbslam3", kV1Pinhole, "quadro"), "no sensor");
}

TEST(OrbSlam3, UnquotedVersionSelectsTheOldParser) {
  const ConsumerView view = load("orbslam3", edited(kV1Pinhole, "\"1.0\"", "1.0"));
  EXPECT_FALSE(view.loads());
  EXPECT_TRUE(mentions(view.warnings, "old parser"));
  EXPECT_TRUE(mentions(view.refusals, "Camera.fx is missing"));
}

TEST(OrbSlam3, RescalesWithoutHalfPixel) {
  const ConsumerView view =
      load("orbslam3", edited(kV1Pinhole, "Camera.fps", "Camera.newWidth: 320\nCamera.newHeight: 120\nCamera.fps"));
  expect_loads(view);
  ASSERT_EQ(view.cameras.size(), 1U);
  EXPECT_EQ(view.cameras[0].width, 320);
  EXPECT_EQ(view.cameras[0].height, 120);
  EXPECT_EQ(view.cameras[0].scale, (std::array<double, 2>{0.5, 0.25}));
  EXPECT_EQ(pixel(view, 0, {0, 0, 1}), (std::array<double, 2>{160.0, 60.0}));
  // cv::resize takes row v to (v + 0.5) / 4 - 0.5.
  EXPECT_TRUE(mentions(view.warnings, "0.38 px off"));
}

TEST(OrbSlam3, FisheyeWorksBeyond90Degrees) {
  const ConsumerView view = load("orbslam3", kV1Fisheye);
  expect_loads(view);
  const double theta = 100.0 / 180.0 * std::acos(-1.0);
  EXPECT_NEAR(pixel(view, 0, {std::sin(theta), 0, std::cos(theta)})[0], 200 * (theta + 0.1 * theta * theta * theta) + 320,
              2e-4);
}

TEST(OrbSlam3, SensorModesAskForTheirKeys) {
  expect_refused(load("orbslam3", kV1Pinhole, "mono-inertial"), "IMU.NoiseGyro is missing");
  expect_refused(load("orbslam3", kV1Pinhole, "stereo"), "Camera2.fx is missing");
  expect_refused(load("orbslam3", kV1Pinhole, "rgbd"), "RGBD.DepthMapFactor is missing");
  expect_refused(load("orbslam3", kV1Pinhole + edited(kImu, "200.0", "200"), "mono-inertial"), "IMU.Frequency is 200");
  expect_refused(load("orbslam3", kV1Fisheye + kSecondIntrinsics + kStereo, "stereo"), "Camera1.overlappingBegin is missing");
  const ConsumerView inertial = load("orbslam3", kV1Pinhole + kImu, "mono-inertial");
  expect_loads(inertial);
  ASSERT_EQ(inertial.poses.size(), 1U);
  EXPECT_EQ(inertial.poses[0].a + "<-" + inertial.poses[0].b, "imu0<-cam0");
  EXPECT_EQ(inertial.poses[0].T_a_b[3], 0.25);
}

TEST(OrbSlam3, SecondFisheyeCameraTakesTheFirstPolynomial) {
  const std::string second = kSecondIntrinsics + "Camera2.k1: 0.2\nCamera2.k2: 0.0\nCamera2.k3: 0.0\nCamera2.k4: 0.0\n";
  const ConsumerView view = load("orbslam3", kV1Fisheye + second + kOverlaps + kStereo, "stereo");
  expect_loads(view);
  EXPECT_TRUE(mentions(view.warnings, "Camera1.k1..k4 for both"));
  const double theta = std::atan(1.0);
  EXPECT_NEAR(pixel(view, 1, {1, 0, 1})[0], 201 * theta * (1 + 0.1 * theta * theta) + 321, 2e-4);
  ASSERT_EQ(view.poses.size(), 1U);
  EXPECT_EQ(view.poses[0].a + "<-" + view.poses[0].b, "cam0<-cam1");
  const ConsumerView equal = load("orbslam3", kV1Fisheye + edited(second, "0.2", "0.1") + kOverlaps + kStereo, "stereo");
  expect_loads(equal);
  EXPECT_TRUE(equal.warnings.empty());
  expect_refused(
      load("orbslam3", kV1Fisheye + kImu + "RGBD.DepthMapFactor: 1.0\nStereo.ThDepth: 40.0\nStereo.b: 0.1\n", "rgbd-inertial"),
      "crashes");
}

TEST(OrbSlam3, SecondPinholeCameraTakesTheFirstDistortion) {
  const std::string second = kSecondIntrinsics + "Camera2.k1: 0.5\nCamera2.k2: 0.0\nCamera2.p1: 0.0\nCamera2.p2: 0.0\n";
  const ConsumerView view = load("orbslam3", kV1Pinhole + second + kStereo, "stereo");
  expect_loads(view);
  EXPECT_TRUE(mentions(view.warnings, "distortion of camera 1"));
  EXPECT_NEAR(pixel(view, 1, {1, 1, 1})[0], 201 * 1.25 + 321, 2e-4);
  std::string bare = kV1Pinhole;
  for (const char* line : {"Camera1.k1: 0.1\n", "Camera1.k2: 0.01\n", "Camera1.p1: 0.001\n", "Camera1.p2: 0.002\n"})
    bare = edited(bare, line, "");
  expect_refused(load("orbslam3", bare + second + kStereo, "stereo"), "null pointer");
  expect_loads(load("orbslam3", bare + kSecondIntrinsics + kStereo, "stereo"));
}

TEST(OrbSlam3, RgbdIgnoresDistortion) {
  const ConsumerView view =
      load("orbslam3", kV1Pinhole + "RGBD.DepthMapFactor: 1.0\nStereo.ThDepth: 40.0\nStereo.b: 0.1\n", "rgbd");
  expect_loads(view);
  EXPECT_TRUE(mentions(view.warnings, "not for RGB-D"));
  EXPECT_NEAR(pixel(view, 0, {1, 1, 1})[0], 520.0, 2e-4);
}

TEST(OrbSlam3, ZeroK1SkipsTheUndistortion) {
  const ConsumerView view = load("orbslam3", edited(kV1Pinhole, "Camera1.k1: 0.1", "Camera1.k1: 0.0"));
  expect_loads(view);
  EXPECT_TRUE(mentions(view.warnings, "skips the whole undistortion"));
  EXPECT_NEAR(pixel(view, 0, {1, 1, 1})[0], 520.0, 2e-4);
}

TEST(OrbSlam3, RectifiedStereoHasOneCameraTwice) {
  const std::string text = edited(kV1Pinhole, "PinHole", "Rectified") + "Stereo.b: 0.5\nStereo.ThDepth: 40.0\n";
  const ConsumerView view = load("orbslam3", text, "stereo");
  expect_loads(view);
  EXPECT_TRUE(mentions(view.warnings, "Rectified images have no distortion"));
  ASSERT_EQ(view.cameras.size(), 2U);
  EXPECT_EQ(pixel(view, 1, {1, 1, 1}), pixel(view, 0, {1, 1, 1}));
  ASSERT_EQ(view.poses.size(), 1U);
  EXPECT_EQ(view.poses[0].T_a_b[3], 0.5);
}

TEST(OrbSlam3, DoubleMatricesAreReinterpreted) {
  const ConsumerView view = load("orbslam3", kV1Pinhole + edited(kImu, "dt: f", "dt: d"), "mono-inertial");
  expect_loads(view);
  EXPECT_TRUE(mentions(view.warnings, "IMU.T_b_c1 is dt: d"));
  ASSERT_EQ(view.poses.size(), 1U);
  EXPECT_EQ(view.poses[0].T_a_b[0], 0.0);    // the low half of the double 1.0
  EXPECT_EQ(view.poses[0].T_a_b[1], 1.875);  // its high half, 0x3FF00000
  expect_refused(load("orbslam3", kV1Pinhole + edited(kImu, "rows: 4", "rows: 3"), "mono-inertial"), "IMU.T_b_c1");
  expect_refused(load("orbslam3", kV1Pinhole + edited(kImu, kMatrix, "[1., 0.]\n"), "mono-inertial"), "!!opencv-matrix");
}

/// OpenCV 4.6 allocates what rows and cols state before it looks at the numbers.
TEST(OrbSlam3, AMatrixLargerThanItsNumbersIsNotAllocated) {
  for (const char* length : {"rows: 1048576", "rows: 1073741824", "rows: -4", "rows: 4.5", "rows: \"4\""}) {
    expect_refused(load("orbslam3", kV1Pinhole + edited(kImu, "rows: 4", length), "mono-inertial"), "IMU.T_b_c1");
  }
  expect_refused(load("orbslam3", kV1Pinhole + edited(kImu, "dt: f", "dt: \"512f\""), "mono-inertial"),
                 "16 numbers for 8192 places");
}

// --- the old parser and the forks
// -----------------------------------------------------------------------------------------------

const std::string kOldPinhole =
    "%YAML:1.0\nCamera.type: \"PinHole\"\nCamera.fx: 200.0\nCamera.fy: 210.0\nCamera.cx: 320.0\nCamera.cy: 240.0\nCamera.k1: "
    "0.1\n"
    "Camera.k2: 0.01\nCamera.p1: 0.001\nCamera.p2: 0.002\n" +
    edited(kImage, "20", "20.0") + kTail;
const std::string kOldImu =
    "IMU.NoiseGyro: 0.01\nIMU.NoiseAcc: 0.01\nIMU.GyroWalk: 0.01\nIMU.AccWalk: 0.01\nIMU.Frequency: 200\nTbc: " + kMatrix;

TEST(OrbSlam3Old, Rules) {
  const ConsumerView view = load("orbslam3", edited(kOldPinhole, "Viewer.PointSize: 2.0", "Viewer.PointSize:2"));
  expect_loads(view);
  EXPECT_NEAR(pixel(view, 0, {1, 1, 1})[0], 200 * 1.25 + 320, 2e-4);
  expect_refused(load("orbslam3", edited(kOldPinhole, "Camera.fx: 200.0", "Camera.fx: 200")), "Camera.fx is 200;");
  expect_refused(load("orbslam3", edited(kOldPinhole, "Camera.p2: 0.002\n", "")), "Camera.p2 is missing");
  expect_refused(load("orbslam3", edited(kOldPinhole, "Camera.type: \"PinHole\"\n", "")), "Camera.type is missing");
  expect_refused(load("orbslam3", edited(kOldPinhole, "PinHole", "DoubleSphere")), "DoubleSphere");
  expect_refused(load("orbslam3", kOldPinhole, "stereo"), "Camera.bf is missing");
  expect_refused(load("orbslam3", kOldPinhole + edited(kOldImu, "200", "200.0"), "mono-inertial"), "IMU.Frequency is 200.0");
}

TEST(OrbSlam3Old, TbcMustBeAnExactRotation) {
  expect_loads(load("orbslam3", kOldPinhole + kOldImu, "mono-inertial"));
  expect_refused(load("orbslam3", kOldPinhole + edited(kOldImu, "[1., 0.,", "[0.999, 0.,"), "mono-inertial"), "Sophus");
  expect_refused(load("orbslam3", kOldPinhole + edited(kOldImu, "dt: f", "dt: d"), "mono-inertial"), "Sophus");
  expect_loads(load("urbste", kOldPinhole + edited(kOldImu, "[1., 0.,", "[0.999, 0.,"), "mono-inertial"));
}

TEST(OrbSlam3Old, FisheyeStereo) {
  std::string text = edited(kOldPinhole, "PinHole", "KannalaBrandt8");
  text = edited(edited(text, "Camera.p1", "Camera.k3"), "Camera.p2", "Camera.k4");
  const std::string tlr = edited(edited(kMatrix, "rows: 4", "rows: 3"), ", 0., 0., 0., 1.]", "]");
  const std::string second = kSecondIntrinsics + "Camera2.k1: 0.0\nCamera2.k2: 0.0\nCamera2.k3: 0.0\nCamera2.k4: 0.0\n";
  const std::string depth = "Camera.bf: 20.0\nThDepth: 40.0\n";
  const ConsumerView view = load("orbslam3", text + second + depth + "Tlr: " + tlr, "stereo");
  expect_loads(view);
  EXPECT_NEAR(pixel(view, 1, {1, 0, 1})[0], 201 * std::atan(1.0) + 321, 2e-4);  // its own polynomial, unlike V1.0
  EXPECT_TRUE(mentions(view.warnings, "lappingBegin"));
  expect_refused(load("orbslam3", text + second + depth + "Tlr: " + kMatrix, "stereo"), "exactly 3 x 4");
}

TEST(Urbste, DoubleSphere) {
  std::string text = edited(kOldPinhole, "PinHole", "DoubleSphere");
  text = edited(edited(text, "Camera.k1: 0.1", "Camera.xi: -0.2"), "Camera.k2: 0.01", "Camera.alpha: 0.6");
  const ConsumerView view = load("urbste", text);
  expect_loads(view);
  const double shifted = -0.2 * std::sqrt(1.25) + 1;
  EXPECT_NEAR(pixel(view, 0, {0, 0.5, 1})[1], 210 * 0.5 / (0.6 * std::sqrt(0.25 + shifted * shifted) + 0.4 * shifted) + 240,
              2e-4);
  EXPECT_FALSE(view.cameras.at(0).project({0.1, 0, -1}));
  expect_refused(load("urbste", edited(text, "Camera.alpha", "Camera.aplha")), "Camera.alpha is missing");
  expect_refused(load("urbste", kV1Pinhole), "Camera.fx is missing");
}

TEST(OrbSlam2, ConvertsImplicitly) {
  const ConsumerView view =
      load("orbslam2", edited(edited(kOldPinhole, "Camera.fx: 200.0", "Camera.fx: 200"), "Camera.p2: 0.002\n", ""));
  expect_loads(view);
  EXPECT_NEAR(pixel(view, 0, {1, 0, 1})[0], 200 * (1 + 0.1 + 0.01) + 320, 2e-4);
  EXPECT_TRUE(mentions(load("orbslam2", edited(kOldPinhole, "Camera.fx: 200.0\n", "")).warnings,
                       "Camera.fx is missing; ORB-SLAM2 takes 0"));
  expect_refused(load("orbslam2", edited(kOldPinhole, "ORBextractor.nLevels: 8\n", "")), "image pyramid");
  const ConsumerView stereo = load("orbslam2", kOldPinhole + "Camera.bf: 20.0\nThDepth: 40\n", "stereo");
  expect_loads(stereo);
  ASSERT_EQ(stereo.poses.size(), 1U);
  EXPECT_NEAR(stereo.poses[0].T_a_b[3], 0.1, 1e-7);
}

const std::string kEucm =
    "%YAML:1.0\nCamera.type: EUCM\nCamera.fx: 200.0\nCamera.fy: 210.0\nCamera.cx: 320.0\nCamera.cy: 240.0\nCamera.k1: "
    "0.6\nCamera.k2: 1.2\n"
    "Camera.p1: 0.0\nCamera.p2: 0.0\nCamera.Tbc: " +
    kMatrix + kImage + kTail;

TEST(SlamNoOpt, Eucm) {
  const ConsumerView view = load("slam_no_opt", kEucm);
  expect_loads(view);
  EXPECT_NEAR(pixel(view, 0, {0.5, 0, 1})[0], 200 * 0.5 / (0.6 * std::sqrt(1.3) + 0.4) + 320, 2e-4);
  ASSERT_EQ(view.poses.size(), 1U);
  EXPECT_EQ(view.poses[0].a + "<-" + view.poses[0].b, "imu0<-cam0");
  const ConsumerView low = load("slam_no_opt", edited(kEucm, "Camera.k1: 0.6", "Camera.k1: 0.4"));
  expect_loads(low);
  EXPECT_TRUE(mentions(low.warnings, "refuses every point"));
  EXPECT_FALSE(low.cameras.at(0).project({0, 0, 1}));
  expect_refused(load("slam_no_opt", edited(kEucm, "EUCM", "KannalaBrandt8")), "EUCM and KB");
  expect_refused(load("slam_no_opt", edited(kEucm, "Camera.Tbc", "Camera.Tcb")), "Camera.Tbc is missing");
  expect_refused(load("orbslam3", kEucm), "Camera.type");
}

TEST(SlamNoOpt, KannalaBrandtCoefficientsAreInP1AndP2) {
  const ConsumerView view = load("slam_no_opt", edited(edited(kEucm, "EUCM", "KB"), "Camera.p1: 0.0", "Camera.p1: 0.1"));
  expect_loads(view);
  const double t = std::atan(1.0);
  EXPECT_NEAR(pixel(view, 0, {1, 0, 1})[0],
              200 * (t + 0.6 * std::pow(t, 3) + 1.2 * std::pow(t, 5) + 0.1 * std::pow(t, 7)) + 320, 5e-4);
}

TEST(SlamNoOpt, Stereo) {
  expect_refused(load("slam_no_opt", kEucm, "stereo"), "RIGHT.K is missing");
  const std::string right =
      "RIGHT.K: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [201., 0., 321., 0., 211., 241., 0., 0., 1.]\n"
      "RIGHT.D: !!opencv-matrix\n   rows: 1\n   cols: 5\n   dt: d\n   data: [0.7, 1., 0., 0., 0.]\n"
      "CAMERA.R: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [1., 0., 0., 0., 1., 0., 0., 0., 1.]\n"
      "CAMERA.T: !!opencv-matrix\n   rows: 1\n   cols: 3\n   dt: d\n   data: [-0.25, 0., 0.]\n";
  const ConsumerView view = load("slam_no_opt", kEucm + right + "Camera.bf: 20.0\nThDepth: 40\n", "stereo");
  expect_loads(view);
  ASSERT_EQ(view.cameras.size(), 2U);
  EXPECT_NEAR(pixel(view, 1, {0.5, 0, 1})[0], 201 * 0.5 / (0.7 * std::sqrt(1.25) + 0.3) + 321, 2e-4);
  ASSERT_EQ(view.poses.size(), 2U);
  EXPECT_EQ(view.poses[0].a + "<-" + view.poses[0].b, "cam1<-cam0");
  EXPECT_EQ(view.poses[0].T_a_b[3], -0.25);
}

// --- hostile input
// --------------------------------------------------------------------------------------------------------------

std::string repeated(std::string_view part, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += part;
  return text;
}

TEST(Consumers, SurviveAnyInput) {
  std::vector<std::string> inputs = {"",
                                     " ",
                                     "\n",
                                     std::string(1, '\0'),
                                     "%YAML",
                                     "%YAML:1.0",
                                     "%YAML:1.0\n",
                                     "{",
                                     "{}",
                                     "<?xml version=\"1.0\"?>",
                                     "\x89PNG\r\n",
                                     "%YAML:1.0\n- 1\n- 2\n",
                                     "%YAML:1.0\na: 1E5\n",
                                     "%YAML:1.0\nFile.version: [1]\n",
                                     std::string(3U << 20U, 'a')};
  for (const char* part : {"[", "{", "- ", "a: ", "{a: ", "[\"]\", ", "? ", "!!map ", "&a ", "\"", "|\n"}) {
    inputs.push_back("%YAML:1.0\na: " + repeated(part, 100000));
    inputs.push_back("a: " + repeated(part, 100000));
  }
  for (const std::string& text : {kV1Pinhole + kImu, kOldPinhole + kOldImu, kEucm, kChain + kSecondCamera}) {
    for (std::size_t size = 0; size < text.size(); size += 7) inputs.push_back(text.substr(0, size));
  }
  for (const std::string& text : inputs) {
    for (const Consumer& consumer : all_consumers()) {
      for (const char* sensor : {"mono-inertial", "stereo"}) {
        const ConsumerView view = consumer.load(text, {sensor});
        EXPECT_TRUE(view.loads() || view.cameras.empty());
      }
    }
  }
}

TEST(Consumers, ProjectSurvivesAnyRay) {
  const double nan = std::nan("");
  const double inf = std::numeric_limits<double>::infinity();
  const ConsumerView views[] = {load("kalibr", kChain + kSecondCamera), load("orbslam3", kV1Pinhole),
                                load("orbslam3", kV1Fisheye), load("slam_no_opt", kEucm), load("orbslam2", kOldPinhole)};
  for (const ConsumerView& view : views) {
    ASSERT_FALSE(view.cameras.empty());
    for (const ConsumerCamera& camera : view.cameras) {
      for (const std::array<double, 3>& ray :
           {std::array<double, 3>{0, 0, 0}, {nan, nan, nan}, {inf, 0, 1}, {0, 0, inf}, {1e300, 1e300, 1e-300}}) {
        const auto result = camera.project(ray);
        EXPECT_TRUE(!result || (std::isfinite((*result)[0]) && std::isfinite((*result)[1])));
      }
    }
  }
}

}  // namespace
}  // namespace fca::consumers
