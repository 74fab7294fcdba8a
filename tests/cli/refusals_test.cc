// SPDX-License-Identifier: BSD-3-Clause
// Facts that no rig has are refused where they stand, and what a layout has no place for before it is written: exit 2, the
// place and the way out, and no output.
#include "cli/run_program.h"
#include "cli/told.h"

namespace fca::test {
namespace {

const std::string kChain = std::string(FCA_EXAMPLES_DIR) + "/tumvi/camchain.yaml";
const std::string kExampleImu = std::string(FCA_EXAMPLES_DIR) + "/tumvi/imu.yaml";
const std::string kRectified = testdata("formats/orbslam3/good/v1-rectified.yaml");

/// Runs `words` on `bytes` (the first word stands for their file): nothing may come of it but an explanation.
/// `where`: the key that is at fault, and its place if it is known.
void expect_refused(const std::string& bytes, std::vector<std::string> words, const std::string& code,
                    const std::string& where = {}) {
  const TemporaryFolder folder;
  const std::string file = folder.write("m.yaml", bytes);
  words.insert(words.begin(), {"convert", file});
  words.insert(words.end(), {"-o", folder / "out/"});
  const RunResult run = run_program(words);
  EXPECT_EQ(run.code, 2) << run.out << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_TRUE(says(run.err, code, where)) << run.err;
  EXPECT_EQ(folder.names(), std::set<std::string>{"m.yaml"});
}

TEST(Refusals, AHugeBaseline) {
  const std::string bytes = read_file(kRectified);
  for (const char* value : {"1e308", "0.0", "-0.11", "1e6"}) {
    expect_refused(with_replaced(bytes, "0.11007784219", value), {"--to", "orbslam3", "--orbslam3-layout", "old"},
                   "out-of-range", "m.yaml:8:11: error: Stereo.b: ");
  }
}

TEST(Refusals, AHugePose) {
  const std::string chain = read_file(kChain);
  for (const char* value : {"1e308", "-1e308", "1e30", "1000001"}) {
    expect_refused(with_replaced(chain, "0.04727988224914392", value), {"--to", "orbslam3"}, "out-of-range",
                   ": error: cam0 T_cam_imu: ");
  }
  for (const char* value : {"1e308", "-1e30", "3"}) {
    expect_refused(with_replaced(chain, "-0.9995250378696743", value), {"--to", "orbslam3"}, "not-a-rotation",
                   ": error: cam0 T_cam_imu: ");
  }
}

TEST(Refusals, AHugePoseOfSettings) {
  const TemporaryFolder folder;
  const RunResult run = run_program(
      {"convert", kChain, "--with", kExampleImu, "--to", "orbslam3", "--orbslam3-layout", "v1", "-o", folder / "s.yaml"});
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string settings = read_file(folder / "s.yaml");
  expect_refused(with_replaced(settings, "0.10106342741419427", "1e308"), {"--to", "kalibr"}, "out-of-range",
                 ": error: Stereo.T_c1_c2: ");
}

TEST(Refusals, AHugeTimeOffset) {
  for (const char* value : {"1e308", "-2e6"}) {
    const std::string bytes =
        with_replaced(read_file(kChain), "  camera_model:", std::string("  timeshift_cam_imu: ") + value + "\n  camera_model:");
    expect_refused(bytes, {"--to", "kalibr"}, "out-of-range", ": error: cam0 timeshift_cam_imu: ");
  }
}

const std::string kPinholePair =
    "cam0:\n"
    "  camera_model: pinhole\n"
    "  distortion_coeffs: [-0.28, 0.07, 0.0002, 1.8e-05]\n"
    "  distortion_model: radtan\n"
    "  intrinsics: [458.654, 457.296, 367.215, 248.375]\n"
    "  resolution: [752, 480]\n"
    "cam1:\n"
    "  T_cn_cnm1:\n"
    "  - [1.0, 0.0, 0.0, -0.11]\n"
    "  - [0.0, 0.9999, -0.0141414, 0.0]\n"
    "  - [0.0, 0.0141414, 0.9999, 0.0]\n"
    "  - [0.0, 0.0, 0.0, 1.0]\n"
    "  camera_model: pinhole\n"
    "  distortion_coeffs: [-0.28, 0.07, 0.0002, 1.8e-05]\n"
    "  distortion_model: radtan\n"
    "  intrinsics: [458.654, 457.296, 367.215, 248.375]\n"
    "  resolution: [752, 480]\n";

// That style is for rectified pairs: without a mode asked for it is the first camera alone.
TEST(Refusals, AnUnrectifiedPairInTheOldStyle) {
  const TemporaryFolder folder;
  const std::string pair = folder.write("pair.yaml", kPinholePair);
  EXPECT_EQ(run_program({"convert", pair, "--to", "orbslam3", "--dry-run"}).code, 0);
  for (const char* layout : {"old", "orbslam2"}) {
    expect_refused(kPinholePair, {"--to", "orbslam3", "--orbslam3-layout", layout, "--sensor", "stereo"}, "pose-not-storable");
    const Told mono({"convert", pair, "--to", "orbslam3", "--orbslam3-layout", layout});
    EXPECT_EQ(mono.code(), 0) << mono.text();
    EXPECT_EQ(mono.json()["cameras"].Size(), 1U) << mono.text();
    EXPECT_TRUE(mono.lost("camera-dropped")) << mono.text();
  }
}

TEST(Refusals, NotARectifiedPairInTheOldStyle) {
  const TemporaryFolder folder;
  const std::string straight =
      with_replaced(with_replaced(kPinholePair, "[0.0, 0.9999, -0.0141414, 0.0]", "[0.0, 1.0, 0.0, 0.0]"),
                    "[0.0, 0.0141414, 0.9999, 0.0]", "[0.0, 0.0, 1.0, 0.0]");
  const std::string pair = folder.write("pair.yaml", straight);
  const RunResult run = run_program({"convert", pair, "--to", "orbslam3", "--orbslam3-layout", "old", "--dry-run"});
  EXPECT_EQ(run.code, 0) << run.out << run.err;
}

}  // namespace
}  // namespace fca::test
