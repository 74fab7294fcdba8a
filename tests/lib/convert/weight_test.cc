// SPDX-License-Identifier: BSD-3-Clause
// Weights of a fit. Evaluated on a grid of pixels, each by the spherical area between the rays of its corners, and by a
// minimisation that knows nothing of the library's.
#include "known_cameras.h"

#include <fca/code.h>
#include <fca/convert/convert.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace fca::test {
namespace {

ConvertOptions options_to(const char* model, WeightKind kind = WeightKind::kPixel) {
  ConvertOptions options;
  options.model = model;
  options.max_angle_rad = 75.0 * kRadians;
  options.bound = false;
  options.weight.kind = kind;
  return options;
}

using Grey = std::function<float(double u, double v)>;

ConvertOptions options_by_image(const char* model, const ImageSize& size, const Grey& grey) {
  ConvertOptions options = options_to(model, WeightKind::kImage);
  auto image = std::make_shared<GreyImage>(GreyImage{size.width, size.height, 255.0F, {}});
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) image->samples.push_back(grey(u, v));
  }
  options.weight.density = std::move(image);
  return options;
}

std::optional<Conversion> converted(const Camera& camera, const ConvertOptions& options) {
  Diagnostics diagnostics;
  std::optional<Conversion> conversion = convert(camera, options, diagnostics);
  EXPECT_TRUE(conversion) << options.model;
  return conversion;
}

/// A pixel of the grid and what it counts.
struct GridPoint {
  Pixel pixel;
  Eigen::Vector3d ray;
  double weight;
};

Eigen::Vector3d vector_of(const std::optional<Ray>& ray) { return Eigen::Map<const Eigen::Vector3d>(ray.value().data()); }

/// The solid angle of a triangle of unit rays (van Oosterom & Strackee 1983).
double solid_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return std::abs(2.0 * std::atan2(a.dot(b.cross(c)), 1.0 + a.dot(b) + b.dot(c) + c.dot(a)));
}

double solid_angle_of_pixel(const CameraModel& model, const Pixel& pixel) {
  const auto corner = [&](double u, double v) { return vector_of(unproject(model, {pixel[0] + u, pixel[1] + v})); };
  const Eigen::Vector3d a = corner(-0.5, -0.5);
  const Eigen::Vector3d c = corner(0.5, 0.5);
  return solid_angle(a, corner(0.5, -0.5), c) + solid_angle(a, c, corner(-0.5, 0.5));
}

/// Every third pixel whose ray lies inside that angle.
std::vector<GridPoint> grid_of(const Camera& camera, double limit_deg, WeightKind kind) {
  std::vector<GridPoint> points;
  for (double u = 0.0; u < camera.image_size->width; u += 3.0) {
    for (double v = 0.0; v < camera.image_size->height; v += 3.0) {
      const std::optional<Ray> ray = unproject(camera.model, {u, v});
      if (!ray || angle_from_axis(*ray) > limit_deg * kRadians) continue;
      points.push_back({{u, v}, vector_of(ray), kind == WeightKind::kAngle ? solid_angle_of_pixel(camera.model, {u, v}) : 1.0});
    }
  }
  return points;
}

double rms_on(const std::vector<GridPoint>& points, const CameraModel& model) {
  double squares = 0.0;
  double sum = 0.0;
  for (const GridPoint& point : points) {
    const std::optional<Pixel> pixel = project(model, {point.ray[0], point.ray[1], point.ray[2]});
    EXPECT_TRUE(pixel);
    if (!pixel) return HUGE_VAL;
    squares += point.weight * (std::pow((*pixel)[0] - point.pixel[0], 2) + std::pow((*pixel)[1] - point.pixel[1], 2));
    sum += point.weight;
  }
  return std::sqrt(squares / sum);
}

std::vector<Camera> lenses() {
  return {kalibr_ds(), kalibr_kb4(), kalibr_radtan(), euroc(), tumvi(), t265_like(), woodscape_front(), rational_lens()};
}

TEST(Weight, EachFitIsTheBestByItsOwn) {
  // Grid and quadrature differ by that much.
  constexpr double kAlike = 1.003;
  int differ = 0;
  for (const Camera& camera : lenses()) {
    for (const char* model : {"ds", "eucm", "kb4", "mei", "ocamcalib"}) {
      SCOPED_TRACE(std::string(model) + " from " + std::string(model_info(camera.model).id));
      const std::optional<Conversion> by_pixel = converted(camera, options_to(model));
      const std::optional<Conversion> by_angle = converted(camera, options_to(model, WeightKind::kAngle));
      ASSERT_TRUE(by_pixel && by_angle);
      EXPECT_FALSE(by_pixel->report.weighted);
      ASSERT_TRUE(by_angle->report.weighted);
      if (by_pixel->report.exact || by_pixel->report.angle_reduced || by_angle->report.angle_reduced) continue;
      // Of another degree another polynomial is the best.
      if (by_pixel->report.degree != by_angle->report.degree) continue;
      const std::vector<GridPoint> pixels = grid_of(camera, 75.0, WeightKind::kPixel);
      const std::vector<GridPoint> angles = grid_of(camera, 75.0, WeightKind::kAngle);
      const double angle_of_angle = rms_on(angles, by_angle->camera.model);
      const double angle_of_pixel = rms_on(angles, by_pixel->camera.model);
      constexpr double kNobodySees = 1e-6;  // px
      EXPECT_LE(angle_of_angle, kAlike * angle_of_pixel + kNobodySees);
      EXPECT_LE(rms_on(pixels, by_pixel->camera.model), kAlike * rms_on(pixels, by_angle->camera.model) + kNobodySees);
      EXPECT_NEAR(by_angle->report.weighted->rms_px, angle_of_angle, 0.02 * angle_of_angle + kNobodySees);
      EXPECT_NEAR(by_angle->report.statistics.error.rms, rms_on(pixels, by_angle->camera.model),
                  0.02 * by_angle->report.statistics.error.rms + kNobodySees);
      differ += angle_of_angle < 0.98 * angle_of_pixel ? 1 : 0;
    }
  }
  EXPECT_GT(differ, 5) << "the weights of these lenses make no difference";
}

/// Levenberg-Marquardt with derivatives by differences, on the grid.
Eigen::VectorXd minimised(const std::vector<GridPoint>& points, CameraModel model) {
  const auto count = static_cast<Eigen::Index>(parameter_values(model).size());
  const auto residuals = [&](const Eigen::VectorXd& p) {
    std::ranges::copy(p, parameter_values(model).begin());
    Eigen::VectorXd r(2 * static_cast<Eigen::Index>(points.size()));
    Eigen::Index i = 0;
    for (const GridPoint& point : points) {
      const Pixel pixel = project(model, {point.ray[0], point.ray[1], point.ray[2]}).value_or(Pixel{1e6, 1e6});
      r[i++] = std::sqrt(point.weight) * (pixel[0] - point.pixel[0]);
      r[i++] = std::sqrt(point.weight) * (pixel[1] - point.pixel[1]);
    }
    return r;
  };
  Eigen::VectorXd p = Eigen::Map<const Eigen::VectorXd>(parameter_values(model).data(), count);
  double damping = 1e-3;
  for (int step = 0; step < 100; ++step) {
    const Eigen::VectorXd r = residuals(p);
    Eigen::MatrixXd J(r.size(), count);
    for (Eigen::Index k = 0; k < count; ++k) {
      const double h = 1e-6 * std::max(1.0, std::abs(p[k]));
      Eigen::VectorXd after = p;
      Eigen::VectorXd before = p;
      after[k] += h;
      before[k] -= h;
      J.col(k) = (residuals(after) - residuals(before)) / (2.0 * h);
    }
    const Eigen::MatrixXd H = J.transpose() * J;
    const Eigen::VectorXd d = H.diagonal();
    bool better = false;
    for (int attempt = 0; attempt < 12 && !better; ++attempt) {
      Eigen::MatrixXd damped = H;
      damped.diagonal() += damping * d;
      const Eigen::VectorXd next = p - damped.ldlt().solve(J.transpose() * r);
      better = residuals(next).squaredNorm() < r.squaredNorm();
      if (better) p = next;
      damping *= better ? 0.2 : 5.0;
    }
    if (!better) break;
  }
  return p;
}

TEST(Weight, AnotherMinimisationAgrees) {
  for (const WeightKind kind : {WeightKind::kPixel, WeightKind::kAngle}) {
    const Camera camera = t265_like();
    const std::vector<GridPoint> points = grid_of(camera, 75.0, kind);
    const std::optional<Conversion> ours = converted(camera, options_to("eucm", kind));
    ASSERT_TRUE(ours);
    // From a start near it.
    CameraModel start = ours->camera.model;
    for (double& value : parameter_values(start)) value *= 1.02;
    const Eigen::VectorXd theirs = minimised(points, start);
    CameraModel found = start;
    std::ranges::copy(theirs, parameter_values(found).begin());
    EXPECT_GT(rms_on(points, start), 5.0);
    const double best = rms_on(points, found);
    EXPECT_NEAR(rms_on(points, ours->camera.model), best, 1e-3 * best);
    for (Eigen::Index i = 0; i < theirs.size(); ++i) {
      const double value = parameter_values(ours->camera.model)[static_cast<std::size_t>(i)];
      EXPECT_NEAR(value, theirs[i], 2e-3 * std::abs(theirs[i])) << i;
    }
  }
}

TEST(Weight, AnImageOfOneGreyIsTheFitOfPixels) {
  for (const Camera& camera : {tumvi(), kalibr_radtan(), t265_like()}) {
    for (const char* model : {"eucm", "ds", "kb4", "radtan"}) {
      const std::optional<Conversion> plain = converted(camera, options_to(model));
      const std::optional<Conversion> grey =
          converted(camera, options_by_image(model, *camera.image_size, [](double, double) { return 77.0F; }));
      ASSERT_TRUE(plain && grey);
      EXPECT_EQ(plain->camera.model, grey->camera.model);
      ASSERT_TRUE(grey->report.weighted);
      EXPECT_EQ(grey->report.weighted->rms_px, plain->report.statistics.error.rms);
      EXPECT_EQ(grey->report.statistics.error.rms, plain->report.statistics.error.rms);
    }
  }
}

TEST(Weight, WhatIsWhiteGetsBetter) {
  using Models = std::vector<std::string>;
  for (const auto& [camera, models] : {std::pair(tumvi(), Models{"eucm", "mei"}), std::pair(t265_like(), Models{"ds", "ucm"}),
                                       std::pair(woodscape_front(), Models{"eucm", "ds"})}) {
    const Pixel centre = principal_point(camera.model);
    const double radius = 0.3 * camera.image_size->width;
    const auto is_white = [&](double u, double v) { return std::hypot(u - centre[0], v - centre[1]) < radius; };
    std::vector<GridPoint> white = grid_of(camera, 75.0, WeightKind::kPixel);
    std::erase_if(white, [&](const GridPoint& point) { return !is_white(point.pixel[0], point.pixel[1]); });
    for (const std::string& model : models) {
      SCOPED_TRACE(model + " from " + std::string(model_info(camera.model).id));
      const std::optional<Conversion> plain = converted(camera, options_to(model.c_str()));
      const std::optional<Conversion> weighted =
          converted(camera, options_by_image(model.c_str(), *camera.image_size,
                                             [&](double u, double v) { return is_white(u, v) ? 255.0F : 0.0F; }));
      ASSERT_TRUE(plain && weighted);
      const double before = rms_on(white, plain->camera.model);
      const double after = rms_on(white, weighted->camera.model);
      EXPECT_LT(after, 0.95 * before);
      EXPECT_NEAR(weighted->report.weighted->rms_px, after, 0.03 * after + 1e-5);
      EXPECT_GT(weighted->report.statistics.error.rms, plain->report.statistics.error.rms);
      // Nearly what a minimisation over the white pixels alone finds.
      CameraModel found = weighted->camera.model;
      const Eigen::VectorXd best = minimised(white, found);
      std::ranges::copy(best, parameter_values(found).begin());
      EXPECT_LT(after, 1.03 * rms_on(white, found) + 1e-5);
    }
  }
}

// A spot of a few pixels, of which a quadrature of the whole image would see nothing.
TEST(Weight, ASmallSpotIsEnough) {
  const Camera camera = tumvi();
  const auto spot = [](double u, double v) { return std::abs(u - 300.0) < 12.0 && std::abs(v - 200.0) < 12.0 ? 255.0F : 0.0F; };
  const std::optional<Conversion> weighted = converted(camera, options_by_image("ucm", *camera.image_size, spot));
  const std::optional<Conversion> plain = converted(camera, options_to("ucm"));
  ASSERT_TRUE(weighted && plain);
  const Ray ray = unproject(camera.model, {300.0, 200.0}).value();
  const auto error = [&ray](const Conversion& conversion) {
    const Pixel pixel = project(conversion.camera.model, ray).value();
    return std::hypot(pixel[0] - 300.0, pixel[1] - 200.0);
  };
  EXPECT_LT(error(*weighted), 0.1 * error(*plain));
}

TEST(Weight, WhatCannotBeIsRefused) {
  const Camera camera = tumvi();
  const auto code_of_failure = [&camera](const ConvertOptions& options) {
    Diagnostics diagnostics;
    EXPECT_FALSE(convert(camera, options, diagnostics));
    return diagnostics.entries().empty() ? Code{} : diagnostics.entries().front().facts.code;
  };
  EXPECT_EQ(code_of_failure(options_by_image("eucm", *camera.image_size, [](double, double) { return 0.0F; })),
            Code::kWeightsBlack);
  // White only where the lens is not.
  EXPECT_EQ(code_of_failure(options_by_image("eucm", *camera.image_size,
                                             [](double u, double v) { return std::hypot(u, v) < 20.0 ? 255.0F : 0.0F; })),
            Code::kWeightsBlack);
  EXPECT_EQ(code_of_failure(options_by_image("eucm", {64, 64}, [](double, double) { return 1.0F; })), Code::kImageOfOtherSize);
  EXPECT_EQ(code_of_failure(options_to("eucm", WeightKind::kImage)), Code::kImageOfOtherSize) << "no image";
  ConvertOptions largest = options_to("eucm", WeightKind::kAngle);
  largest.objective = Objective::kMax;
  EXPECT_EQ(code_of_failure(largest), Code::kWeightedForRms);
}

}  // namespace
}  // namespace fca::test
