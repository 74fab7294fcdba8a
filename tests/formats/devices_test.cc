// SPDX-License-Identifier: BSD-3-Clause
// The memories of devices: DepthAI's EEPROM, ZED's SN*.conf, what RealSense's tools print. They are only read.
#include "formats/test_files.h"

#include <fca/code.h>

#include <array>
#include <cmath>

namespace fca::test {
namespace {

std::string good(const std::string& name) { return read_file(testdata_dir() / name); }

struct Outcome {
  std::optional<Calibration> calibration;
  Diagnostics diagnostics;
  [[nodiscard]] const Rig& rig() const { return calibration->rig; }
  [[nodiscard]] std::vector<Code> codes() const {
    std::vector<Code> result;
    for (const Diagnostic& entry : diagnostics.entries()) result.push_back(entry.facts.code);
    return result;
  }
};

Outcome read_with(const std::string& bytes, const std::string& name, std::optional<ImageSize> size = {}) {
  Outcome outcome;
  std::optional<text::Document> document = text::parse_document({name, bytes}, outcome.diagnostics);
  ReadOptions options;
  options.image_size = size;
  if (document) outcome.calibration = read_calibration({*std::move(document)}, nullptr, options, outcome.diagnostics);
  return outcome;
}

std::vector<std::string> names_of(const Rig& rig) {
  std::vector<std::string> names;
  for (const Camera& camera : rig.cameras) names.push_back(camera.name);
  return names;
}

std::array<double, 3> moved(const Transform& T, const std::array<double, 3>& p) {
  std::array<double, 3> result{};
  for (int row = 0; row < 3; ++row)
    result.at(static_cast<std::size_t>(row)) = T(row, 0) * p[0] + T(row, 1) * p[1] + T(row, 2) * p[2] + T(row, 3);
  return result;
}

TEST(ReadOnly, NoneIsWritten) {
  for (const char* id : {"depthai", "openicc", "zed", "realsense"}) {
    const Format* format = find_format(id);
    ASSERT_NE(format, nullptr) << id;
    EXPECT_FALSE(format->is_written());
    Diagnostics diagnostics;
    EXPECT_FALSE(write_calibration(*format, nullptr, Rig(), {}, diagnostics));
    EXPECT_EQ(diagnostics.entries().front().facts.code, Code::kFormatIsReadOnly);
  }
}

// ---- DepthAI

TEST(Depthai, CamerasAreNamedAndSortedBySocket) {
  const Rig rig = calibration_of(good("depthai/good/oak.json"), "oak.json").rig;
  EXPECT_EQ(names_of(rig), (std::vector<std::string>{"CAM_A", "CAM_B", "CAM_C"}));
  EXPECT_EQ(rig.cameras[0].image_size, (ImageSize{1920, 1080}));
  EXPECT_EQ(model_info(rig.cameras[0].model).id, "radtan") << "the last nine of 14 are 0";
  EXPECT_EQ(model_info(rig.cameras[1].model).id, "rational") << "the last six are 0";
  EXPECT_EQ(model_info(rig.cameras[2].model).id, "opencv14") << "a tilt";
}

TEST(Depthai, CoefficientsHaveOpenCvsOrderAndNoneIsDropped) {
  const Rig rig = calibration_of(good("depthai/good/oak.json"), "oak.json").rig;
  struct Number {
    ParameterId id;
    double value;
  };
  constexpr std::array kExpected = {Number{"fx", 801.25}, Number{"fy", 801.5},      Number{"cx", 640.75},
                                    Number{"cy", 398.25}, Number{"k1", 9.5},        Number{"p1", 0.00025},
                                    Number{"k3", 30.5},   Number{"k4", 9.25},       Number{"k6", 29.75},
                                    Number{"s1", 0.0},    Number{"tau_x", -0.0025}, Number{"tau_y", 0.00125}};
  for (const auto& [id, value] : kExpected) EXPECT_EQ(parameter(rig.cameras[2].model, id), value) << id.name();
}

// The right camera (CAM_C) sits 3.75 cm right of the colour camera; the left one 7.5 cm left of the right one.
TEST(Depthai, ExtrinsicsTakePointsToTheOtherCameraInCentimetres) {
  const Rig rig = calibration_of(good("depthai/good/oak.json"), "oak.json").rig;
  const Transform T_a_c = rig.resolve("CAM_A", "CAM_C").value();
  EXPECT_DOUBLE_EQ(T_a_c(0, 3), 0.0375);
  EXPECT_NEAR(T_a_c(0, 2), std::sin(0.004), 1e-15);
  const std::array<double, 3> left = moved(rig.resolve("CAM_A", "CAM_B").value(), {0.0, 0.0, 0.0});
  // R_y(0.004) (-0.075, 0.00025, -0.000375) + (0.0375, -0.000125, 0.000875)
  EXPECT_NEAR(left[0], -0.075 * std::cos(0.004) - 0.000375 * std::sin(0.004) + 0.0375, 1e-12);
  EXPECT_NEAR(left[1], 0.000125, 1e-12);
  EXPECT_NEAR(left[2], 0.075 * std::sin(0.004) - 0.000375 * std::cos(0.004) + 0.000875, 1e-12);
}

TEST(Depthai, TheUnitMayBeStated) {
  const Rig rig = calibration_of(good("depthai/good/wide.json"), "wide.json").rig;
  EXPECT_NEAR(rig.resolve("CAM_C", "CAM_B").value()(0, 3), -0.075, 1e-15) << "millimetres";
  EXPECT_NEAR(rig.resolve("CAM_C", "CAM_D").value()(0, 3), 0.1, 1e-15) << "metres";
  EXPECT_EQ(model_info(rig.cameras[0].model).id, "kb4");
  EXPECT_EQ(parameter(rig.cameras[0].model, "k4"), -0.0015);
  EXPECT_EQ(model_info(rig.cameras[2].model).id, "pinhole");
}

TEST(Depthai, ASizeOfZeroIsOneThatIsNotStated) {
  const std::string bytes = good("depthai/good/version-5.json");
  for (const Camera& camera : calibration_of(bytes, "v5.json").rig.cameras) EXPECT_FALSE(camera.image_size);
  const Outcome told = read_with(bytes, "v5.json", ImageSize{1280, 800});
  for (const Camera& camera : told.rig().cameras) EXPECT_EQ(camera.image_size, (ImageSize{1280, 800}));
}

TEST(Depthai, ACameraOfZerosIsNone) {
  const Outcome outcome = read_with(good("depthai/bad/not-calibrated.json"), "eeprom.json");
  EXPECT_EQ(names_of(outcome.rig()), (std::vector<std::string>{"CAM_A", "CAM_B"}));
  EXPECT_EQ(outcome.rig().stated("CAM_A", "CAM_C"), nullptr) << "no pose is made up";
  EXPECT_EQ(outcome.codes(), (std::vector<Code>{Code::kTableNotCalibrated, Code::kTableNotCalibrated}));
}

TEST(Depthai, TheImuIsInTheCameraAndThatIsInDoubt) {
  const Outcome outcome = read_with(good("depthai/bad/imu.json"), "eeprom.json");
  const Transform* T_a_imu = outcome.rig().stated("CAM_A", "imu0");
  ASSERT_NE(T_a_imu, nullptr);
  EXPECT_DOUBLE_EQ((*T_a_imu)(0, 3), 0.0375);
  EXPECT_DOUBLE_EQ((*T_a_imu)(1, 1), -1.0);
  EXPECT_EQ(outcome.rig().kind_of("imu0"), FrameKind::kImu);
  EXPECT_EQ(outcome.codes(), std::vector<Code>{Code::kDepthaiImuDirection});
}

TEST(Depthai, WhatIsNotOfTheRigIsKept) {
  const Rig rig = calibration_of(good("depthai/good/oak.json"), "oak.json").rig;
  for (const char* key : {"boardName", "stereoRectificationData", "version"})
    EXPECT_NE(rig.find_extra_field("", key), nullptr) << key;
  EXPECT_NE(rig.find_extra_field("CAM_C", "extrinsics specTranslation"), nullptr);
  EXPECT_EQ(rig.find_extra_field("CAM_A", "extrinsics specTranslation"), nullptr) << "zeros say nothing";
}

// ---- ZED

TEST(Zed, ThePoseIsThatOfTheLeftCameraInTheRightOne) {
  const Rig rig = calibration_of(good("zed/good/SN1.conf"), "SN1.conf").rig;
  EXPECT_EQ(names_of(rig), (std::vector<std::string>{"left", "right"}));
  const Transform* T = rig.stated("right", "left");
  ASSERT_NE(T, nullptr);
  EXPECT_DOUBLE_EQ((*T)(0, 3), -0.119875) << "the left camera is left of the right one";
  // Rodrigues' vector (RX, CV, RZ), which is small: R is about I + [v].
  EXPECT_NEAR((*T)(2, 1), 0.00375, 1e-5);
  EXPECT_NEAR((*T)(0, 2), 0.00625, 1e-5);
  EXPECT_NEAR((*T)(1, 0), -0.00125, 1.5e-5);
}

TEST(Zed, K3StandsBeforeTheTangentialTerms) {
  const Rig rig = calibration_of(good("zed/good/SN1.conf"), "SN1.conf").rig;
  const CameraModel& left = rig.cameras[0].model;
  EXPECT_EQ(model_info(left).id, "radtan");
  EXPECT_EQ(parameter(left, "k2"), 0.0275);
  EXPECT_EQ(parameter(left, "k3"), 0.0);
  EXPECT_EQ(parameter(left, "p1"), 0.00025);
  EXPECT_EQ(parameter(left, "p2"), -0.0005);
}

TEST(Zed, TheKindOfLensIsThatOfItsKeys) {
  const auto lens = [](const std::string& name) {
    return std::string(model_info(calibration_of(good(name), "SN1.conf").rig.cameras[0].model).id);
  };
  EXPECT_EQ(lens("zed/good/mini.conf"), "kb4");
  EXPECT_EQ(lens("zed/good/x.conf"), "rational");
  EXPECT_EQ(lens("zed/good/one-4k.conf"), "radtan") << "k4 to k6 are 0";
  EXPECT_EQ(lens("zed/good/left-alone.conf"), "pinhole");
  EXPECT_EQ(lens("zed/bad/fisheye-filled-up.conf"), "kb4");
}

TEST(Zed, TheSizeChoosesTheSection) {
  const std::string bytes = good("zed/bad/several-sizes.conf");
  EXPECT_EQ(read_with(bytes, "SN1.conf").codes(), std::vector<Code>{Code::kDeviceSizeNeeded});
  EXPECT_EQ(read_with(bytes, "SN1.conf", ImageSize{640, 480}).codes(), std::vector<Code>{Code::kDeviceSizeUnknown});
  const Outcome hd = read_with(bytes, "SN1.conf", ImageSize{1280, 720});
  ASSERT_EQ(hd.rig().cameras.size(), 2U);
  EXPECT_EQ(parameter(hd.rig().cameras[0].model, "fx"), 700.0);
  EXPECT_EQ(hd.rig().cameras[0].image_size, (ImageSize{1280, 720}));
  EXPECT_NE(hd.rig().stated("right", "left"), nullptr);
}

TEST(Zed, ASectionThatOneCameraLacksLeavesItOut) {
  std::string bytes = good("zed/bad/several-sizes.conf");
  bytes = with_replaced(bytes, "[RIGHT_CAM_2K]", "[RIGHT_CAM_OTHER]");
  const Outcome outcome = read_with(bytes, "SN1.conf", ImageSize{2208, 1242});
  EXPECT_EQ(names_of(outcome.rig()), std::vector<std::string>{"left"});
  EXPECT_EQ(outcome.codes(), std::vector<Code>{Code::kDeviceCameraOfOtherSize});
}

// ---- RealSense

TEST(Realsense, StreamsAreCameras) {
  const Rig rig = calibration_of(good("realsense/good/d435i.txt"), "d435i.txt").rig;
  EXPECT_EQ(names_of(rig), (std::vector<std::string>{"Infrared_1", "Infrared_2", "Color"})) << "Depth is Infrared_1";
  EXPECT_EQ(rig.cameras[2].image_size, (ImageSize{640, 480}));
  EXPECT_EQ(parameter(rig.cameras[2].model, "cx"), 325.25);
  EXPECT_EQ(model_info(rig.cameras[2].model).id, "pinhole") << "Inverse Brown Conrady with zeros";
}

TEST(Realsense, AnExtrinsicTakesPointsOfTheFirstToTheSecond) {
  const Rig rig = calibration_of(good("realsense/good/d435i.txt"), "d435i.txt").rig;
  const Transform* T = rig.stated("Color", "Infrared_1");
  ASSERT_NE(T, nullptr);
  EXPECT_EQ((*T)(0, 3), 0.015);
  EXPECT_EQ((*T)(0, 1), -0.008) << "the text has rows";
  EXPECT_EQ(rig.resolve("Infrared_2", "Infrared_1").value()(0, 3), -0.05);
  EXPECT_EQ(rig.kind_of("imu0"), FrameKind::kImu);
  EXPECT_EQ(rig.stated("imu0", "Infrared_1")->operator()(0, 3), -0.0055);
  EXPECT_EQ(rig.stated("Infrared_1", "Color"), nullptr) << "it is the other way round what stands there already";
}

TEST(Realsense, RustPrintsColumns) {
  const Rig rig = calibration_of(good("realsense/good/rust.txt"), "intrinsics.txt").rig;
  EXPECT_EQ(names_of(rig), (std::vector<std::string>{"depth", "rgb"}));
  const Transform* T = rig.stated("rgb", "depth");
  ASSERT_NE(T, nullptr);
  EXPECT_EQ((*T)(1, 0), -0.008);
  EXPECT_EQ((*T)(0, 3), 0.0145);
}

TEST(Realsense, LensesByTheirNames) {
  const auto lens = [](const std::string& name) { return calibration_of(good(name), "device.txt").rig.cameras[0].model; };
  EXPECT_EQ(model_info(lens("realsense/good/t265.txt")).id, "kb4");
  EXPECT_EQ(model_info(lens("realsense/good/zr300.txt")).id, "fov");
  EXPECT_EQ(parameter(lens("realsense/good/zr300.txt"), "w"), 0.9325);
  const CameraModel brown = lens("realsense/good/color.txt");
  EXPECT_EQ(parameter(brown, "p1"), -0.00025);
  EXPECT_EQ(parameter(brown, "k3"), -0.02);
  const Outcome inverse = read_with(good("realsense/bad/inverse.txt"), "device.txt");
  EXPECT_EQ(model_info(inverse.rig().cameras[0].model).id, "radtan");
  EXPECT_EQ(inverse.codes(), std::vector<Code>{Code::kRealsenseInverseModel});
}

// librealsense prints the pose to Infrared 1 where that to Infrared 2 belongs.
TEST(Realsense, ABlockThatIsACopyIsLeftOut) {
  const Outcome outcome = read_with(good("realsense/bad/copied-block.txt"), "device.txt");
  EXPECT_EQ(outcome.codes(), (std::vector<Code>{Code::kRealsenseCopiedBlock, Code::kRealsenseDepthIsInfrared}));
  EXPECT_EQ(outcome.rig().stated("Infrared_2", "Color"), nullptr);
  const double x = outcome.rig().resolve("Infrared_2", "Color").value()(0, 3);
  EXPECT_NEAR(x, -0.015 * 0.999968 - 0.008 * 0.0002 - 0.05, 1e-6);
}

TEST(Realsense, TheSizeIsThatOfTheStreamsThatHaveSeveral) {
  const std::string bytes = good("realsense/bad/several-sizes.txt");
  EXPECT_EQ(read_with(bytes, "device.txt").codes(), std::vector<Code>{Code::kDeviceSizeNeeded});
  const Outcome told = read_with(bytes, "device.txt", ImageSize{1280, 720});
  ASSERT_EQ(told.rig().cameras.size(), 2U);
  EXPECT_EQ(told.rig().cameras[0].image_size, (ImageSize{848, 480})) << "depth has this one only";
  EXPECT_EQ(parameter(told.rig().cameras[1].model, "fx"), 905.5);
}

// A comment in somebody's YAML is no list of a device.
TEST(Realsense, APastedCommentIsNone) {
  const std::string chain = "# Intrinsic of \"Color\" / 640x480 / {RGB8}\n" + good("kalibr/good/ds.yaml");
  EXPECT_EQ(calibration_of(chain, "camchain.yaml").format->id, "kalibr");
}

}  // namespace
}  // namespace fca::test
