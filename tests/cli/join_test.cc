// SPDX-License-Identifier: BSD-3-Clause
// --join: what every file specifies is the joined rig's, whichever files the others are.
#include "cli/read_rig.h"
#include "cli/run_program.h"
#include "cli/told.h"

namespace fca::test {
namespace {

const std::string kFront = testdata("formats/woodscape/good/front.json");
const std::string kToolbox = testdata("formats/ocamcalib/good/toolbox.txt");

/// tumvi.yaml's pair with these cam_overlaps.
std::string pair_with(const std::string& of_cam0, const std::string& of_cam1) {
  const std::string pair = with_replaced(read_file(kTumvi), "cam_overlaps: [1]", "cam_overlaps: " + of_cam0);
  return with_replaced(pair, "cam_overlaps: [0]", "cam_overlaps: " + of_cam1);
}

/// The block of cam0.
std::string camera_in(const std::string& chain) {
  const std::size_t begin = chain.find("cam0:");
  return chain.substr(begin, chain.find("cam1:") - begin);
}

/// What cam0, cam1, ... of a chain say, wherever they stand.
std::vector<std::string> overlaps_in(const std::string& chain) {
  std::vector<std::string> result;
  const std::string key = "cam_overlaps: ";
  for (int i = 0;; ++i) {
    const std::size_t camera = chain.find("cam" + std::to_string(i) + ":\n");
    if (camera == std::string::npos) return result;
    const std::size_t at = chain.find(key, camera);
    result.push_back(at == std::string::npos ? "" : chain.substr(at + key.size(), chain.find('\n', at) - at - key.size()));
  }
}

TEST(JoinedChains, CountTheirOverlapsAgain) {
  const TemporaryFolder folder;
  const std::string pair = folder.write("pair.yaml", pair_with("[1]", "[0]"));
  const std::string other = folder.write("other.yaml", with_replaced(pair_with("[1]", "[0]"), "190.97", "191.97"));
  // Comments of the second are lost; nothing else is.
  const RunResult run = run_program({"convert", pair, other, "--join", "--to", "kalibr"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(overlaps_in(run.out), (std::vector<std::string>{"[1]", "[0]", "[3]", "[2]"})) << run.out;
  EXPECT_FALSE(contains(run.err, "cam_overlaps")) << run.err;
  // In another order the same cameras see the same.
  const RunResult swapped = run_program({"convert", pair, other, "--join", "--camera", "3,0,1,2", "--to", "kalibr"});
  EXPECT_EQ(overlaps_in(swapped.out), (std::vector<std::string>{"[3]", "[2]", "[1]", "[0]"})) << swapped.out << swapped.err;
  EXPECT_FALSE(contains(swapped.err, "cam_overlaps")) << swapped.err;
  // Without its partner there is none to speak of, and that is reported.
  const Told without({"convert", pair, other, "--join", "--camera", "0,1,2", "--to", "kalibr"});
  EXPECT_EQ(overlaps_in(without.bytes()), (std::vector<std::string>{"[1]", "[0]", "[]"})) << without.bytes();
  EXPECT_TRUE(without.lost("not-carried", "cam2 cam_overlaps [3]")) << without.text();
}

// Both files call their camera cam0.
TEST(JoinedChains, WhatIsWrongWithACameraIsSaidByItsNameInTheRig) {
  const TemporaryFolder folder;
  const std::string good = folder.write("a.yaml", camera_in(read_file(kTumvi)));
  const std::string wrong =
      folder.write("b.yaml", with_replaced(read_file(good), "resolution: [512, 512]", "resolution: [200, 512]"));
  for (const auto& [files, camera] :
       {std::pair(std::vector{good, wrong}, "cam1"), std::pair(std::vector{wrong, good}, "cam0")}) {
    const Told run({"convert", files[0], files[1], "--join", "--to", "opencv", "--accept", "pose-missing"});
    bool is_named = false;
    for (const auto& reason : run.json()["verdict"]["reasons"].GetArray())
      is_named = is_named || (std::string(reason["code"].GetString()) == "centre-outside" && reason["camera"] == camera);
    EXPECT_TRUE(is_named) << run.text();
  }
}

TEST(JoinedChains, AnEmptyListOfOverlapsIsNoLoss) {
  const TemporaryFolder folder;
  const std::string first = folder.write("first.yaml", camera_in(read_file(kTumvi)));
  const std::string alone =
      folder.write("alone.yaml", with_replaced(read_file(first), "cam_overlaps: [1]", "cam_overlaps: []"));
  const std::string other = folder.write("other.yaml", with_replaced(read_file(alone), "190.97", "191.97"));
  const RunResult run = run_program({"convert", alone, other, "--join", "--to", "kalibr", "--strict"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(overlaps_in(run.out), (std::vector<std::string>{"[]", "[]"})) << run.out;
}

TEST(JoinedFormats, TheOpenCvModelIsOfTheOpenCvFiles) {
  const TemporaryFolder folder;
  const std::string ambiguous =
      folder.write("amb.yml",
                   "%YAML:1.0\n---\nK: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
                   "   data: [ 300., 0., 320., 0., 301., 240., 0., 0., 1. ]\nD: !!opencv-matrix\n   rows: 4\n   cols: 1\n"
                   "   dt: d\n   data: [ 0.01, 0.002, 0.0003, 0.0004 ]\n");
  const std::vector<std::string> words = {"convert", kTumvi, ambiguous, "--join", "--size", "640x480", "--to", "kalibr"};
  EXPECT_TRUE(says(run_program(words).err, "ambiguous-model", "--opencv-model")) << run_program(words).err;
  for (const auto& [meant, id] : {std::pair{"pinhole", "radtan"}, {"fisheye", "kb4"}}) {
    std::vector<std::string> told = words;
    told.insert(told.end(), {"--opencv-model", meant});
    const RunResult run = run_program(told);
    EXPECT_EQ(run.code, 0) << run.err;
    const Rig rig = rig_in(run.out);
    ASSERT_EQ(rig.cameras.size(), 3U);
    EXPECT_EQ(model_info(rig.cameras.back().model).id, id);
  }
  // Of files of which none is OpenCV's it says nothing.
  EXPECT_EQ(run_program({"convert", kTumvi, kDs, "--join", "--to", "kalibr", "--opencv-model", "pinhole"}).code, 3);
}

// A file that already is what is to be written keeps its bytes, whatever stands next to it and wherever.
TEST(JoinedFormats, AFileOfTheTargetsFormatKeepsItsBytes) {
  struct Case {
    const char* to;
    std::string kept;
    std::string fitted;
  };
  for (const Case& row : {Case{"ocamcalib", kToolbox, kFront}, Case{"woodscape", kFront, kToolbox}}) {
    for (const bool first : {true, false}) {
      SCOPED_TRACE(row.to + std::string(first ? " first" : " second"));
      const TemporaryFolder folder;
      const Told run({"convert", first ? row.kept : row.fitted, first ? row.fitted : row.kept, "--join", "--to", row.to,
                      "--max-angle", "60", "-o", folder / "{camera}"});
      EXPECT_EQ(run.code(), 0) << run.text();
      std::vector<std::string> outputs;
      for (const std::string& name : folder.names()) outputs.push_back(read_file(folder / name));
      ASSERT_EQ(outputs.size(), 2U) << run.text();
      EXPECT_EQ(std::ranges::count(outputs, read_file(row.kept)), 1) << run.text();
      EXPECT_FALSE(run.lost("comments-dropped", row.kept)) << run.text();
    }
  }
}

// What stands in a further part is lost whole, and once.
TEST(JoinedFormats, AnImuBesideFilesOfOneCameraIsALoss) {
  const std::string other = testdata("formats/ocamcalib/good/free-layout.txt");
  for (const std::string& second : {other, kFront}) {
    const TemporaryFolder folder;
    const Told run({"convert", kToolbox, second, "--join", "--with", testdata("formats/kalibr/good/imu.yaml"), "--to",
                    "ocamcalib", "--max-angle", "60", "-o", folder / "{camera}"});
    EXPECT_EQ(run.code(), 0) << run.text();
    const auto losses = run.json()["losses"].GetArray();
    EXPECT_EQ(std::ranges::count_if(losses, [](const auto& loss) { return loss["code"] == "imu-dropped"; }), 1) << run.text();
    EXPECT_TRUE(run.lost("imu-dropped", "imu0")) << run.text();
  }
}

// DSO's camera.txt holds one camera: two of them stay two, as they are.
TEST(JoinedFormats, LinesOfDsosStayWhatTheyAre) {
  const TemporaryFolder folder;
  const std::string one = testdata("formats/dso/good/equidistant.txt");
  const std::string two = testdata("formats/dso/good/fov-bare.txt");
  const RunResult run = run_program({"convert", one, two, "--join", "--to", "dso", "-o", folder / "{camera}.txt", "--strict"});
  EXPECT_EQ(run.code, 0) << run.err;
  ASSERT_EQ(folder.names().size(), 2U) << run.out;
  std::multiset<std::string> outputs;
  for (const std::string& name : folder.names()) outputs.insert(read_file(folder / name));
  EXPECT_EQ(outputs, (std::multiset<std::string>{read_file(one), read_file(two)}));
  // With a camera of another format next to them: one line more.
  const RunResult mixed = run_program({"convert", kTumvi, one, "--join", "--to", "dso", "-o", folder / "m/{camera}.txt"});
  EXPECT_EQ(mixed.code, 0) << mixed.err;
  for (const char* camera : {"m/cam0.txt", "m/cam1.txt", "m/cam2.txt"})
    EXPECT_TRUE(read_file(folder / camera).starts_with("EquiDistant ")) << camera << mixed.out;
  EXPECT_EQ(read_file(folder / "m/cam2.txt"), read_file(one));
}

// One camera is one file's: what takes one FILE has nothing to join.
TEST(Join, IsOfferedWhereSeveralFilesAreTaken) {
  for (const char* command : {"convert", "show"})
    EXPECT_TRUE(contains(run_program({command, "--help"}).out, "--join")) << command;
  for (const char* command : {"project", "unproject", "models"}) {
    EXPECT_FALSE(contains(run_program({command, "--help"}).out, "--join")) << command;
    EXPECT_EQ(run_program({command, kTumvi, "--camera", "0", "--join"}).code, 3) << command;
  }
}

}  // namespace
}  // namespace fca::test
