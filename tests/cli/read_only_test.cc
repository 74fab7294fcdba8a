// SPDX-License-Identifier: BSD-3-Clause
// Formats that are only read: the memories of devices, which no program reads from others.
#include "cli/read_rig.h"
#include "cli/run_program.h"
#include "cli/told.h"

namespace fca::test {
namespace {

const std::string kOak = testdata("formats/depthai/good/oak.json");
const std::string kZed = testdata("formats/zed/bad/several-sizes.conf");
const std::string kGopro = testdata("formats/openicc/good/fisheye.json");

TEST(ReadOnly, NoneIsATarget) {
  for (const char* id : {"depthai", "openicc", "zed", "realsense"}) {
    const RunResult run = run_program({"convert", testdata("formats/kalibr/good/ds.yaml"), "--to", id});
    EXPECT_EQ(run.code, 3) << id;
    EXPECT_TRUE(contains(run.err, "does not write it") && contains(run.err, "kalibr")) << run.err;
    EXPECT_TRUE(contains(run_program({"formats"}).out, id));
  }
  const RunResult none = run_program({"convert", kOak});
  EXPECT_EQ(none.code, 3);
  EXPECT_FALSE(contains(none.err, "depthai")) << none.err;
}

TEST(ReadOnly, EachIsConverted) {
  for (const std::string& name : {std::string("depthai/good/oak.json"), std::string("openicc/good/fisheye-with-pose.json"),
                                  std::string("zed/good/SN1.conf"), std::string("realsense/good/d435i.txt")}) {
    for (const char* to : {"kalibr", "opencv", "ros", "basalt"}) {
      const TemporaryFolder out;
      const RunResult run =
          run_program({"convert", testdata("formats/" + name), "--to", to, "--max-angle", "30", "-o", (out / "o") + "/"});
      EXPECT_LE(run.code, 1) << name << " " << to << "\n" << run.out << run.err;
      EXPECT_FALSE(fs::is_empty(fs::path(out / "o"))) << name << " " << to;
    }
  }
}

TEST(ReadOnly, NothingIsWrittenIntoOne) {
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--to", "kalibr"}}) {
    std::vector<std::string> words = {"convert", testdata("formats/kalibr/good/ds.yaml"), "--into", kOak};
    words.insert(words.end(), more.begin(), more.end());
    const RunResult run = run_program(words);
    EXPECT_EQ(run.code, 3) << run.err;
    EXPECT_TRUE(says(run.err, "format-read-only")) << run.err;
  }
}

TEST(ReadOnly, ASettingIsOfTheFileThatIsWritten) {
  const RunResult run =
      run_program({"convert", kGopro, "--to", "kalibr", "--set", "cam0/rostopic=/gopro", "--max-angle", "60"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "/gopro")) << run.out;
}

TEST(ReadOnly, EachIsShownCheckedAndCompared) {
  for (const std::string& file :
       {kOak, kGopro, testdata("formats/zed/good/SN1.conf"), testdata("formats/realsense/good/d435i.txt")}) {
    EXPECT_EQ(run_program({"show", file}).code, 0) << file;
    EXPECT_LE(run_program({"check", file}).code, 1) << file;
    EXPECT_EQ(run_program({"compare", file, file}).code, 0) << file;
  }
}

// One size is told, and those that have several lenses take it.
TEST(ReadOnly, TheSizeIsAskedForWhereALensIsToBeChosen) {
  const RunResult asked = run_program({"convert", kZed, "--to", "kalibr"});
  EXPECT_EQ(asked.code, 2);
  EXPECT_TRUE(says(asked.err, "size-needed", "--size") && contains(asked.err, "1280x720")) << asked.err;
  EXPECT_EQ(run_program({"show", kZed, "--size", "1280x720"}).code, 0);
  EXPECT_EQ(run_program({"convert", kZed, "--size", "1280x720", "--to", "kalibr"}).code, 0);
  EXPECT_EQ(run_program({"show", kZed, "--size", "640x480"}).code, 2);
}

TEST(ReadOnly, ABatchTakesThem) {
  const TemporaryFolder folder;
  const RunResult run = run_program({"convert", kGopro, testdata("formats/openicc/good/pinhole.json"), "--to", "opencv",
                                     "--max-angle", "60", "-o", (folder / "out") + "/"});
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_EQ(static_cast<int>(std::distance(fs::directory_iterator(folder / "out"), fs::directory_iterator())), 2);
}

}  // namespace
}  // namespace fca::test
