// SPDX-License-Identifier: BSD-3-Clause
// What convert does to the file system: a path holds the old content or the new, nothing else is touched, nothing is left
// behind.
#include "cli/run_program.h"
#include "cli/told.h"

#include <sys/stat.h>

namespace fca::test {
namespace {

const std::string kOld = "an old file\n";

RunResult convert(const std::vector<std::string>& more, const std::string& input = kTumvi) {
  std::vector<std::string> words = {"convert", input, "--to", "orbslam3"};
  words.insert(words.end(), more.begin(), more.end());
  return run_program(words);
}

bool is_settings(const std::string& bytes) {
  return bytes.starts_with("%YAML:1.0\n") && contains(bytes, "Camera.fx") && bytes.ends_with("\n");
}

mode_t mode_of(const std::string& path) {
  struct stat status {};
  EXPECT_EQ(::stat(path.c_str(), &status), 0) << path;
  return status.st_mode & 07777;
}

TEST(OutputFile, IsWrittenAndSaid) {
  const TemporaryFolder folder;
  const RunResult run = convert({"-o", folder / "out.yaml"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(is_settings(read_file(folder / "out.yaml")));
  EXPECT_TRUE(contains(run.out, folder / "out.yaml")) << run.out;
  EXPECT_EQ(folder.names(), std::set<std::string>{"out.yaml"});
}

TEST(OutputFile, IsTheSameOnStandardOutput) {
  const TemporaryFolder folder;
  ASSERT_EQ(convert({"-o", folder / "out.yaml"}).code, 0);
  const RunResult bare = convert({});
  EXPECT_EQ(bare.out, read_file(folder / "out.yaml"));
  EXPECT_TRUE(contains(bare.err, "ORB-SLAM3")) << "the report goes to stderr";
  EXPECT_EQ(convert({"-o", "-"}).out, bare.out);
}

TEST(OutputFile, AnExistingOneIsUntouchedWithoutForce) {
  const TemporaryFolder folder;
  const std::string path = folder.write("out.yaml", kOld);
  const RunResult run = convert({"-o", path});
  EXPECT_EQ(run.code, 4) << run.err;
  EXPECT_TRUE(says(run.err, "cannot-write", "--force")) << run.err;
  EXPECT_EQ(read_file(path), kOld);
  EXPECT_EQ(folder.names(), std::set<std::string>{"out.yaml"});
  EXPECT_FALSE(contains(run.out, path));
}

TEST(OutputFile, AnExistingOneIsReplacedWithForceAndKeepsItsPermissions) {
  for (const mode_t mode : {0600U, 0644U, 0664U, 0755U}) {
    const TemporaryFolder folder;
    const std::string path = folder.write("out.yaml", kOld);
    ::chmod(path.c_str(), mode);
    EXPECT_EQ(convert({"-o", path, "--force"}).code, 0);
    EXPECT_TRUE(is_settings(read_file(path)));
    EXPECT_EQ(mode_of(path), mode);
    EXPECT_EQ(folder.names(), std::set<std::string>{"out.yaml"});
  }
}

TEST(OutputFile, ANewOneHasTheUsersMask) {
  const TemporaryFolder folder;
  const mode_t mask = ::umask(027);
  EXPECT_EQ(convert({"-o", folder / "out.yaml"}).code, 0);
  ::umask(mask);
  EXPECT_EQ(mode_of(folder / "out.yaml"), 0640U);
}

TEST(OutputFile, ASymbolicLinkIsWrittenThrough) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "elsewhere");
  const std::string target = folder.write("elsewhere/real.yaml", kOld);
  fs::create_symlink(target, folder / "link.yaml");
  EXPECT_EQ(convert({"-o", folder / "link.yaml"}).code, 4);
  EXPECT_EQ(read_file(target), kOld);
  EXPECT_EQ(convert({"-o", folder / "link.yaml", "--force"}).code, 0);
  EXPECT_TRUE(fs::is_symlink(folder / "link.yaml"));
  EXPECT_TRUE(is_settings(read_file(target)));
}

// The link says where the file is wanted, also before there is one.
TEST(OutputFile, ADanglingLinkIsWrittenThrough) {
  const TemporaryFolder folder;
  fs::create_symlink(folder / "later.yaml", folder / "link.yaml");
  const RunResult run = convert({"-o", folder / "link.yaml"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(fs::is_symlink(folder / "link.yaml"));
  EXPECT_TRUE(is_settings(read_file(folder / "later.yaml")));
}

TEST(OutputFile, OutputMayBeTheInputWithForce) {
  const TemporaryFolder folder;
  const std::string path = folder.write("chain.yaml", read_file(kTumvi));
  EXPECT_EQ(convert({"-o", path}, path).code, 4);
  EXPECT_EQ(read_file(path), read_file(kTumvi));
  EXPECT_EQ(convert({"-o", path, "--force"}, path).code, 0);
  EXPECT_TRUE(is_settings(read_file(path)));
  EXPECT_EQ(folder.names(), std::set<std::string>{"chain.yaml"});
}

TEST(OutputFile, AMissingFolderIsAnErrorUnlessNamedAsOne) {
  const TemporaryFolder folder;
  const RunResult run = convert({"-o", folder / "no/such/out.yaml"});
  EXPECT_EQ(run.code, 4) << run.err;
  EXPECT_TRUE(says(run.err, "cannot-write", "no/such/out.yaml")) << run.err;
  EXPECT_TRUE(folder.names().empty());
  EXPECT_EQ(convert({"-o", folder / "new/"}).code, 0);
  EXPECT_TRUE(is_settings(read_file(folder / "new/tumvi.orbslam3.yaml")));
  EXPECT_EQ(convert({"-o", folder / "two/{format}/{stem}.yaml"}).code, 0);
  EXPECT_TRUE(is_settings(read_file(folder / "two/orbslam3/tumvi.yaml")));
}

TEST(OutputFile, ANameOfAnotherSyntaxIsNoted) {
  const TemporaryFolder folder;
  const RunResult run = convert({"-o", folder / "out.xml"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(says(run.err, "extension", "out.xml")) << run.err;
  EXPECT_FALSE(says(convert({"-o", folder / "out.yaml"}).err, "extension"));
}

TEST(OutputFile, TheHintOfAPatternHasTheFilesExtension) {
  const TemporaryFolder folder;
  for (const auto& [to, extension] : {std::pair("woodscape", ".json"), {"ocamcalib", ".txt"}}) {
    const RunResult run = run_program(
        {"convert", testdata("formats/kalibr/good/tumvi.yaml"), "--to", to, "--max-angle", "80", "-o", folder / "one"});
    EXPECT_EQ(run.code, 3) << run.err;
    EXPECT_TRUE(says(run.err, "one-camera-per-file", std::string("{stem}.{camera}") + extension)) << run.err;
  }
}

// Datasets have one calib.yaml per folder: what is proposed then is a pattern that tells them apart, or what always does.
TEST(OutputFile, InputsOfOneNameAreToldApartByTheirFolders) {
  const TemporaryFolder folder;
  for (const char* name : {"a", "b", "a/c", "b/c"}) fs::create_directory(folder / name);
  for (const char* name : {"a/x.yaml", "b/x.yaml", "a/c/x.yaml", "b/c/x.yaml"}) folder.write(name, read_file(kTumvi));
  for (const char* to : {"orbslam3", "woodscape"}) {
    std::vector<std::string> words = {"convert", folder / "a/x.yaml", folder / "b/x.yaml", "--to", to, "--max-angle", "80",
                                      "-o"};
    std::vector<std::string> into_folder = words;
    into_folder.push_back(folder / "out/");
    const RunResult refused = run_program(into_folder);
    EXPECT_EQ(refused.code, 3) << refused.err;
    const std::size_t begin = refused.err.find("'out/");
    ASSERT_NE(begin, std::string::npos) << refused.err;
    const std::string pattern = refused.err.substr(begin + 1, refused.err.find('\'', begin + 1) - begin - 1);
    words.push_back(folder / pattern);
    const RunResult run = run_program(words);
    EXPECT_EQ(run.code, 0) << run.err;
  }
  EXPECT_EQ(folder.names(), (std::set<std::string>{"a", "b", "out"}));
  EXPECT_TRUE(is_settings(read_file(folder / "out/b.x.yaml")));
  const RunResult same = run_program(
      {"convert", folder / "a/c/x.yaml", folder / "b/c/x.yaml", "--to", "orbslam3", "-o", folder / "{folder}.{stem}.yaml"});
  EXPECT_EQ(same.code, 3) << same.err;
  EXPECT_TRUE(contains(same.err, "-o") && !contains(same.err, "{")) << "no pattern tells them apart: " << same.err;
}

TEST(OutputFile, AFolderGetsANameOfItsOwn) {
  const TemporaryFolder folder;
  EXPECT_EQ(convert({"-o", folder.path().string()}).code, 0);
  EXPECT_EQ(folder.names(), std::set<std::string>{"tumvi.orbslam3.yaml"});
}

TEST(OutputFile, AFolderOrAFileThatCannotBeWrittenIsAnError) {
  if (::geteuid() == 0) GTEST_SKIP() << "root writes everywhere";
  const TemporaryFolder folder;
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_EQ(convert({"-o", folder / "out.yaml"}).code, 4);
  fs::permissions(folder.path(), fs::perms::owner_all);
  EXPECT_TRUE(folder.names().empty());
}

// To rename a file over it needs a right to the folder alone.
TEST(OutputFile, AWriteProtectedFileIsKept) {
  const TemporaryFolder folder;
  const std::string path = folder.write("out.yaml", kOld);
  fs::permissions(path, fs::perms::owner_read);
  const RunResult run = convert({"-o", path, "--force"});
  EXPECT_EQ(run.code, 4);
  EXPECT_TRUE(says(run.err, "cannot-write")) << run.err;
  EXPECT_EQ(read_file(path), kOld);
  EXPECT_EQ(folder.names(), std::set<std::string>{"out.yaml"});
}

TEST(OutputFile, AnotherHardLinkKeepsTheOldText) {
  const TemporaryFolder folder;
  const std::string path = folder.write("out.yaml", kOld);
  fs::create_hard_link(path, folder / "other.yaml");
  EXPECT_EQ(convert({"-o", path, "--force"}).code, 0);
  EXPECT_EQ(read_file(folder / "other.yaml"), kOld);
  EXPECT_NE(read_file(path), kOld);
}

TEST(OutputFile, PathsThatLeadNowhereAreInputOutput) {
  const TemporaryFolder folder;
  fs::create_symlink("loop", folder.path() / "loop");
  for (const std::string& path : {folder / "loop", folder / std::string(5000, 'a'), folder / "loop/out.yaml"}) {
    const RunResult run = convert({"-o", path});
    EXPECT_EQ(run.code, 4) << path << run.err;
    EXPECT_TRUE(says(run.err, "cannot-write")) << run.err;
  }
  EXPECT_EQ(folder.names(), std::set<std::string>{"loop"});
}

// A second file that cannot be written takes the first with it.
TEST(OutputFile, SeveralFilesAreWrittenAllOrNone) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "imu.yaml");
  const RunResult run =
      run_program({"convert", kTumvi, "--with", kImu, "--to", "kalibr", "--model", "ds", "-o", folder.path().string()});
  EXPECT_EQ(run.code, 4) << run.err;
  EXPECT_EQ(folder.names(), std::set<std::string>{"imu.yaml"});
}

TEST(OutputFile, AFileInTheWayOfAFolderIsAnError) {
  const TemporaryFolder folder;
  const std::string path = folder.write("file", kOld);
  EXPECT_EQ(convert({"-o", path + "/out.yaml", "--force"}).code, 4);
  EXPECT_EQ(convert({"-o", path + "/", "--force"}).code, 4);
  EXPECT_EQ(read_file(path), kOld);
}

TEST(OutputFile, DryRunWritesNothing) {
  const TemporaryFolder folder;
  const RunResult run = convert({"-o", folder / "out.yaml", "--dry-run"});
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(folder.names().empty());
  EXPECT_TRUE(contains(run.out, "cam0")) << run.out;
}

TEST(OutputFile, ARejectedFileIsNotWrittenAndTheOldIsKept) {
  const TemporaryFolder folder;
  const std::string old = folder.write("old.yaml", kOld);
  // A time offset, which ORB-SLAM3 does not hold; and lenses that it holds with an error.
  const std::string model = "  distortion_model: equidistant\n";
  const TemporaryFolder inputs;
  const std::string delayed =
      inputs.write("delayed.yaml", with_replaced(read_file(kTumvi), model, model + "  timeshift_cam_imu: 0.01\n"));
  for (const auto& [limit, code] : {std::pair{std::vector<std::string>{"--max-error", "1e-9"}, "error-limit"},
                                    std::pair{std::vector<std::string>{"--strict"}, "strict-loss"}}) {
    for (const std::string& path : {old, folder / "new.yaml"}) {
      std::vector<std::string> words = {"-o", path, "--force"};
      words.insert(words.end(), limit.begin(), limit.end());
      words.insert(words.end(), {"--with", kImu});
      const RunResult run = convert(words, code == std::string("strict-loss") ? delayed : kDs);
      EXPECT_EQ(run.code, 1) << limit[0] << run.err;
      EXPECT_TRUE(contains(run.out + run.err, "[" + std::string(code) + "]")) << run.out << run.err;
      words.emplace_back("--json");
      rapidjson::Document json;
      json.Parse(convert(words, code == std::string("strict-loss") ? delayed : kDs).out.c_str());
      ASSERT_FALSE(json.HasParseError());
      EXPECT_TRUE(json["outputs"].Empty()) << "what is said to be written; in words: golden/convert.txt";
      EXPECT_EQ(json["refused_outputs"].Size(), 1U);
    }
  }
  EXPECT_EQ(read_file(old), kOld);
  EXPECT_EQ(folder.names(), std::set<std::string>{"old.yaml"});
  const RunResult piped = convert({"--strict", "--with", kImu}, delayed);
  EXPECT_EQ(piped.code, 1);
  EXPECT_EQ(piped.out, "") << "a rejected file must not go to a pipe either";
}

TEST(OutputFile, SeveralInputsGoIntoAFolder) {
  const TemporaryFolder folder;
  const RunResult run = run_program({"convert", kTumvi, kDs, "--to", "orbslam3", "-o", folder / "out/"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(is_settings(read_file(folder / "out/tumvi.orbslam3.yaml")));
  EXPECT_TRUE(is_settings(read_file(folder / "out/ds.orbslam3.yaml")));
  const RunResult pattern =
      run_program({"convert", kTumvi, kDs, "--to", "orbslam3", "-o", folder / "{format}-{stem}-{camera}.yaml"});
  EXPECT_EQ(pattern.code, 0) << pattern.err;
  EXPECT_TRUE(fs::exists(folder / "orbslam3-ds-cam0-cam1.yaml")) << pattern.out;
  EXPECT_EQ(run_program({"convert", kTumvi, kDs, "--to", "orbslam3"}).code, 3);
  EXPECT_EQ(run_program({"convert", kTumvi, kDs, "--to", "orbslam3", "-o", folder / "one.yaml"}).code, 3);
}

TEST(OutputFile, OfSeveralInputsTheGoodOnesAreWritten) {
  const TemporaryFolder folder;
  const std::string empty = folder.write("empty.yaml", "");
  const RunResult run = run_program({"convert", empty, kTumvi, "--to", "orbslam3", "-o", folder / "out/"});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(is_settings(read_file(folder / "out/tumvi.orbslam3.yaml")));
  EXPECT_FALSE(fs::exists(folder / "out/empty.orbslam3.yaml"));
}

TEST(OutputFile, CollisionsAreRefusedBeforeAnythingIsWritten) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "a");
  const std::string twin = folder.write("a/tumvi.yaml", read_file(kTumvi));
  for (const std::string& output : {folder / "out/", folder / "{format}.yaml"}) {
    const RunResult run = run_program({"convert", kTumvi, twin, "--to", "orbslam3", "-o", output, "--force"});
    EXPECT_EQ(run.code, 3) << run.err;
    EXPECT_TRUE(contains(run.err, kTumvi) && contains(run.err, twin)) << run.err;
  }
  // The same file under two spellings of its path.
  const RunResult spelled =
      run_program({"convert", kTumvi, twin, "--to", "orbslam3", "-o", folder / "{camera}/../x.yaml", "--force"});
  EXPECT_NE(spelled.code, 0);
  EXPECT_EQ(folder.names(), std::set<std::string>{"a"});
}

// Who gives an IMU's file means it: it is not left out because one file was named.
TEST(OutputFile, AnImuThatWasGivenWantsAFolder) {
  const TemporaryFolder folder;
  for (const char* format : {"kalibr", "openvins"}) {
    const RunResult run = run_program({"convert", kTumvi, "--with", kImu, "--to", format, "-o", folder / "out.yaml"});
    EXPECT_EQ(run.code, 3) << format << run.err;
    EXPECT_TRUE(says(run.err, "one-output", "-o FOLDER/")) << run.err;
  }
  EXPECT_TRUE(folder.names().empty());
  EXPECT_EQ(run_program({"convert", kTumvi, "--with", kImu, "--to", "openvins", "-o", folder.path().string()}).code, 0);
  EXPECT_EQ(folder.names(), (std::set<std::string>{"kalibr_imu_chain.yaml", "kalibr_imucam_chain.yaml"}));
}

TEST(OutputFile, TheImuOfACamchainGoesBesideIt) {
  const TemporaryFolder folder;
  const std::string settings = testdata("formats/orbslam3/good/v1-stereo-inertial.yaml");
  const RunResult run = run_program({"convert", settings, "--to", "kalibr", "-o", folder / "out/"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(read_file(folder / "out/imu.yaml"), "accelerometer_noise_density")) << run.out;
  EXPECT_TRUE(contains(read_file(folder / "out/camchain.yaml"), "camera_model")) << run.out;
  // With one output there is no room for it, and that is a loss.
  const Told piped({"convert", settings, "--to", "kalibr", "--strict"});
  EXPECT_EQ(piped.code(), 1);
  EXPECT_TRUE(piped.lost("second-file-dropped", "imu.yaml")) << piped.text();
}

}  // namespace
}  // namespace fca::test
