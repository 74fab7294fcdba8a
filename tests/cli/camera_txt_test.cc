// SPDX-License-Identifier: BSD-3-Clause
// DSO's camera.txt through the command: it stays what it is, or nothing is written.
#include "cli/run_program.h"
#include "cli/told.h"

namespace fca::test {
namespace {

const std::string kEquidistant = testdata("formats/dso/good/equidistant.txt");
const std::string kFov = testdata("formats/dso/good/fov-bare.txt");

TEST(CameraTxt, AnotherModelIsAnotherLineOfDsos) {
  const TemporaryFolder folder;
  const std::string file = folder.write("camera.txt", read_file(kEquidistant));
  const Told run({"convert", file, "--into", file, "--in-place", "--model", "fov", "--max-angle", "60"});
  EXPECT_EQ(run.code(), 0) << run.text();
  EXPECT_TRUE(run.loads()) << run.text();
  const std::string after = read_file(file);
  EXPECT_TRUE(after.starts_with("FOV ")) << after;
  EXPECT_EQ(after.substr(after.find('\n')), read_file(kEquidistant).substr(read_file(kEquidistant).find('\n')));
}

TEST(CameraTxt, TheInputsLensGoesInto) {
  for (const std::string& input : {kFov, testdata("formats/dso/good/radtan-bare.txt")}) {
    const RunResult other_size = run_program({"convert", input, "--into", kEquidistant});
    EXPECT_EQ(other_size.code, 2) << other_size.err;
    const std::string size = input == kFov ? "1280x1024" : "752x480";
    const Told run({"convert", input, "--into", kEquidistant, "--resize", size});
    EXPECT_EQ(run.code(), 0) << run.text();
    EXPECT_TRUE(run.bytes().starts_with(input == kFov ? "FOV " : "RadTan ")) << run.bytes();
    EXPECT_TRUE(run.json()["cameras"][0]["exact"].GetBool()) << run.text();
  }
  // A model that DSO does not know takes the base's.
  const RunResult run = run_program({"convert", kDs, "--camera", "cam0", "--into", kEquidistant, "--max-angle", "80"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with("EquiDistant ")) << run.out;
}

TEST(CameraTxt, WhatDoesNotFitIsRefused) {
  const TemporaryFolder folder;
  const std::string base = folder.write("camera.txt", read_file(kEquidistant));
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{kTumvi}, {kTumvi, "--camera", "cam0", "--model", "mei", "--max-angle", "97.5"}}) {
    std::vector<std::string> all = {"convert", "--into", base, "--in-place"};
    all.insert(all.end(), words.begin(), words.end());
    const RunResult run = run_program(all);
    const bool is_of_two = words.size() == 1;
    EXPECT_EQ(run.code, is_of_two ? 3 : 2) << run.err << run.out;
    EXPECT_TRUE(says(run.err, is_of_two ? "one-camera-per-file" : "into-another-layout")) << run.err;
    EXPECT_EQ(read_file(base), read_file(kEquidistant));
  }
}

TEST(CameraTxt, IsWrittenByItsName) {
  const TemporaryFolder folder;
  const Told one({"convert", kTumvi, "--camera", "cam0", "--to", "tumvi", "-o", folder / "camera.txt"});
  EXPECT_EQ(one.code(), 0) << one.text();
  EXPECT_TRUE(read_file(folder / "camera.txt").starts_with("EquiDistant 190.9"));
  EXPECT_TRUE(one.loads()) << one.text();
  EXPECT_STREQ(one.json()["proof"][0]["program"].GetString(), "DSO (camera.txt)");
  // It holds one camera: a pair is two of them, and never YAML under its name.
  const RunResult two = run_program({"convert", kTumvi, "--to", "tumvi", "-o", folder / "two.txt"});
  EXPECT_EQ(two.code, 3) << two.err;
  EXPECT_TRUE(says(two.err, "one-camera-per-file")) << two.err;
  const Told each({"convert", kTumvi, "--to", "tumvi", "-o", folder / "{camera}.txt"});
  EXPECT_EQ(each.code(), 0) << each.text();
  EXPECT_TRUE(read_file(folder / "cam0.txt").starts_with("EquiDistant 190.9"));
  EXPECT_TRUE(read_file(folder / "cam1.txt").starts_with("EquiDistant 190.4"));
  EXPECT_TRUE(each.lost("pose-dropped", "T_cam1_cam0")) << each.text();
}

}  // namespace
}  // namespace fca::test
