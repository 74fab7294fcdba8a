// SPDX-License-Identifier: BSD-3-Clause
// camchain -> ORB-SLAM3 settings -> camchain: nothing of what both can say is lost on the way.
#include "formats/rigs.h"
#include "formats/test_files.h"

#include <fca/formats/proof.h>
#include <fca/formats/wording.h>

#include <cmath>

namespace fca::test {
namespace {

Calibration with_imu(const std::string& chain) {
  Diagnostics diagnostics;
  std::optional<Calibration> calibration = read_calibration(
      {document_of(chain), document_of(read_file(testdata_dir() / "kalibr/good/imu.yaml"))}, nullptr, {}, diagnostics);
  EXPECT_TRUE(calibration);
  return calibration ? *std::move(calibration) : Calibration();
}

std::string written(const char* format, const Rig& rig) {
  Diagnostics diagnostics;
  const std::optional<Written> result = find_format(format)->write(nullptr, rig, {}, diagnostics);
  EXPECT_TRUE(result) << (diagnostics.entries().empty() ? "" : message_of(diagnostics.entries().front()));
  return result ? result->files.front().document.bytes() : "";
}

Calibration tumvi() { return with_imu(read_file(testdata_dir() / "kalibr/good/tumvi.yaml")); }

TEST(ConvertChain, ThePartsOfACalibrationAreOneRig) {
  const Calibration calibration = tumvi();
  EXPECT_EQ(calibration.rig.cameras.size(), 2U);
  ASSERT_EQ(calibration.rig.imus.size(), 1U);
  EXPECT_EQ(calibration.rig.imus.front(), tumvi_imu());
  EXPECT_EQ(calibration.documents.size(), 2U);
}

TEST(ConvertChain, ThereAndBackTheDoublesAreTheSame) {
  const Rig start = tumvi().rig;
  const Rig there = calibration_of(written("orbslam3", start)).rig;
  const Rig back = calibration_of(written("kalibr", there)).rig;
  ASSERT_EQ(back.cameras.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(model_info(there.cameras[i].model).id, "kb4");
    EXPECT_EQ(back.cameras[i].model, start.cameras[i].model);
    EXPECT_EQ(back.cameras[i].image_size, start.cameras[i].image_size);
  }
  EXPECT_LE(element_difference(back.resolve("cam1", "cam0").value(), start.resolve("cam1", "cam0").value()), 1e-12);
  EXPECT_LE(element_difference(back.resolve("cam0", "imu0").value(), start.resolve("cam0", "imu0").value()), 1e-12);
  EXPECT_LE(element_difference(back.resolve("cam1", "imu0").value(), start.resolve("cam1", "imu0").value()), 1e-12);
}

// ORB-SLAM3 holds floats: its pixels are those of Kalibr to 2e-4 px, and of each other's poses to a float's precision.
TEST(ConvertChain, BothProgramsUnderstandTheSame) {
  const Rig start = tumvi().rig;
  const std::string settings = written("orbslam3", start);
  const std::string chain = written("kalibr", calibration_of(settings).rig);
  const consumers::ConsumerView orbslam = consumers::find_consumer("orbslam3")->load(settings, {"stereo-inertial"});
  const consumers::ConsumerView kalibr = consumers::find_consumer("kalibr")->load(chain, {});
  ASSERT_TRUE(orbslam.loads()) << sentence_of(orbslam.refusals.front());
  ASSERT_TRUE(kalibr.loads()) << sentence_of(kalibr.refusals.front());
  int compared = 0;
  for (double x = -1.0; x <= 1.0; x += 0.1) {
    for (double y = -1.0; y <= 1.0; y += 0.1) {
      const auto a = orbslam.cameras.at(0).project({x, y, 1.0});
      const auto b = kalibr.cameras.at(0).project({x, y, 1.0});
      ASSERT_TRUE(a && b);
      EXPECT_NEAR((*a)[0], (*b)[0], 2e-4);
      EXPECT_NEAR((*a)[1], (*b)[1], 2e-4);
      ++compared;
    }
  }
  EXPECT_GT(compared, 400);
}

// A rotation printed with few digits is no exact rotation; its inverse's inverse is still itself (the transpose's would not
// be).
TEST(ConvertChain, APrintedRotationSurvivesTwoInversions) {
  Rig rig = tumvi().rig;
  for (PoseEdge& edge : rig.poses) {
    for (double& value : edge.T_a_b.values) value = std::round(value * 1e4) / 1e4;
  }
  const Rig back = calibration_of(written("kalibr", calibration_of(written("orbslam3", rig)).rig)).rig;
  EXPECT_LE(element_difference(back.resolve("cam1", "cam0").value(), rig.resolve("cam1", "cam0").value()), 1e-12);
  EXPECT_LE(element_difference(back.resolve("cam0", "imu0").value(), rig.resolve("cam0", "imu0").value()), 1e-12);
}

TEST(ConvertChain, ASecondStatementOfTheSameFactMustAgree) {
  Diagnostics diagnostics;
  const text::Document imu = document_of(read_file(testdata_dir() / "kalibr/good/imu.yaml"));
  const text::Document other =
      document_of(with_replaced(read_file(testdata_dir() / "kalibr/good/imu.yaml"), "0.0028", "0.0029"));
  EXPECT_TRUE(read_calibration({imu, imu}, nullptr, {}, diagnostics));
  EXPECT_FALSE(read_calibration({imu, other}, nullptr, {}, diagnostics));
  EXPECT_EQ(id_of(diagnostics.entries().back()), "stated-twice");
}

}  // namespace
}  // namespace fca::test
