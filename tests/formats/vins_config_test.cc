// SPDX-License-Identifier: BSD-3-Clause
// VINS-Fusion's configuration: what it says together with the camera files that it names, and how little of it an edit touches.
#include "formats/oracle_table.h"
#include "formats/rigs.h"

#include <fca/formats/proof.h>
#include <fca/formats/wording.h>

namespace fca::test {
namespace {

const Format& vins() { return *find_format("vins"); }
std::string good(const std::string& name) { return read_file(testdata_dir() / "vins" / "good" / name); }

/// The configuration with two camera files next to it, as the command reads them.
Calibration read_together(const std::string& config, const std::string& cam0, const std::string& cam1) {
  Diagnostics diagnostics;
  std::optional<Calibration> calibration = read_calibration(
      {document_of(config, "here/config.yaml"), document_of(cam0, "here/cam0.yaml"), document_of(cam1, "here/cam1.yaml")},
      nullptr, {}, diagnostics);
  EXPECT_TRUE(calibration) << (diagnostics.entries().empty() ? "" : message_of(diagnostics.entries().front()));
  EXPECT_TRUE(diagnostics.entries().empty());
  return calibration ? *std::move(calibration) : Calibration();
}

Calibration pair() { return read_together(good("config.yaml"), good("kannala-brandt.yaml"), good("kannala-brandt.yaml")); }

bool loses(const Written& written, const std::string& code) {
  return std::ranges::find(written.losses, code, [](const Loss& loss) { return id_of(loss); }) != written.losses.end();
}

// parameters.cpp: TIC is body_T_cam's translation: where the camera sits in the IMU.
TEST(VinsConfig, SaysItsPartTogetherWithItsCameraFiles) {
  const Calibration calibration = pair();
  const Rig& rig = calibration.rig;
  EXPECT_EQ(calibration.formats.size(), 3U);
  ASSERT_EQ(rig.cameras.size(), 2U);
  EXPECT_EQ(rig.cameras[1].name, "cam1");
  EXPECT_EQ(rig.cameras[1].topic, "/cam1/image_raw");
  EXPECT_EQ(rig.cameras[1].time_offset_s, 0.0);
  const Transform* T = rig.stated("imu0", "cam1");
  ASSERT_NE(T, nullptr);
  EXPECT_EQ((*T)(1, 3), 0.12);
  EXPECT_TRUE(rig.imus.empty()) << "its noise is of samples, and no rate says how many";
}

TEST(VinsConfig, WithoutItsCameraFilesItIsPosesAlone) {
  const Calibration calibration = calibration_of(good("config.yaml"), "config.yaml");
  EXPECT_TRUE(calibration.rig.cameras.empty());
  EXPECT_EQ(calibration.rig.poses.size(), 2U);
}

TEST(VinsConfig, TheTimeOffsetIsAddedToTheImagesTime) {
  const std::string config = with_replaced(good("config.yaml"), "td: 0.0 ", "td: -0.0021 ");
  for (const Camera& camera : read_together(config, good("kannala-brandt.yaml"), good("kannala-brandt.yaml")).rig.cameras)
    EXPECT_EQ(camera.time_offset_s, -0.0021);
}

// 2: VINS-Fusion calibrates the pose itself and reads none.
TEST(VinsConfig, APoseThatIsNotReadIsNone) {
  const std::string config = with_replaced(good("config.yaml"), "estimate_extrinsic: 0", "estimate_extrinsic: 2");
  EXPECT_EQ(calibration_of(config, "config.yaml").rig.stated("imu0", "cam0"), nullptr);
}

// What the rig says otherwise is edited, and the lenses go to the files that are named.
TEST(VinsConfig, AnEditChangesItsOwnNumbers) {
  const Calibration calibration = pair();
  Rig rig = calibration.rig;
  for (Camera& camera : rig.cameras) camera.time_offset_s = 0.0035;
  rig.poses[1].T_a_b(1, 3) = 0.125;
  rig.cameras[1].model = sample_model("mei");
  const Written written = written_by(vins(), &calibration.documents.front(), rig);
  EXPECT_EQ(written.files.front().document.bytes(),
            with_replaced(with_replaced(good("config.yaml"), "0.12,", "0.125,"), "td: 0.0 ", "td: 0.0035 "));
  ASSERT_EQ(written.files.size(), 3U);
  EXPECT_TRUE(written.losses.empty());
  EXPECT_EQ(written.files[1].document.source().name, "cam0.yaml");
  EXPECT_EQ(written.files[2].document.source().name, "cam1.yaml");
  const Rig back =
      read_together(written.files[0].document.bytes(), written.files[1].document.bytes(), written.files[2].document.bytes())
          .rig;
  EXPECT_EQ(back.cameras, rig.cameras);
  EXPECT_EQ(back.poses, rig.poses);
  const consumers::Consumer& program = *consumers::find_consumer("vins");
  for (const Written::File& file : written.files) {
    const ProofResult proof = prove(program, file.document.bytes(), {}, rig, file.cameras);
    EXPECT_TRUE(proof.agrees()) << (proof.refusals.empty() ? "" : sentence_of(proof.refusals.front()));
  }
  EXPECT_EQ(program.load(written.files[0].document.bytes(), {}).poses.size(), 2U);
}

// integration_base.h multiplies a sample's noise with the time step: density * sqrt(rate) is what a sample has.
TEST(VinsConfig, NoiseIsOfSamples) {
  const Calibration calibration = pair();
  Rig rig = calibration.rig;
  rig.imus.push_back({"imu0", 0.0001, 0.00002, 0.002, 0.00025, 400.0, ""});
  const std::string bytes = written_by(vins(), &calibration.documents.front(), rig).files.front().document.bytes();
  for (const char* line : {"acc_n: 0.04 ", "gyr_n: 0.002 ", "acc_w: 0.005 ", "gyr_w: 4.0e-04 "})
    EXPECT_NE(bytes.find(line), std::string::npos) << line << bytes;
  rig.imus.front().rate_hz.reset();
  const Written without = written_by(vins(), &calibration.documents.front(), rig);
  EXPECT_EQ(without.files.front().document.bytes(), good("config.yaml"));
  EXPECT_TRUE(loses(without, "imu-dropped"));
}

TEST(VinsConfig, TheRateMakesDensitiesOfItsNoise) {
  const text::Document config = document_of(good("config.yaml"), "config.yaml");
  ReadOptions options;
  options.imu_rate_hz = 200.0;
  Diagnostics diagnostics;
  const std::optional<Rig> rig = vins().read(std::span(&config, 1), options, diagnostics);
  ASSERT_TRUE(rig) << diagnostics.entries().size();
  ASSERT_EQ(rig->imus.size(), 1U);
  const Imu& imu = rig->imus.front();
  EXPECT_DOUBLE_EQ(imu.accelerometer_noise_density.value(), 0.1 / std::sqrt(200.0));
  EXPECT_DOUBLE_EQ(imu.gyroscope_noise_density.value(), 0.01 / std::sqrt(200.0));
  EXPECT_EQ(imu.rate_hz, 200.0);
  EXPECT_EQ(written_by(vins(), &config, *rig).files.front().document.bytes(), good("config.yaml")) << "and back";
  EXPECT_TRUE(pair().rig.imus.empty()) << "nobody knows its rate";
}

// A file's name is no way to write elsewhere.
TEST(VinsConfig, CameraFilesLieBesideIt) {
  const std::string config = with_replaced(good("config.yaml"), "cam0_calib: \"cam0.yaml\"", "cam0_calib: \"../../cam0.yaml\"");
  Rig rig = pair().rig;
  const text::Document base = document_of(config, "config.yaml");
  const Written written = written_by(vins(), &base, rig);
  EXPECT_EQ(written.files[1].document.source().name, "cam0.yaml");
  EXPECT_EQ(written.files[0].document.bytes(), good("config.yaml"));
}

// One file for both cameras of a rectified pair (KITTI's) stays one while they are alike.
TEST(VinsConfig, OneFileServesTwoCamerasThatAreAlike) {
  const std::string config = with_replaced(good("config.yaml"), "\"cam1.yaml\"", "\"cam0.yaml\"");
  Rig rig = pair().rig;
  const text::Document base = document_of(config, "config.yaml");
  EXPECT_EQ(written_by(vins(), &base, rig).files.size(), 2U);
  ASSERT_TRUE(set_parameter(rig.cameras[1].model, "cx", 250.0));
  const Written written = written_by(vins(), &base, rig);
  ASSERT_EQ(written.files.size(), 3U);
  EXPECT_EQ(written.files[0].document.bytes(), good("config.yaml"));
}

// What it has no place for is said: a third camera, an offset of its own.
TEST(VinsConfig, WhatHasNoPlaceIsSaidLost) {
  const Calibration calibration = pair();
  Rig rig = calibration.rig;
  rig.cameras[1].time_offset_s = 0.01;
  rig.cameras.push_back(rig.cameras[0]);
  rig.cameras.back().name = "cam2";
  const Written written = written_by(vins(), &calibration.documents.front(), rig);
  EXPECT_TRUE(loses(written, "time-offset-dropped"));
  EXPECT_TRUE(loses(written, "camera-dropped"));
}

}  // namespace
}  // namespace fca::test
