// SPDX-License-Identifier: BSD-3-Clause
// A camchain that becomes TUM-VI's: of the same layout, and so only what the dataset's habits ask for changes.
#include "cli/run_program.h"
#include "cli/told.h"

namespace fca::test {
namespace {

// The dataset's own chain is detected as Kalibr's and nothing in it needs to change, keys that only Kalibr's tools read
// included.
TEST(TumViChainByCommand, AChainOfTheDatasetKeepsItsBytes) {
  for (const std::string from : {"kalibr", "tumvi"}) {
    for (const std::string to : {"kalibr", "tumvi"}) {
      SCOPED_TRACE(from + " -> " + to);
      const RunResult run = run_program({"convert", kTumvi, "--from", from, "--to", to, "--strict"});
      EXPECT_EQ(run.code, 0) << run.err;
      EXPECT_EQ(run.out, read_file(kTumvi));
    }
  }
}

// What the dataset's two statements of a pose cannot both say is written once, told, and proven as written.
TEST(TumViChainByCommand, ContradictingPosesAreMadeOneAndProven) {
  const TemporaryFolder folder;
  const std::string number = "-0.10106110275180535";  // T_cn_cnm1's x
  const std::string path = folder.write("chain.yaml", with_replaced(read_file(kTumvi), number, "-0.11106110275180535"));
  const Told run({"convert", path, "--to", "tumvi", "-o", folder / "out.yaml"});
  EXPECT_EQ(run.code(), 0) << run.text();
  EXPECT_TRUE(run.lost("pose-recomputed", "cam1 T_cam_imu")) << run.text();
  EXPECT_TRUE(run.loads()) << run.text();
  const RunResult again = run_program({"convert", folder / "out.yaml", "--to", "tumvi", "--strict"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(again.out, read_file(folder / "out.yaml"));
}

TEST(TumViChainByCommand, ATimeOffsetGoesAndNothingElse) {
  const TemporaryFolder folder;
  const std::string chain = read_file(kTumvi);
  const std::string topic = "  rostopic: /cam0/image_raw\n";
  const std::string path = folder.write("chain.yaml", with_replaced(chain, topic, topic + "  timeshift_cam_imu: 0.002\n"));
  const Told run({"convert", path, "--to", "tumvi"});
  EXPECT_EQ(run.code(), 0) << run.text();
  EXPECT_EQ(run.bytes(), chain);
  ASSERT_TRUE(run.lost("time-offset-dropped")) << run.text();
  for (const auto& loss : run.json()["losses"].GetArray()) {
    const bool is_offset = loss["code"] == "time-offset-dropped";
    EXPECT_TRUE(!is_offset || contains(loss["do"].GetString(), " 0.002 s")) << run.text();
  }
}

// Kalibr reads them in TUM-VI's chains as in any other.
TEST(TumViChainByCommand, KalibrsModelsStay) {
  const TemporaryFolder folder;
  for (const std::string name : {"block-style.yaml", "ds.yaml", "eucm.yaml", "omni.yaml"}) {
    SCOPED_TRACE(name);
    const RunResult run =
        run_program({"convert", testdata("formats/kalibr/good/" + name), "--to", "tumvi", "-o", folder / name, "--json"});
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(contains(run.out, "\"exact\": true") || contains(run.out, "\"exact\":true")) << run.out;
    EXPECT_FALSE(contains(run.out, "\"exact\": false") || contains(run.out, "\"exact\":false")) << run.out;
  }
}

// Both statements of the second camera's pose are there again when the cameras change places.
TEST(KalibrChainByCommand, CamerasThatChangePlacesKeepRedundantPoses) {
  const TemporaryFolder folder;
  const RunResult run = run_program({"convert", kTumvi, "--camera", "1,0", "--to", "kalibr", "-o", folder / "out.yaml"});
  EXPECT_EQ(run.code, 0) << run.err;
  const std::string out = read_file(folder / "out.yaml");
  EXPECT_TRUE(contains(out, "T_cn_cnm1")) << out;
  EXPECT_LT(out.find("T_cam_imu"), out.rfind("T_cam_imu")) << out;
}

// The pose of what remains is composed, and written where the removed camera's block begins.
TEST(KalibrChainByCommand, ACameraLeftOutInTheMiddleKeepsTheBaseline) {
  const TemporaryFolder folder;
  const auto block = [](const std::string& name, const std::string& pose) {
    return name + ":\n" + pose +
           "  camera_model: pinhole\n  distortion_coeffs: [0.0, 0.0, 0.0, 0.0]\n  distortion_model: radtan\n"
           "  intrinsics: [500.0, 500.0, 320.0, 240.0]\n  resolution: [640, 480]\n  rostopic: /" +
           name + "\n";
  };
  const auto beside = [](const std::string& x) {
    return "  T_cn_cnm1:\n  - [1.0, 0.0, 0.0, " + x +
           "]\n  - [0.0, 1.0, 0.0, 0.0]\n  - [0.0, 0.0, 1.0, 0.0]\n  - [0.0, 0.0, 0.0, 1.0]\n";
  };
  const std::string chain =
      folder.write("chain.yaml", block("cam0", "") + block("cam1", beside("-0.125")) + block("cam2", beside("-0.25")));
  const RunResult run = run_program({"convert", chain, "--camera", "2,0", "--to", "kalibr", "-o", folder / "out.yaml"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_FALSE(contains(run.out, "T_cam2_cam0")) << run.out;  // not among what is lost
  EXPECT_TRUE(contains(read_file(folder / "out.yaml"), "- [1.0, 0.0, 0.0, 0.375]")) << read_file(folder / "out.yaml");
}

// --camera names the cameras in the order in which they are to stand, in a base, too.
TEST(KalibrChainByCommand, TheOrderOfTheCamerasGoesIntoTheBase) {
  const TemporaryFolder folder;
  const RunResult run = run_program({"convert", kTumvi, "--camera", "1,0", "--into", kTumvi, "-o", folder / "out.yaml"});
  EXPECT_EQ(run.code, 0) << run.err;
  const std::string base = read_file(kTumvi);
  const std::string out = read_file(folder / "out.yaml");
  const std::string first = "190.97847715128717";
  const std::string second = "190.44236969414825";
  EXPECT_LT(base.find(first), base.find(second));
  EXPECT_LT(out.find(second), out.find(first)) << out;
  EXPECT_EQ(out.find("cam0:"), base.find("cam0:")) << out;
}

// cam_overlaps counts cameras by their places, and an added one changes none.
TEST(KalibrChainByCommand, AnAddedCameraLeavesTheOthersOverlaps) {
  const TemporaryFolder folder;
  const std::string two = read_file(kTumvi);
  std::string third = two.substr(two.find("cam1:"));
  third = with_replaced(third, "cam1:", "cam2:");
  const RunResult run =
      run_program({"convert", folder.write("three.yaml", two + third), "--into", kTumvi, "--accept", "poses-contradict"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with(two.substr(0, two.size() - 1))) << run.out;
}

}  // namespace
}  // namespace fca::test
