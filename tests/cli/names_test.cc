// SPDX-License-Identifier: BSD-3-Clause
// What people type: names of programs for formats, other names of commands, a second input, a unit.
#include "cli/read_rig.h"
#include "cli/run_program.h"
#include "cli/told.h"

#include <fca/formats/consumers/consumer.h>
#include <fca/formats/program_names.h>
#include <fca/formats/text/prose.h>

#include <set>

namespace fca::test {
namespace {

// A name either is a format's or is answered with one that works.
TEST(Names, EveryProgramIsServedOrAnswered) {
  for (const ProgramName& program : all_program_names()) {
    ASSERT_NE(find_format(program.format), nullptr) << program.title;
    for (const std::string_view name : program.names) {
      const std::string typed(name);
      EXPECT_EQ(find_format(typed), nullptr) << typed << " is a format, and needs no other name";
      const RunResult run = run_program({"convert", kTumvi, "--camera", "0", "--max-angle", "40", "--to", typed});
      if (!find_format(program.format)->is_written()) {
        EXPECT_EQ(run.code, 3) << typed;
        EXPECT_TRUE(contains(run.err, std::string(program.title))) << typed << ": " << run.err;
        EXPECT_FALSE(contains(run_program({"show", kTumvi, "--from", typed}).err, "unknown format")) << typed;
        continue;
      }
      if (program.is_served()) {
        EXPECT_NE(run.code, 3) << typed << run.err;
        continue;
      }
      EXPECT_EQ(run.code, 3) << typed;
      for (const std::string& value : {std::string(program.title), "--to " + std::string(program.format)})
        EXPECT_TRUE(contains(run.err, value)) << typed << ": " << run.err;
      const RunResult from = run_program({"show", kTumvi, "--from", typed});
      EXPECT_EQ(from.code, 3) << typed;
      for (const std::string_view value : {program.title, program.reads, program.format})
        EXPECT_TRUE(contains(from.err, std::string(value))) << typed << ": " << from.err;
    }
  }
}

// Half of what is called so is written.
TEST(Names, ANameOfSeveralProgramsIsAnsweredWithBoth) {
  const RunResult isaac = run_program({"convert", kTumvi, "--to", "isaac"});
  for (const char* value : {"--to ros", "isaac-sim"}) EXPECT_TRUE(contains(isaac.err, value)) << isaac.err;
  for (const ProgramName& program : all_program_names()) EXPECT_FALSE(program.is_served() && !program.served_part.empty());
}

TEST(Names, SuggestionsAreNear) {
  const std::vector<std::string> names = {"kalibr", "orbslam3", "ros", "ds", "opencv"};
  const auto nearest = [&names](std::string_view typed) { return text::nearest(typed, names); };
  const auto only = [](std::string name) { return std::vector{std::move(name)}; };
  for (const auto& [typed, meant] : {std::pair{"kalbir", "kalibr"},
                                     {"kal", "kalibr"},
                                     {"klaibr", "kalibr"},
                                     {"orb", "orbslam3"},
                                     {"rost", "ros"},
                                     {"rot", "ros"},
                                     {"opencv-fisheye4", "opencv"}}) {
    EXPECT_EQ(nearest(typed), only(meant)) << typed;
  }
  for (const char* typed : {"foo", "bos", "k", "xy", "colmap", "okvis2", ""}) EXPECT_TRUE(nearest(typed).empty()) << typed;
}

TEST(Names, AnOptionThatIsNearlyOneIsNamed) {
  const RunResult run = run_program({"convert", kTumvi, "--too", "kalibr"});
  EXPECT_EQ(run.code, 3);
  EXPECT_TRUE(contains(run.err, "--to?")) << run.err;
  EXPECT_TRUE(contains(run_program({"convert", kTumvi, "--mdoel", "ds"}).err, "--model?"));
  const RunResult other = run_program({"convert", kTumvi, "--qqqqqq"});
  EXPECT_EQ(other.code, 3);
  EXPECT_TRUE(contains(other.err, "--qqqqqq")) << other.err;
}

TEST(Names, NoneStandsTwice) {
  std::set<std::string> names;
  for (const ProgramName& program : all_program_names()) {
    for (const std::string_view name : program.names) EXPECT_TRUE(names.insert(std::string(name)).second) << name;
  }
}

TEST(Names, AProgramsNameMayMeanALayoutOrASyntax) {
  const Told orbslam2({"convert", kTumvi, "--camera", "0", "--model", "radtan", "--max-angle", "40", "--to", "ORB_SLAM2"});
  EXPECT_TRUE(consumers::find_consumer("orbslam2")->load(orbslam2.bytes(), {"mono"}).loads()) << orbslam2.text();
  // Without a model asked for it is one that the layout holds.
  const Told pair({"convert", kTumvi, "--max-angle", "40", "--to", "orbslam2"});
  EXPECT_TRUE(consumers::find_consumer("orbslam2")->load(pair.bytes(), {"mono"}).loads()) << pair.text();
  const Told dso({"convert", kTumvi, "--camera", "0", "--model", "radtan", "--max-angle", "40", "--to", "dso"});
  EXPECT_TRUE(consumers::find_consumer("dso")->load(dso.bytes(), {}).loads()) << dso.text();
}

// A format that serves several programs calls a file by its own program.
TEST(Names, AFileGoesByItsProgramsName) {
  const std::string settings = testdata("formats/orbslam3/good/orbslam2-tight.yaml");
  const RunResult shown = run_program({"show", settings});
  EXPECT_TRUE(contains(shown.out, "ORB-SLAM2 settings")) << shown.out;
  const RunResult json = run_program({"show", settings, "--from", "orbslam2", "--json"});
  EXPECT_TRUE(contains(json.out, "\"orbslam2\"")) << json.out;
  const Told pair({"convert", kTumvi, "--max-angle", "40", "--to", "orbslam2"});
  EXPECT_STREQ(pair.json()["to"].GetString(), "orbslam2");
  const RunResult txt = run_program({"show", testdata("formats/dso/good/equidistant.txt"), "--from", "dso"});
  EXPECT_TRUE(contains(txt.out, "DSO camera.txt")) << txt.out;
  const RunResult list = run_program({"formats"});
  EXPECT_TRUE(contains(list.out, "ORB-SLAM2 settings") && contains(list.out, "DSO camera.txt")) << list.out;
}

// gsplat reads COLMAP's files, and fewer models than COLMAP.
TEST(Names, AProgramGetsAModelThatItTakes) {
  const TemporaryFolder folder;
  const std::string fov = folder.write("cameras.txt", "1 FOV 640 480 300.0 300.0 320.0 240.0 0.9\n");
  const std::string rational =
      folder.write("full.txt", "1 FULL_OPENCV 640 480 400.0 400.0 320.0 240.0 0.1 0.02 0.0 0.0 0.001 0.3 0.01 0.001\n");
  for (const auto& [file, program] : {std::pair{fov, "gsplat"}, std::pair{rational, "gsplat"}, std::pair{fov, "lichtfeld"}}) {
    const Told told({"convert", file, "--to", program});
    const consumers::Consumer& consumer = *consumers::find_consumer(program);
    EXPECT_TRUE(consumer.load(told.bytes(), {}).loads()) << program << told.text();
    EXPECT_TRUE(contains(told.text(), std::string(consumer.program))) << told.text();
  }
  EXPECT_EQ(run_program({"convert", fov, "--to", "gsplat", "--model", "fov"}).code, 2);
  EXPECT_EQ(run_program({"convert", fov, "--to", "colmap"}).code, 0);
  EXPECT_EQ(run_program({"convert", rational, "--to", "3dgrut"}).code, 0);
}

// An image's size is next to the file, and the user says it.
TEST(Names, AProgramThatLooksAtTheImagesKnowsTheirSize) {
  const TemporaryFolder folder;
  const std::string file = folder.write(
      "transforms.json",
      R"({"fl_x": 500.0, "frames": [{"file_path": "a.png", "transform_matrix": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}]})");
  EXPECT_EQ(run_program({"check", file, "--size", "640x480", "--for", "instant-ngp"}).code, 0);
  EXPECT_EQ(run_program({"check", file, "--size", "640x480", "--for", "nerfstudio"}).code, 1);
}

TEST(Names, CommandsHaveOthersToo) {
  EXPECT_EQ(run_program({"diff", kTumvi, kTumvi}).out, run_program({"compare", kTumvi, kTumvi}).out);
  EXPECT_EQ(run_program({"help", "convert"}).out, run_program({"convert", "--help"}).out);
  EXPECT_EQ(run_program({"undistort", "--help"}).out, run_program({"remap", "--help"}).out);
  EXPECT_EQ(run_program({"help"}).out, run_program({"--help"}).out);
  // A script that wants the first line gets the same of both.
  EXPECT_TRUE(run_program({"version"}).out.starts_with(run_program({"--version"}).out));
}

TEST(Names, AnImuBesideAChainIsAPartOfIt) {
  const Told with({"convert", kTumvi, "--with", kImu, "--to", "orbslam3", "--no-provenance"});
  for (const auto& [first, second] : {std::pair{kTumvi, kImu}, std::pair{kImu, kTumvi}}) {
    const Told beside({"convert", first, second, "--to", "orbslam3", "--no-provenance"});
    EXPECT_EQ(beside.code(), 0) << beside.text();
    EXPECT_EQ(beside.bytes(), with.bytes());
  }
  // Also where several inputs have room.
  const TemporaryFolder out;
  const RunResult run = run_program({"convert", kTumvi, kImu, "--to", "orbslam3", "--no-provenance", "-o", (out / "o") + "/"});
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_EQ(read_file(out / "o/tumvi.orbslam3.yaml"), with.bytes());
  // Two with cameras stay two calibrations.
  EXPECT_EQ(run_program({"convert", kTumvi, testdata("formats/kalibr/good/ds.yaml"), "--to", "opencv"}).code, 3);
}

TEST(Names, AUnitIsForTranslationsWithoutOne) {
  const std::string pair = testdata("formats/opencv/good/stereo-14.yml");
  const std::vector<std::string> words = {"convert", pair, "--size", "640x480", "--to", "kalibr"};
  const auto in_unit = [&words](const char* unit) {
    std::vector<std::string> all = words;
    if (*unit != '\0') all.insert(all.end(), {"--unit", unit});
    return Told(all);
  };
  const Told assumed = in_unit("");
  EXPECT_TRUE(assumed.made_up("translation unit")) << assumed.text();
  const double metres = (*rig_in(assumed.bytes()).resolve("cam1", "cam0"))(0, 3);
  for (const auto& [unit, factor] : {std::pair{"m", 1.0}, {"cm", 1e-2}, {"mm", 1e-3}}) {
    const Told run = in_unit(unit);
    EXPECT_FALSE(run.made_up("translation unit")) << run.text();
    EXPECT_NEAR((*rig_in(run.bytes()).resolve("cam1", "cam0"))(0, 3), factor * metres, 1e-12) << unit;
  }
  EXPECT_EQ(in_unit("inch").code(), 3);
  EXPECT_EQ(run_program({"convert", kTumvi, "--to", "opencv", "--unit", "mm"}).code, 3) << "Kalibr's are metres";
}

// COLMAP's are metres by custom, which no file specifies: they are read so, and an assumption.
TEST(Names, AUnitMayBeToldOfARigOfColmaps) {
  const auto x_in = [](std::vector<std::string> further) {
    const std::string good = "formats/colmap/good/";
    std::vector<std::string> words = {
        "convert", testdata(good + "fisheye-pair.txt"), "--with", testdata(good + "fisheye-pair-rig.json"), "--to", "kalibr"};
    words.insert(words.end(), further.begin(), further.end());
    const Told run(words);
    EXPECT_EQ(run.made_up("translation unit"), further.empty()) << run.text();
    return rig_in(run.bytes()).resolve("cam1", "cam0").value()(0, 3);
  };
  const double metres = x_in({});
  EXPECT_NE(metres, 0.0);
  EXPECT_NEAR(x_in({"--unit", "cm"}), 1e-2 * metres, 1e-12);
}

/// cv::stereoCalibrate's of a board in millimetres: T is 120 long.
std::string pair_in_millimetres() {
  const std::string pair = read_file(testdata("formats/opencv/good/stereo-14.yml"));
  const std::size_t at = pair.find("data:", pair.find("T: !!opencv-matrix"));
  return pair.substr(0, at) + "data: [ -120., 0., 0. ]" + pair.substr(pair.find(']', at) + 1);
}

TEST(Names, AUnitThatIsGivenIsNoQuestion) {
  const TemporaryFolder folder;
  const std::vector<std::string> words = {"convert", folder.write("mm.yml", pair_in_millimetres()), "--size", "640x480", "--to",
                                          "kalibr"};
  const Told refused(words);
  EXPECT_TRUE(refused.says("units-not-stated", "--unit mm"));
  EXPECT_EQ(refused.code(), 1) << "120 m between two cameras are not written";
  std::vector<std::string> in_millimetres = words;
  in_millimetres.insert(in_millimetres.end(), {"--unit", "mm"});
  const Told run(in_millimetres);
  EXPECT_FALSE(run.says("units-not-stated")) << run.text();
  EXPECT_NEAR((*rig_in(run.bytes()).resolve("cam1", "cam0"))(0, 3), -0.12, 1e-12);
}

TEST(Names, AUnitIsThatOfTheFileWithoutOneInAComparison) {
  const TemporaryFolder folder;
  const std::string in_mm = folder.write("mm.yml", pair_in_millimetres());
  const std::vector<std::string> read = {"--size", "640x480", "--unit", "mm"};
  const auto run = [&read](std::vector<std::string> words) {
    words.insert(words.end(), read.begin(), read.end());
    return run_program(words);
  };
  const std::string chain = folder.write("chain.yaml", run({"convert", in_mm, "--to", "kalibr"}).out);
  EXPECT_EQ(run({"compare", chain, in_mm}).code, 0);
  EXPECT_EQ(run({"compare", in_mm, chain}).code, 0);
  EXPECT_EQ(run({"compare", chain, chain}).code, 3);
}

}  // namespace
}  // namespace fca::test
