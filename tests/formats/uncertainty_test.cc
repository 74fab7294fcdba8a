// SPDX-License-Identifier: BSD-3-Clause
// Files that specify how uncertain a calibration is: Kalibr's report, a covariance, OpenCV's standard deviations.
#include "test_files.h"

#include <fca/code.h>
#include <fca/formats/calibration.h>

#include <gtest/gtest.h>

#include <cmath>

namespace fca::test {
namespace {

const std::string kChain = R"(cam0:
  camera_model: pinhole
  distortion_model: equidistant
  distortion_coeffs: [0.0034, 0.0007, -0.0021, 0.0002]
  intrinsics: [190.97847715, 190.97330705, 254.93170606, 256.89744285]
  resolution: [512, 512]
cam1:
  camera_model: ds
  distortion_model: none
  distortion_coeffs: []
  intrinsics: [-0.17213086, 0.59311776, 158.28600035, 158.27434575, 254.96116579, 256.88943945]
  resolution: [512, 512]
  T_cn_cnm1:
  - [1.0, 0.0, 0.0, -0.1]
  - [0.0, 1.0, 0.0, 0.0]
  - [0.0, 0.0, 1.0, 0.0]
  - [0.0, 0.0, 0.0, 1.0]
)";

/// As NumPy breaks the lines of six numbers.
const std::string kReport = R"(Calibration results 
====================
Camera-system parameters:
cam0 (/cam0/image_raw):
    type: <class 'aslam_cv.libaslam_cv_python.EquidistantDistortedPinholeCameraGeometry'>
    distortion: [ 0.0034  0.0007 -0.0021  0.0002] +- [0.0011 0.0012 0.0013 0.0014]
    projection: [190.97847715 190.97330705 254.93170606 256.89744285] +- [0.11 0.12 0.13 0.14]
    reprojection error: [0.030000, -0.040000] +- [0.120000, 0.000000]

cam1 (/cam1/image_raw):
    type: <class 'aslam_cv.libaslam_cv_python.DoubleSphereCameraGeometry'>
    distortion: [] +- []
    projection: [ -0.17213086   0.59311776 158.28600035 158.27434575 254.96116579
 256.88943945] +- [0.001 0.002 0.3 0.4 0.5
 0.6]
    reprojection error: [0.000001, -0.000002] +- [0.200000, 0.150000]

baseline T_1_0:
    q: [-0.0001 0.0002 0.0003 1.        ] +- [0.001 0.002 0.003]
    t: [-0.1  0.  0. ] +- [0.0001 0.0002 0.0003]



Target configuration
====================

  Type: aprilgrid
)";

const std::string kImuReport = R"(Calibration results
===================
Normalized Residuals
----------------------------
Reprojection error (cam0):     mean 0.3, median 0.25, std: 0.4
Gyroscope error (imu0):        mean 0.1, median 0.1, std: 0.1
Accelerometer error (imu0):    mean 0.1, median 0.1, std: 0.1

Residuals
----------------------------
Reprojection error (cam0) [px]:     mean 0.6, median 0.5, std: 0.8
Reprojection error (cam1) [px]:     no corners
Gyroscope error (imu0) [rad/s]:     mean 0.01, median 0.01, std: 0.01
Accelerometer error (imu0) [m/s^2]: mean 0.01, median 0.01, std: 0.01

Transformation (cam0):
-----------------------
T_ci:  (imu0 to cam0): 
[[1. 0. 0. 0.]]
)";

struct Outcome {
  std::optional<Calibration> calibration;
  Diagnostics diagnostics;
  std::vector<text::Source> sources;

  [[nodiscard]] bool says(Code code) const { return find(code) != nullptr; }
  [[nodiscard]] const Diagnostic* find(Code code) const {
    for (const Diagnostic& entry : diagnostics.entries()) {
      if (entry.facts.code == code) return &entry;
    }
    return nullptr;
  }
  /// Of the first error; 0: it has none.
  [[nodiscard]] int line_of_error() const {
    for (const Diagnostic& entry : diagnostics.entries()) {
      if (entry.severity != Severity::kError) continue;
      for (const text::Source& source : sources) {
        if (source.name == entry.where.file && entry.where.length > 0) return source.position(entry.where.offset).line;
      }
    }
    return 0;
  }
};

Outcome read(const std::vector<text::Source>& sources, const ReadOptions& options = {}) {
  Outcome outcome;
  outcome.sources = sources;
  std::vector<text::Document> documents;
  for (const text::Source& source : sources) {
    std::optional<text::Document> document = parse_calibration(source, outcome.diagnostics);
    if (!document) return outcome;
    documents.push_back(*std::move(document));
  }
  outcome.calibration = read_calibration(std::move(documents), nullptr, options, outcome.diagnostics);
  return outcome;
}

Outcome read_with(const std::string& part, const std::string& name = "results-cam.txt") {
  return read({{"camchain.yaml", kChain}, {name, part}});
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), by);
}

double sigma_of(const Rig& rig, const std::string& camera, std::string_view name) {
  const Uncertainty* found = rig.find_uncertainty(camera);
  if (found == nullptr) return -1.0;
  const std::span<const Parameter> parameters = find_model(found->model)->parameters;
  const auto place = std::ranges::find(parameters, name, &Parameter::name) - parameters.begin();
  return found->sigmas.at(static_cast<std::size_t>(place));
}

TEST(KalibrReport, StatesTheSigmaOfEachParameter) {
  for (const char* name : {"results-cam.txt", "report", "x.yaml"}) {
    const Outcome outcome = read_with(kReport, name);
    ASSERT_TRUE(outcome.calibration) << name;
    EXPECT_TRUE(outcome.diagnostics.entries().empty());
    const Rig& rig = outcome.calibration->rig;
    EXPECT_EQ(rig.cameras.size(), 2U);
    const std::vector<std::pair<const char*, double>> of_cam0 = {
        {"fx", 0.11}, {"fy", 0.12}, {"cx", 0.13}, {"cy", 0.14}, {"k1", 0.0011}, {"k2", 0.0012}, {"k3", 0.0013}, {"k4", 0.0014}};
    for (const auto& [parameter, sigma] : of_cam0) EXPECT_EQ(sigma_of(rig, "cam0", parameter), sigma) << parameter;
    const std::vector<std::pair<const char*, double>> of_cam1 = {{"xi", 0.001}, {"alpha", 0.002}, {"fx", 0.3},
                                                                 {"fy", 0.4},   {"cx", 0.5},      {"cy", 0.6}};
    for (const auto& [parameter, sigma] : of_cam1) EXPECT_EQ(sigma_of(rig, "cam1", parameter), sigma) << parameter;
    EXPECT_FALSE(rig.find_uncertainty("cam0")->has_covariance());
    EXPECT_NEAR(*rig.find_uncertainty("cam0")->reprojection_rms_px, 0.13, 1e-12);
    EXPECT_EQ(rig.find_uncertainty("cam0")->where.file, name);
    ASSERT_EQ(rig.pose_uncertainties.size(), 1U);
    EXPECT_EQ(rig.pose_uncertainties.front().a, "cam1");
    EXPECT_EQ(rig.pose_uncertainties.front().rotation_rad, (std::array<double, 3>{0.001, 0.002, 0.003}));
    EXPECT_EQ(rig.pose_uncertainties.front().translation_m, (std::array<double, 3>{0.0001, 0.0002, 0.0003}));
  }
}

TEST(KalibrReport, IsReadInTheLayoutOfOldVersions) {
  std::string old = kReport;
  for (const char* camera : {"cam0 (", "cam1 (", "    type", "    distortion", "    projection", "    reprojection"})
    old = replaced(old, camera, "\t" + std::string(camera));
  for (std::size_t at = 0; (at = old.find('\n', at)) != std::string::npos; at += 2) old.replace(at, 1, "\r\n");
  EXPECT_TRUE(read_with(old).calibration);
}

TEST(KalibrReport, OfAnImuStatesReprojectionErrors) {
  const Outcome outcome = read_with(kImuReport, "results-imucam.txt");
  ASSERT_TRUE(outcome.calibration);
  const std::vector<Uncertainty>& stated = outcome.calibration->rig.uncertainties;
  ASSERT_EQ(stated.size(), 1U);
  EXPECT_NEAR(*stated.front().reprojection_rms_px, 1.0, 1e-12);
  EXPECT_EQ(outcome.calibration->rig.find_uncertainty("cam0"), nullptr) << "it states no sigma";
}

// Each line that is read, cut off or with a letter in it: an error on that line, or where what it lacks should stand.
TEST(KalibrReport, IsRefusedAtTheLineThatIsBroken) {
  for (const std::string& report : {kReport, kImuReport}) {
    const std::vector<std::string> lines = split(report, '\n');
    const bool has_cameras = &report == &kReport || report == kReport;
    for (std::size_t i = 3; i < lines.size(); ++i) {
      const std::string& line = lines[i];
      if (line.starts_with("Target") || line.starts_with("Transformation")) break;
      if (line.find_first_not_of(" -") == std::string::npos || line.find("no corners") != std::string::npos) continue;
      if (!has_cameras && !line.starts_with("Reprojection")) continue;
      const auto with = [&](const std::string& by) {
        std::string text;
        for (std::size_t k = 0; k < lines.size(); ++k) text += (k == i ? by : lines[k]) + "\n";
        return read_with(text);
      };
      for (const std::string& by : {"?" + line, line.substr(0, line.size() - std::min<std::size_t>(7, line.size() / 2)),
                                    line + " 3 ?", std::string("???")}) {
        const Outcome outcome = with(by);
        if (outcome.says(Code::kUncertaintyOfOtherValues)) continue;  // a number without its last digits is another number
        EXPECT_FALSE(outcome.calibration) << i + 1 << ": " << by;
        const int told = outcome.line_of_error();
        EXPECT_GE(told, static_cast<int>(i)) << i + 1 << ": " << by;
        EXPECT_LE(told, static_cast<int>(i + 3)) << i + 1 << ": " << by;
      }
    }
  }
}

TEST(KalibrReport, IsRefusedWithAnImpossibleNumber) {
  for (const auto& [old, by] : std::vector<std::pair<std::string, std::string>>{{"0.0011 0.0012", "nan 0.0012"},
                                                                                {"0.0011 0.0012", "-0.0011 0.0012"},
                                                                                {"0.0011 0.0012", "0.0012"},
                                                                                {"0.11 0.12", "0.11 0.12 0.12"},
                                                                                {"190.97847715 ", "1e999 "},
                                                                                {"0.001 0.002 0.003", "0.001 -0.002 0.003"}}) {
    const Outcome outcome = read_with(replaced(kReport, old, by));
    EXPECT_FALSE(outcome.calibration) << by;
    EXPECT_GT(outcome.line_of_error(), 0) << by;
  }
  EXPECT_TRUE(read_with(replaced(kReport, "DoubleSphere", "TripleSphere")).says(Code::kReportUnknownGeometry));
  EXPECT_TRUE(read_with(kReport.substr(0, 30)).says(Code::kReportNothing));
}

TEST(KalibrReport, MustBelongToTheCalibration) {
  const Outcome other_camera = read_with(replaced(kReport, "cam1 (", "cam4 ("));
  EXPECT_FALSE(other_camera.calibration);
  EXPECT_TRUE(other_camera.says(Code::kUncertaintyOfOtherCamera));
  EXPECT_EQ(other_camera.line_of_error(), 10);

  const Outcome other_model = read_with(replaced(kReport, "EquidistantDistorted", "Distorted"));
  EXPECT_FALSE(other_model.calibration);
  EXPECT_TRUE(other_model.says(Code::kUncertaintyOfOtherModel));

  const Outcome other_values = read_with(replaced(kReport, "190.97847715 ", "191.17847715 "));
  EXPECT_FALSE(other_values.calibration);
  EXPECT_TRUE(other_values.says(Code::kUncertaintyOfOtherValues));
  EXPECT_EQ(other_values.line_of_error(), 4);

  const Outcome rounded = read_with(replaced(kReport, "190.97847715 ", "190.98 "));
  EXPECT_TRUE(rounded.calibration);
  ASSERT_TRUE(rounded.says(Code::kUncertaintyOfOtherValues));
  EXPECT_EQ(rounded.find(Code::kUncertaintyOfOtherValues)->severity, Severity::kWarning);
}

TEST(KalibrReport, AloneIsAFileWithoutCameras) {
  const Outcome outcome = read({{"results-cam.txt", kReport}});
  ASSERT_TRUE(outcome.calibration);
  EXPECT_TRUE(outcome.calibration->rig.cameras.empty());
  EXPECT_EQ(outcome.calibration->rig.uncertainties.size(), 2U);
}

const std::string kCovariance = R"(# of a solver of one's own
covariance cam1 ds xi alpha fx
4e-6 1e-6 2e-4
1e-6 1e-6 1e-4
2e-4 1e-4 0.09
)";

TEST(Covariance, IsReadAsItStands) {
  std::string commas = kCovariance;
  for (const char* row : {"4e-6 1e-6 2e-4", "1e-6 1e-6 1e-4"}) {
    std::string with = row;
    std::ranges::replace(with, ' ', ',');
    commas = replaced(commas, row, with);
  }
  for (const std::string& text : {kCovariance, commas}) {
    const Outcome outcome = read_with(text, "covariance.csv");
    ASSERT_TRUE(outcome.calibration);
    const Rig& rig = outcome.calibration->rig;
    EXPECT_NEAR(sigma_of(rig, "cam1", "xi"), 2e-3, 1e-15);
    EXPECT_NEAR(sigma_of(rig, "cam1", "fx"), 0.3, 1e-15);
    EXPECT_EQ(sigma_of(rig, "cam1", "cx"), 0.0) << "it was held";
    const Uncertainty& stated = *rig.find_uncertainty("cam1");
    const std::span<const Parameter> parameters = find_model("ds")->parameters;
    const auto place = [&parameters](std::string_view name) {
      return static_cast<std::size_t>(std::ranges::find(parameters, name, &Parameter::name) - parameters.begin());
    };
    EXPECT_EQ(stated.covariance.at(place("fx") * parameters.size() + place("xi")), 2e-4);
    EXPECT_EQ(stated.covariance.at(place("alpha") * parameters.size() + place("fx")), 1e-4);
  }
}

TEST(Covariance, CountsMoreThanStandardDeviationsAlone) {
  const Outcome outcome = read({{"camchain.yaml", kChain}, {"results-cam.txt", kReport}, {"covariance.csv", kCovariance}});
  ASSERT_TRUE(outcome.calibration);
  EXPECT_TRUE(outcome.calibration->rig.find_uncertainty("cam1")->has_covariance());
  EXPECT_FALSE(outcome.calibration->rig.find_uncertainty("cam0")->has_covariance());
}

TEST(Covariance, IsRefusedWhereItIsNone) {
  struct Case {
    const char* old;
    const char* by;
    Code code;
    int line;
  };
  for (const Case& each :
       {Case{"4e-6 1e-6", "4e-6 2e-6", Code::kCovarianceNotSymmetric, 4}, Case{"0.09", "-0.09", Code::kReportSigmaNegative, 5},
        Case{"0.09", "0.0000001", Code::kCovarianceImpossible, 2}, Case{"0.09", "0.09 1", Code::kNumbersWanted, 5},
        Case{"2e-4 1e-4 0.09", "", Code::kCovarianceRowsMissing, 2}, Case{"0.09", "x", Code::kValueNoNumber, 5},
        Case{" fx", " f", Code::kCovarianceUnknownParameter, 2}, Case{" fx", " xi", Code::kReportTwice, 2},
        Case{" ds", " dss", Code::kUnknownModel, 2}, Case{"cam1 ds", "cam7 ds", Code::kUncertaintyOfOtherCamera, 2},
        Case{"cam1 ds", "cam0 ds", Code::kUncertaintyOfOtherModel, 2}}) {
    const Outcome outcome = read_with(replaced(kCovariance, each.old, each.by), "covariance.csv");
    EXPECT_FALSE(outcome.calibration) << each.by;
    EXPECT_TRUE(outcome.says(each.code)) << each.by;
    EXPECT_EQ(outcome.line_of_error(), each.line) << each.by;
  }
}

/// As OpenCV's sample writes them, with 18 standard deviations.
std::string opencv_file(const std::string& sigmas) {
  return "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\ncamera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: "
         "d\n"
         "   data: [ 500., 0., 320., 0., 400., 240., 0., 0., 1. ]\ndistortion_coefficients: !!opencv-matrix\n   rows: 5\n"
         "   cols: 1\n   dt: d\n   data: [ -0.2, 0.05, 0.001, 0.002, -0.01 ]\navg_reprojection_error: 0.25\n" +
         sigmas;
}
const std::string kSigmas =
    "stdDeviationsIntrinsics: !!opencv-matrix\n   rows: 18\n   cols: 1\n   dt: d\n   data: [ 0.5, 0.6, 0.7, 0.8, 0.01, 0.02, "
    "0.003, 0.004, 0.05, 0., 0., 0., 0., 0., 0., 0., 0., 0. ]\n";

TEST(OpenCvSigmas, AreThoseOfCalibrateCamera) {
  const Outcome outcome = read({{"out.yml", opencv_file(kSigmas)}});
  ASSERT_TRUE(outcome.calibration);
  const Rig& rig = outcome.calibration->rig;
  const std::vector<std::pair<const char*, double>> expected = {{"fx", 0.5},   {"fy", 0.6},   {"cx", 0.7},
                                                                {"cy", 0.8},   {"k1", 0.01},  {"k2", 0.02},
                                                                {"p1", 0.003}, {"p2", 0.004}, {"k3", 0.05}};
  for (const auto& [parameter, sigma] : expected) EXPECT_EQ(sigma_of(rig, "cam0", parameter), sigma) << parameter;
  EXPECT_EQ(rig.find_uncertainty("cam0")->reprojection_rms_px, 0.25);
  EXPECT_NE(rig.find_extra_field("", "stdDeviationsIntrinsics"), nullptr) << "no format keeps it: it is listed as lost";
}

TEST(OpenCvSigmas, OfAFixedAspectRatioFollowFy) {
  const Outcome outcome = read({{"out.yml", opencv_file(replaced(kSigmas, "[ 0.5,", "[ 0.,"))}});
  ASSERT_TRUE(outcome.calibration);
  EXPECT_NEAR(sigma_of(outcome.calibration->rig, "cam0", "fx"), 0.6 * 500.0 / 400.0, 1e-12);
}

TEST(OpenCvSigmas, ThatAreNoneAreWarnedOf) {
  for (const auto& [old, by] : std::vector<std::pair<std::string, std::string>>{{"[ 0.5,", "[ -0.5,"}, {"18\n", "17\n"}}) {
    const Outcome outcome = read({{"out.yml", opencv_file(replaced(kSigmas, old, by))}});
    ASSERT_TRUE(outcome.calibration) << by;
    EXPECT_TRUE(outcome.says(Code::kOpencvSigmasOdd)) << by;
    EXPECT_EQ(outcome.calibration->rig.find_uncertainty("cam0"), nullptr) << by;
  }
}

TEST(OpenCvSigmas, FollowTheirCameraIntoARig) {
  ReadOptions options;
  options.join = true;
  const Outcome outcome = read(
      {{"left.yml", opencv_file(kSigmas)}, {"right.yml", opencv_file(replaced(kSigmas, "[ 0.5, 0.6", "[ 1.5, 1.6"))}}, options);
  ASSERT_TRUE(outcome.calibration);
  EXPECT_EQ(sigma_of(outcome.calibration->rig, "cam0", "fx"), 0.5);
  EXPECT_EQ(sigma_of(outcome.calibration->rig, "cam1", "fx"), 1.5);
}

TEST(OpenCvSigmas, AreFoundInTheCorpus) {
  const std::vector<fs::path> files = corpus_files_of("opencv");
  if (files.empty()) GTEST_SKIP() << "no corpus here";
  int with_error = 0;
  for (const fs::path& path : files) {
    const std::string bytes = read_file(path);
    const bool states_it =
        bytes.find("vg_reprojection_error") != std::string::npos || bytes.find("vg_Reprojection_Error") != std::string::npos;
    if (!states_it) continue;
    const Outcome outcome = read({{path.filename().string(), bytes}});
    if (!outcome.calibration || outcome.calibration->rig.cameras.size() != 1) continue;
    const std::vector<Uncertainty>& stated = outcome.calibration->rig.uncertainties;
    ASSERT_EQ(stated.size(), 1U) << path;
    ASSERT_TRUE(stated.front().reprojection_rms_px) << path;
    EXPECT_GT(*stated.front().reprojection_rms_px, 0.0);
    EXPECT_LT(*stated.front().reprojection_rms_px, 10.0);
    ++with_error;
  }
  EXPECT_GE(with_error, 3);
}

}  // namespace
}  // namespace fca::test
