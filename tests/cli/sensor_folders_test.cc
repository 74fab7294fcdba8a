// SPDX-License-Identifier: BSD-3-Clause
// Folders of sensors' files: EuRoC's mav0 and Kimera-VIO's parameters are one rig, and are written as their programs look for
// them.
#include "cli/read_rig.h"
#include "cli/run_program.h"
#include "cli/told.h"

namespace fca::test {
namespace {

/// The regular files below a folder, by their paths in it.
std::set<std::string> files_below(const fs::path& folder) {
  std::set<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.insert(fs::relative(entry.path(), folder).string());
  }
  return files;
}

/// A folder of Kimera's parameters, of our own files.
std::string kimera_folder(const TemporaryFolder& folder) {
  const std::string good = "formats/kimera/good/";
  folder.write("LeftCameraParams.yaml", read_file(testdata(good + "left.yaml")));
  folder.write("RightCameraParams.yaml", read_file(testdata(good + "right-crlf.yaml")));
  folder.write("ImuParams.yaml", read_file(testdata(good + "imu.yaml")));
  return folder.path().string();
}

/// A dataset of EuRoC's.
std::string euroc_folder(const TemporaryFolder& folder) {
  const std::string good = "formats/euroc/good/";
  for (const auto& [name, file] : {std::pair("cam0", "cam0.yaml"), {"cam1", "cam1-crlf.yaml"}, {"imu0", "imu.yaml"}}) {
    fs::create_directories(folder.path() / "mav0" / name);
    folder.write("mav0/" + std::string(name) + "/sensor.yaml", read_file(testdata(good + file)));
  }
  return folder.path().string();
}

TEST(SensorFolders, EurocIsWrittenAsADataset) {
  const TemporaryFolder folder;
  const RunResult run = run_program({"convert", kTumvi, "--with", kImu, "--to", "euroc", "-o", folder.path().string()});
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_EQ(files_below(folder.path()),
            (std::set<std::string>{"mav0/cam0/sensor.yaml", "mav0/cam1/sensor.yaml", "mav0/imu0/sensor.yaml"}));
  // And back, by the folder that holds mav0 and by mav0 itself.
  for (const std::string& input : {folder.path().string(), folder / "mav0"}) {
    const RunResult back = run_program({"convert", input, "--to", "kalibr", "-o", "-"});
    EXPECT_EQ(back.code, 0) << back.err;
    const Rig rig = rig_in(back.out);
    EXPECT_EQ(rig.cameras.size(), 2U) << back.out;
    EXPECT_TRUE(rig.resolve("cam1", "cam0"));
    EXPECT_TRUE(rig.resolve("cam0", "imu0"));
  }
}

// Each is called sensor.yaml.
TEST(SensorFolders, TheCommentTellsTheFilesApart) {
  const TemporaryFolder folder;
  const RunResult run = run_program({"convert", euroc_folder(folder), "--to", "kalibr", "-o", "-"});
  EXPECT_EQ(run.code, 0) << run.err;
  for (const char* name : {"cam0/sensor.yaml, SHA-256", "cam1/sensor.yaml, SHA-256", "imu0/sensor.yaml, SHA-256"})
    EXPECT_TRUE(contains(run.out, name)) << name << run.out;
}

TEST(SensorFolders, AFolderMav0IsNotNested) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_program({"convert", kTumvi, "--to", "euroc", "-o", (folder / "mav0") + "/"}).code, 0);
  EXPECT_EQ(files_below(folder.path()), (std::set<std::string>{"mav0/cam0/sensor.yaml", "mav0/cam1/sensor.yaml"}));
}

TEST(SensorFolders, OneFileOfAFolderIsEdited) {
  const TemporaryFolder base;
  const TemporaryFolder out;
  const RunResult run = run_program({"convert", kTumvi, "--to", "kimera", "--into", kimera_folder(base), "-o", out / "o/"});
  EXPECT_EQ(run.code, 3) << run.out << run.err;
  EXPECT_TRUE(says(run.err, "into-folder", "RightCameraParams.yaml")) << run.err;
  EXPECT_TRUE(files_below(out.path()).empty());
}

// Whose file is left out, and whose tuning would be written as text.
TEST(SensorFolders, WhatKimerasImuFileStatesIsNotLostInSilence) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("chain.yaml", with_replaced(read_file(kTumvi), "  camera_model: pinhole\n",
                                                                     "  camera_model: pinhole\n  timeshift_cam_imu: 0.005\n"));
  const Told alone({"convert", chain, "--camera", "cam0", "--to", "kimera"});
  EXPECT_TRUE(alone.lost("second-file-dropped")) << alone.text();
  const std::string imu = read_file(testdata("formats/kimera/good/imu.yaml"));
  const std::size_t at = imu.find("imu_preintegration_type: ");
  ASSERT_NE(at, std::string::npos);
  const std::string line = imu.substr(at, imu.find('\n', at) - at);
  const std::string hostile =
      folder.write("ImuParams.yaml", with_replaced(imu, line, "imu_preintegration_type: \"1\\nimu_time_shift: 5.0\\nx: 1\""));
  const RunResult fresh = run_program({"convert", hostile, "--to", "kimera", "--rewrite", "-o", "-"});
  EXPECT_FALSE(contains(fresh.out, "imu_time_shift: 5.0")) << fresh.out;
}

TEST(SensorFolders, AnImuThatIsNotTheBodyIsAnErrorToCheck) {
  for (const char* file : {"formats/kimera/bad/imu-moved.yaml", "formats/euroc/bad/imu-moved.yaml"}) {
    const RunResult run = run_program({"check", testdata(file)});
    EXPECT_EQ(run.code, 1) << run.out;
    EXPECT_TRUE(says(run.out, "poses-contradict")) << run.out;
    EXPECT_FALSE(says(run.out, "missing-key")) << run.out;
  }
}

TEST(SensorFolders, KimeraHasItsStockNames) {
  const TemporaryFolder folder;
  const RunResult run = run_program({"convert", kTumvi, "--with", kImu, "--to", "kimera", "-o", folder.path().string()});
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_EQ(files_below(folder.path()),
            (std::set<std::string>{"ImuParams.yaml", "LeftCameraParams.yaml", "RightCameraParams.yaml"}));
}

// Each is an input of its own, called by its folder, whether it is named, met in a folder or said twice.
TEST(SensorFolders, SeveralAreABatch) {
  const TemporaryFolder folder;
  for (const char* name : {"MH_01", "MH_02"}) {
    const TemporaryFolder euroc;
    fs::copy(euroc_folder(euroc), folder.path() / name, fs::copy_options::recursive);
  }
  for (const std::vector<std::string>& inputs :
       {std::vector<std::string>{folder.path().string()}, {folder / "MH_01", folder / "MH_02/mav0/"}}) {
    const TemporaryFolder out;
    std::vector<std::string> words = {"convert", "--to", "orbslam3", "-o", (out / "") + "/"};
    words.insert(words.begin() + 1, inputs.begin(), inputs.end());
    const RunResult run = run_program(words);
    EXPECT_EQ(run.code, 0) << run.out << run.err;
    EXPECT_EQ(files_below(out.path()), (std::set<std::string>{"MH_01.orbslam3.yaml", "MH_02.orbslam3.yaml"})) << run.out;
    EXPECT_EQ(rig_in(read_file(out / "MH_02.orbslam3.yaml")).cameras.size(), 2U);
  }
}

// What is read and written back keeps every byte, in each of the files.
TEST(SensorFolders, WrittenBackTheyAreTheSame) {
  const TemporaryFolder kimera;
  const TemporaryFolder euroc;
  for (const auto& [format, input] :
       {std::pair(std::string("kimera"), kimera_folder(kimera)), {"euroc", euroc_folder(euroc)}}) {
    SCOPED_TRACE(format);
    const TemporaryFolder out;
    const RunResult run = run_program({"convert", input, "--to", format, "-o", out.path().string()});
    EXPECT_EQ(run.code, 0) << run.out << run.err;
    EXPECT_EQ(files_below(out.path()), files_below(input));
    for (const std::string& file : files_below(input))
      EXPECT_EQ(read_file(out / file), read_file(fs::path(input) / file)) << file;
  }
}

TEST(SensorFolders, AreOneRigToEveryCommand) {
  const TemporaryFolder euroc;
  const std::string input = euroc_folder(euroc);
  const RunResult show = run_program({"show", input});
  EXPECT_EQ(show.code, 0) << show.err;
  for (const char* sensor : {"cam0: ", "cam1: ", "imu0"}) EXPECT_TRUE(contains(show.out, sensor)) << show.out;
  const RunResult check = run_program({"check", input});
  EXPECT_EQ(check.code, 0) << check.out << check.err;
  const RunResult compare = run_program({"compare", input, input});
  EXPECT_EQ(compare.code, 0) << compare.out << compare.err;
}

// The IMU's time shift is that of the cameras in the other files.
TEST(SensorFolders, KimerasTimeShiftBecomesTheCameras) {
  const TemporaryFolder kimera;
  const RunResult run = run_program({"convert", kimera_folder(kimera), "--to", "kalibr", "-o", "-"});
  EXPECT_EQ(run.code, 0) << run.err;
  for (const Camera& camera : rig_in(run.out).cameras) EXPECT_EQ(camera.time_offset_s, 0.00625);
}

}  // namespace
}  // namespace fca::test
