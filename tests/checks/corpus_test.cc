// SPDX-License-Identifier: BSD-3-Clause
// Over the corpus of real files: every file that its own program refuses has an error that says why, and no other file has one.
// The folder is not part of the repository; without it all is skipped.
#include "check_files.h"

#include <fca/formats/sightings.h>
#include <fca/formats/wording.h>

#include <cstdio>
#include <map>
#include <set>

namespace fca::test {
namespace {

/// Files that deserve an error, each looked at by hand.
struct Evaluated {
  std::string_view part;  ///< Of the name.
  std::string_view code;
  std::string_view why;
};

constexpr Evaluated kEvaluated[] = {
    {"kalibr_dynamic-imu.yaml", "program-refuses", "Kalibr's result: imu0 around the keys it wants at the top"},
    {"working_directory__imu-camera_imu.yaml", "program-refuses", "the same"},
    {"results_yaml__imu-kalibr_raw", "program-refuses", "the same"},
    {"dm-vio__configs__4seasons.yaml", "program-refuses", "DM-VIO's settings: no update_rate, no rostopic"},
    {"dm-vio__configs__euroc.yaml", "program-refuses", "the same"},
    {"dm-vio__configs__tumvi.yaml", "program-refuses", "the same"},
    {"dm-vio__configs__oakd_noise_tumvi.yaml", "program-refuses", "the same"},
    {"dm-vio__configs__t265_noise_tumvi.yaml", "program-refuses", "the same"},
    {"4seasons_calib__camchain.yaml", "program-refuses", "a top-level T_cam1_cam0, which Kalibr counts as a camera"},
    {"oakd_calib__camchain.yaml", "missing-key", "poses without camera_model"},
    {"camchain__70a02b7.yaml", "unknown-model", "camera_model: onmi/radial"},
    {"camchain_Kannala.yaml", "unknown-model", "camera_model: pinhole/radial"},
    {"imu_3Dx-GX3-35__11d5c0d.yaml", "merge-conflict", "git's markers stand in it"},
    {"xinli_stereo137.yaml", "not-a-rotation", "Camera.Tbc: R^T R is 0.11 from the identity"},
    {"xinli_stereo137_KB.yaml", "program-refuses", "KannalaBrandt8 without k3 and k4; and Tbc as above"},
    {"xinli_stereo170.yaml", "not-a-rotation", "Camera.Tbc as in xinli_stereo137"},
    {"thien94__orb_slam3_ros__config__Monocular__NTU_VIRAL.yaml", "program-misreads",
     "V1.0 rectifies the second camera wrongly: 3.5 px"},
    {"thien94__orb_slam3_ros__config__RGB-D-Inertial__RealSense_D435i.yaml", "program-misreads",
     "V1.0 does not undistort with depth"},
    {"thien94__orb_slam3_ros__config__RGB-D__TUM1.yaml", "program-misreads", "the same: 6.0 px"},
    {"thien94__orb_slam3_ros__config__RGB-D__TUM2.yaml", "program-misreads", "the same"},
    {"thien94__orb_slam3_ros__config__Stereo__RealSense_T265.yaml", "real-for-int", "Camera.fps: 30."},
    {"urbste__ORB_SLAM3__Examples__Stereo__KITTI00-02.yaml", "int-for-real", "Viewer.ViewpointY: -100"},
    {"euroc_ds_calib__83e1872.json", "program-refuses", "one number for the noise of three axes, as Basalt had it before 2020"},
    {"euroc_eucm_calib__9973a89.json", "program-refuses", "the same"},
    {"tumvi_512_ds_calib__1f5d4b8.json", "program-refuses", "the same"},
    {"tumvi_512_eucm_calib__50010a8.json", "program-refuses", "the same"},
    {"rovio__cfg__M600", "program-refuses",
     "ROVIO's: neither rectification_matrix nor projection_matrix, which ROS's parser wants"},
    {"rovio__cfg__domi_cam", "program-refuses", "the same"},
    {"rovio__cfg__euroc_cam", "program-refuses", "the same"},
    {"MicroEurocDataset__mav0", "opencv-header", "Kimera's copies of EuRoC's files, for OpenCV: PyYAML refuses the first line"},
    {"D455__ImuParams.yaml", "program-refuses", "no imu_bias_init_sigma"},
    {"kalibr__templates__camera.yaml", "unknown-format", "a template with {{ }}"},
    {"hl-qiu__processData", "focal-length-not-in-pixels", "fl_x of 166504 px for 1024 columns"},
    {"example__gopro__gopro__", "program-refuses", "OpenVSLAM's keys with points, which stella_vslam has no more"},
    {"test__data__calib_cam.yaml", "program-refuses", "vikit's: one camera without SVO's list"},
    {"test__data__calib_omni.yaml", "program-refuses", "the same"},
    {"test__data__calib_pinhole_", "program-refuses", "vikit's flat keys, which SVO has no more"},
    {"SynWoodScape", "carla-translation", "no \"translation\": KeyError in projection.py"},
};

/// Refusals of SUMMARY.tsv that are no defect of the file: it was given to a program it is not for.
struct NotForIt {
  std::string_view part;
  std::string_view why;
};

constexpr NotForIt kNotForIt[] = {
    {"imu", "imu.yaml, which the chain's reader was given"},
    {"raulmur__ORB_SLAM2", "ORB-SLAM2 reads it; ORB-SLAM3 wants Camera.type"},
    {"ns15417__slam_no_opt", "slam_no_opt or ORB-SLAM2 reads it; ORB-SLAM3 wants another Camera.type"},
    {"extrinsics", "the poses of a stereo pair, without cameras"},
};

const Evaluated* evaluated(const std::string& file) {
  const auto* const found =
      std::ranges::find_if(kEvaluated, [&file](const Evaluated& row) { return file.find(row.part) != std::string::npos; });
  return found == std::end(kEvaluated) ? nullptr : found;
}

std::vector<fs::path> corpus_files() {
  std::vector<fs::path> files;
  for (const Format& format : written_formats()) {
    const std::vector<fs::path> found = corpus_files_of(format.id);
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

/// Findings about files that are as their author means them, each looked at by hand.
constexpr Evaluated kFalseAlarms[] = {
    {"synth_Scenario", "focal-lengths-differ", "rendered with such pixels: they are the truth"},
    {"xinli_stereo", "focal-lengths-differ", "images of 4:3 squeezed to 16:9: all cameras have the same ratio"},
    {"x1000_12.yaml", "focal-lengths-differ", "the same"},
    {"dm-vio__configs__", "imu-noise-too-large", "inflated on purpose: DM-VIO's authors tuned it"},
    {"odysseyplus_", "imu-walk-above-noise", "a walk that its author tuned"},
};

int false_alarms_in(const std::string& file, const std::string& code) {
  return std::ranges::any_of(kFalseAlarms,
                             [&](const Evaluated& row) { return row.code == code && file.find(row.part) != std::string::npos; })
             ? 1
             : 0;
}

// Prints the table of findings by code.
TEST(CheckCorpus, ErrorsAreThoseComputedByHand) {
  if (!has_corpus()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  std::map<std::string, int> counted;
  std::map<std::string, Sighting> seen;
  std::size_t calibrations = 0;
  std::size_t without_errors = 0;
  for (const fs::path& path : corpus_files()) {
    const text::Source source = {path.filename().string(), read_file(path)};
    const CheckReport report = checked(source);
    if (!report.is_calibration) continue;
    ++calibrations;
    const Evaluated* expected = evaluated(source.name);
    bool expected_said = false;
    std::set<std::string> codes;
    for (const Finding& finding : report.findings) {
      ++counted[severity_word(finding.severity) + " " + id_of(finding)];
      EXPECT_NE(find_check_code(id_of(finding)), nullptr) << id_of(finding);
      codes.insert(id_of(finding));
      if (finding.severity != Severity::kError) continue;
      expected_said = expected_said || (expected != nullptr && id_of(finding) == expected->code);
      EXPECT_NE(expected, nullptr) << source.name << ": " << line_of(finding, source) << ": " << message_of(finding);
    }
    for (const std::string& code : codes) {
      ++seen[code].files;
      seen[code].false_alarms += false_alarms_in(source.name, code);
    }
    EXPECT_EQ(expected_said, expected != nullptr) << source.name << ": " << (expected != nullptr ? expected->why : "");
    without_errors += report.has(Severity::kError) ? 0 : 1;
  }
  EXPECT_GT(calibrations, 300U);
  // What --explain says of each code.
  EXPECT_EQ(calibrations, static_cast<std::size_t>(kRealFiles));
  for (const auto& [code, is] : seen) {
    const Sighting said = sighting_of(code);
    EXPECT_TRUE(said.files == is.files && said.false_alarms == is.false_alarms)
        << "    Sighting{\"" << code << "\", " << is.files << ", " << is.false_alarms << "},";
  }
  for (const Sighting& row : sightings()) EXPECT_TRUE(seen.contains(std::string(row.id))) << row.id;
  std::printf("%zu calibrations, %zu without an error\n", calibrations, without_errors);
  for (const auto& [code, count] : counted) std::printf("%5d  %s\n", count, code.c_str());
}

bool is_own_program(const std::string& folder, const std::string& program) {
  return folder == program || (folder == "tumvi" && program == "kalibr");
}

TEST(CheckCorpus, WhatItsOwnProgramRefusesHasAnError) {
  const fs::path summary = shared_dir() / "oracles" / "SUMMARY.tsv";
  if (!has_corpus() || !fs::exists(summary)) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  std::size_t refused = 0;
  for (const std::string& line : split(read_file(summary), '\n')) {
    const std::vector<std::string> fields = split(line, '\t');
    if (fields.size() < 4 || !is_own_program(fields[0], fields[2]) || fields[3].find("rejected") == std::string::npos) continue;
    const CheckReport report = checked(shared_dir() / "corpus" / fields[0] / fields[1]);
    if (!report.is_calibration || report.format == nullptr || (report.format->id != fields[0] && fields[0] != "tumvi"))
      continue;
    if (fields[0] == "tumvi" && report.format->id == "basalt") continue;  // Basalt's own, given to Kalibr
    if (fields[0] == "tumvi" && report.format->id == "dso") continue;     // DSO's camera.txt, given to Kalibr
    ++refused;
    const bool excused =
        std::ranges::any_of(kNotForIt, [&](const NotForIt& row) { return fields[1].find(row.part) != std::string::npos; });
    EXPECT_TRUE(report.has(Severity::kError) || excused) << fields[1] << ": " << fields[3];
  }
  EXPECT_GT(refused, 40U);
}

// The manifest's own words on who refuses a file.
TEST(CheckCorpus, WhatTheManifestCallsRejectedHasAnError) {
  if (!has_corpus()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  std::size_t rejected = 0;
  for (const std::string& line : split(read_file(shared_dir() / "corpus" / "MANIFEST.tsv"), '\n')) {
    const std::vector<std::string> fields = split(line, '\t');
    if (fields.size() < 7 || fields[0].starts_with("extra/")) continue;
    const std::size_t by = fields[6].find("rejected by: ");
    const bool by_kalibr = by != std::string::npos && fields[6].find("Kalibr", by) != std::string::npos;
    if (!by_kalibr) continue;
    const CheckReport report = checked(shared_dir() / "corpus" / fields[0]);
    if (report.format != nullptr && report.format->id == "openvins") continue;  // a chain with OpenVINS' first line
    ++rejected;
    EXPECT_TRUE(report.has(Severity::kError)) << fields[0] << ": " << fields[6];
  }
  EXPECT_GT(rejected, 10U);
}

// What no format of ours reads is skipped in folders, not called wrong.
TEST(CheckCorpus, OtherProgramsFilesAreNoCalibrationsOfOurs) {
  const fs::path folder = shared_dir() / "corpus" / "extra" / "opencv_not_a_calibration";
  if (!fs::exists(folder)) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  for (const fs::path& path : files_in(folder)) EXPECT_FALSE(checked(path).is_calibration) << path;
}

}  // namespace
}  // namespace fca::test
