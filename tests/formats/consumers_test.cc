// SPDX-License-Identifier: BSD-3-Clause
// The typing rules, misreadings and limits of the programs, each on a small handwritten file.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "complaints.h"
#include "pyyaml.h"

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

void expect_loads(const ConsumerView& view) { EXPECT_TRUE(view.loads()) << joined(view.refusals); }

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

  expect_refused(load("kalibr", kalibr_none("ds", "[0.0, 1.0, 200.0, 210.0, 320.0, 240.0]")), Code::kKalibrSaysAlphaOutside,
                 "cam0/intrinsics", {1.0, "ds"});
  expect_refused(load("kalibr", kalibr_none("eucm", "[0.5, -1.0, 200.0, 210.0, 320.0, 240.0]")), Code::kKalibrSaysBetaNegative,
                 "cam0/intrinsics", {-1.0});
  expect_refused(load("kalibr", kalibr_none("omni", "[-0.1, 200.0, 210.0, 320.0, 240.0]")), Code::kKalibrSaysXiNegative,
                 "cam0/intrinsics", {-0.1});
  expect_warning(load("kalibr", kalibr_none("pinhole", "[200.0, 210.0, 320.0, 240.0]")), Code::kKalibrSaysPinholeWithNone,
                 "cam0");
}

TEST(Kalibr, TypesAndRanges) {
  struct Case {
    const char* from;
    const char* to;
    Code code;
    const char* key = "";
    std::vector<Argument> values = {};
  };
  const Case cases[] = {
      {"[200.0,", "[200,", Code::kKalibrSaysNoFloat, "cam0/intrinsics", {"fu", Message{Code::kPyYamlScalar, {"int", "200"}}}},
      {"320.0,", "320,", Code::kKalibrSaysNoFloat, "cam0/intrinsics", {"pu", Message{Code::kProgramWriteReal, {"320"}}}},
      {"[200.0,", "[-200.0,", Code::kKalibrSaysNegative, "cam0/intrinsics", {"fu", "-200.0"}},
      {"240.0]", "-0.5]", Code::kKalibrSaysNegative, "cam0/intrinsics", {"pv", "-0.5"}},
      {"[200.0,",
       "[2e2,",
       Code::kKalibrSaysNoFloat,
       "cam0/intrinsics",
       {"fu", Message{Code::kPyYamlString, {"2e2"}}, Message{Code::kKalibrSaysFormOfFloats}}},
      {"240.0]",
       "240.0, 1.0]",
       Code::kKalibrSaysIntrinsicsCount,
       "cam0/intrinsics",
       {Message{Code::kPyYamlList, {5}}, "[fu, fv, pu, pv]", "pinhole"}},
      {"0.002]",
       "0.002, 0.1]",
       Code::kKalibrSaysCoefficientCount,
       "cam0/distortion_coeffs",
       {Message{Code::kPyYamlList, {5}}, 4, "radtan"}},
      {"0.001,", "1e-3,", Code::kKalibrSaysCoefficientType, "cam0/distortion_coeffs", {Message{Code::kPyYamlString, {"1e-3"}}}},
      {"[640, 480]", "[640.0, 480]", Code::kKalibrSaysResolutionNoInts, "cam0/resolution"},
      {"timeshift_cam_imu: 0.005",
       "timeshift_cam_imu: 1e-5",
       Code::kKalibrSaysTimeshiftNoFloat,
       "cam0/timeshift_cam_imu",
       {Message{Code::kPyYamlString, {"1e-5"}}}},
      {"timeshift_cam_imu: 0.005",
       "timeshift_cam_imu: 0",
       Code::kKalibrSaysTimeshiftNoFloat,
       "cam0/timeshift_cam_imu",
       {Message{Code::kPyYamlScalar, {"int", "0"}}}},
      {"radtan",
       "radial-tangential",
       Code::kKalibrSaysUnknownDistortion,
       "cam0/distortion_model",
       {Message{Code::kPyYamlString, {"radial-tangential"}}}},
      {"pinhole",
       "pinhole-radtan",
       Code::kKalibrSaysUnknownModel,
       "cam0/camera_model",
       {Message{Code::kPyYamlString, {"pinhole-radtan"}}}},
      {"rostopic: /cam0/image",
       "rostopic: 5",
       Code::kKalibrSaysTopicNoString,
       "cam0/rostopic",
       {Message{Code::kPyYamlScalar, {"int", "5"}}}},
      {"[0.0, 1.0, 0.0, 0.1]", "[0.0, 1.0, 0.0]", Code::kKalibrSaysPoseNoRows, "cam0/T_cam_imu"},
      {"[0.0, 1.0, 0.0, 0.1]", "[0.0, 1.0, 1e-9, 0.1]", Code::kKalibrSaysPoseNoRows, "cam0/T_cam_imu"},
      {"  camera_model: pinhole\n", "", Code::kKalibrSaysKeyMissing, "cam0/camera_model"},
      {"  resolution: [640, 480]\n", "", Code::kKalibrSaysKeyMissing, "cam0/resolution"},
      {"cam0:\n", "%YAML:1.0\ncam0:\n", Code::kKalibrSaysNotParsed, "", {Message{Code::kPyYamlOpenCvHeader, {"%YAML:1.0"}}}},
  };
  for (const Case& c : cases) expect_refused(load("kalibr", edited(kChain, c.from, c.to)), c.code, c.key, c.values);
  expect_loads(load("kalibr", edited(kChain, "[0.1, 0.01,", "[1, 0,")));  // the coefficients may be ints
}

TEST(Kalibr, CombinationsAndChainKeys) {
  expect_refused(load("kalibr", kChain + "T_imu_body: 1\n"), Code::kKalibrSaysForeignKeys, "T_imu_body/",
                 {2, "T_imu_body", "cam1"});
  const std::string omni = edited(edited(kChain, "pinhole", "omni"), "[200.0", "[1.0, 200.0");
  expect_loads(load("kalibr", omni));
  expect_refused(load("kalibr", edited(omni, "radtan", "equidistant")), Code::kKalibrSaysNoSuchCamera, "cam0",
                 {"omni", "equidistant"});
  expect_refused(load("kalibr", edited(kalibr_none("ds", "[0.1, 0.5, 200.0, 210.0, 320.0, 240.0]"),
                                       "none\n  distortion_coeffs: []", "radtan\n  distortion_coeffs: [0, 0, 0, 0]")),
                 Code::kKalibrSaysNoSuchCamera, "cam0", {"ds", "radtan"});
  expect_refused(load("kalibr", kSecondCamera), Code::kKalibrSaysForeignKeys, "cam1/", {1, "cam1", "cam0"});
  expect_refused(load("kalibr", kChain + edited(kSecondCamera, "[0]", "[2]")), Code::kKalibrSaysOverlapsBeyond,
                 "cam1/cam_overlaps", {Message{Code::kPyYamlScalar, {"int", "2"}}, 2});
  expect_refused(load("kalibr", "cam0: 5\n"), Code::kKalibrSaysCameraNoMap, "cam0",
                 {Message{Code::kPyYamlScalar, {"int", "5"}}});
  expect_refused(load("kalibr", "- 1\n"), Code::kKalibrSaysFileNoMap, "", {Message{Code::kPyYamlList, {1}}});
}

TEST(Kalibr, MissingBaselineOnlyWarns) {
  const ConsumerView view = load("kalibr", kChain + kSecondCamera.substr(0, kSecondCamera.find("  T_cn_cnm1")));
  expect_warning(view, Code::kKalibrSaysBaselineMissing, "cam1/T_cn_cnm1", {"cam0", "cam1"});
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
  expect_refused(load("kalibr-imu", edited(imu, "1.0e-05", "1e-5")), Code::kKalibrSaysImuNoNumber, "gyroscope_random_walk",
                 {Message{Code::kPyYamlString, {"1e-5"}}});
  expect_refused(load("kalibr-imu", edited(imu, "0.01", "0")), Code::kKalibrSaysImuNotPositive, "accelerometer_noise_density",
                 {"0"});
  expect_refused(load("kalibr-imu", edited(imu, "update_rate: 200\n", "")), Code::kKalibrSaysKeyMissing, "update_rate");
  expect_refused(load("kalibr-imu", edited(imu, "/imu", "7")), Code::kKalibrSaysImuTopic, "rostopic");
  expect_refused(load("kalibr-imu", "imu0:\n  update_rate: 200\n"), Code::kKalibrSaysImuNested, "imu0/");
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
    Code code;
    const char* key = "";
    std::vector<Argument> values = {};
  };
  const Case cases[] = {
      {"Camera.fps: 20",
       "Camera.fps: 20.0",
       Code::kOrbslamNotInt,
       "Camera.fps",
       {Message{Code::kValueReal, {20.0}}, Message{Code::kOrbslamWriteInt, {20}}, "ORB-SLAM3 V1.0"}},
      {"Camera1.fx: 200.0",
       "Camera1.fx: 200",
       Code::kOrbslamNotReal,
       "Camera1.fx",
       {200, Message{Code::kProgramWriteReal, {200}}, "ORB-SLAM3 V1.0"}},
      {"Camera1.k1: 0.1", "Camera1.k1: 0", Code::kOrbslamNotReal, "Camera1.k1", {0, Message{Code::kProgramWriteReal, {0}}}},
      {"Camera1.k2: 0.01\n", "", Code::kOrbslamKeyMissing, "Camera1.k2", {"ORB-SLAM3 V1.0"}},
      {"Camera1.p2: 0.002",
       "Camera1.p2: 0.002\nCamera1.k3: 0",
       Code::kOrbslamNotReal,
       "Camera1.k3",
       {0, Message{Code::kProgramWriteReal, {0}}}},
      {"\"PinHole\"", "\"EUCM\"", Code::kOrbslamV1Type, "Camera.type", {Message{Code::kValueString, {"EUCM"}}}},
      {"\"PinHole\"",
       "PinHole # the type",
       Code::kOrbslamV1Type,
       "Camera.type",
       {Message{Code::kValueString, {"PinHole # the type"}}, Message{Code::kOrbslamCommentInText}}},
      {"Viewer.PointSize: 2.0",
       "Viewer.PointSize: 2",
       Code::kOrbslamNotReal,
       "Viewer.PointSize",
       {2, Message{Code::kProgramWriteReal, {2}}}},
      {"Viewer.ViewpointF: 500.0\n", "", Code::kOrbslamKeyMissing, "Viewer.ViewpointF", {"ORB-SLAM3 V1.0"}},
      {"ORBextractor.nFeatures: 1000",
       "ORBextractor.nFeatures: 1000.",
       Code::kOrbslamNotInt,
       "ORBextractor.nFeatures",
       {Message{Code::kValueReal, {1000.0}}, Message{Code::kOrbslamWriteInt, {1000}}}},
      {"Camera.RGB: 1", "Camera.RGB: \"1\"", Code::kOrbslamNotInt, "Camera.RGB", {Message{Code::kValueString, {"1"}}}},
      {"Camera.RGB: 1",
       "Camera.RGB: 1\nSystem.thFarPoints: 20",
       Code::kOrbslamNotReal,
       "System.thFarPoints",
       {20, Message{Code::kProgramWriteReal, {20}}}},
      {"Camera.RGB: 1", "Camera.RGB: 1\nSystem.LoadAtlasFromFile: 3", Code::kOrbslamNotText, "System.LoadAtlasFromFile", {3}},
      {"Camera.RGB: 1",
       "Camera.RGB: 1\nCamera.newWidth: 320.",
       Code::kOrbslamNotInt,
       "Camera.newWidth",
       {Message{Code::kValueReal, {320.0}}, Message{Code::kOrbslamWriteInt, {320}}}},
      {"%YAML:1.0\n", "# mine\n%YAML:1.0\n", Code::kOrbslamNoHeader},
      {"Camera.fps: 20", "Camera.fps:\t20", Code::kStorageNotTaken, "", {Message{Code::kStorageReaderOf, {"ORB-SLAM3 V1.0"}}}},
  };
  for (const Case& c : cases) expect_refused(load("orbslam3", edited(kV1Pinhole, c.from, c.to)), c.code, c.key, c.values);
  expect_refused(load("orbslam3", kV1Pinhole, "quadro"), Code::kOrbslamNoSensor, "", {"quadro"});
}

TEST(OrbSlam3, UnquotedVersionSelectsTheOldParser) {
  const ConsumerView view = load("orbslam3", edited(kV1Pinhole, "\"1.0\"", "1.0"));
  EXPECT_TRUE(complains(view.warnings, Code::kOrbslamVersionNotText, "File.version", {Message{Code::kValueReal, {1.0}}}))
      << joined(view.warnings);
  expect_refused(view, Code::kOrbslamKeyMissing, "Camera.fx");
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
  expect_warning(view, Code::kOrbslamHalfPixelOff, "Camera.newWidth/", {0.375});
}

TEST(OrbSlam3, FisheyeWorksBeyond90Degrees) {
  const ConsumerView view = load("orbslam3", kV1Fisheye);
  expect_loads(view);
  const double theta = 100.0 / 180.0 * std::acos(-1.0);
  EXPECT_NEAR(pixel(view, 0, {std::sin(theta), 0, std::cos(theta)})[0], 200 * (theta + 0.1 * theta * theta * theta) + 320,
              2e-4);
}

TEST(OrbSlam3, SensorModesAskForTheirKeys) {
  expect_refused(load("orbslam3", kV1Pinhole, "mono-inertial"), Code::kOrbslamKeyMissing, "IMU.NoiseGyro", {"ORB-SLAM3 V1.0"});
  expect_refused(load("orbslam3", kV1Pinhole, "stereo"), Code::kOrbslamKeyMissing, "Camera2.fx", {"ORB-SLAM3 V1.0"});
  expect_refused(load("orbslam3", kV1Pinhole, "rgbd"), Code::kOrbslamKeyMissing, "RGBD.DepthMapFactor", {"ORB-SLAM3 V1.0"});
  expect_refused(load("orbslam3", kV1Pinhole + edited(kImu, "200.0", "200"), "mono-inertial"), Code::kOrbslamNotReal,
                 "IMU.Frequency", {200, Message{Code::kProgramWriteReal, {200}}});
  expect_refused(load("orbslam3", kV1Fisheye + kSecondIntrinsics + kStereo, "stereo"), Code::kOrbslamKeyMissing,
                 "Camera1.overlappingBegin", {"ORB-SLAM3 V1.0"});
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
  expect_warning(view, Code::kOrbslamSecondFisheyeIgnored, "Camera2.k1/");
  const double theta = std::atan(1.0);
  EXPECT_NEAR(pixel(view, 1, {1, 0, 1})[0], 201 * theta * (1 + 0.1 * theta * theta) + 321, 2e-4);
  ASSERT_EQ(view.poses.size(), 1U);
  EXPECT_EQ(view.poses[0].a + "<-" + view.poses[0].b, "cam0<-cam1");
  const ConsumerView equal = load("orbslam3", kV1Fisheye + edited(second, "0.2", "0.1") + kOverlaps + kStereo, "stereo");
  expect_loads(equal);
  EXPECT_TRUE(equal.warnings.empty());
  expect_refused(
      load("orbslam3", kV1Fisheye + kImu + "RGBD.DepthMapFactor: 1.0\nStereo.ThDepth: 40.0\nStereo.b: 0.1\n", "rgbd-inertial"),
      Code::kOrbslamSecondNeverRead);
}

TEST(OrbSlam3, SecondPinholeCameraTakesTheFirstDistortion) {
  const std::string second = kSecondIntrinsics + "Camera2.k1: 0.5\nCamera2.k2: 0.0\nCamera2.p1: 0.0\nCamera2.p2: 0.0\n";
  const ConsumerView view = load("orbslam3", kV1Pinhole + second + kStereo, "stereo");
  expect_loads(view);
  expect_warning(view, Code::kOrbslamSecondPinholeIgnored, "Camera2.k1");
  EXPECT_NEAR(pixel(view, 1, {1, 1, 1})[0], 201 * 1.25 + 321, 2e-4);
  std::string bare = kV1Pinhole;
  for (const char* line : {"Camera1.k1: 0.1\n", "Camera1.k2: 0.01\n", "Camera1.p1: 0.001\n", "Camera1.p2: 0.002\n"})
    bare = edited(bare, line, "");
  expect_refused(load("orbslam3", bare + second + kStereo, "stereo"), Code::kOrbslamReadsNull, "Camera2.k1");
  expect_loads(load("orbslam3", bare + kSecondIntrinsics + kStereo, "stereo"));
}

TEST(OrbSlam3, RgbdIgnoresDistortion) {
  const ConsumerView view =
      load("orbslam3", kV1Pinhole + "RGBD.DepthMapFactor: 1.0\nStereo.ThDepth: 40.0\nStereo.b: 0.1\n", "rgbd");
  expect_loads(view);
  expect_warning(view, Code::kOrbslamDepthNotUndistorted, "Camera1.k1");
  EXPECT_NEAR(pixel(view, 0, {1, 1, 1})[0], 520.0, 2e-4);
}

TEST(OrbSlam3, ZeroK1SkipsTheUndistortion) {
  const ConsumerView view = load("orbslam3", edited(kV1Pinhole, "Camera1.k1: 0.1", "Camera1.k1: 0.0"));
  expect_loads(view);
  expect_warning(view, Code::kOrbslamSkipsUndistortion, "Camera1.k1", {"ORB-SLAM3 V1.0"});
  EXPECT_NEAR(pixel(view, 0, {1, 1, 1})[0], 520.0, 2e-4);
}

TEST(OrbSlam3, RectifiedStereoHasOneCameraTwice) {
  const std::string text = edited(kV1Pinhole, "PinHole", "Rectified") + "Stereo.b: 0.5\nStereo.ThDepth: 40.0\n";
  const ConsumerView view = load("orbslam3", text, "stereo");
  expect_loads(view);
  expect_warning(view, Code::kOrbslamRectifiedIgnores, "Camera1.k1");
  ASSERT_EQ(view.cameras.size(), 2U);
  EXPECT_EQ(pixel(view, 1, {1, 1, 1}), pixel(view, 0, {1, 1, 1}));
  ASSERT_EQ(view.poses.size(), 1U);
  EXPECT_EQ(view.poses[0].T_a_b[3], 0.5);
}

TEST(OrbSlam3, DoubleMatricesAreReinterpreted) {
  const ConsumerView view = load("orbslam3", kV1Pinhole + edited(kImu, "dt: f", "dt: d"), "mono-inertial");
  expect_loads(view);
  expect_warning(view, Code::kOrbslamPoseOfDoubles, "IMU.T_b_c1");
  ASSERT_EQ(view.poses.size(), 1U);
  EXPECT_EQ(view.poses[0].T_a_b[0], 0.0);    // the low half of the double 1.0
  EXPECT_EQ(view.poses[0].T_a_b[1], 1.875);  // its high half, 0x3FF00000
  expect_refused(load("orbslam3", kV1Pinhole + edited(kImu, "rows: 4", "rows: 3"), "mono-inertial"),
                 Code::kOrbslamUnreadableMatrix, "IMU.T_b_c1");
  expect_refused(load("orbslam3", kV1Pinhole + edited(kImu, kMatrix, "[1., 0.]\n"), "mono-inertial"), Code::kOrbslamNoMatrix,
                 "IMU.T_b_c1", {Message{Code::kValueList}});
}

/// OpenCV 4.6 allocates what rows and cols state before it looks at the numbers.
TEST(OrbSlam3, AMatrixLargerThanItsNumbersIsNotAllocated) {
  const Message no_count = {Code::kStorageNoCount, {"rows"}};
  const std::pair<const char*, Message> lengths[] = {{"rows: 1048576", {Code::kStorageTooFewNumbers, {16, 4194304}}},
                                                     {"rows: 1073741824", no_count},
                                                     {"rows: -4", no_count},
                                                     {"rows: 4.5", no_count},
                                                     {"rows: \"4\"", no_count}};
  for (const auto& [length, why] : lengths) {
    expect_refused(load("orbslam3", kV1Pinhole + edited(kImu, "rows: 4", length), "mono-inertial"),
                   Code::kOrbslamUnreadableMatrix, "IMU.T_b_c1", {why});
  }
  expect_refused(load("orbslam3", kV1Pinhole + edited(kImu, "dt: f", "dt: \"512f\""), "mono-inertial"),
                 Code::kOrbslamUnreadableMatrix, "IMU.T_b_c1", {Message{Code::kStorageTooFewNumbers, {16, 8192}}});
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
  expect_refused(load("orbslam3", edited(kOldPinhole, "Camera.fx: 200.0", "Camera.fx: 200")), Code::kOrbslamNotReal,
                 "Camera.fx", {200, Message{Code::kProgramWriteReal, {200}}});
  expect_refused(load("orbslam3", edited(kOldPinhole, "Camera.p2: 0.002\n", "")), Code::kOrbslamKeyMissing, "Camera.p2",
                 {"ORB-SLAM3 V1.0"});
  expect_refused(load("orbslam3", edited(kOldPinhole, "Camera.type: \"PinHole\"\n", "")), Code::kOrbslamOldTypeMissing,
                 "Camera.type");
  expect_refused(load("orbslam3", edited(kOldPinhole, "PinHole", "DoubleSphere")), Code::kOrbslamOldType, "Camera.type",
                 {Message{Code::kValueString, {"DoubleSphere"}}});
  expect_refused(load("orbslam3", kOldPinhole, "stereo"), Code::kOrbslamKeyMissing, "Camera.bf", {"ORB-SLAM3 V1.0"});
  expect_refused(load("orbslam3", kOldPinhole + edited(kOldImu, "200", "200.0"), "mono-inertial"), Code::kOrbslamNotInt,
                 "IMU.Frequency", {Message{Code::kValueReal, {200.0}}, Message{Code::kOrbslamWriteInt, {200}}});
}

TEST(OrbSlam3Old, TbcMustBeAnExactRotation) {
  expect_loads(load("orbslam3", kOldPinhole + kOldImu, "mono-inertial"));
  expect_refused(load("orbslam3", kOldPinhole + edited(kOldImu, "[1., 0.,", "[0.999, 0.,"), "mono-inertial"),
                 Code::kOrbslamSophusAborts, "Tbc");
  expect_refused(load("orbslam3", kOldPinhole + edited(kOldImu, "dt: f", "dt: d"), "mono-inertial"), Code::kOrbslamSophusAborts,
                 "Tbc");
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
  expect_warning(view, Code::kOrbslamLappingNotInt, "Camera.lappingBegin");
  expect_warning(view, Code::kOrbslamLappingNotInt, "Camera2.lappingBegin");
  expect_refused(load("orbslam3", text + second + depth + "Tlr: " + kMatrix, "stereo"), Code::kOrbslamPairSize, "Tlr", {4});
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
  expect_refused(load("urbste", edited(text, "Camera.alpha", "Camera.aplha")), Code::kOrbslamKeyMissing, "Camera.alpha",
                 {"urbste/ORB_SLAM3"});
  expect_refused(load("urbste", kV1Pinhole), Code::kOrbslamKeyMissing, "Camera.fx", {"urbste/ORB_SLAM3"});
}

TEST(OrbSlam2, ConvertsImplicitly) {
  const ConsumerView view =
      load("orbslam2", edited(edited(kOldPinhole, "Camera.fx: 200.0", "Camera.fx: 200"), "Camera.p2: 0.002\n", ""));
  expect_loads(view);
  EXPECT_NEAR(pixel(view, 0, {1, 0, 1})[0], 200 * (1 + 0.1 + 0.01) + 320, 2e-4);
  EXPECT_TRUE(complains(load("orbslam2", edited(kOldPinhole, "Camera.fx: 200.0\n", "")).warnings, Code::kOrbslamTakesZero,
                        "Camera.fx", {"ORB-SLAM2"}));
  expect_refused(load("orbslam2", edited(kOldPinhole, "ORBextractor.nLevels: 8\n", "")), Code::kOrbslamNoLevels,
                 "ORBextractor.nLevels");
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
  expect_warning(low, Code::kOrbslamEucmRefusesAll, "Camera.k1", {0.4});
  EXPECT_FALSE(low.cameras.at(0).project({0, 0, 1}));
  expect_refused(load("slam_no_opt", edited(kEucm, "EUCM", "KannalaBrandt8")), Code::kOrbslamNoOptType, "Camera.type",
                 {Message{Code::kValueString, {"KannalaBrandt8"}}});
  expect_refused(load("slam_no_opt", edited(kEucm, "Camera.Tbc", "Camera.Tcb")), Code::kOrbslamKeyMissing, "Camera.Tbc",
                 {"slam_no_opt"});
  expect_refused(load("orbslam3", kEucm), Code::kOrbslamOldType, "Camera.type", {Message{Code::kValueString, {"EUCM"}}});
}

TEST(SlamNoOpt, KannalaBrandtCoefficientsAreInP1AndP2) {
  const ConsumerView view = load("slam_no_opt", edited(edited(kEucm, "EUCM", "KB"), "Camera.p1: 0.0", "Camera.p1: 0.1"));
  expect_loads(view);
  const double t = std::atan(1.0);
  EXPECT_NEAR(pixel(view, 0, {1, 0, 1})[0],
              200 * (t + 0.6 * std::pow(t, 3) + 1.2 * std::pow(t, 5) + 0.1 * std::pow(t, 7)) + 320, 5e-4);
}

TEST(SlamNoOpt, Stereo) {
  expect_refused(load("slam_no_opt", kEucm, "stereo"), Code::kOrbslamKeyMissing, "RIGHT.K", {"slam_no_opt"});
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
