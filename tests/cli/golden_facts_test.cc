// SPDX-License-Identifier: BSD-3-Clause
// Facts that conversions between real programs' files must meet, by the numbers in the files themselves: read here by
// cv::FileStorage or as text, by none of our readers.
#include "cli/run_program.h"
#include "cli/told.h"

#include <cmath>
#include <sstream>

#include <opencv2/core.hpp>

namespace fca::test {
namespace {

/// The numbers between the brackets after a key.
std::vector<double> numbers_behind(const std::string& text, const std::string& key) {
  const std::size_t at = text.find("[", text.find(key + ":"));
  EXPECT_NE(at, std::string::npos) << key << " in " << text;
  std::vector<double> numbers;
  std::istringstream stream(text.substr(at + 1, text.find(']', at) - at - 1));
  for (std::string number; std::getline(stream, number, ',');) numbers.push_back(std::stod(number));
  return numbers;
}

cv::Mat matrix_in(const std::string& bytes, const std::string& key) {
  const cv::FileStorage storage(bytes, cv::FileStorage::READ | cv::FileStorage::MEMORY);
  cv::Mat matrix;
  storage[key] >> matrix;
  EXPECT_FALSE(matrix.empty()) << key << " in " << bytes;
  return matrix;
}

/// T_cn_cnm1 of TUM VI's second camera, row by row.
std::vector<std::vector<double>> kalibr_rows() {
  const std::string text = read_file(kTumvi);
  std::vector<std::vector<double>> rows;
  std::string rest = text.substr(text.find("T_cn_cnm1:"));
  for (int row = 0; row < 4; ++row) {
    const std::size_t bracket = rest.find("- [");
    rows.push_back(numbers_behind("row:" + rest.substr(bracket), "row"));
    rest = rest.substr(bracket + 3);
  }
  return rows;
}

// ns15417/slam_no_opt's files say t_image = t_imu + Camera.delaytoimu; Kalibr, t_imu = t_cam + timeshift_cam_imu.
TEST(GoldenFacts, SlamNoOptsDelayIsKalibrsTimeshiftWithTheOtherSign) {
  const TemporaryFolder folder;
  const std::string settings = read_file(testdata("formats/orbslam3/good/slam-no-opt-eucm.yaml"));
  const std::string delayed = folder.write("delayed.yaml", settings + "Camera.delaytoimu: 0.0125 # by hand\n");
  const RunResult to_kalibr = run_program({"convert", delayed, "--to", "kalibr"});
  EXPECT_TRUE(contains(to_kalibr.out, "timeshift_cam_imu: -0.0125\n")) << to_kalibr.out << to_kalibr.err;
  // The other way, into the fork's file: that number alone, and its comment stays.
  const std::string chain = folder.write("chain.yaml", with_replaced(to_kalibr.out, "-0.0125", "0.5"));
  const RunResult back =
      run_program({"convert", chain, "--to", "orbslam3", "--model", "eucm", "--into", delayed, "--accept", "program-refuses"});
  EXPECT_TRUE(contains(back.out, "Camera.delaytoimu: -0.5 # by hand\n")) << back.out << back.err;
  EXPECT_FALSE(contains(back.err, "time-offset-dropped")) << back.err;
}

// cv::stereoCalibrate: p_2 = R p_1 + T. Kalibr: p_cam1 = T_cn_cnm1 p_cam0.
TEST(GoldenFacts, OpenCvsRAndTAreKalibrsTCnCnm1) {
  const std::vector<std::vector<double>> kalibr = kalibr_rows();
  const RunResult run = run_program({"convert", kTumvi, "--to", "opencv", "--opencv-layout", "stereo"});
  ASSERT_EQ(run.code, 0) << run.err;
  const cv::Mat R = matrix_in(run.out, "R");
  const cv::Mat T = matrix_in(run.out, "T");
  ASSERT_EQ(R.total(), 9U);
  ASSERT_EQ(T.total(), 3U);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) EXPECT_EQ(R.at<double>(row, column), kalibr[row][column]);
    EXPECT_EQ(T.at<double>(row), kalibr[row][3]);
  }
}

// ORB-SLAM3: p_c1 = T_c1_c2 p_c2, a rigid motion the other way: R' = R^T, t' = -R^T t.
TEST(GoldenFacts, OrbSlam3sTC1C2IsItsInverse) {
  const std::vector<std::vector<double>> kalibr = kalibr_rows();
  const RunResult run = run_program({"convert", kTumvi, "--to", "orbslam3", "--orbslam3-layout", "v1"});
  ASSERT_EQ(run.code, 0) << run.err;
  const cv::Mat T = matrix_in(run.out, "Stereo.T_c1_c2");
  ASSERT_EQ(T.type(), CV_32F);
  for (int row = 0; row < 3; ++row) {
    double translation = 0.0;
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(T.at<float>(row, k), kalibr[k][row], 1e-6);
      translation -= kalibr[k][row] * kalibr[k][3];
    }
    EXPECT_NEAR(T.at<float>(row, 3), translation, 1e-7);
  }
}

// Mei's model without distortion (m = (x, y) / (z + xi d)) divided by 1 + xi is the unified model, alpha = xi / (1 + xi). To
// take f as it stands, as a known tool does, is 212 px wrong.
TEST(GoldenFacts, OmniWithoutDistortionIsTheUnifiedModelBothWays) {
  constexpr double kXi = 1.75;
  constexpr double kFocal = 660.0;
  const std::string omni =
      "cam0:\n  camera_model: omni\n  distortion_coeffs: [0.0, 0.0, 0.0, 0.0]\n  distortion_model: radtan\n"
      "  intrinsics: [1.75, 660.0, 655.0, 319.5, 241.25]\n  resolution: [640, 480]\n";
  const TemporaryFolder folder;
  const Told there({"convert", folder.write("omni.yaml", omni), "--to", "kalibr", "--model", "ucm", "-o", folder / "ucm.yaml"});
  ASSERT_EQ(there.code(), 0) << there.text();
  EXPECT_STREQ(there.json()["cameras"][0]["from_model"].GetString(), "mei");
  EXPECT_TRUE(there.json()["cameras"][0]["exact"].GetBool()) << there.text();
  // alpha beta fu fv pu pv
  const std::vector<double> eucm = numbers_behind(read_file(folder / "ucm.yaml"), "intrinsics");
  ASSERT_EQ(eucm.size(), 6U);
  EXPECT_NEAR(eucm[0], kXi / (1 + kXi), 1e-12);
  EXPECT_EQ(eucm[1], 1.0);
  EXPECT_NEAR(eucm[2], kFocal / (1 + kXi), 1e-9);
  EXPECT_NEAR(eucm[3], 655.0 / (1 + kXi), 1e-9);
  EXPECT_NEAR(eucm[4], 319.5, 1e-9);
  const RunResult back = run_program({"convert", folder / "ucm.yaml", "--to", "kalibr", "--model", "mei", "--anew"});
  ASSERT_EQ(back.code, 0) << back.err;
  // xi fu fv pu pv
  const std::vector<double> mei = numbers_behind(back.out, "intrinsics");
  ASSERT_EQ(mei.size(), 5U);
  EXPECT_NEAR(mei[0], kXi, 1e-9);
  EXPECT_NEAR(mei[1], kFocal, 1e-6);
  EXPECT_NEAR(mei[2], 655.0, 1e-6);
}

}  // namespace
}  // namespace fca::test
