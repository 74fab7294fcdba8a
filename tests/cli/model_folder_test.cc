// SPDX-License-Identifier: BSD-3-Clause
// Folders of COLMAP's models: what is written into one, which of its files is read, and that an edit changes its cameras alone.
#include "cli/read_rig.h"
#include "cli/run_program.h"
#include "cli/told.h"

#include <fca/rig/rotation.h>

namespace fca::test {
namespace {

std::string good(const std::string& name) { return read_file(testdata("formats/colmap/good/" + name)); }

/// The files of a folder by their names.
std::map<std::string, std::string> files_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    files.emplace(entry.path().filename().string(), read_file(entry.path()));
  return files;
}

/// A model whose images no program of ours understands.
void write_model(const TemporaryFolder& folder, const std::string& extension, const std::string& cameras) {
  folder.write("cameras" + extension, good(cameras));
  folder.write("images" + extension, "somebody's images\n");
  folder.write("points3D" + extension, "somebody's points\n");
}

TEST(ModelFolder, IsWrittenAsColmapOpensIt) {
  const TemporaryFolder folder;
  const std::string out = (folder / "model") + "/";
  EXPECT_EQ(run_program({"convert", kTumvi, "--to", "colmap", "-o", out}).code, 0);
  std::set<std::string> names;
  for (const auto& [name, bytes] : files_in(out)) names.insert(name);
  EXPECT_EQ(names, (std::set<std::string>{"cameras.txt", "images.txt", "points3D.txt", "rig_config.json", "rigs.txt"}));
  // And back, with its poses.
  const RunResult back = run_program({"convert", out, "--to", "kalibr", "-o", "-"});
  EXPECT_EQ(back.code, 0) << back.err;
  const Rig rig = rig_in(back.out);
  EXPECT_EQ(rig.cameras.size(), 2U);
  EXPECT_TRUE(rig.resolve("cam1", "cam0"));
}

// However the folder is written: no hidden ".kalibr.yaml".
TEST(ModelFolder, GivesWhatIsWrittenItsName) {
  const TemporaryFolder folder;
  const std::string model = folder / "model";
  EXPECT_EQ(run_program({"convert", kTumvi, "--to", "colmap", "-o", model + "/"}).code, 0);
  for (const std::string& word : {model, model + "/", model + "/."}) {
    const fs::path out = folder.path() / "out";
    const RunResult run = run_program({"convert", word, "--to", "kalibr", "-o", out.string() + "/"});
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(files_in(out).contains("model.kalibr.yaml")) << word;
    fs::remove_all(out);
  }
}

// What is kept and what is converted alike.
TEST(ModelFolder, WrittenElsewhereItKeepsItsPoses) {
  const TemporaryFolder folder;
  const std::string model = (folder / "model") + "/";
  EXPECT_EQ(run_program({"convert", kTumvi, "--to", "colmap", "-o", model}).code, 0);
  const std::string own_line = "# somebody's\n" + read_file(fs::path(model) / "cameras.txt");
  fs::remove(fs::path(model) / "cameras.txt");
  folder.write("model/cameras.txt", own_line);
  fs::remove(fs::path(model) / "rig_config.json");
  const auto before = files_in(model);
  for (const std::vector<std::string>& fit : {std::vector<std::string>(), {"--model", "eucm"}}) {
    const std::string out = folder / ("out" + std::to_string(fit.size())) + "/";
    std::vector<std::string> words = {"convert", model, "--to", "colmap", "-o", out};
    words.insert(words.end(), fit.begin(), fit.end());
    const RunResult run = run_program(words);
    ASSERT_EQ(run.code, 0) << run.err << run.out;
    EXPECT_TRUE(files_in(out).at("cameras.txt").starts_with("# somebody's\n"));
    const Rig was = rig_in(run_program({"convert", model, "--to", "kalibr", "-o", "-"}).out);
    const Rig now = rig_in(run_program({"convert", out, "--to", "kalibr", "-o", "-"}).out);
    ASSERT_TRUE(was.resolve("cam1", "cam0") && now.resolve("cam1", "cam0"));
    EXPECT_LT(largest_difference(*was.resolve("cam1", "cam0"), *now.resolve("cam1", "cam0")).distance, 1e-15);
    EXPECT_EQ(files_in(model), before);
  }
  // With the rigs' own numbers and comments, into its own folder, too.
  folder.write("model/rigs.txt", "# somebody's rig\n7" + before.at("rigs.txt").substr(before.at("rigs.txt").rfind("\n1 ") + 2));
  const std::string rigs = files_in(model).at("rigs.txt");
  for (const std::string& out : {folder / "again/", model})
    EXPECT_EQ(run_program({"convert", model, "--to", "colmap", "--force", "-o", out}).code, 0) << out;
  EXPECT_EQ(files_in(folder.path() / "again").at("rigs.txt"), rigs);
  EXPECT_EQ(files_in(model).at("rigs.txt"), rigs);
  EXPECT_FALSE(files_in(model).contains("rig_config.json"));
  // In one file there is no place for them.
  const Told alone({"convert", model, "--to", "colmap", "-o", folder / "cameras.txt"});
  EXPECT_STREQ(alone.json()["verdict"]["word"].GetString(), "use-with-care");
}

TEST(ModelFolder, ACameraAloneHasNoRigs) {
  const TemporaryFolder folder;
  const std::string out = (folder / "model") + "/";
  EXPECT_EQ(run_program({"convert", kTumvi, "--camera", "cam0", "--to", "colmap", "-o", out}).code, 0);
  EXPECT_EQ(files_in(out).size(), 3U);
  EXPECT_TRUE(files_in(out).contains("points3D.txt"));
}

// Images that are there are somebody's.
TEST(ModelFolder, ImagesAreNeverWrittenOver) {
  const TemporaryFolder folder;
  folder.write("images.txt", "somebody's images\n");
  EXPECT_EQ(
      run_program({"convert", kTumvi, "--camera", "cam0", "--to", "colmap", "--force", "-o", folder.path().string()}).code, 0);
  EXPECT_EQ(files_in(folder.path()).at("images.txt"), "somebody's images\n");
  EXPECT_TRUE(files_in(folder.path()).contains("cameras.txt"));
}

// COLMAP opens one of them: the other would be written for nobody.
TEST(ModelFolder, TextIsNotWrittenBesideBinaryNorBinaryBesideText) {
  for (const auto& [there, written] : {std::pair(".bin", ".txt"), std::pair(".txt", ".bin")}) {
    const TemporaryFolder folder;
    write_model(folder, there, "pinhole" + std::string(there));
    const auto before = files_in(folder.path());
    const std::string out = folder / ("cameras" + std::string(written));
    const RunResult run = run_program({"convert", kTumvi, "--camera", "cam0", "--to", "colmap", "--force", "-o", out});
    EXPECT_EQ(run.code, 3) << run.out << run.err;
    EXPECT_NE(run.err.find("other-form-in-folder"), std::string::npos) << run.err;
    EXPECT_EQ(files_in(folder.path()), before);
  }
}

// Of several inputs each has a file of its own there.
TEST(ModelFolder, ABatchIsNoModel) {
  const TemporaryFolder folder;
  folder.write("a.txt", good("pinhole.txt"));
  folder.write("b.txt", good("opencv.txt"));
  const std::string out = (folder / "out") + "/";
  EXPECT_EQ(run_program({"convert", folder / "a.txt", folder / "b.txt", "--rewrite", "--to", "colmap", "-o", out}).code, 0);
  const auto files = files_in(out);
  EXPECT_EQ(files.size(), 2U);
  EXPECT_TRUE(files.contains("a.colmap.txt"));
}

// A pattern that ends with a slash is a folder for each.
TEST(ModelFolder, APatternGivesEachInputAFolder) {
  const TemporaryFolder folder;
  folder.write("a.txt", good("pinhole.txt"));
  folder.write("b.txt", good("opencv.txt"));
  const std::string out = folder / "out/{stem}/";
  EXPECT_EQ(run_program({"convert", folder / "a.txt", folder / "b.txt", "--rewrite", "--to", "colmap", "-o", out}).code, 0);
  for (const char* stem : {"a", "b"}) {
    const auto files = files_in(folder / ("out/" + std::string(stem)));
    EXPECT_EQ(files.size(), 3U) << stem;
    EXPECT_TRUE(files.contains("cameras.txt") && files.contains("images.txt")) << stem;
  }
}

// A program of lenses alone opens no file of rigs.
TEST(ModelFolder, IsCheckedAsItsProgramOpensIt) {
  const TemporaryFolder folder;
  const std::string out = (folder / "model") + "/";
  EXPECT_EQ(run_program({"convert", kTumvi, "--to", "colmap", "-o", out}).code, 0);
  for (const auto& [program, files] : {std::pair("colmap", 3U), {"gsplat", 1U}, {"lichtfeld", 1U}}) {
    const Told check({"check", out, "--for", program});
    EXPECT_EQ(check.code(), 0) << check.text();
    EXPECT_EQ(check.json()["files"].Size(), files) << check.text();
  }
  EXPECT_EQ(run_program({"check", out + "rig_config.json", "--for", "gsplat"}).code, 1);
}

TEST(ModelFolder, BinaryWinsOverText) {
  const TemporaryFolder folder;
  write_model(folder, ".txt", "fov.txt");
  write_model(folder, ".bin", "pinhole.bin");
  const RunResult run = run_program({"convert", folder.path().string(), "--to", "kalibr", "-o", "-"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(parameter(rig_in(run.out).cameras.at(0).model, "fx"), 500.5);
  // COLMAP opens what is whole.
  fs::remove(folder / "points3D.bin");
  const RunResult text = run_program({"convert", folder.path().string(), "--to", "colmap", "-o", "-"});
  EXPECT_EQ(text.out, good("fov.txt")) << text.err;
}

TEST(ModelFolder, AnEditChangesItsCamerasAlone) {
  for (const char* extension : {".bin", ".txt"}) {
    const TemporaryFolder folder;
    write_model(folder, extension, "pinhole" + std::string(extension));
    const auto before = files_in(folder.path());
    const TemporaryFolder input;
    input.write("other.txt", "1 PINHOLE 640 480 512.0 513.0 320.5 240.25\n");
    const RunResult run = run_program({"convert", input / "other.txt", "--into", folder.path().string(), "--in-place"});
    EXPECT_EQ(run.code, 0) << run.err << run.out;
    const auto after = files_in(folder.path());
    ASSERT_EQ(after.size(), before.size());
    for (const auto& [name, bytes] : after) {
      if (name.starts_with("cameras")) {
        EXPECT_NE(bytes, before.at(name)) << name;
        EXPECT_TRUE(name.ends_with(".txt") || bytes.size() == before.at(name).size()) << name;
      } else {
        EXPECT_EQ(bytes, before.at(name)) << name;
      }
    }
  }
}

TEST(ModelFolder, BinaryIsWrittenByItsExtension) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_program({"convert", testdata("formats/colmap/good/lenses.bin"), "--to", "colmap", "-o", folder / "a.txt"}).code,
            0);
  EXPECT_EQ(run_program({"convert", folder / "a.txt", "--to", "colmap", "-o", folder / "a.bin"}).code, 0);
  EXPECT_EQ(read_file(folder / "a.bin"), good("lenses.bin"));
}

// A folder of binary files is named by its cameras.
TEST(ModelFolder, IsWrittenInBinaryByTheNameOfItsCameras) {
  const TemporaryFolder folder;
  const RunResult run = run_program({"convert", kTumvi, "--to", "colmap", "-o", folder / "cameras.bin"});
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  std::set<std::string> names;
  for (const auto& [name, bytes] : files_in(folder.path())) names.insert(name);
  EXPECT_EQ(names, (std::set<std::string>{"cameras.bin", "images.bin", "points3D.bin", "rig_config.json", "rigs.bin"}));
  const RunResult back = run_program({"convert", folder.path().string(), "--to", "kalibr", "-o", "-"});
  EXPECT_EQ(back.code, 0) << back.err;
  EXPECT_TRUE(rig_in(back.out).resolve("cam1", "cam0"));
}

TEST(ModelFolder, ShowReadsCamerasThatAreAlone) {
  const TemporaryFolder folder;
  folder.write("cameras.txt", good("fov.txt"));
  const RunResult run = run_program({"show", folder.path().string()});
  EXPECT_EQ(run.code, 0) << run.err;
}

TEST(ModelFolder, GsplatGetsAModelThatItTakes) {
  const TemporaryFolder folder;
  const std::string input = folder.write("in.txt", "1 SIMPLE_RADIAL_FISHEYE 640 480 300 320 240 0\n");
  const RunResult run = run_program({"convert", input, "--to", "gsplat", "-o", "-"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("1 OPENCV_FISHEYE "), std::string::npos) << run.out;
}

// There are no lines in it.
TEST(ModelFolder, PlacesInBinaryFilesAreBytes) {
  const std::string bad = testdata("formats/colmap/bad/fx-nan.bin");
  const RunResult run = run_program({"check", bad});
  EXPECT_NE((run.out + run.err).find(bad + ":byte 88: error"), std::string::npos) << run.out << run.err;
  const RunResult json = run_program({"check", "--json", bad});
  EXPECT_NE(json.out.find("\"byte\": 88"), std::string::npos) << json.out;
}

}  // namespace
}  // namespace fca::test
