// SPDX-License-Identifier: BSD-3-Clause
// Files that we write, opened by cv::FileStorage, and what stands there given to OpenCV's own projections: the pixels are ours,
// in every syntax and for every model that OpenCV has.
#include "formats/oracle_table.h"
#include "formats/rigs.h"

#include <fca/formats/consumers/consumer.h>

#include <numbers>

#include <opencv2/calib3d.hpp>
#include <opencv2/ccalib/omnidir.hpp>
#include <opencv2/core.hpp>

namespace fca::test {
namespace {

struct Syntax {
  const char* extension;
  int flag;
};

constexpr Syntax kSyntaxes[] = {
    {".yml", cv::FileStorage::FORMAT_YAML}, {".xml", cv::FileStorage::FORMAT_XML}, {".json", cv::FileStorage::FORMAT_JSON}};

/// Rays up to `last` rad from the axis that the camera has a pixel for.
struct Points {
  std::vector<cv::Point3d> rays;
  std::vector<Pixel> pixels;
};

Points points_of(const CameraModel& model, double last) {
  constexpr int kAngles = 40;
  constexpr int kAzimuths = 16;
  Points points;
  for (int i = 0; i <= kAngles; ++i) {
    for (int j = 0; j < kAzimuths; ++j) {
      const double angle = last * i / kAngles;
      const double azimuth = 2.0 * std::numbers::pi * j / kAzimuths;
      const Ray ray = {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)};
      const std::optional<Pixel> pixel = project(model, ray);
      if (!pixel) continue;
      points.rays.emplace_back(ray[0], ray[1], ray[2]);
      points.pixels.push_back(*pixel);
    }
  }
  return points;
}

/// The projection that belongs to the model, with what the file says as it says it.
std::vector<cv::Point2d> projected(const cv::FileStorage& file, const std::string& model,
                                   const std::vector<cv::Point3d>& rays) {
  const cv::Mat K = file["camera_matrix"].mat();
  const cv::Mat D = file["distortion_coefficients"].mat();
  const cv::Vec3d zero(0, 0, 0);
  std::vector<cv::Point2d> pixels;
  if (model == "kb4") {
    cv::fisheye::projectPoints(rays, pixels, zero, zero, K, D);
  } else if (model == "mei") {
    cv::omnidir::projectPoints(rays, pixels, zero, zero, K, file["xi"].real(), D);
  } else {
    cv::projectPoints(rays, zero, zero, K, D, pixels);
  }
  return pixels;
}

CameraModel model_for(const std::string& id) {
  if (id == "rational")
    return model_of(id,
                    {605.286, 605.699, 637.01, 366.758, 0.522, -2.6951, 0.000899, -0.000228, 1.5296, 0.4012, -2.5146, 1.4555});
  CameraModel model = sample_model(id);
  if (id == "radtan") set_parameter(model, "k3", -0.0123456789);
  return model;
}

TEST(OpenCvFunctions, AgreeOnWhatWeWrite) {
  const Format& opencv = *find_format("opencv");
  for (const auto& [model, last] :
       {std::pair<std::string, double>{"radtan", 0.7}, {"rational", 0.6}, {"kb4", 1.5}, {"mei", 1.8}}) {
    Rig rig;
    rig.cameras.push_back({"cam0", ImageSize{1280, 720}, model_for(model), std::nullopt, std::nullopt, ""});
    const Points points = points_of(rig.cameras[0].model, last);
    ASSERT_GT(points.rays.size(), 300U) << model;
    for (const Syntax& syntax : kSyntaxes) {
      SCOPED_TRACE(model + syntax.extension);
      WriteOptions options;
      options.extension = syntax.extension;
      const std::string bytes = written_by(opencv, nullptr, rig, options).files.at(0).document.bytes();
      const cv::FileStorage file(bytes, cv::FileStorage::READ | cv::FileStorage::MEMORY | syntax.flag);
      ASSERT_TRUE(file.isOpened());
      const std::vector<cv::Point2d> theirs = projected(file, model, points.rays);
      ASSERT_EQ(theirs.size(), points.pixels.size());
      double worst = 0.0;
      for (std::size_t i = 0; i < theirs.size(); ++i)
        worst = std::max(worst, distance(points.pixels[i], {theirs[i].x, theirs[i].y}));
      EXPECT_LE(worst, 1e-9);
    }
  }
}

// Pixel to ray, where the distorted angle goes beyond 90 degrees long before the ray's does, and where Newton ends nowhere.
TEST(OpenCvFunctions, GoWrongAsTheirConsumerSays) {
  const Format& opencv = *find_format("opencv");
  for (const std::vector<double>& k : {std::vector<double>{0.15, 0.02, 0.0, 0.0}, {-0.3, 0.2, -0.1, 0.02}}) {
    Rig rig;
    rig.cameras.push_back({"cam0", ImageSize{1280, 720}, model_of("kb4", {300.0, 301.0, 640.3, 359.8, k[0], k[1], k[2], k[3]}),
                           std::nullopt, std::nullopt, ""});
    const std::string bytes = written_by(opencv, nullptr, rig, {}).files.at(0).document.bytes();
    const cv::FileStorage file(bytes, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    const consumers::ConsumerView view = consumers::find_consumer("opencv")->load(bytes, {"", OpenCvModel::kFisheye});
    ASSERT_EQ(view.cameras.size(), 1U) << bytes;
    std::vector<cv::Point2d> pixels;
    for (int u = 0; u < 1280; u += 20) {
      for (int v = 0; v < 720; v += 20) pixels.emplace_back(u, v);
    }
    std::vector<cv::Point2d> theirs;
    cv::fisheye::undistortPoints(pixels, theirs, file["camera_matrix"].mat(), file["distortion_coefficients"].mat());
    int wrong = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const Pixel pixel = {pixels[i].x, pixels[i].y};
      const std::optional<Ray> ray = view.cameras[0].unproject(pixel);
      ASSERT_TRUE(ray);
      const double size = std::hypot(theirs[i].x, theirs[i].y);
      EXPECT_LE(distance({(*ray)[0], (*ray)[1]}, {theirs[i].x, theirs[i].y}), 1e-9 * std::max(1.0, size * size)) << pixels[i];
      const std::optional<Pixel> back = view.cameras[0].project(*ray);
      wrong += back && distance(*back, pixel) <= 1.0 ? 0 : 1;
    }
    EXPECT_GE(wrong, 50);
  }
}

}  // namespace
}  // namespace fca::test
