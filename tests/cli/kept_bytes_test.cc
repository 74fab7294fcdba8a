// SPDX-License-Identifier: BSD-3-Clause
// What an edit does not speak of stays, and what cannot be done is refused rather than done by halves.
#include "cli/read_rig.h"
#include "cli/run_program.h"
#include "cli/told.h"

namespace fca::test {
namespace {

const std::string kCarla = testdata("formats/woodscape/bad/carla.json");
const std::string kExtrinsics = testdata("formats/opencv/good/extrinsics.yml");

// SynWoodScape's JSONs have a rotation and no translation that projection.py reads: to rewrite the file would be to make
// up a pose.
TEST(KeptBytes, SynWoodScapesRotationOutlivesAnEdit) {
  const std::string before = read_file(kCarla);
  const Told run({"convert", kCarla, "--to", "woodscape", "--resize", "640x483"});
  ASSERT_EQ(run.code(), 0) << run.text();
  const std::string after = run.bytes();
  EXPECT_EQ(after.substr(0, after.find("\"intrinsic\"")), before.substr(0, before.find("\"intrinsic\"")));
  EXPECT_TRUE(run.lost_nothing()) << run.text();
  EXPECT_TRUE(run.json()["defaults"].Empty()) << run.text();  // such as a pose that is made up
  EXPECT_EQ(rig_in(after).cameras.at(0).image_size, (ImageSize{640, 483}));
}

TEST(KeptBytes, CarlasTranslationBesideANewPoseIsListed) {
  const Told run({"convert", testdata("formats/woodscape/good/front.json"), "--into", kCarla});
  ASSERT_EQ(run.code(), 0) << run.text();
  EXPECT_TRUE(run.lost("stale-derived", "extrinsic.translation used in CARLA (CARLA reference)")) << run.text();
  EXPECT_EQ(rig_in(run.bytes()).poses.size(), 1U);
}

// The base is for images of its own.
TEST(KeptBytes, SizeIsTheInputsNotTheBases) {
  const RunResult run = run_program({"convert", testdata("formats/opencv/good/k1d1.yml"), "--into",
                                     testdata("formats/opencv/good/stereo-14.yml"), "--size", "700x500"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Rig rig = rig_in(run.out);
  for (const Camera& camera : rig.cameras) EXPECT_EQ(camera.image_size, (ImageSize{700, 500}));
}

// Of several inputs, it is that of those which state none.
TEST(KeptBytes, SizeIsThatOfTheJoinedFilesWithoutOne) {
  const RunResult run =
      run_program({"convert", testdata("formats/opencv/good/k1d1.yml"), testdata("formats/kalibr/good/eucm.yaml"), "--join",
                   "--size", "700x500", "--to", "opencv"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Rig rig = rig_in(run.out);
  ASSERT_EQ(rig.cameras.size(), 3U);
  EXPECT_EQ(rig.cameras[1].image_size, (ImageSize{700, 500}));
  EXPECT_EQ(rig.cameras[2].image_size, (ImageSize{512, 512}));
}

TEST(KeptBytes, AnInputWithoutAPairsPoseHasNoPlaceInOne) {
  const TemporaryFolder folder;
  const std::string base = folder.write("extrinsics.yml", read_file(kExtrinsics));
  const std::string one = testdata("formats/kalibr/good/eucm.yaml");
  for (const std::vector<std::string>& inputs : {std::vector<std::string>{one}, {kCarla, kCarla, "--join"}}) {
    std::vector<std::string> words = {"convert", "--into", base, "--in-place"};
    words.insert(words.end(), inputs.begin(), inputs.end());
    const RunResult run = run_program(words);
    EXPECT_EQ(run.code, 2) << run.out << run.err;
    EXPECT_TRUE(says(run.err, "pose-missing", inputs.front())) << run.err;
    EXPECT_EQ(read_file(base), read_file(kExtrinsics));
  }
}

/// CAHVOR, of which rays alone are known.
const std::string kOwnLens =
    "{\n    'lensmodel': 'LENSMODEL_CAHVOR',\n    'intrinsics': [600, 605, 502, 397, 0.01, -0.02, 0.003, 0.04, -0.01],\n"
    "    'rt_cam_ref': [0, 0, 0, 0.5, 0, 0],\n    'extrinsics': [0, 0, 0, 0.5, 0, 0],\n    'imagersize': [1000, 800]\n}\n";

TEST(KeptBytes, ALensOfMrcalsOwnStaysInItsOwnFormat) {
  const TemporaryFolder folder;
  const std::string path = folder.write("own.cameramodel", kOwnLens);
  const RunResult run = run_program({"convert", path, "--to", "mrcal"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, kOwnLens);
  const RunResult resized = run_program({"convert", path, "--to", "mrcal", "--resize", "500x400"});
  ASSERT_EQ(resized.code, 0) << resized.err;
  EXPECT_TRUE(rig_in(resized.out).cameras.at(0).rays.empty());
  EXPECT_EQ(rig_in(resized.out).cameras.at(0).image_size, (ImageSize{500, 400}));
}

TEST(KeptBytes, ATableOfRaysIsReadUnderAnyName) {
  std::string table = "# u,v,x,y,z\n";
  for (int i = 0; i < 40; ++i)
    table += std::to_string(40 * (i % 8)) + "," + std::to_string(40 * (i / 8)) + "," + std::to_string(0.1 * (i % 8 - 4)) + "," +
             std::to_string(0.1 * (i / 8 - 2)) + ",1\n";
  for (const char* header : {"# u,v,x,y,z\n", "u,v,x,y,z\n", "\"U\",\"V\",\"X\",\"Y\",\"Z\"\n"}) {
    const std::string bytes = header + table.substr(table.find('\n') + 1);
    const RunResult run = run_program({"show", "-", "--size", "320x200"}, {.input = bytes});
    EXPECT_EQ(run.code, 0) << header << run.err;
    EXPECT_TRUE(contains(run.out, "table of rays")) << run.out;
  }
}

}  // namespace
}  // namespace fca::test
