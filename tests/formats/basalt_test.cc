// SPDX-License-Identifier: BSD-3-Clause
// Basalt's calibration JSON: what its numbers mean, what is written comes back, and what the program itself computed.
#include "formats/lost_facts.h"
#include "formats/oracle_table.h"
#include "formats/rigs.h"

#include <fca/code.h>
#include <fca/formats/proof.h>
#include <fca/formats/wording.h>
#include <fca/rig/rotation.h>

#include <random>
#include <set>

namespace fca::test {
namespace {

const Format& basalt() { return *find_format("basalt"); }
const consumers::Consumer& program() { return *consumers::find_consumer("basalt"); }
std::string good(const std::string& name) { return read_file(testdata_dir() / "basalt" / "good" / name); }

Rig read_back(const Written& written) { return calibration_of(written.files.front().document.bytes(), "file.json").rig; }

bool loses(const Written& written, const std::string& id) {
  return std::ranges::any_of(written.losses, [&id](const Loss& loss) { return id_of(loss) == id; });
}

// calibration.hpp: "With raw image timestamp t_r and this offset o we can get a timestamp aligned with IMU clock as t_r + o".
TEST(Basalt, TimeOffsetIsNanosecondsAddedToTheImagesTime) {
  const Rig rig = calibration_of(good("pair.json"), "pair.json").rig;
  for (const Camera& camera : rig.cameras) EXPECT_EQ(camera.time_offset_s, -0.0021);
}

// The same two cameras by their authors: T_cam_imu of the published chain, 2 mm and 0.2 deg from Basalt's own estimate.
TEST(Basalt, PosesTakePointsOfTheCameraToTheImu) {
  const Rig rig = calibration_of(good("pair.json"), "pair.json").rig;
  const std::optional<Transform> T_cam0_imu0 = rig.resolve("cam0", "imu0");
  ASSERT_TRUE(T_cam0_imu0);
  EXPECT_LT(distance_between(*T_cam0_imu0, T_cam0_imu()), 0.005);
  EXPECT_LT(angle_between(*T_cam0_imu0, T_cam0_imu()), 0.005);
  ASSERT_NE(rig.stated("imu0", "cam1"), nullptr);
}

TEST(Basalt, NoiseIsDensities) {
  const Rig rig = calibration_of(good("pair.json"), "pair.json").rig;
  ASSERT_EQ(rig.imus.size(), 1U);
  EXPECT_EQ(rig.imus.front(), (Imu{"imu0", 0.000282, 0.0001, 0.016, 0.001, 200.0, ""}));
}

// One number stands for one axis only where all three are the same.
TEST(Basalt, AxesThatDifferAreKeptButNotAveraged) {
  const Rig rig = calibration_of(good("every-type-crlf.json"), "a.json").rig;
  ASSERT_EQ(rig.imus.size(), 1U);
  EXPECT_FALSE(rig.imus.front().accelerometer_noise_density);
  EXPECT_EQ(rig.imus.front().gyroscope_noise_density, 0.00016);
  const ExtraField* kept = rig.find_extra_field("imu0", "accel_noise_std");
  ASSERT_NE(kept, nullptr);
  EXPECT_EQ(kept->value, "[0.0028, 0.0028, 0.003]");
}

TEST(Basalt, EveryModelComesBackAndTheProgramComputesTheSame) {
  for (const StoredModel& stored : basalt().models) {
    SCOPED_TRACE(stored.model);
    Rig rig;
    if (stored.model == "rational") {
      rig = sample_rig("radtan", {.two = true, .imu = true});
      for (Camera& camera : rig.cameras)
        camera.model =
            model_of("rational", {458.6, 457.3, 367.2, 248.4, -0.28, 0.07, 0.0002, 0.00002, 0.001, 0.01, 0.002, 0.0005});
    } else {
      rig = sample_rig(std::string(stored.model), {.two = true, .imu = true});
    }
    const Written written = written_by(basalt(), nullptr, rig);
    const Rig back = read_back(written);
    ASSERT_EQ(back.cameras.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(back.cameras[i].model, rig.cameras[i].model);
    EXPECT_LE(test::element_difference(*back.resolve("cam1", "imu0"), *rig.resolve("cam1", "imu0")), 1e-12);
    const ProofResult proof = prove(program(), written.files.front().document.bytes(), {}, rig);
    EXPECT_TRUE(proof.agrees()) << (proof.refusals.empty() ? "" : sentence_of(proof.refusals.front()));
    EXPECT_LE(proof.max_diff_px, 1e-9);
    EXPECT_GT(proof.compared_share, 0.9);
  }
}

// Random poses, offsets of whole nanoseconds and noise come back: numbers bit for bit, poses to rounding.
TEST(Basalt, FactsComeBack) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::uniform_int_distribution<int> nanoseconds(-2'000'000'000, 2'000'000'000);
  for (int i = 0; i < 100; ++i) {
    Rig rig = sample_rig("ds", {.two = true, .imu = true});
    rig.poses.clear();
    const double offset = nanoseconds(random) / 1e9;
    for (Camera& camera : rig.cameras) {
      camera.topic.clear();
      camera.time_offset_s = offset;
      const Quaternion q = normalised({number(random), number(random), number(random), 1.5 + number(random)});
      rig.poses.push_back({"imu0", camera.name, pose_of(q, {number(random), number(random), number(random)})});
    }
    rig.imus.front() = {"imu0",
                        1e-4 * (2.0 + number(random)),
                        1e-5 * (2.0 + number(random)),
                        1e-3 * (2.0 + number(random)),
                        1e-4 * (2.0 + number(random)),
                        200.0,
                        ""};
    const Written written = written_by(basalt(), nullptr, rig);
    EXPECT_TRUE(written.losses.empty());
    EXPECT_TRUE(written.defaults.empty());
    const Rig back = read_back(written);
    EXPECT_EQ(back.cameras, rig.cameras);
    EXPECT_EQ(back.imus, rig.imus);
    for (const PoseEdge& edge : rig.poses) EXPECT_LE(test::element_difference(*back.stated(edge.a, edge.b), edge.T_a_b), 4e-15);
  }
}

// Basalt has one offset for all cameras.
TEST(Basalt, AnOffsetOfItsOwnIsSaidLost) {
  Rig rig = sample_rig("ds", {.two = true, .imu = true});
  rig.cameras[0].time_offset_s = 0.002;
  rig.cameras[1].time_offset_s = 0.003;
  const Written written = written_by(basalt(), nullptr, rig);
  EXPECT_EQ(read_back(written).cameras[0].time_offset_s, 0.002);
  ASSERT_TRUE(loses(written, "time-offset-dropped"));
  const auto loss = std::ranges::find(written.losses, Code::kOtherTimeOffset, &Loss::kind);
  ASSERT_NE(loss, written.losses.end());
  EXPECT_EQ(loss->values.at(0), Argument(Message{Code::kBasaltOneOffset}));
  EXPECT_TRUE(is_said_of(facts_of(*loss), Code::kOtherTimeOffset, {"cam1", 0.003, 0.002, 0.001})) << remedy_of(*loss);
  rig.cameras[1].time_offset_s = rig.cameras[0].time_offset_s = 0.0020000004;
  EXPECT_TRUE(loses(written_by(basalt(), nullptr, rig), "time-offset-rounded"));
}

// A quaternion is a rotation; a matrix printed with four digits is not quite one.
TEST(Basalt, APoseThatIsNoRotationIsRestatedAndSaid) {
  Rig rig = sample_rig("ds", {.imu = true});
  rig.poses.front().T_a_b(0, 1) += 1e-4;
  const Written written = written_by(basalt(), nullptr, rig);
  EXPECT_TRUE(loses(written, "pose-recomputed"));
  ASSERT_EQ(written.restated.size(), 1U);
  EXPECT_LE(rotation_defect(written.restated.front().T_a_b), 1e-15);
  EXPECT_LE(test::element_difference(*read_back(written).stated("imu0", "cam0"), written.restated.front().T_a_b), 1e-15);
}

// What the program demands and nobody stated is said, every value of it.
TEST(Basalt, WhatIsMadeUpIsListed) {
  Rig rig = sample_rig("ds", {.two = true});
  const Written written = written_by(basalt(), nullptr, rig);
  std::set<std::string> keys;
  for (const DefaultedValue& value : written.defaults) {
    EXPECT_TRUE(value.look_at_it);
    keys.insert(value.key);
  }
  EXPECT_EQ(keys, (std::set<std::string>{"cam0 T_imu_cam", "cam1 T_imu_cam", "imu_update_rate", "accel_noise_std",
                                         "gyro_noise_std", "accel_bias_std", "gyro_bias_std"}));
  EXPECT_TRUE(program().load(written.files.front().document.bytes(), {}).loads());
  EXPECT_LE(test::element_difference(*read_back(written).resolve("cam1", "cam0"), T_cam1_cam0()), 1e-12)
      << "the cameras' pose to each other is known and kept";
}

// Edits touch their own numbers; biases and vignette stay.
TEST(Basalt, AnEditChangesItsOwnNumbers) {
  const std::string bytes = good("pair.json");
  const Calibration calibration = calibration_of(bytes, "pair.json");
  Rig rig = calibration.rig;
  ASSERT_TRUE(set_parameter(rig.cameras[1].model, "cx", 300.5));
  rig.cameras[0].image_size = ImageSize{640, 512};
  for (Camera& camera : rig.cameras) camera.time_offset_s = 1e-9;
  rig.imus.front().gyroscope_random_walk = 2e-5;
  const Written written = written_by(basalt(), &calibration.documents.front(), rig);
  std::string expected = with_replaced(bytes, "252.56547609702953", "300.5");
  expected = with_replaced(expected, "-2100000", "1");
  expected = with_replaced(expected, "[0.0001, 0.0001, 0.0001]", "[2.0e-05, 2.0e-05, 2.0e-05]");
  expected.replace(expected.find("512"), 3, "640");
  EXPECT_EQ(written.files.front().document.bytes(), expected);
}

TEST(Basalt, AnotherModelTakesTheOnesPlace) {
  const Calibration calibration = calibration_of(good("mono-vignette.json"), "mono.json");
  Rig rig = calibration.rig;
  rig.cameras.front().model = sample_model("kb4");
  const Written written = written_by(basalt(), &calibration.documents.front(), rig);
  const std::string bytes = written.files.front().document.bytes();
  EXPECT_EQ(read_back(written).cameras, rig.cameras);
  EXPECT_EQ(bytes.find("alpha"), std::string::npos);
  EXPECT_NE(bytes.find("50000000000"), std::string::npos) << "the vignette is kept";
  EXPECT_TRUE(program().load(bytes, {}).loads());
}

// Fewer cameras: rewritten, with the IMU and its biases.
TEST(Basalt, FewerCamerasKeepTheImusBiases) {
  const Calibration calibration = calibration_of(good("pair.json"), "pair.json");
  Rig rig = calibration.rig;
  rig.cameras.pop_back();
  std::erase_if(rig.poses, [](const PoseEdge& edge) { return edge.b == "cam1"; });
  const Written written = written_by(basalt(), &calibration.documents.front(), rig);
  const Rig back = read_back(written);
  EXPECT_EQ(back.cameras, rig.cameras);
  EXPECT_EQ(back.imus, rig.imus);
  EXPECT_EQ(back.extra_fields, calibration.rig.extra_fields);
  EXPECT_FALSE(loses(written, "not-carried"));
}

// What Basalt printed of real files, against the model that our reader gives.
TEST(Basalt, OurModelIsThePrograms) {
  if (!has_shared()) GTEST_SKIP() << "no oracles in '" FCA_SHARED_DIR "'";
  int compared = 0;
  for (const char* folder : {"basalt", "tumvi"}) {
    for (const OracleTable& table : oracle_tables(folder, "basalt")) {
      const ReadCorpusFile file = read_corpus_file(table.file);
      ASSERT_TRUE(file.calibration) << table.file;
      for (const OracleRow& row : table.rows) {
        const std::optional<Pixel> ours = project(file.calibration->rig.cameras.at(table.camera).model, row.ray);
        EXPECT_EQ(ours.has_value(), !std::isnan(row.pixel[0])) << table.file;
        if (!ours || std::isnan(row.pixel[0])) continue;
        EXPECT_LE(distance(*ours, row.pixel), 1e-9) << table.file;
        ++compared;
      }
    }
  }
  EXPECT_GE(compared, 500);
}

}  // namespace
}  // namespace fca::test
