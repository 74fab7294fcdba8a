// SPDX-License-Identifier: BSD-3-Clause
// --crop, --binning and --resize: whatever the format, the file written has the calibrated camera's pixels, mapped.
#include "cli/read_rig.h"
#include "cli/run_program.h"
#include "cli/told.h"

#include <fca/formats/text/numbers.h>
#include <fca/rig/image_change.h>

#include <cmath>
#include <sstream>

namespace fca::test {
namespace {

/// Both cameras' pixels of rays over the lens, the first's mapped.
void expect_mapped(const Camera& before, const PixelMap& map, const Camera& after) {
  constexpr double kTolerancePx = 1e-9;
  int compared = 0;
  for (double u = 1.0; u < before.image_size->width; u += before.image_size->width / 9.0) {
    for (double v = 1.0; v < before.image_size->height; v += before.image_size->height / 9.0) {
      const std::optional<Ray> ray = unproject(before.model, {u, v});
      if (!ray) continue;
      const std::optional<Pixel> pixel = project(after.model, *ray);
      ASSERT_TRUE(pixel);
      const Pixel expected = map({u, v});
      EXPECT_NEAR((*pixel)[0], expected[0], kTolerancePx);
      EXPECT_NEAR((*pixel)[1], expected[1], kTolerancePx);
      ++compared;
    }
  }
  EXPECT_GT(compared, 20);
}

// An anisotropic one: each format says two focal lengths in its own way.
TEST(ImageChange, EveryFormatSaysTheNewCameras) {
  const ImageChange change = {.crop = ImageRegion{16, 8, {400, 380}}, .binning = 2, .resize = ImageSize{300, 200}};
  for (const char* file :
       {"kalibr/good/tumvi.yaml", "kalibr/good/ds.yaml", "kalibr/good/omni.yaml", "opencv/good/calibration.yml",
        "opencv/good/fisheye.json", "opencv/good/omnidir.xml", "ocamcalib/good/toolbox.txt", "dso/good/equidistant.txt",
        "dso/good/radtan-bare.txt", "orbslam3/good/v1-stereo-inertial.yaml", "orbslam3/good/slam-no-opt-eucm.yaml",
        "woodscape/good/front.json"}) {
    SCOPED_TRACE(file);
    const std::string path = testdata(std::string("formats/") + file);
    const std::string format = std::string(file).substr(0, std::string(file).find('/'));
    const Rig before = rig_in(read_file(path));
    const std::string model(model_info(before.cameras.front().model).id);  // a fork's, too, only where it is asked for
    const RunResult run = run_program({"convert", path, "--to", format, "--model", model, "--crop", "16,8,400,380", "--binning",
                                       "2", "--resize", "300x200", "--max-angle", "60"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(says(run.err, "images-changed")) << run.err;
    const Rig after = rig_in(run.out);
    ASSERT_EQ(before.cameras.size(), after.cameras.size());
    for (std::size_t i = 0; i < before.cameras.size(); ++i) {
      EXPECT_EQ(after.cameras[i].image_size, change.resize);
      Diagnostics diagnostics;
      const std::optional<ChangedImage> changed = changed_image(*before.cameras[i].image_size, change, diagnostics);
      ASSERT_TRUE(changed);
      expect_mapped(before.cameras[i], changed->map, after.cameras[i]);
    }
    EXPECT_EQ(before.poses, after.poses);
  }
}

/// The second polynomial of a calib_results.txt, read as the program's scanf does: a count and as many coefficients.
std::vector<double> inverse_polynomial(const std::string& bytes) {
  std::istringstream stream(bytes.substr(bytes.find('\n', bytes.find("inverse mapping"))));
  std::size_t count = 0;
  stream >> count;
  std::vector<double> coefficients(count);
  for (double& coefficient : coefficients) stream >> coefficient;
  EXPECT_TRUE(stream) << bytes;
  return coefficients;
}

// rho(theta) = sum b_i theta^i is the radius in pixels: in images s times as large it is s times as long, at every angle.
TEST(ImageChange, AnOCamCalibFilesOwnInversePolynomialIsScaled) {
  const std::string path = testdata("formats/ocamcalib/good/toolbox.txt");
  const std::vector<double> before = inverse_polynomial(read_file(path));
  ASSERT_EQ(before.size(), 19U);
  const auto radius = [](const std::vector<double>& b, double theta) {
    double rho = 0.0;
    for (std::size_t i = 0; i < b.size(); ++i) rho += b[i] * std::pow(theta, static_cast<double>(i));
    return rho;
  };
  struct Case {
    std::vector<std::string> options;
    double scale;
  };
  for (const Case& c :
       {Case{{"--binning", "2"}, 0.5}, Case{{"--resize", "1920x1200"}, 2.0}, Case{{"--resize", "320x200"}, 1.0 / 3.0}}) {
    std::vector<std::string> words = {"convert", path, "--to", "ocamcalib"};
    words.insert(words.end(), c.options.begin(), c.options.end());
    const Told run(words);
    ASSERT_EQ(run.code(), 0) << run.text();
    EXPECT_TRUE(run.json()["defaults"].Empty()) << run.text();  // it is the input's, not one that is fitted here
    const std::vector<double> after = inverse_polynomial(run.bytes());
    ASSERT_EQ(after.size(), before.size()) << run.bytes();
    for (double theta = -1.5; theta < 0.5; theta += 0.05) {
      const double expected = c.scale * radius(before, theta);
      EXPECT_NEAR(radius(after, theta), expected, 1e-11 * (1.0 + std::abs(expected))) << theta;
    }
  }
}

// What TUM VI's authors publish for 1024 and for 512 pixels (rpng/open_vins issue 152 names both calibrations).
TEST(ImageChange, TumVi1024BecomesTumVi512) {
  const TemporaryFolder folder;
  std::string chain = read_file(kTumvi);
  for (const auto& [small, large] : {std::pair("[512, 512]", "[1024, 1024]"), std::pair("[512, 512]", "[1024, 1024]"),
                                     std::pair("190.97847715128717, 190.9733070521226", "381.9570, 381.9466"),
                                     std::pair("190.44236969414825, 190.4344384721956", "380.8847, 380.8689"),
                                     std::pair("254.93170605935475, 256.8974428996504", "510.3634, 514.2949"),
                                     std::pair("252.59949716835982, 254.91723064636983", "505.6990, 510.3345")})
    chain = with_replaced(chain, small, large);
  const RunResult run = run_program({"convert", folder.write("1024.yaml", chain), "--to", "kalibr", "--resize", "512x512"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Rig published = rig_in(read_file(kTumvi));
  const Rig resized = rig_in(run.out);
  for (std::size_t i = 0; i < published.cameras.size(); ++i) {
    EXPECT_EQ(resized.cameras[i].image_size, published.cameras[i].image_size);
    for (std::size_t axis = 0; axis < 2; ++axis)
      EXPECT_NEAR(principal_point(resized.cameras[i].model)[axis], principal_point(published.cameras[i].model)[axis], 1e-3);
  }
}

TEST(ImageChange, ProjectAnswersForTheNewImages) {
  const RunOptions ray{"0.3 -0.2 1\n"};
  const RunResult whole = run_program({"project", kTumvi, "--camera", "cam0"}, ray);
  const RunResult binned = run_program({"project", kTumvi, "--camera", "cam0", "--binning", "2"}, ray);
  std::istringstream before(whole.out);
  std::istringstream after(binned.out);
  double u[2] = {};
  double v[2] = {};
  before >> u[0] >> v[0];
  after >> u[1] >> v[1];
  EXPECT_NEAR(u[1], (u[0] + 0.5) / 2 - 0.5, 1e-9) << binned.out << binned.err;
  EXPECT_NEAR(v[1], (v[0] + 0.5) / 2 - 0.5, 1e-9);
}

// P1, P2 and Q of cv::stereoRectify stay in an edited file; that they are of other images is said.
TEST(ImageChange, WhatAnEditCannotKnowIsWarnedOf) {
  const std::string stereo = testdata("formats/opencv/good/stereo-14.yml");
  const RunResult run = run_program({"convert", stereo, "--size", "640x480", "--to", "opencv", "--binning", "2"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(says(run.err, "stale-derived")) << run.err;
  EXPECT_FALSE(contains(run_program({"convert", stereo, "--size", "640x480", "--to", "opencv"}).err, "stale-"));
  const RunResult rewritten =
      run_program({"convert", stereo, "--size", "640x480", "--to", "opencv", "--binning", "2", "--rewrite"});
  EXPECT_FALSE(contains(rewritten.err, "stale-")) << rewritten.err;
}

TEST(ImageChange, WhatMakesNoImageIsRefused) {
  const auto code = [](const std::string& option, const std::string& value) {
    const RunResult run = run_program({"show", kTumvi, option, value});
    EXPECT_NE(run.err, "");
    return run.code;
  };
  for (const char* region : {"1,2,3", "1,2,3,4,5", "a,b,c,d", "1;2;3;4"}) EXPECT_EQ(code("--crop", region), 3) << region;
  for (const char* bins : {"0", "-1", "1.5", "two"}) EXPECT_EQ(code("--binning", bins), 3) << bins;
  for (const char* size : {"640", "0x480", "640x"}) EXPECT_EQ(code("--resize", size), 3) << size;
  EXPECT_EQ(code("--crop", "500,0,100,100"), 2);
  EXPECT_EQ(code("--binning", "513"), 2);
  const RunResult sizeless = run_program({"show", testdata("formats/opencv/good/stereo-14.yml"), "--binning", "2"});
  EXPECT_EQ(sizeless.code, 2);
  EXPECT_TRUE(says(sizeless.err, "image-size-missing", "--size")) << sizeless.err;
}

// OCamCalib's two polynomials are separate fits, which differ most near the axis: the proof must not take that for ours.
TEST(ImageChange, OCamCalibsOwnDisagreementIsNotHeldAgainstTheFile) {
  const fs::path folder = fs::path(FCA_SHARED_DIR) / "corpus" / "ocamcalib";
  if (!fs::exists(folder)) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  const TemporaryFolder output;
  int files = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string path = entry.path().string();
    const RunResult run =
        run_program({"convert", path, "--to", "ocamcalib", "--binning", "2", "-o", output / "binned.txt", "--force"});
    EXPECT_FALSE(says(run.err, "proof-failed")) << path << "\n" << run.err;
    files += run.code == 0 ? 1 : 0;
  }
  EXPECT_GE(files, 30);
}

}  // namespace
}  // namespace fca::test
