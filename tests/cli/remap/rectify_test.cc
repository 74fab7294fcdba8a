// SPDX-License-Identifier: BSD-3-Clause
// rectify's maps, images and settings are OpenCV's for the same rotations and camera, and put matches into rows.
#include "cli/told.h"
#include "images.h"

#include <fca/formats/calibration.h>
#include <fca/formats/text/read_document.h>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace fca::test {
namespace {

/// A pair as OpenCV has it.
struct Pair {
  bool is_fisheye = false;
  cv::Size size;
  std::array<cv::Matx33d, 2> K;
  std::array<std::vector<double>, 2> D;
  cv::Matx33d R;
  cv::Vec3d T;
};

cv::Matx33d turned(double x, double y, double z) {
  cv::Matx33d R;
  cv::Rodrigues(cv::Vec3d(x, y, z), R);
  return R;
}

/// EuRoC's lenses, on a head of our own.
Pair narrow() {
  return {false,
          {752, 480},
          {cv::Matx33d(458.654, 0, 367.215, 0, 457.296, 248.375, 0, 0, 1),
           cv::Matx33d(457.587, 0, 379.999, 0, 456.134, 255.238, 0, 0, 1)},
          {std::vector<double>{-0.28340811, 0.07395907, 0.00019359, 1.76187114e-05, 0.0},
           std::vector<double>{-0.28368365, 0.07451284, -0.00010473, -3.55590700e-05, 0.0}},
          turned(0.004, -0.01, 0.002),
          {-0.11, 0.0004, -0.0008}};
}

/// TUM-VI's lenses.
Pair wide() {
  return {true,
          {512, 512},
          {cv::Matx33d(190.978, 0, 254.931, 0, 190.973, 256.897, 0, 0, 1),
           cv::Matx33d(190.442, 0, 252.599, 0, 190.434, 254.917, 0, 0, 1)},
          {std::vector<double>{0.00348, 0.000715, -0.00205, 0.000203}, std::vector<double>{0.0034, 0.00177, -0.00266, 0.00033}},
          turned(0.047, 0.0007, 0.0008),
          {-0.101, -0.002, -0.0012}};
}

std::string numbers(const double* values, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += (i == 0 ? "" : ", ") + cv::format("%.17g", values[i]);
  return "[" + text + "]";
}

std::string matrix(const std::string& key, const double* values, int rows, int cols) {
  return key + ": !!opencv-matrix\n   rows: " + std::to_string(rows) + "\n   cols: " + std::to_string(cols) +
         "\n   dt: d\n   data: " + numbers(values, rows * cols) + "\n";
}

/// The pair as a camchain.
std::string chain(const Pair& pair, bool is_exchanged = false) {
  std::string text;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t camera = is_exchanged ? 1 - i : i;
    const cv::Matx33d& K = pair.K.at(camera);
    const std::array<double, 4> k = {K(0, 0), K(1, 1), K(0, 2), K(1, 2)};
    text += "cam" + std::to_string(i) + ":\n  camera_model: pinhole\n  intrinsics: " + numbers(k.data(), 4) +
            "\n  distortion_model: " + (pair.is_fisheye ? "equidistant" : "radtan") +
            "\n  distortion_coeffs: " + numbers(pair.D.at(camera).data(), 4) +
            cv::format("\n  resolution: [%d, %d]\n", pair.size.width, pair.size.height);
  }
  const cv::Matx33d R = is_exchanged ? pair.R.t() : pair.R;
  const cv::Vec3d T = is_exchanged ? -(pair.R.t() * pair.T) : pair.T;
  text += "  T_cn_cnm1:\n";
  for (int row = 0; row < 3; ++row) {
    const std::array<double, 4> values = {R(row, 0), R(row, 1), R(row, 2), T[row]};
    text += "    - " + numbers(values.data(), 4) + "\n";
  }
  return text + "    - [0.0, 0.0, 0.0, 1.0]\n";
}

struct Rectified {
  cv::Matx33d R1, R2;
  cv::Matx34d P1, P2;
  cv::Matx44d Q;
};

Rectified by_opencv(const Pair& pair, double alpha) {
  Rectified result;
  cv::stereoRectify(pair.K[0], pair.D[0], pair.K[1], pair.D[1], pair.size, pair.R, pair.T, result.R1, result.R2, result.P1,
                    result.P2, result.Q, cv::CALIB_ZERO_DISPARITY, alpha);
  return result;
}

/// OpenCV's sample stereo_calib.cpp writes such files.
std::string intrinsics(const Pair& pair) {
  return "%YAML:1.0\n---\n" + matrix("M1", pair.K[0].val, 3, 3) + matrix("D1", pair.D[0].data(), 1, 5) +
         matrix("M2", pair.K[1].val, 3, 3) + matrix("D2", pair.D[1].data(), 1, 5);
}
std::string extrinsics(const Pair& pair, const Rectified& rectified) {
  return "%YAML:1.0\n---\n" + matrix("R", pair.R.val, 3, 3) + matrix("T", pair.T.val, 3, 1) +
         matrix("R1", rectified.R1.val, 3, 3) + matrix("R2", rectified.R2.val, 3, 3) + matrix("P1", rectified.P1.val, 3, 4) +
         matrix("P2", rectified.P2.val, 3, 4) + matrix("Q", rectified.Q.val, 4, 4);
}

cv::Matx33d rotation_in(const rapidjson::Value& view) {
  cv::Matx33d R;
  for (unsigned i = 0; i < 9; ++i) R.val[i] = view["T_rectified_camera"][i / 3 * 4 + i % 3].GetDouble();
  return R;
}

cv::Matx33d camera_in(const rapidjson::Value& pair, unsigned view) {
  return {pair["fx"].GetDouble(),
          0,
          pair["views"][view]["cx"].GetDouble(),
          0,
          pair["fy"].GetDouble(),
          pair["views"][view]["cy"].GetDouble(),
          0,
          0,
          1};
}

/// The map of OpenCV for the pair's own rotations and camera.
cv::Mat2f opencv_map(const Pair& pair, const rapidjson::Value& json, unsigned view, const cv::Size& size) {
  cv::Mat u;
  cv::Mat v;
  const cv::Matx33d R = rotation_in(json["views"][view]);
  const cv::Matx33d P = camera_in(json, view);
  if (pair.is_fisheye) {
    cv::fisheye::initUndistortRectifyMap(pair.K.at(view), pair.D.at(view), R, P, size, CV_32FC1, u, v);
  } else {
    cv::initUndistortRectifyMap(pair.K.at(view), pair.D.at(view), R, P, size, CV_32FC1, u, v);
  }
  cv::Mat map;
  cv::merge(std::vector<cv::Mat>{u, v}, map);
  return map;
}

TEST(Rectify, MapsAreOpenCvs) {
  for (const Pair& pair : {narrow(), wide()}) {
    const TemporaryFolder folder;
    const std::string file = folder.write("chain.yaml", chain(pair));
    const Told told({"rectify", file, "--maps", "-o", folder / "out/"});
    ASSERT_EQ(told.code(), 0) << told.text();
    const auto& json = told.json()["pair"];
    for (unsigned view = 0; view < 2; ++view) {
      const std::string name = view == 0 ? "out/left_map.npy" : "out/right_map.npy";
      const cv::Mat2f map = read_npy(folder / name, pair.size.width, pair.size.height);
      const cv::Mat2f expected = opencv_map(pair, json, view, pair.size);
      int seen = 0;
      for (int v = 0; v < map.rows; ++v) {
        for (int u = 0; u < map.cols; ++u) {
          if (std::isnan(map(v, u)[0])) continue;
          ++seen;
          ASSERT_NEAR(map(v, u)[0], expected(v, u)[0], 1e-3) << u << " " << v;
          ASSERT_NEAR(map(v, u)[1], expected(v, u)[1], 1e-3) << u << " " << v;
        }
      }
      EXPECT_EQ(seen, map.rows * map.cols);
    }
  }
}

/// What cv::remap shows of an image of gradients.
cv::Mat1b shown(const cv::Mat1b& image, const cv::Mat& map1, const cv::Mat& map2) {
  cv::Mat1b seen;
  cv::remap(image, seen, map1, map2, cv::INTER_LINEAR);
  return seen;
}

TEST(Rectify, MapsOfOpenCvShowTheSame) {
  const Pair pair = wide();
  cv::Mat1b image(pair.size);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) image(v, u) = static_cast<std::uint8_t>((u + v) / 8 + 20);
  }
  // Above a million pixels the text is compressed.
  for (const cv::Size size : {pair.size, cv::Size(1024, 1024)}) {
    const TemporaryFolder folder;
    const std::string file = folder.write("chain.yaml", chain(pair));
    const auto written = [&](const std::string& format, const std::string& name) {
      const Told told({"rectify", file, "--map-format", format, "--out-size", cv::format("%dx%d", size.width, size.height),
                       "-o", folder / (format + "/")});
      EXPECT_EQ(told.code(), 0) << told.text();
      EXPECT_TRUE(std::string(told.json()["maps"][0].GetString()).ends_with(name));
      return folder / (format + "/" + name);
    };
    const std::string extension = size.area() > 1'000'000 ? ".yml.gz" : ".yml";
    const cv::Mat2f map = read_npy(written("npy", "left_map.npy"), size.width, size.height);
    const cv::Mat1b expected = shown(image, map, cv::Mat());
    for (const std::string format : {"float", "fixed"}) {
      const cv::FileStorage storage(written(format, "left_map" + extension), cv::FileStorage::READ);
      ASSERT_TRUE(storage.isOpened());
      cv::Mat map1;
      cv::Mat map2;
      storage["map1"] >> map1;
      storage["map2"] >> map2;
      EXPECT_EQ(map1.type(), format == "float" ? CV_32FC1 : CV_16SC2);
      EXPECT_EQ(map2.type(), format == "float" ? CV_32FC1 : CV_16UC1);
      EXPECT_LE(cv::norm(shown(image, map1, map2), expected, cv::NORM_INF), format == "float" ? 0.0 : 1.0);
    }
  }
}

TEST(Rectify, RotationsAreOpenCvsInEitherOrder) {
  const Pair pair = narrow();
  const TemporaryFolder folder;
  const Rectified theirs = by_opencv(pair, 0);
  for (const bool is_exchanged : {false, true}) {
    const Told told({"rectify", folder.write("chain.yaml", chain(pair, is_exchanged))});
    ASSERT_EQ(told.code(), 0) << told.text();
    const auto& json = told.json()["pair"];
    EXPECT_EQ(json["exchanged"].GetBool(), is_exchanged);
    EXPECT_STREQ(json["views"][0]["camera"].GetString(), is_exchanged ? "cam1" : "cam0");
    EXPECT_LE(cv::norm(rotation_in(json["views"][0]) - theirs.R1, cv::NORM_INF), 1e-12);
    EXPECT_LE(cv::norm(rotation_in(json["views"][1]) - theirs.R2, cv::NORM_INF), 1e-12);
    EXPECT_NEAR(json["baseline_m"].GetDouble(), cv::norm(pair.T), 1e-12);
    EXPECT_NEAR(json["fx"].GetDouble(), theirs.P1(0, 0), 0.5);
    EXPECT_LE(told.json()["vertical_disparity"]["at_ten_baselines"]["max_px"].GetDouble(), 1e-9);
  }
}

// Points in front of the cameras, through OpenCV's lenses and back.
TEST(Rectify, MatchesLieInOneRow) {
  const Pair pair = narrow();
  const TemporaryFolder folder;
  const Told told({"rectify", folder.write("chain.yaml", chain(pair))});
  ASSERT_EQ(told.code(), 0) << told.text();
  const auto& json = told.json()["pair"];
  std::mt19937 random(5);
  std::uniform_real_distribution<double> one(-1.0, 1.0);
  std::vector<cv::Point3d> points;
  for (int i = 0; i < 1000; ++i) points.emplace_back(0.5 * one(random), 0.3 * one(random), 1.5 + one(random));
  std::array<std::vector<cv::Point2d>, 2> rectified;
  cv::Vec3d turn;
  cv::Rodrigues(pair.R, turn);
  for (unsigned i = 0; i < 2; ++i) {
    std::vector<cv::Point2d> pixels;
    cv::projectPoints(points, i == 0 ? cv::Vec3d() : turn, i == 0 ? cv::Vec3d() : pair.T, pair.K.at(i), pair.D.at(i), pixels);
    cv::undistortPoints(pixels, rectified.at(i), pair.K.at(i), pair.D.at(i), rotation_in(json["views"][i]), camera_in(json, i),
                        cv::TermCriteria(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-12));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(rectified[0][i].y, rectified[1][i].y, 0.05);
    EXPECT_GT(rectified[0][i].x, rectified[1][i].x);
  }
}

/// By OpenCV, where a rectified image of that rotation and camera shows a pixel of the camera's own; not a number outside it.
cv::Point2d rectified_by_opencv(const Camera& camera, const Pixel& pixel, const cv::Matx33d& R, const cv::Matx33d& P) {
  const std::span<const double> p = parameter_values(camera.model);
  const cv::Matx33d K(p[0], 0, p[2], 0, p[1], p[3], 0, 0, 1);
  const std::vector<double> D(p.begin() + 4, p.begin() + 8);
  const std::vector<cv::Point2d> pixels = {{pixel[0], pixel[1]}};
  std::vector<cv::Point2d> rectified;
  if (model_info(camera.model).id == "kb4") {
    cv::fisheye::undistortPoints(pixels, rectified, K, D, R, P);
  } else {
    cv::undistortPoints(pixels, rectified, K, D, R, P,
                        cv::TermCriteria(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-12));
  }
  return rectified.front();
}

bool opencv_has(const Camera& camera) {
  const std::string_view model = model_info(camera.model).id;
  return model == "kb4" || (model == "radtan" && parameter(camera.model, "k3") == 0.0);
}

// Points that both rectified images show, seen by the cameras of the file.
TEST(Rectify, MatchesOfRealPairsLieInOneRow) {
  const fs::path corpus = fs::path(FCA_SHARED_DIR) / "corpus/kalibr";
  if (!fs::exists(corpus)) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(corpus)) files.push_back(entry.path());
  std::ranges::sort(files);
  int pairs = 0;
  std::mt19937 random(6);
  std::uniform_real_distribution<double> one(0.0, 1.0);
  for (const fs::path& file : files) {
    const Told told({"rectify", file.string()});
    if (told.code() != 0) continue;
    const auto& json = told.json()["pair"];
    Diagnostics diagnostics;
    std::optional<text::Document> document = text::parse_document({file.string(), read_file(file)}, diagnostics);
    ASSERT_TRUE(document);
    const std::optional<Calibration> calibration = read_calibration({*std::move(document)}, nullptr, {}, diagnostics);
    ASSERT_TRUE(calibration);
    const Rig& rig = calibration->rig;
    const Camera& first = *rig.find_camera(json["views"][0]["camera"].GetString());
    const Camera& second = *rig.find_camera(json["views"][1]["camera"].GetString());
    if (!opencv_has(first) || !opencv_has(second) || json["vertical"].GetBool()) continue;
    ++pairs;
    const Transform T = *rig.resolve(second.name, first.name);
    int seen = 0;
    for (int i = 0; i < 20000 && seen < 1000; ++i) {
      const Pixel pixel = {one(random) * first.image_size->width, one(random) * first.image_size->height};
      const std::optional<Ray> ray = unproject(first.model, pixel);
      const double metres = 1.0 + 20.0 * one(random);
      if (!ray || angle_from_axis(*ray) > 50.0 * kRadians) continue;
      Ray there{};
      for (int row = 0; row < 3; ++row) {
        there.at(static_cast<std::size_t>(row)) =
            metres * (T(row, 0) * (*ray)[0] + T(row, 1) * (*ray)[1] + T(row, 2) * (*ray)[2]) + T(row, 3);
      }
      const std::optional<Pixel> match = project(second.model, there);
      if (!match || !second.image_size->holds(*match) || angle_from_axis(there) > 50.0 * kRadians) continue;
      ++seen;
      const cv::Point2d left = rectified_by_opencv(first, pixel, rotation_in(json["views"][0]), camera_in(json, 0));
      const cv::Point2d right = rectified_by_opencv(second, *match, rotation_in(json["views"][1]), camera_in(json, 1));
      ASSERT_NEAR(left.y, right.y, 0.05) << file << " " << pixel[0] << " " << pixel[1];
    }
    EXPECT_GT(seen, 500) << file;
  }
  EXPECT_GE(pairs, 3);
}

double value_in(const std::string& path, const std::string& key) {
  const cv::FileStorage storage(path, cv::FileStorage::READ);
  return static_cast<double>(storage[key]);
}

TEST(Rectify, SettingsHaveTheCameraThatTheFileStates) {
  const Pair pair = narrow();
  const Rectified theirs = by_opencv(pair, 0);
  const TemporaryFolder folder;
  const std::string file = folder.write("intrinsics.yml", intrinsics(pair));
  const std::string part = folder.write("extrinsics.yml", extrinsics(pair, theirs));
  const std::vector<std::string> reading = {"rectify", file, "--with", part, "--size", "752x480"};
  const auto run = [&](std::vector<std::string> more) {
    std::vector<std::string> words = reading;
    words.insert(words.end(), more.begin(), more.end());
    const RunResult result = run_program(words);
    EXPECT_EQ(result.code, 0) << result.err;
    return result;
  };
  run({"--to", "orbslam3", "-o", folder / "settings.yaml"});
  EXPECT_EQ(static_cast<std::string>(cv::FileStorage(folder / "settings.yaml", cv::FileStorage::READ)["Camera.type"]),
            "Rectified");
  EXPECT_DOUBLE_EQ(value_in(folder / "settings.yaml", "Camera1.fx"), theirs.P1(0, 0));
  EXPECT_DOUBLE_EQ(value_in(folder / "settings.yaml", "Camera1.cy"), theirs.P1(1, 2));
  EXPECT_NEAR(value_in(folder / "settings.yaml", "Stereo.b"), -theirs.P2(0, 3) / theirs.P2(0, 0), 1e-15);

  run({"--to", "orbslam2", "-o", folder / "orbslam2.yaml"});
  EXPECT_NEAR(value_in(folder / "orbslam2.yaml", "Camera.bf"), -theirs.P2(0, 3), 1e-12);
  const cv::FileStorage two(folder / "orbslam2.yaml", cv::FileStorage::READ);
  for (const auto& [key, expected] : {std::pair<std::string, cv::Mat>{"LEFT.R", cv::Mat(theirs.R1)},
                                      {"RIGHT.R", cv::Mat(theirs.R2)},
                                      {"LEFT.P", cv::Mat(theirs.P1)},
                                      {"RIGHT.P", cv::Mat(theirs.P2)},
                                      {"RIGHT.K", cv::Mat(pair.K[1])}}) {
    cv::Mat there;
    two[key] >> there;
    ASSERT_EQ(there.size(), expected.size()) << key;
    EXPECT_LE(cv::norm(there, expected, cv::NORM_INF), 1e-12) << key;
  }

  // Whatever format holds the pair, it is the same one when it is read again.
  run({"--to", "opencv", "-o", folder / "stereo.yml"});
  run({"--to", "ros", "-o", folder / "ros/"});
  const Told before({"rectify", file, "--with", part, "--size", "752x480"});
  const std::vector<std::vector<std::string>> again = {
      {"rectify", folder / "stereo.yml"},
      {"rectify", folder / "orbslam2.yaml"},
      {"rectify", folder / "ros/cam0.yaml", "--with", folder / "ros/cam1.yaml"}};
  for (const std::vector<std::string>& words : again) {
    const Told after(words);
    ASSERT_EQ(after.code(), 0) << after.text();
    const auto& a = before.json()["pair"];
    const auto& b = after.json()["pair"];
    EXPECT_TRUE(b["stated"].GetBool()) << words[1];
    EXPECT_NEAR(a["fx"].GetDouble(), b["fx"].GetDouble(), 1e-9) << words[1];
    EXPECT_NEAR(a["baseline_m"].GetDouble(), b["baseline_m"].GetDouble(), 1e-12) << words[1];
    for (unsigned view = 0; view < 2; ++view) {
      EXPECT_LE(cv::norm(rotation_in(a["views"][view]) - rotation_in(b["views"][view]), cv::NORM_INF), 1e-12) << words[1];
      EXPECT_NEAR(a["views"][view]["cx"].GetDouble(), b["views"][view]["cx"].GetDouble(), 1e-9) << words[1];
    }
  }
}

TEST(Rectify, FilesThatStateTheirCamerasAreWrittenToEveryFormat) {
  const TemporaryFolder folder;
  const std::string file = folder.write("chain.yaml", chain(narrow()));
  const std::string orbslam2 = folder / "orbslam2.yaml";
  ASSERT_EQ(Told({"rectify", file, "--to", "orbslam2", "-o", orbslam2}).code(), 0);
  for (const std::string format : {"opencv", "ros", "orbslam3", "orbslam2"}) {
    const Told told({"rectify", orbslam2, "--to", format, "-o", folder / (format + "/")});
    EXPECT_EQ(told.code(), 0) << format << told.text();
    EXPECT_TRUE(told.json()["pair"]["stated"].GetBool());
  }
}

TEST(Rectify, AViewThatIsAskedForIsComputed) {
  const Pair pair = narrow();
  const TemporaryFolder folder;
  const std::string file = folder.write("intrinsics.yml", intrinsics(pair));
  const std::string part = folder.write("extrinsics.yml", extrinsics(pair, by_opencv(pair, 1)));
  const Told told({"rectify", file, "--with", part, "--size", "752x480", "--pinhole", "70", "--out-size", "640x400"});
  ASSERT_EQ(told.code(), 0) << told.text();
  const auto& json = told.json()["pair"];
  EXPECT_FALSE(json["stated"].GetBool());
  EXPECT_NEAR(json["fx"].GetDouble(), 320.0 / std::tan(35.0 * kRadians), 1e-9);
  EXPECT_EQ(json["width"].GetInt(), 640);
  EXPECT_NEAR(json["full_fov_deg"].GetDouble(), 70.0, 1e-9);
}

TEST(Rectify, LikeOpenCvIsOpenCv) {
  const Pair pair = narrow();
  const TemporaryFolder folder;
  for (const double alpha : {0.0, 0.7}) {
    const Rectified theirs = by_opencv(pair, alpha);
    const Told told({"rectify", folder.write("chain.yaml", chain(pair)), "--like-opencv", "--alpha", std::to_string(alpha)});
    ASSERT_EQ(told.code(), 0) << told.text();
    const auto& json = told.json()["pair"];
    EXPECT_NEAR(json["fx"].GetDouble(), theirs.P1(0, 0), 1e-9);
    EXPECT_NEAR(json["views"][1]["cy"].GetDouble(), theirs.P2(1, 2), 1e-9);
    EXPECT_LE(std::abs(told.json()["ours_minus_opencv"]["fx"].GetDouble()), 0.5);
  }
}

TEST(Rectify, ImagesOfFoldersKeepTheirNames) {
  const Pair pair = narrow();
  const TemporaryFolder folder;
  const std::string file = folder.write("chain.yaml", chain(pair));
  for (const char* side : {"l", "r"}) {
    fs::create_directories(folder / side);
    for (const char* name : {"/1.png", "/2.png"})
      folder.write(std::string(side) + name, bytes_of(noise(752, 480, CV_8UC1), ".png"));
  }
  const Told told({"rectify", file, folder / "l", folder / "r", "--maps", "-o", folder / "out/"});
  ASSERT_EQ(told.code(), 0) << told.text();
  for (const std::string side : {"left", "right"}) {
    const cv::Mat2f map = read_npy(folder / ("out/" + side + "_map.npy"), 752, 480);
    for (const char* name : {"/1.png", "/2.png"}) {
      cv::Mat expected;
      cv::remap(noise(752, 480, CV_8UC1), expected, map, cv::noArray(), cv::INTER_LINEAR);
      EXPECT_TRUE(same(read_picture(folder / ("out/" + side + name)), expected)) << side << name;
    }
  }
  EXPECT_EQ(told.json()["images"].Size(), 4U);
  // What is there stays.
  EXPECT_EQ(run_program({"rectify", file, folder / "l", folder / "r", "-o", folder / "out/"}).code, 4);
}

TEST(Rectify, RemapLikeACameraInfoIsImageProc) {
  const TemporaryFolder folder;
  const std::string file = folder.write("chain.yaml", chain(narrow()));
  ASSERT_EQ(run_program({"rectify", file, "--to", "ros", "--maps", "-o", folder / "out/"}).code, 0);
  const std::string camera = folder / "out/cam1.yaml";
  const RunResult run = run_program({"remap", camera, "--like", camera, "--map", folder / "map.npy"});
  ASSERT_EQ(run.code, 0) << run.err;
  const cv::Mat2f map = read_npy(folder / "map.npy", 752, 480);
  const cv::Mat2f expected = read_npy(folder / "out/right_map.npy", 752, 480);
  for (int v = 0; v < map.rows; v += 7) {
    for (int u = 0; u < map.cols; u += 7) {
      ASSERT_EQ(std::isnan(map(v, u)[0]), std::isnan(expected(v, u)[0]));
      if (std::isnan(map(v, u)[0])) continue;
      ASSERT_NEAR(map(v, u)[0], expected(v, u)[0], 1e-3);
      ASSERT_NEAR(map(v, u)[1], expected(v, u)[1], 1e-3);
    }
  }
}

// A small roll of the second camera moves the rows at the image's border by half its width times the angle.
TEST(Rectify, StereoFeelsAnotherPose) {
  const TemporaryFolder folder;
  Pair rolled = narrow();
  constexpr double kRoll = 2e-3;
  rolled.R = turned(0.0, 0.0, kRoll) * narrow().R;
  rolled.T = turned(0.0, 0.0, kRoll) * narrow().T;
  const std::string file = folder.write("chain.yaml", chain(narrow()));
  const Told told({"compare", file, folder.write("rolled.yaml", chain(rolled))});
  const auto& pair = told.json()["files"][0]["pair"];
  ASSERT_TRUE(pair.IsObject()) << told.text();
  const double expected = kRoll * 0.5 * 752;
  EXPECT_NEAR(pair["epipolar_max_px"].GetDouble(), expected, 0.25 * expected);
  EXPECT_LT(pair["epipolar_rms_px"].GetDouble(), pair["epipolar_max_px"].GetDouble());
  const Told same({"compare", file, file});
  EXPECT_LE(same.json()["files"][0]["pair"]["epipolar_max_px"].GetDouble(), 1e-9);
}

TEST(Rectify, StereoFeelsAFit) {
  const TemporaryFolder folder;
  const std::string file = folder.write("chain.yaml", chain(wide()));
  const auto pair_of = [&](const std::string& model) {
    const Told told({"convert", file, "--to", "kalibr", "--model", model, "--dry-run"});
    return told.json()["pair"]["epipolar_max_px"].GetDouble();
  };
  EXPECT_LE(pair_of("kb4"), 1e-6);
  EXPECT_GT(pair_of("ucm"), 1e-3);
  EXPECT_LT(pair_of("ds"), pair_of("ucm"));
}

TEST(Rectify, StereoFeelsLessOfAFitOfBoth) {
  const TemporaryFolder folder;
  const std::string file = folder.write("chain.yaml", chain(wide()));
  const auto told = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"convert", file, "--to", "kalibr", "--model", "eucm", "--max-angle", "95", "--dry-run"};
    words.insert(words.end(), more.begin(), more.end());
    return Told(words);
  };
  const Told separate = told({});
  const Told together = told({"--pair"});
  ASSERT_EQ(together.code(), 0) << together.text();
  EXPECT_TRUE(together.says("pair-fitted"));
  EXPECT_LT(together.json()["pair"]["epipolar_rms_px"].GetDouble(),
            0.8 * separate.json()["pair"]["epipolar_rms_px"].GetDouble());
  EXPECT_EQ(told({"--pair", "--absorb-rotation"}).code(), 3);
  EXPECT_EQ(told({"--pair", "--fix", "alpha=0.6"}).code(), 3);
  EXPECT_EQ(told({"--pair", "--objective", "max"}).code(), 3);
  EXPECT_EQ(told({"--pair", "--weight", "angle"}).code(), 3);
  EXPECT_EQ(told({"--pair", "--camera", "cam0"}).code(), 3);
  // No pose is written that could hold a turn.
  const Told without_poses({"convert", file, "--to", "vins", "--model", "mei", "--max-angle", "80", "--pair", "--dry-run"});
  EXPECT_FALSE(without_poses.says("turned-into-pose")) << without_poses.text();
  Pair other_size = wide();
  std::string sizes = chain(other_size);
  sizes.replace(sizes.rfind("[512, 512]"), 10, "[640, 480]");
  const Told uneven({"convert", folder.write("sizes.yaml", sizes), "--to", "kalibr", "--model", "eucm", "--pair", "--dry-run"});
  EXPECT_EQ(uneven.code(), 2) << uneven.text();
  const Told kept({"convert", file, "--to", "kalibr", "--pair", "--dry-run"});
  EXPECT_EQ(kept.code(), 0) << kept.text();
  EXPECT_TRUE(kept.says("pair-fit-does-not-help"));
}

TEST(Rectify, RefusesWhatIsNoPair) {
  const TemporaryFolder folder;
  const std::string good = folder.write("chain.yaml", chain(narrow()));
  const auto refused = [](const std::vector<std::string>& words, int exit_code, const std::string& code) {
    const Told told(words);
    EXPECT_EQ(told.code(), exit_code) << told.text();
    EXPECT_TRUE(told.says(code)) << told.text();
  };
  refused({"rectify", good, "--camera", "cam0"}, 2, "no-pair");
  Pair aside = narrow();
  aside.R = turned(0.0, 1.2, 0.0);
  refused({"rectify", folder.write("aside.yaml", chain(aside))}, 2, "nothing-in-common");
  Pair together = narrow();
  together.T = {};
  refused({"rectify", folder.write("together.yaml", chain(together))}, 2, "no-baseline");
  std::string other_size = chain(narrow());
  other_size.replace(other_size.rfind("[752, 480]"), 10, "[640, 480]");
  refused({"rectify", folder.write("size.yaml", other_size)}, 2, "image-size");
  const std::string without_pose = chain(narrow()).substr(0, chain(narrow()).find("  T_cn_cnm1"));
  refused({"rectify", folder.write("pose.yaml", without_pose)}, 2, "pose-missing");
  const std::string fisheye = folder.write("fisheye.yaml", chain(wide()));
  refused({"rectify", fisheye, "--pinhole", "150"}, 3, "view-too-wide");
  refused({"rectify", good, "--to", "kalibr"}, 3, "option-without-use");
  refused({"rectify", fisheye, "--to", "orbslam2"}, 2, "model-not-storable");
  Pair above = narrow();
  above.T = {0.0004, -0.11, 0.0008};
  refused({"rectify", folder.write("above.yaml", chain(above)), "--to", "orbslam3"}, 2, "pair-vertical");
  EXPECT_EQ(run_program({"rectify", good, "--pinhole", "90", "--alpha", "0"}).code, 3);
  EXPECT_EQ(run_program({"rectify", good, "--maps"}).code, 3);
}

TEST(Rectify, IsWhatAModelOfThatNameCannotDo) {
  const TemporaryFolder folder;
  const std::string file = folder.write("chain.yaml", chain(narrow()));
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"convert", file, "--to", "orbslam3", "--model", "rectified"}, {"report", file, "--model", "Rectified"}}) {
    const RunResult run = run_program(words);
    EXPECT_EQ(run.code, 3);
    EXPECT_TRUE(contains(run.err, "fca-io rectify")) << run.err;
  }
}

}  // namespace
}  // namespace fca::test
