// SPDX-License-Identifier: BSD-3-Clause
// What a conversion says of what it drops is true, and names it.
#include "cli/run_program.h"
#include "cli/told.h"

#include <sstream>

namespace fca::test {
namespace {

// Facts of the calibration and the images are named, whatever they begin with; tuning comes as one.
TEST(Losses, FactsAreNamedAndTuningIsGrouped) {
  const TemporaryFolder folder;
  const std::string settings = folder.write(
      "settings.yaml", read_file(testdata("formats/orbslam3/good/v1-stereo-inertial.yaml")) +
                           "LEFT.height: 480\nLEFT.width: 752\nLEFT.K: 3.0\nCamera.newWidth: 256\nCamera.newHeight: 256\n");
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--json"}}) {
    std::vector<std::string> words = {"convert", settings, "--to", "kalibr", "-o", folder / "out/", "--force"};
    words.insert(words.end(), more.begin(), more.end());
    const RunResult run = run_program(words);
    EXPECT_EQ(run.code, 0) << run.err;
    for (const char* fact : {"LEFT.height 480", "LEFT.width 752", "LEFT.K 3.0", "Viewer.* (", "ORBextractor.* ("})
      EXPECT_TRUE(contains(run.out, fact)) << fact << run.out;
    EXPECT_FALSE(contains(run.out, "LEFT.*")) << run.out;
    EXPECT_FALSE(contains(run.out, "Camera.*")) << run.out;
  }
}

// SynWoodScape's quaternion has a place; what it lacks is a translation that is not CARLA's.
TEST(Losses, HalfAPoseIsLostForWhatItLacks) {
  const TemporaryFolder folder;
  const std::string front = with_replaced(read_file(testdata("formats/woodscape/good/front.json")), "\"translation\"",
                                          "\"translation used in CARLA (CARLA reference)\"");
  const std::string carla = folder.write("FV.json", front);
  for (const char* option : {"--rewrite", "--resize=640x483"}) {
    const Told run({"convert", carla, "--to", "woodscape", "-o", folder / "out.json", option, "--force"});
    const bool rewritten = option == std::string("--rewrite");  // else it is kept
    // The reason is in golden/convert.txt.
    EXPECT_EQ(run.lost("not-carried", "extrinsic.quaternion"), rewritten) << run.text();
  }
}

// What only a camera says that nobody asked for is not missed.
TEST(Losses, ADeselectedCameraLosesNothing) {
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--rewrite"}}) {
    const TemporaryFolder folder;
    const std::string chain =
        folder.write("chain.yaml", with_replaced(read_file(kTumvi), "cam1:\n", "cam1:\n  line_delay: 0.00002\n"));
    std::vector<std::string> words = {"convert", chain, "--camera", "0", "--to", "kalibr", "-o", folder / "out.yaml"};
    words.insert(words.end(), more.begin(), more.end());
    const RunResult run = run_program(words);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_FALSE(contains(run.out, "cam1")) << run.out;
  }
}

// A camera that is added to others of MC-Calib's takes their keys' style, not what they say.
TEST(Losses, AnAddedCameraSaysNothingThatItsInputDoesNot) {
  const RunResult run = run_program({"convert", testdata("formats/opencv/good/cameras.yml"),
                                     testdata("formats/opencv/good/calibration.yml"), "--join", "--to", "opencv"});
  EXPECT_EQ(run.code, 0) << run.err;
  const std::size_t added = run.out.find("\ncamera_3:");
  ASSERT_NE(added, std::string::npos) << run.out;
  std::set<std::string> keys;
  std::istringstream lines(run.out.substr(added + 1));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("   ") && line[3] != ' ') keys.insert(line.substr(3, line.find(':') - 3));
  }
  EXPECT_EQ(keys, (std::set<std::string>{"camera_matrix", "distortion_vector", "distortion_type", "img_width", "img_height"}))
      << run.out.substr(added);
}

}  // namespace
}  // namespace fca::test
