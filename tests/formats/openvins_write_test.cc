// SPDX-License-Identifier: BSD-3-Clause
// OpenVINS' chains: told from Kalibr's, written with what the program stops without, and read back.
#include "formats/oracle_table.h"
#include "formats/rigs.h"
#include "id_and_arguments.h"

#include <fca/code.h>
#include <fca/formats/proof.h>
#include <fca/formats/wording.h>

namespace fca::test {
namespace {

const Format& openvins() { return *find_format("openvins"); }
const consumers::Consumer& program() { return *consumers::find_consumer("openvins"); }
std::string good(const std::string& name) { return read_file(testdata_dir() / "openvins" / "good" / name); }

bool loses(const Written& written, const std::string& code) {
  return std::ranges::any_of(written.losses, [&code](const Loss& loss) { return id_of(loss) == code; });
}

// One line tells them apart: Kalibr's PyYAML refuses it, OpenVINS' cv::FileStorage nothing without it.
TEST(OpenVinsFormat, TheFirstLineTellsItFromKalibr) {
  for (const char* name : {"pair.yaml", "three.yaml", "imu.yaml"}) {
    const std::string bytes = good(name);
    EXPECT_EQ(calibration_of(bytes).format->id, "openvins") << name;
    const std::string without = bytes.substr(bytes.find('\n') + 1);
    const std::string plain = without.starts_with("#") || without.find("---\n") == std::string::npos
                                  ? without
                                  : without.substr(without.find("---\n") + 4);
    EXPECT_EQ(calibration_of(plain).format->id, "kalibr") << name;
  }
}

// The program shifts every camera by the first one's offset already.
TEST(OpenVinsFormat, WhatIsToBeAddedIsTheDifferenceToTheFirstCameras) {
  Rig rig = sample_rig("kb4", {.two = true, .imu = true});
  rig.cameras[0].time_offset_s = 0.01;
  for (const auto& [offset, to_add] : {std::pair(0.02, 0.01), std::pair(0.0, -0.01)}) {
    rig.cameras[1].time_offset_s = offset;
    const Written written = written_by(openvins(), nullptr, rig);
    const auto loss = std::ranges::find(written.losses, Code::kOtherTimeOffset, &Loss::kind);
    ASSERT_NE(loss, written.losses.end());
    EXPECT_TRUE(speaks_of({loss->kind, {loss->values.back()}}, to_add)) << remedy_of(*loss);
  }
}

TEST(OpenVinsFormat, WhatIsWrittenTheProgramReads) {
  for (const std::string model : {"radtan", "kb4", "pinhole"}) {
    const Rig rig = sample_rig(model, {.two = true, .imu = true});
    const Written written = written_by(openvins(), nullptr, rig);
    ASSERT_EQ(written.files.size(), 2U) << model;
    EXPECT_TRUE(written.losses.empty()) << what_of(written.losses.front());
    const std::string bytes = written.files.front().document.bytes();
    const ProofResult proof = prove(program(), bytes, {}, rig);
    EXPECT_TRUE(proof.agrees()) << (proof.refusals.empty() ? "" : sentence_of(proof.refusals.front()));
    EXPECT_TRUE(proof.warnings.empty());
    EXPECT_LE(proof.max_diff_pose, 1e-12);
    EXPECT_EQ(proof.poses, (std::vector<std::string>{"T_imu0_cam0", "T_imu0_cam1"}));
    const Calibration back = calibration_of(bytes);
    EXPECT_EQ(back.format->id, "openvins");
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(back.rig.cameras[i].image_size, rig.cameras[i].image_size);
      EXPECT_EQ(back.rig.cameras[i].topic, rig.cameras[i].topic);
      for (const ParameterId name : ParameterIds{"fx", "cy", "k1", "p2"})
        EXPECT_EQ(parameter(back.rig.cameras[i].model, name).value_or(0.0),
                  parameter(rig.cameras[i].model, name).value_or(0.0));
    }
    const Calibration imu = calibration_of(written.files.back().document.bytes());
    EXPECT_EQ(imu.format->id, "openvins");
    EXPECT_EQ(imu.rig.imus, rig.imus);
    EXPECT_TRUE(consumers::find_consumer("openvins-imu")->load(written.files.back().document.bytes(), {}).loads());
  }
}

// It takes four numbers for fx fy cx cy whatever camera_model says: no other model may be written.
TEST(OpenVinsFormat, NoOtherModelIsWritten) {
  for (const std::string model : {"ds", "eucm", "mei", "fov"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(openvins().write(nullptr, sample_rig(model, {.imu = true}), {}, diagnostics)) << model;
    EXPECT_TRUE(diagnostics.has_errors());
  }
}

TEST(OpenVinsFormat, AnOffsetOfItsOwnIsSaidLost) {
  Rig rig = sample_rig("kb4", {.two = true, .imu = true});
  rig.cameras[0].time_offset_s = 0.002;
  rig.cameras[1].time_offset_s = 0.002;
  EXPECT_FALSE(loses(written_by(openvins(), nullptr, rig), "time-offset-dropped"));
  rig.cameras[1].time_offset_s = 0.003;
  EXPECT_TRUE(loses(written_by(openvins(), nullptr, rig), "time-offset-dropped"));
}

// The pose in an IMU that nobody knows is made up, and said; the cameras' pose to each other is not.
TEST(OpenVinsFormat, WithoutAnImuThePosesAreInTheFirstCamera) {
  const Rig rig = sample_rig("kb4", {.two = true});
  const Written written = written_by(openvins(), nullptr, rig);
  EXPECT_EQ(written.files.size(), 1U);
  ASSERT_EQ(written.defaults.size(), 2U);
  for (const DefaultedValue& value : written.defaults) EXPECT_TRUE(value.look_at_it);
  const Rig back = calibration_of(written.files.front().document.bytes()).rig;
  EXPECT_LE(test::element_difference(*back.resolve("cam1", "cam0"), T_cam1_cam0()), 1e-12);
}

TEST(OpenVinsFormat, AnEditKeepsTheFilesText) {
  const std::string bytes = good("pair.yaml");
  const Calibration calibration = calibration_of(bytes);
  Rig rig = calibration.rig;
  ASSERT_TRUE(set_parameter(rig.cameras[0].model, "fx", 460.5));
  const Written written = written_by(openvins(), &calibration.documents.front(), rig);
  EXPECT_EQ(written.files.front().document.bytes(), with_replaced(bytes, "458.625", "460.5"));
  EXPECT_EQ(written.files.front().programs, std::vector<std::string>{"openvins"});
}

// The IMU's own intrinsics are an OpenVINS chain's, and go from one to the next.
TEST(OpenVinsFormat, TheImusIntrinsicsAreKept) {
  const Calibration imu = calibration_of(good("imu.yaml"));
  Rig rig = imu.rig;
  const Written written = written_by(openvins(), nullptr, rig);
  EXPECT_EQ(calibration_of(written.files.front().document.bytes()).rig, rig);
  EXPECT_TRUE(written.defaults.empty());
  EXPECT_TRUE(written.losses.empty());
}

}  // namespace
}  // namespace fca::test
