// SPDX-License-Identifier: BSD-3-Clause
// remap makes the images that OpenCV makes where OpenCV knows the model, and right ones where it does not.
#include "cli/lit_image.h"
#include "cli/spawn_program.h"
#include "cli/told.h"
#include "images.h"

#include <fca/remap/view.h>
#include <fca/rig/rotation.h>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <numbers>

namespace fca::test {
namespace {

cv::Matx33d matrix_of(const CameraModel& model) {
  const std::span<const double> p = parameter_values(model);
  return {p[0], 0, p[2], 0, p[1], p[3], 0, 0, 1};
}

/// The map of a pinhole view, by OpenCV.
cv::Mat opencv_map(const Camera& source, double full_fov_deg) {
  const CameraModel target = pinhole_of_view(*source.image_size, full_fov_deg * kRadians);
  const cv::Size size(source.image_size->width, source.image_size->height);
  const std::span<const double> p = parameter_values(source.model);
  const std::vector<double> k(p.begin() + 4, p.begin() + 8);
  cv::Mat u;
  cv::Mat v;
  if (model_info(source.model).id == "kb4") {
    cv::fisheye::initUndistortRectifyMap(matrix_of(source.model), k, cv::Matx33d::eye(), matrix_of(target), size, CV_32FC1, u,
                                         v);
  } else {
    cv::initUndistortRectifyMap(matrix_of(source.model), k, cv::Matx33d::eye(), matrix_of(target), size, CV_32FC1, u, v);
  }
  cv::Mat map;
  cv::merge(std::vector<cv::Mat>{u, v}, map);
  return map;
}

TEST(Remap, ShowsAllDirectionsInOneImage) {
  const TemporaryFolder folder;
  const std::string camera = folder.write("cam.yaml", kFisheye);
  const cv::Mat image = noise(512, 512, CV_8UC3);
  const std::string path = folder.write("image.png", bytes_of(image, ".png"));
  const RunResult run =
      run_program({"remap", camera, path, "--equirectangular", "--out-size", "400x200", "-o", folder / "out.png"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "1 EQUIRECTANGULAR 400 200 400 200")) << run.out;
  const cv::Mat out = read_picture(folder / "out.png");
  EXPECT_EQ(out.size(), cv::Size(400, 200));
  EXPECT_EQ(out.at<cv::Vec3b>(100, 5), cv::Vec3b()) << "behind the camera";
  // As many pixels per degree as the middle of the input has: 191 px per radian.
  const Told told({"remap", camera, "--equirectangular", "--map", folder / "map.npy"});
  EXPECT_STREQ(told.json()["view"]["model"].GetString(), "equirectangular");
  EXPECT_EQ(told.json()["view"]["width"].GetInt(), 1200);
  EXPECT_EQ(told.json()["view"]["height"].GetInt(), 600);
  EXPECT_EQ(run_program({"remap", camera, "--equirectangular", "--pinhole", "90"}).code, 3);
}

TEST(Remap, MakesTheImageThatOpenCvMakes) {
  struct Case {
    Camera camera;
    std::string file;
    double fov;
  };
  for (const Case& each : {Case{tumvi(), kFisheye, 110.0}, Case{euroc(), kRadtan, 75.0}}) {
    const TemporaryFolder folder;
    const std::string camera = folder.write("cam.yaml", each.file);
    const cv::Mat image = noise(each.camera.image_size->width, each.camera.image_size->height, CV_8UC3);
    const std::string path = folder.write("image.png", bytes_of(image, ".png"));
    for (const auto& [name, flag] : {std::pair{"bilinear", cv::INTER_LINEAR}, std::pair{"lanczos", cv::INTER_LANCZOS4}}) {
      const RunResult run = run_program({"remap", camera, path, "--pinhole", std::to_string(each.fov), "--interpolation", name,
                                         "-o", folder / "out.png", "--force"});
      ASSERT_EQ(run.code, 0) << run.err;
      cv::Mat expected;
      cv::remap(image, expected, opencv_map(each.camera, each.fov), cv::noArray(), flag);
      EXPECT_TRUE(same(read_picture(folder / "out.png"), expected)) << name;
    }
  }
}

// A view is what its model says, however far that is from the lens: cv::undistort makes the same image, and nothing is warned
// of.
TEST(Remap, AViewAsAnotherModelIsExact) {
  const TemporaryFolder folder;
  const std::string camera = folder.write("cam.yaml", kRadtan);
  const Camera source = euroc();
  const cv::Mat image = noise(source.image_size->width, source.image_size->height, CV_8UC3);
  const std::string path = folder.write("image.png", bytes_of(image, ".png"));
  const Told run({"remap", camera, path, "--model", "pinhole", "-o", folder / "out.png"});
  ASSERT_EQ(run.code(), 0) << run.text();
  EXPECT_EQ(run.json()["diagnostics"].Size(), 0U) << run.text();
  const auto& view = run.json()["view"]["parameters"];
  const cv::Matx33d K = {
      view["fx"].GetDouble(), 0, view["cx"].GetDouble(), 0, view["fy"].GetDouble(), view["cy"].GetDouble(), 0, 0, 1};
  const std::span<const double> p = parameter_values(source.model);
  cv::Mat expected;
  cv::undistort(image, expected, matrix_of(source.model), std::vector<double>(p.begin() + 4, p.begin() + 8), K);
  // cv::undistort's maps are rounded to 1/32 px.
  cv::Mat difference;
  cv::absdiff(read_picture(folder / "out.png"), expected, difference);
  EXPECT_LE(cv::mean(difference.reshape(1))[0], 2.0);
}

// Whatever the samples are, they stay what they are, and the exported map does the same in cv::remap.
TEST(Remap, KeepsTheKindOfImageAndExportsTheMapItUses) {
  const TemporaryFolder folder;
  const std::string camera = folder.write("cam.yaml", kFisheye);
  const std::vector<std::pair<int, std::string>> kinds = {{CV_8UC1, ".png"},  {CV_8UC3, ".png"},  {CV_8UC4, ".png"},
                                                          {CV_16UC1, ".png"}, {CV_16UC3, ".tif"}, {CV_16UC4, ".png"},
                                                          {CV_16UC1, ".pgm"}, {CV_8UC3, ".ppm"},  {CV_8UC3, ".bmp"}};
  for (const auto& [type, extension] : kinds) {
    SCOPED_TRACE(extension + " " + std::to_string(type));
    const cv::Mat image = noise(512, 512, type);
    const std::string path = folder.write("image" + extension, bytes_of(image, extension));
    const RunResult run = run_program({"remap", camera, path, "--model", "ds", "--rotate", "20,-10,5", "-o",
                                       folder / ("out" + extension), "--map", folder / "map.npy", "--force"});
    ASSERT_EQ(run.code, 0) << run.err;
    cv::Mat expected;
    cv::remap(image, expected, read_npy(folder / "map.npy", 512, 512), cv::noArray(), cv::INTER_LINEAR);
    EXPECT_TRUE(same(read_picture(folder / ("out" + extension)), expected));
  }
}

// A line in space through a fisheye is a curve; in the pinhole image it is straight. Its points: centroids of columns.
TEST(Remap, StraightLinesAreStraightInAPinhole) {
  const TemporaryFolder folder;
  const std::string camera = folder.write("cam.yaml", kFisheye);
  const Ray normal = {0.05, 0.8, -0.598};
  constexpr double kWidth = 0.01;  // rad: two pixels
  const cv::Mat1b image = rendered(tumvi(), [&](const Ray& ray) {
    const double across = (normal[0] * ray[0] + normal[1] * ray[1] + normal[2] * ray[2]) / kWidth;
    return 255.0 * std::exp(-across * across);
  });
  const std::string path = folder.write("line.png", bytes_of(image, ".png"));
  const RunResult run =
      run_program({"remap", camera, path, "--pinhole", "100", "--interpolation", "lanczos", "-o", folder / "out.png"});
  ASSERT_EQ(run.code, 0) << run.err;
  const cv::Mat1b straight = read_picture(folder / "out.png");
  std::vector<cv::Point2d> points;
  for (int u = 8; u < straight.cols - 8; ++u) {
    double sum = 0.0;
    double first = 0.0;
    for (int v = 0; v < straight.rows; ++v) {
      sum += straight(v, u);
      first += v * static_cast<double>(straight(v, u));
    }
    ASSERT_GT(sum, 255.0) << "column " << u;
    points.emplace_back(u, first / sum);
  }
  cv::Vec4d line;
  cv::fitLine(cv::Mat(points), line, cv::DIST_L2, 0, 1e-9, 1e-9);
  double squares = 0.0;
  for (const cv::Point2d& point : points) {
    const double off = (point.x - line[2]) * line[1] - (point.y - line[3]) * line[0];
    squares += off * off;
  }
  EXPECT_LE(std::sqrt(squares / static_cast<double>(points.size())), 0.1) << "px";
}

// A landmark 93 degrees from the axis, in another fisheye and in a pinhole that is turned to it.
TEST(Remap, SeesBeyondNinetyDegrees) {
  const TemporaryFolder folder;
  const std::string camera = folder.write("cam.yaml", kFisheye);
  const double angle = 93.0 * kRadians;
  const Ray landmark = {std::sqrt(0.5) * std::sin(angle), std::sqrt(0.5) * std::sin(angle), std::cos(angle)};
  const cv::Mat1b image = rendered(tumvi(), [&](const Ray& ray) {
    const double cosine = landmark[0] * ray[0] + landmark[1] * ray[1] + landmark[2] * ray[2];
    constexpr double kRadius = 0.02;
    return 255.0 * std::exp(-(2.0 - 2.0 * cosine) / (kRadius * kRadius));
  });
  const std::string path = folder.write("image.png", bytes_of(image, ".png"));
  const auto centroid_of = [](const cv::Mat& picture) {
    const cv::Moments moments = cv::moments(picture);
    return Pixel{moments.m10 / moments.m00, moments.m01 / moments.m00};
  };
  const std::string like =
      folder.write("like.yaml", with_replaced(with_replaced(kFisheye, "190.978", "171.978"), "254.93", "250.93"));
  Camera wider = tumvi();
  set_parameter(wider.model, "fx", 171.97847715128717);
  set_parameter(wider.model, "cx", 250.93170605935475);
  ASSERT_EQ(run_program({"remap", camera, path, "--like", like, "-o", folder / "like.png"}).code, 0);
  const Pixel in_like = centroid_of(read_picture(folder / "like.png"));
  const Pixel expected = *project(wider.model, landmark);
  EXPECT_NEAR(in_like[0], expected[0], 0.2);
  EXPECT_NEAR(in_like[1], expected[1], 0.2);

  ASSERT_EQ(run_program({"remap", camera, path, "--pinhole", "60", "--rotate", "90,-45,0", "-o", folder / "turned.png"}).code,
            0);
  const Pixel in_turned = centroid_of(read_picture(folder / "turned.png"));
  const Transform T_view_source = inverse(turned(90 * kRadians, -45 * kRadians, 0.0)).value();
  const Pixel there = *project(pinhole_of_view({512, 512}, 60 * kRadians), rotated(T_view_source, landmark));
  EXPECT_NEAR(in_turned[0], there[0], 0.5);
  EXPECT_NEAR(in_turned[1], there[1], 0.5);
}

TEST(Remap, TheMaskSaysWhatTheSourceSees) {
  const TemporaryFolder folder;
  const std::string camera = folder.write("cam.yaml", kRadtan);
  const RunResult run = run_program({"remap", camera, "--pinhole", "120", "--out-size", "400x300", "--mask",
                                     folder / "mask.png", "--map", folder / "map.npy"});
  ASSERT_EQ(run.code, 0) << run.err;
  const cv::Mat1b mask = read_picture(folder / "mask.png");
  const cv::Mat2f map = read_npy(folder / "map.npy", 400, 300);
  ASSERT_EQ(mask.size(), cv::Size(400, 300));
  const CameraModel target = pinhole_of_view({400, 300}, 120 * kRadians);
  int wrong = 0;
  for (int v = 0; v < mask.rows; ++v) {
    for (int u = 0; u < mask.cols; ++u) {
      const std::optional<Pixel> place =
          project(euroc().model, *unproject(target, {static_cast<double>(u), static_cast<double>(v)}));
      const auto inside = [&](double margin) {
        return place && (*place)[0] >= -margin && (*place)[1] >= -margin && (*place)[0] <= 751 + margin &&
               (*place)[1] <= 479 + margin;
      };
      const bool seen = mask(v, u) == 255;
      wrong += (seen && !inside(0.02)) || (!seen && inside(0.0)) || (mask(v, u) != 0 && !seen) ? 1 : 0;
      wrong += place.has_value() == std::isnan(map(v, u)[0]) ? 1 : 0;
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(cv::countNonZero(mask), 0);
  EXPECT_LT(cv::countNonZero(mask), 400 * 300);
}

TEST(Remap, TakesManyImages) {
  const TemporaryFolder folder;
  const std::string camera = folder.write("cam.yaml", kRadtan);
  fs::create_directory(folder.path() / "in");
  constexpr int kImages = 12;
  for (int i = 0; i < kImages; ++i)
    folder.write("in/" + std::to_string(i) + ".png", bytes_of(cv::Mat(480, 752, CV_8UC1, cv::Scalar(i + 1)), ".png"));
  folder.write("in/notes.txt", "no image");
  for (const std::string jobs : {"1", "4"}) {
    const RunResult run = run_program(
        {"remap", camera, folder / "in", "--pinhole", "60", "--jobs", jobs, "-o", folder / "out" + jobs + "/{stem}.u.png"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(std::distance(fs::directory_iterator(folder / "out" + jobs), fs::directory_iterator()), kImages);
    for (int i = 0; i < kImages; ++i) {
      const cv::Mat1b image = read_picture(folder / "out" + jobs + "/" + std::to_string(i) + ".u.png");
      ASSERT_EQ(image.size(), cv::Size(752, 480));
      EXPECT_EQ(image(240, 376), i + 1);
    }
  }
  const RunResult again =
      run_program({"remap", camera, folder / "in/*.png", "--pinhole", "60", "-o", folder / "out1/{stem}.u.png"});
  EXPECT_EQ(again.code, 4);
  EXPECT_TRUE(says(again.err, "cannot-write", "--force")) << again.err;
  EXPECT_EQ(run_program({"remap", camera, folder / "in", "--pinhole", "60", "-o", folder / "one.png"}).code, 3);
  EXPECT_EQ(run_program({"remap", camera, folder / "in", "--pinhole", "60", "-o", folder / "{camera}.png"}).code, 3);
}

TEST(Remap, SaysBothSizesAndTheFix) {
  const TemporaryFolder folder;
  const std::string camera = folder.write("cam.yaml", kRadtan);
  const std::string half = folder.write("half.png", bytes_of(noise(376, 240, CV_8UC1), ".png"));
  const RunResult run = run_program({"remap", camera, half, "--pinhole", "70", "-o", folder / "out.png"});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(says(run.err, "image-size", "376 x 240") && says(run.err, "image-size", "752 x 480") &&
              says(run.err, "image-size", "--resize 376x240"))
      << run.err;
  EXPECT_FALSE(fs::exists(folder / "out.png"));
  EXPECT_EQ(run_program({"remap", camera, half, "--pinhole", "70", "--resize", "376x240", "-o", folder / "out.png"}).code, 0);
  const std::string part = folder.write("part.png", bytes_of(noise(300, 300, CV_8UC1), ".png"));
  EXPECT_TRUE(says(run_program({"remap", camera, part, "--pinhole", "70", "-o", folder / "part.u.png"}).err, "image-size",
                   "--crop X,Y,300,300"));
}

TEST(Remap, RefusesWhatIsNoImage) {
  const TemporaryFolder folder;
  const std::string camera = folder.write("cam.yaml", kRadtan);
  const std::string png = bytes_of(noise(752, 480, CV_8UC3), ".png");
  const std::string jpg = bytes_of(noise(752, 480, CV_8UC3), ".jpg");
  fs::create_directory(folder.path() / "folder.png");
  struct Case {
    std::string path;
    int code;
  };
  const std::vector<Case> cases = {{folder.write("empty.png", ""), 2},
                                   {folder.write("text.png", "a text"), 2},
                                   {folder.write("cut.png", png.substr(0, png.size() / 2)), 2},
                                   {folder.write("cut.jpg", jpg.substr(0, jpg.size() / 2)), 2},
                                   {folder.write("head.png", png.substr(0, 60)), 2},
                                   {folder.write("dot.png", bytes_of(noise(1, 1, CV_8UC1), ".png")), 2},
                                   {folder / "folder.png", 2},
                                   {folder / "missing.png", 4},
                                   {"/dev/zero", 2}};
  for (const Case& each : cases) {
    const RunResult run = run_program({"remap", camera, each.path, "--pinhole", "70", "-o", folder / "out.png"});
    EXPECT_EQ(run.code, each.code) << each.path << run.err;
    EXPECT_FALSE(run.err.empty());
    EXPECT_FALSE(fs::exists(folder / "out.png")) << each.path;
  }
  // The others get their results.
  const std::string good = folder.write("good.png", png);
  const RunResult run =
      run_program({"remap", camera, folder / "empty.png", good, folder / "cut.png", "--pinhole", "70", "-o", folder / "out/"});
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(read_picture(folder / "out/good.png").size(), cv::Size(752, 480));
  EXPECT_FALSE(fs::exists(folder / "out/cut.png"));
}

TEST(Remap, ATinyCameraIsACamera) {
  const TemporaryFolder folder;
  const std::string camera =
      folder.write("cam.yaml", with_replaced(with_replaced(kRadtan, "[752, 480]", "[1, 1]"), "367.215, 248.375", "0.0, 0.0"));
  const std::string dot = folder.write("dot.png", bytes_of(cv::Mat(1, 1, CV_8UC1, cv::Scalar(9)), ".png"));
  const RunResult run = run_program({"remap", camera, dot, "--pinhole", "1", "-o", folder / "out.png"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(cv::Mat1b(read_picture(folder / "out.png"))(0, 0), 9);
}

TEST(Remap, WritesWholeFilesOrNone) {
  const TemporaryFolder folder;
  const std::string camera = folder.write("cam.yaml", kRadtan);
  const std::string image = folder.write("image.png", bytes_of(noise(752, 480, CV_8UC3), ".png"));
  EXPECT_EQ(run_program({"remap", camera, image, "--pinhole", "70", "-o", "/dev/full"}).code, 4);
  const RunResult full = spawn_program({"remap", camera, image, "--pinhole", "70", "-o", "-"}, {}, "/dev/full");
  EXPECT_EQ(full.code, 4);
  const RunResult out = run_program({"remap", camera, image, "--pinhole", "70", "-o", "-"});
  ASSERT_EQ(run_program({"remap", camera, image, "--pinhole", "70", "-o", folder / "out.png"}).code, 0);
  EXPECT_EQ(out.out, read_file(folder / "out.png"));
  // A format that cannot hold what the image holds is refused, and so is the image's own place.
  const std::string deep = folder.write("deep.png", bytes_of(noise(752, 480, CV_16UC1), ".png"));
  const RunResult lossy = run_program({"remap", camera, deep, "--pinhole", "70", "-o", folder / "deep.jpg"});
  EXPECT_EQ(lossy.code, 3);
  EXPECT_TRUE(says(lossy.err, "image-format", "16 bits")) << lossy.err;
  EXPECT_FALSE(fs::exists(folder / "deep.jpg"));
  EXPECT_EQ(run_program({"remap", camera, deep, "--pinhole", "70", "-o", deep, "--force"}).code, 3);
}

// --force is for what an earlier run wrote, not for what this one reads.
TEST(Remap, OverwritesNoInput) {
  const TemporaryFolder folder;
  const std::string chain = folder.write("cam.yaml", kRadtan);
  const std::string camera = folder.write("cam.npy", kRadtan);
  const std::string image = folder.write("image.png", bytes_of(noise(752, 480, CV_8UC3), ".png"));
  fs::create_symlink(image, folder / "link.png");
  const std::vector<std::vector<std::string>> unwanted = {
      {chain, image, "-o", folder / "out.png", "--mask", image},
      {chain, image, "-o", folder / "out.png", "--mask", folder / "link.png"},
      {camera, image, "-o", folder / "out.png", "--map", camera}};
  const std::string before = read_file(image) + read_file(camera) + read_file(chain);
  for (std::vector<std::string> words : unwanted) {
    words.insert(words.begin(), "remap");
    words.insert(words.end(), {"--pinhole", "70", "--force"});
    EXPECT_EQ(run_program(words).code, 3) << words.back();
    EXPECT_EQ(read_file(image) + read_file(camera) + read_file(chain), before);
    EXPECT_FALSE(fs::exists(folder / "out.png"));
  }
}

TEST(Remap, RefusesWhatIsNoView) {
  const TemporaryFolder folder;
  const std::string camera = folder.write("cam.yaml", kRadtan);
  const std::string two = testdata("formats/kalibr/good/tumvi.yaml");
  const auto code = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "remap");
    words.insert(words.end(), {"--map", folder / "map.npy"});
    const int result = run_program(words).code;
    EXPECT_EQ(result == 0, fs::exists(folder / "map.npy"));
    return result;
  };
  EXPECT_EQ(code({camera}), 3) << "no view";
  EXPECT_EQ(code({camera, "--pinhole", "180"}), 3);
  EXPECT_EQ(code({camera, "--pinhole", "nan"}), 3);
  EXPECT_EQ(code({camera, "--pinhole", "90", "--model", "ds"}), 3);
  EXPECT_EQ(code({camera, "--rotate", "1,2"}), 3);
  EXPECT_EQ(code({camera, "--rotate", "1,2,x"}), 3);
  EXPECT_EQ(code({camera, "--model", "kb5"}), 3);
  EXPECT_EQ(code({camera, "--pinhole", "90", "--interpolation", "cubic"}), 3);
  EXPECT_EQ(code({camera, "--pinhole", "60", "--rotate", "180,0,0"}), 1) << "nothing is seen";
  EXPECT_EQ(code({two, "--pinhole", "60"}), 3) << "whose images?";
  EXPECT_EQ(code({camera, "--pinhole", "60", "--out-size", "30000x30000"}), 2) << "too large";
  EXPECT_EQ(code({camera, "--like", folder / "missing.yaml"}), 4);
  EXPECT_EQ(code({two, "--camera", "cam1", "--pinhole", "60"}), 0);
}

TEST(Remap, SaysWhatItDidAsJson) {
  const TemporaryFolder folder;
  const std::string camera = folder.write("cam.yaml", kRadtan);
  const RunResult run = run_program({"remap", camera, "--pinhole", "60", "--map", folder / "map.npy", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "\"seen_share\": 1.0") && contains(run.out, "\"model\": \"pinhole\"")) << run.out;
}

// What lies outside the lens is taken from nowhere, and the mask and the map say so.
TEST(Remap, TakesNothingFromOutsideTheLens) {
  const TemporaryFolder folder;
  const std::string camera = folder.write("cam.yaml", kChain);
  const Lit lit{.u = 271.0, .v = 243.0, .radius = 200.0};
  const std::string seen = folder.write("seen.pgm", lit.file());
  const RunResult run = run_program({"remap", camera, seen, "--rotate", "0,0,0", "--lens-circle", seen, "--mask",
                                     folder / "mask.png", "-o", folder / "out.png"});
  ASSERT_EQ(run.code, 0) << run.err;
  const cv::Mat1b mask = read_picture(folder / "mask.png");
  ASSERT_EQ(mask.size(), cv::Size(512, 512));
  int wrong = 0;
  for (int v = 0; v < mask.rows; ++v) {
    for (int u = 0; u < mask.cols; ++u) {
      constexpr double kFound = 1.5;  // px: how well a circle is found
      const bool close = std::abs(std::hypot(u - lit.u, v - lit.v) - lit.radius) <= kFound;
      wrong += !close && (mask(v, u) != 0) != lit.contains(u, v) ? 1 : 0;
    }
  }
  EXPECT_EQ(wrong, 0) << "pixels";
  const RunResult over = run_program(
      {"remap", camera, "--rotate", "0,0,0", "--lens-circle", seen, "--mask", seen + ".png", "--map", seen, "--force"});
  EXPECT_EQ(over.code, 3) << "a map is a .npy file";
}

// A few bytes that say they are gigabytes.
TEST(Remap, RefusesWhatIsTooLargeForAnyCamera) {
  const TemporaryFolder folder;
  const std::string camera = folder.write("cam.yaml", kFisheye);
  const std::string bomb = folder.write("bomb.pgm", "P5\n30000 30000\n255\n" + std::string(1000, 'x'));
  const RunResult run = run_program({"remap", camera, bomb, "--pinhole", "90", "-o", folder / "out.png"});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(says(run.err, "no-image", "134 megapixels")) << run.err;
  EXPECT_FALSE(contains(run.err, "OpenCV")) << run.err;
}

}  // namespace
}  // namespace fca::test
