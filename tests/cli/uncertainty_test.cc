// SPDX-License-Identifier: BSD-3-Clause
// What the command reports of a calibration's own uncertainty: report, JSON, page, limit and verdict; and of one lens for two.
#include "run_program.h"
#include "told.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fca::test {
namespace {

const std::string kPose = R"(  T_cn_cnm1:
  - [1.0, 0.0, 0.0, -0.1]
  - [0.0, 1.0, 0.0, 0.0]
  - [0.0, 0.0, 1.0, 0.0]
  - [0.0, 0.0, 0.0, 1.0]
)";

std::string camera(const std::string& name, const std::string& coefficients, const std::string& intrinsics) {
  return name + ":\n  camera_model: pinhole\n  distortion_model: equidistant\n  distortion_coeffs: [" + coefficients +
         "]\n  intrinsics: [" + intrinsics + "]\n  resolution: [512, 512]\n  rostopic: /" + name + "/image_raw\n";
}

const std::string kFirst = camera("cam0", "0.0034, 0.0007, -0.0021, 0.0002", "190.98, 190.97, 254.93, 256.90");
const std::string kPair = kFirst + camera("cam1", "0.0084, 0.0017, -0.0036, 0.0004", "190.44, 190.43, 252.60, 254.92") + kPose;

const std::string kReport = R"(Calibration results 
====================
Camera-system parameters:
cam0 (/cam0/image_raw):
    type: <class 'aslam_cv.libaslam_cv_python.EquidistantDistortedPinholeCameraGeometry'>
    distortion: [ 0.0034  0.0007 -0.0021  0.0002] +- [0.0011 0.0012 0.0013 0.0002]
    projection: [190.98 190.97 254.93 256.9 ] +- [0.11 0.12 0.13 0.14]
    reprojection error: [0.000001, -0.000002] +- [0.120000, 0.100000]
)";

/// Of cam0, without correlations of any size: fx and fy, each as uncertain as that.
std::string covariance(double sigma_px) {
  const std::string variance = std::to_string(sigma_px * sigma_px);
  return "covariance cam0 kb4 fx fy\n" + variance + " 0\n0 " + variance + "\n";
}

struct Files {
  TemporaryFolder folder;
  std::string chain = folder.write("camchain.yaml", kFirst);
  std::string report = folder.write("results-cam.txt", kReport);
  std::string pair = folder.write("pair.yaml", kPair);
  std::string with(double sigma_px) const { return folder.write("covariance.csv", covariance(sigma_px)); }
};

TEST(OwnUncertainty, OfAReportIsALimitThatDecidesNothing) {
  const Files files;
  const std::vector<std::string> words = {"convert", files.chain, "--to", "kalibr", "--model", "eucm", "--max-angle", "90"};
  const Told alone(words);
  std::vector<std::string> with_report = words;
  with_report.insert(with_report.end(), {"--with", files.report});
  const Told told(with_report);
  ASSERT_EQ(told.code(), 0) << told.text();
  EXPECT_EQ(told.bytes(), alone.bytes());
  EXPECT_EQ(std::string(told.json()["verdict"]["word"].GetString()), alone.json()["verdict"]["word"].GetString());
  ASSERT_TRUE(told.json()["cameras"][0].HasMember("uncertainty")) << told.text();
  const auto& own = told.json()["cameras"][0]["uncertainty"];
  EXPECT_FALSE(own["correlations_known"].GetBool());
  EXPECT_GT(own["max_px"].GetDouble(), 0.13) << "at least cx alone";
  EXPECT_FALSE(own.HasMember("sigmas"));
  EXPECT_TRUE(told.lost("not-carried", "standard deviations"));
  const RunResult text = run_program(with_report);
  EXPECT_TRUE(contains(text.out + text.err, "at most")) << text.out << text.err;
  EXPECT_TRUE(contains(text.out + text.err, "correlations unknown"));
}

TEST(OwnUncertainty, OfACovarianceIsCarriedToTheNewParameters) {
  const Files files;
  const Told told(
      {"convert", files.chain, "--with", files.with(0.5), "--to", "kalibr", "--model", "eucm", "--max-angle", "90"});
  ASSERT_EQ(told.code(), 0) << told.text();
  const auto& own = told.json()["cameras"][0]["uncertainty"];
  EXPECT_TRUE(own["correlations_known"].GetBool());
  EXPECT_EQ(own["covariance"].Size(), 36U);
  // Both focal lengths scale: fx of eucm follows fx of kb4.
  EXPECT_NEAR(own["sigmas"]["fx"].GetDouble(), 0.5, 0.1);
  EXPECT_NEAR(own["sigmas"]["cx"].GetDouble(), 0.0, 0.02);
}

TEST(OwnUncertainty, IsTheMeasureOfALimitInSigmas) {
  const Files files;
  const auto run = [&](const std::vector<std::string>& further) {
    std::vector<std::string> words = {"convert", files.chain, "--to", "kalibr", "--model", "eucm", "--max-angle", "90"};
    words.insert(words.end(), further.begin(), further.end());
    return run_program(words);
  };
  const RunResult unknown = run({"--max-error", "0.2sigma"});
  EXPECT_EQ(unknown.code, 3);
  EXPECT_TRUE(says(unknown.err, "sigma-unknown", "cam0")) << unknown.err;
  const RunResult limit = run({"--max-error", "0.2sigma", "--with", files.report});
  EXPECT_EQ(limit.code, 3);
  EXPECT_TRUE(says(limit.err, "sigma-unknown", "results-cam.txt")) << limit.err;
  EXPECT_EQ(run({"--max-error", "sigma"}).code, 3);
  EXPECT_EQ(run({"--max-error", "-1sigma"}).code, 3);
}

TEST(OwnUncertainty, DecidesWhetherALimitInSigmasIsMet) {
  const Files files;
  // All parameters are uncertain, so that no pixel is certain.
  const auto file = [&](double scale) {
    std::string text = "covariance cam0 kb4 fx fy cx cy\n";
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) text += (i == j ? std::to_string(scale * scale) : "0") + (j < 3 ? " " : "\n");
    }
    return files.folder.write("covariance.csv", text);
  };
  const auto code = [&](double scale) {
    return run_program({"convert", files.chain, "--to", "kalibr", "--model", "eucm", "--max-angle", "90", "--with", file(scale),
                        "--max-error", "0.2sigma"})
        .code;
  };
  const Told told({"convert", files.chain, "--to", "kalibr", "--model", "eucm", "--max-angle", "90", "--with", file(1.0)});
  const double sigmas = told.json()["cameras"][0]["uncertainty"]["error_sigmas"].GetDouble();
  ASSERT_GT(sigmas, 0.0);
  EXPECT_EQ(code(1.05 * sigmas / 0.2), 0);
  EXPECT_EQ(code(0.95 * sigmas / 0.2), 1);
}

TEST(OwnUncertainty, TakesCareOffAnErrorBelowIt) {
  const Files files;
  // A fit that is off by more than is ready, and less than is wrong.
  const std::vector<std::string> words = {"convert", files.chain, "--to", "kalibr", "--model", "ucm"};
  const Told before(words);
  ASSERT_EQ(std::string(before.json()["verdict"]["word"].GetString()), "use-with-care") << before.text();
  const auto word = [&](double sigma_px) {
    std::vector<std::string> with = words;
    with.insert(with.end(), {"--with", files.with(sigma_px)});
    return std::string(Told(with).json()["verdict"]["word"].GetString());
  };
  EXPECT_EQ(word(4.0), "ready");
  EXPECT_EQ(word(0.01), "use-with-care");
}

TEST(OwnUncertainty, FollowsTheImages) {
  const Files files;
  const auto max_px = [&](const std::vector<std::string>& further) {
    std::vector<std::string> words = {"convert", files.chain, "--with", files.with(0.5), "--to", "kalibr", "--model", "eucm"};
    words.insert(words.end(), further.begin(), further.end());
    return Told(words).json()["cameras"][0]["uncertainty"]["max_px"].GetDouble();
  };
  EXPECT_NEAR(max_px({"--resize", "256x256"}) / max_px({}), 0.5, 0.01);
}

TEST(OwnUncertainty, IsShownAndDrawn) {
  const Files files;
  const RunResult shown = run_program({"show", files.chain, "--with", files.report});
  EXPECT_EQ(shown.code, 0) << shown.err;
  EXPECT_TRUE(contains(shown.out, "fx 0.11")) << shown.out;
  const Told json({"show", files.chain, "--with", files.report});
  EXPECT_EQ(json.json()["files"][0]["uncertainties"][0]["sigmas"]["k4"].GetDouble(), 0.0002);
  const RunResult page = run_program({"report", files.chain, "--with", files.report, "--to", "kalibr", "--model", "eucm"});
  EXPECT_EQ(page.code, 0) << page.err;
  EXPECT_TRUE(contains(page.out, "own uncertainty")) << "neither said nor drawn";
}

TEST(OwnUncertainty, WhereItIsUnknownTwoCalibrationsAreTheMeasure) {
  const Files files;
  const Told told({"convert", files.chain, "--to", "kalibr", "--model", "eucm", "--max-angle", "90"});
  const auto& camera = told.json()["cameras"][0];
  ASSERT_TRUE(camera.HasMember("repeatability"));
  EXPECT_FALSE(camera.HasMember("uncertainty"));
  EXPECT_NEAR(camera["repeatability"]["times_the_error"].GetDouble() * camera["error_px"]["rms"].GetDouble(),
              camera["repeatability"]["rms_px"].GetDouble(), 1e-9);
  const Told kept({"convert", files.chain, "--to", "kalibr"});
  EXPECT_FALSE(kept.json()["cameras"][0].HasMember("repeatability")) << "nothing is off";
}

TEST(CommonLens, IsWrittenForBothFisheyes) {
  const Files files;
  const auto run = [&](const std::string& layout) {
    return Told({"convert", files.pair, "--to", "orbslam3", "--orbslam3-layout", layout, "--max-angle", "90", "--accept",
                 "pixels-off"});
  };
  const Told plain = run("v1");
  const Told common = run("v1-common");
  ASSERT_EQ(common.code(), 0) << common.text();
  const auto rms = [](const Told& told, unsigned camera) {
    return told.json()["cameras"][camera]["in_image_px"]["rms"].GetDouble();
  };
  EXPECT_LT(rms(plain, 0), 1e-3);
  EXPECT_LT(rms(common, 1), 0.6 * rms(plain, 1)) << "as V1.0 sees the second camera";
  EXPECT_NEAR(rms(common, 0), rms(common, 1), 0.3 * rms(common, 1)) << "both give way";
  EXPECT_TRUE(common.says("common-lens", "cam1"));
  for (const char* key : {"k1", "k2", "k3", "k4"}) {
    EXPECT_EQ(common.json()["cameras"][0]["parameters"][key].GetDouble(),
              common.json()["cameras"][1]["parameters"][key].GetDouble());
  }
  const Told mono({"convert", files.pair, "--to", "orbslam3", "--orbslam3-layout", "v1-common", "--sensor", "mono"});
  EXPECT_TRUE(mono.says("layout-unfit", "v1-common")) << mono.text();
  const Told single({"convert", files.chain, "--to", "orbslam3", "--orbslam3-layout", "v1-common"});
  EXPECT_EQ(single.code(), 3);
  EXPECT_TRUE(single.says("layout-unfit", "v1-common")) << single.text();
}

}  // namespace
}  // namespace fca::test
