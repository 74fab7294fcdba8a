// SPDX-License-Identifier: BSD-3-Clause
// The propagation of a calibration's uncertainty against draws from it: to pixels, to fitted models, from residuals.
#include "known_cameras.h"

#include <fca/convert/convert.h>
#include <fca/convert/ray_table.h>
#include <fca/convert/uncertainty.h>

#include <gtest/gtest.h>
#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace fca {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A ray of the camera's image at those fractions of its width and height.
Ray ray_at(const Camera& camera, double u, double v) {
  const ImageSize size = *camera.image_size;
  return unproject(camera.model, {u * (size.width - 1.0), v * (size.height - 1.0)}).value();
}

/// Rays all over the image that have a pixel.
std::vector<Ray> rays_of(const Camera& camera, int steps) {
  std::vector<Ray> rays;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      const ImageSize size = *camera.image_size;
      const auto ray = unproject(camera.model, {(size.width - 1.0) * i / steps, (size.height - 1.0) * j / steps});
      if (ray && angle_from_axis(*ray) < 85.0 * test::kRadians) rays.push_back(*ray);
    }
  }
  return rays;
}

VectorXd pixels_of(const CameraModel& model, const std::vector<Ray>& rays) {
  VectorXd pixels(static_cast<Index>(2 * rays.size()));
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Pixel pixel = project(model, rays[i]).value();
    pixels[static_cast<Index>(2 * i)] = pixel[0];
    pixels[static_cast<Index>(2 * i + 1)] = pixel[1];
  }
  return pixels;
}

/// What a calibration with such points has: sigma^2 (J'J)^-1 by central differences, with the correlations that fx and k1 have.
Uncertainty calibrated(const Camera& camera, double sigma_px) {
  const std::vector<Ray> rays = rays_of(camera, 12);
  const auto count = static_cast<Index>(parameter_values(camera.model).size());
  MatrixXd jacobian(static_cast<Index>(2 * rays.size()), count);
  for (Index i = 0; i < count; ++i) {
    CameraModel more = camera.model;
    CameraModel less = camera.model;
    const double step = 1e-6 * std::max(1.0, std::abs(parameter_values(more)[static_cast<std::size_t>(i)]));
    parameter_values(more)[static_cast<std::size_t>(i)] += step;
    parameter_values(less)[static_cast<std::size_t>(i)] -= step;
    jacobian.col(i) = (pixels_of(more, rays) - pixels_of(less, rays)) / (2.0 * step);
  }
  const MatrixXd covariance =
      sigma_px * sigma_px * (jacobian.transpose() * jacobian).ldlt().solve(MatrixXd::Identity(count, count));
  Uncertainty result;
  result.camera = camera.name;
  result.model = model_info(camera.model).id;
  for (Index i = 0; i < count; ++i) {
    result.sigmas.push_back(std::sqrt(covariance(i, i)));
    for (Index j = 0; j < count; ++j) result.covariance.push_back(covariance(std::min(i, j), std::max(i, j)));
  }
  return result;
}

MatrixXd matrix_of(const Uncertainty& uncertainty) {
  const auto count = static_cast<Index>(uncertainty.sigmas.size());
  return Eigen::Map<const MatrixXd>(uncertainty.covariance.data(), count, count);
}

/// Cameras drawn from the calibration's own distribution.
class Draws {
 public:
  Draws(const CameraModel& model, const Uncertainty& uncertainty)
      : model_(model), factor_(matrix_of(uncertainty).llt().matrixL()) {}

  CameraModel next() {
    VectorXd normal(factor_.rows());
    for (double& each : normal) each = normal_(engine_);
    const VectorXd step = factor_ * normal;
    CameraModel drawn = model_;
    for (Index i = 0; i < step.size(); ++i) parameter_values(drawn)[static_cast<std::size_t>(i)] += step[i];
    return drawn;
  }

 private:
  CameraModel model_;
  MatrixXd factor_;
  std::mt19937_64 engine_{12345};
  std::normal_distribution<double> normal_;
};

/// The standard deviation along the direction in which rows spread most, by brute force over directions.
double spread_of(const std::vector<Pixel>& pixels) {
  double worst = 0.0;
  for (int deg = 0; deg < 180; ++deg) {
    double sum = 0.0;
    double squares = 0.0;
    for (const Pixel& pixel : pixels) {
      const double along = std::cos(deg * test::kRadians) * pixel[0] + std::sin(deg * test::kRadians) * pixel[1];
      sum += along;
      squares += along * along;
    }
    const auto count = static_cast<double>(pixels.size());
    worst = std::max(worst, std::sqrt(squares / count - (sum / count) * (sum / count)));
  }
  return worst;
}

/// The largest relative deviation of the predicted sigma from the spread of drawn pixels, over rays of the image.
double worst_deviation(const Camera& camera, const Uncertainty& truth, const Uncertainty& stated) {
  constexpr int kDraws = 4000;
  const std::vector<Ray> rays = {ray_at(camera, 0.5, 0.5), ray_at(camera, 0.2, 0.3), ray_at(camera, 0.05, 0.5),
                                 ray_at(camera, 0.85, 0.85), ray_at(camera, 0.03, 0.05)};
  std::vector<std::vector<Pixel>> drawn(rays.size());
  Draws draws(camera.model, truth);
  for (int i = 0; i < kDraws; ++i) {
    const CameraModel model = draws.next();
    for (std::size_t k = 0; k < rays.size(); ++k) drawn[k].push_back(project(model, rays[k]).value());
  }
  double worst = 0.0;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const double predicted = pixel_sigma(camera.model, stated, rays[k]).value();
    worst = std::max(worst, std::abs(predicted / spread_of(drawn[k]) - 1.0));
  }
  return worst;
}

/// Parameters that move pixels by up to 0.05 px each, and one that moves them by ten times as much.
Uncertainty led_by(const Camera& camera, std::size_t leading, double leading_px) {
  const std::vector<Ray> rays = rays_of(camera, 12);
  const std::size_t count = parameter_values(camera.model).size();
  Uncertainty result;
  result.model = model_info(camera.model).id;
  result.covariance.assign(count * count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    CameraModel more = camera.model;
    const double step = 1e-6 * std::max(1.0, std::abs(parameter_values(more)[i]));
    parameter_values(more)[i] += step;
    const double px_per_step = (pixels_of(more, rays) - pixels_of(camera.model, rays)).cwiseAbs().maxCoeff();
    result.sigmas.push_back((i == leading ? leading_px : 0.05) * step / px_per_step);
    result.covariance[i * count + i] = result.sigmas[i] * result.sigmas[i];
  }
  return result;
}

constexpr double kSpreadOfDraws = 0.06;  // five times that of a standard deviation of 4,000 draws

TEST(Uncertainty, OfPixelsIsTheSpreadOfDraws) {
  for (const Camera& camera : {test::tumvi(), test::euroc(), test::kalibr_ds()}) {
    const Uncertainty uncertainty = calibrated(camera, 0.1);
    EXPECT_LE(worst_deviation(camera, uncertainty, uncertainty), kSpreadOfDraws) << model_info(camera.model).id;
  }
}

TEST(Uncertainty, OfPixelsIsWrongWhereOneSigmaIsHalved) {
  constexpr double kLeadingPx = 0.5;
  for (const Camera& camera : {test::tumvi(), test::euroc(), test::kalibr_ds()}) {
    for (std::size_t i = 0; i < parameter_values(camera.model).size(); ++i) {
      const Uncertainty truth = led_by(camera, i, kLeadingPx);
      const std::string name =
          std::string(model_info(camera.model).id) + " " + std::string(model_info(camera.model).parameters[i].name);
      EXPECT_LE(worst_deviation(camera, truth, truth), kSpreadOfDraws) << name;
      EXPECT_GT(worst_deviation(camera, truth, led_by(camera, i, 0.5 * kLeadingPx)), 2.0 * kSpreadOfDraws) << name;
    }
  }
}

TEST(Uncertainty, WithoutCorrelationsIsTheWorstOfAllCorrelations) {
  for (const Camera& camera : {test::tumvi(), test::kalibr_ds()}) {
    Uncertainty full = calibrated(camera, 1.0);
    Uncertainty alone = full;
    alone.covariance.clear();
    const std::size_t count = full.sigmas.size();
    for (const Ray& ray : {ray_at(camera, 0.5, 0.5), ray_at(camera, 0.1, 0.2), ray_at(camera, 0.8, 0.6)}) {
      const double limit = pixel_sigma(camera.model, alone, ray).value();
      EXPECT_GE(limit, pixel_sigma(camera.model, full, ray).value());
      // Correlations of 1 and -1 alone, all of them.
      double worst = 0.0;
      for (std::size_t signs = 0; signs < (std::size_t{1} << count); ++signs) {
        Uncertainty extreme = alone;
        for (std::size_t i = 0; i < count; ++i) {
          for (std::size_t j = 0; j < count; ++j) {
            const double sign = ((signs >> i) & 1U) == ((signs >> j) & 1U) ? 1.0 : -1.0;
            extreme.covariance.push_back(sign * alone.sigmas[i] * alone.sigmas[j]);
          }
        }
        worst = std::max(worst, pixel_sigma(camera.model, extreme, ray).value());
      }
      EXPECT_NEAR(limit, worst, 1e-9 * worst);
    }
  }
}

TEST(Uncertainty, OfAFittedModelIsTheSpreadOfFits) {
  const Camera camera = test::tumvi();
  const Uncertainty uncertainty = calibrated(camera, 0.2);
  ConvertOptions options;
  options.model = "eucm";
  options.max_angle_rad = 80.0 * test::kRadians;
  options.bound = false;
  Diagnostics diagnostics;
  const std::optional<Conversion> conversion = convert(camera, options, diagnostics);
  ASSERT_TRUE(conversion);
  const std::optional<PixelUncertainty> own =
      pixel_uncertainty(camera, conversion->camera, conversion->report, &uncertainty, options.max_angle_rad);
  ASSERT_TRUE(own);
  ASSERT_FALSE(own->sigmas.empty());
  constexpr int kDraws = 400;
  Draws draws(camera.model, uncertainty);
  std::vector<std::vector<double>> values(own->sigmas.size());
  for (int i = 0; i < kDraws; ++i) {
    Camera drawn = camera;
    drawn.model = draws.next();
    const std::optional<Conversion> fitted = convert(drawn, options, diagnostics);
    ASSERT_TRUE(fitted);
    for (std::size_t k = 0; k < values.size(); ++k) values[k].push_back(parameter_values(fitted->camera.model)[k]);
  }
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double mean = Eigen::Map<const VectorXd>(values[k].data(), kDraws).mean();
    const double spread = std::sqrt((Eigen::Map<const VectorXd>(values[k].data(), kDraws).array() - mean).square().mean());
    EXPECT_NEAR(own->sigmas[k] / spread, 1.0, 0.15) << model_info(conversion->camera.model).parameters[k].name;
  }
}

TEST(Uncertainty, OfAKeptModelIsItsOwn) {
  const Camera camera = test::tumvi();
  const Uncertainty uncertainty = calibrated(camera, 0.5);
  Diagnostics diagnostics;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, {}, diagnostics);
  ASSERT_TRUE(field_of_view);
  const std::optional<Uncertainty> same = uncertainty_of_fit(camera.model, uncertainty, camera.model, {}, *field_of_view);
  ASSERT_TRUE(same);
  for (std::size_t i = 0; i < same->sigmas.size(); ++i) {
    if (parameter_values(camera.model)[i] == 0.0) continue;
    EXPECT_NEAR(same->sigmas[i], uncertainty.sigmas[i], 1e-6 * uncertainty.sigmas[i]);
  }
}

/// A lattice of rays whose pixels a detector has seen with that noise.
Camera seen(const Camera& camera, double noise_px, std::mt19937_64& engine) {
  std::normal_distribution<double> noise(0.0, noise_px);
  Camera table = camera;
  table.rays.clear();
  for (const Ray& ray : rays_of(camera, 20)) {
    const Pixel pixel = project(camera.model, ray).value();
    table.rays.push_back({ray, {pixel[0] + noise(engine), pixel[1] + noise(engine)}, 1.0});
  }
  std::erase_if(table.rays, [](const Correspondence& entry) { return entry.pixel[0] < 0.0 || entry.pixel[1] < 0.0; });
  for (Correspondence& entry : table.rays) entry.weight = 1.0 / static_cast<double>(table.rays.size());
  const LensCentre centre = centre_of(table.rays).value();
  table.model = Intrinsics<Pinhole>{{centre.focal[0], centre.focal[1], centre.point[0], centre.point[1]}};
  return table;
}

TEST(Uncertainty, OfMeasuredRaysIsTheSpreadOfMeasurements) {
  const Camera camera = test::tumvi();
  constexpr int kDraws = 250;
  std::mt19937_64 engine(99);
  ConvertOptions options;
  options.model = "kb4";
  const Ray ray = ray_at(camera, 0.15, 0.2);
  std::vector<Pixel> pixels;
  double mean_sigma = 0.0;
  double mean_largest = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const Camera table = seen(camera, 0.4, engine);
    Diagnostics diagnostics;
    const std::optional<Conversion> conversion = convert(table, options, diagnostics);
    ASSERT_TRUE(conversion);
    const std::optional<PixelUncertainty> own = pixel_uncertainty(table, conversion->camera, conversion->report, nullptr, {});
    ASSERT_TRUE(own);
    EXPECT_TRUE(own->of_residuals);
    EXPECT_FALSE(own->is_limit);
    const std::optional<Uncertainty> of_fit = uncertainty_of_residuals(conversion->camera.model, table.rays, {});
    ASSERT_TRUE(of_fit);
    mean_sigma += pixel_sigma(conversion->camera.model, *of_fit, ray).value() / kDraws;
    mean_largest += own->max_px / kDraws;
    pixels.push_back(project(conversion->camera.model, ray).value());
  }
  EXPECT_NEAR(mean_sigma / spread_of(pixels), 1.0, 0.2);
  EXPECT_GE(mean_largest, mean_sigma);
}

TEST(Uncertainty, OfAnApproximatedLensIsNone) {
  Camera camera = test::tumvi();
  const CameraModel model = camera.model;
  const std::optional<Camera> table = measured(
      camera, [&model](const Ray& ray) { return project(model, ray); }, 90.0 * test::kRadians);
  ASSERT_TRUE(table);
  ConvertOptions options;
  options.model = "ds";
  Diagnostics diagnostics;
  const std::optional<Conversion> conversion = convert(*table, options, diagnostics);
  ASSERT_TRUE(conversion);
  EXPECT_FALSE(pixel_uncertainty(*table, conversion->camera, conversion->report, nullptr, {})) << "areas are no measurements";
}

TEST(Uncertainty, FollowsTheImagesSize) {
  const Camera camera = test::tumvi();
  const PixelMap map = {{0.5, 0.5}, {-0.25, -0.25}};
  for (const bool with_correlations : {true, false}) {
    Uncertainty uncertainty = calibrated(camera, 1.0);
    if (!with_correlations) uncertainty.covariance.clear();
    const Uncertainty halved = with_pixels(uncertainty, camera.model, map);
    const Ray ray = ray_at(camera, 0.2, 0.7);
    EXPECT_NEAR(pixel_sigma(with_pixels(camera.model, map), halved, ray).value(),
                0.5 * pixel_sigma(camera.model, uncertainty, ray).value(), 1e-9);
  }
}

// A map of every pixel checks the summary.
TEST(Uncertainty, WorstPixelIsTheWorstOfAllPixels) {
  const Camera camera = test::euroc();
  const Uncertainty uncertainty = calibrated(camera, 1.0);
  ConversionReport report;
  report.exact = true;
  report.scored_to_deg = 180.0;
  const std::optional<PixelUncertainty> own = pixel_uncertainty(camera, camera, report, &uncertainty, {});
  ASSERT_TRUE(own);
  double worst = 0.0;
  double squares = 0.0;
  int count = 0;
  for (int u = 0; u < camera.image_size->width; u += 4) {
    for (int v = 0; v < camera.image_size->height; v += 4) {
      const std::optional<Ray> ray = unproject(camera.model, {static_cast<double>(u), static_cast<double>(v)});
      if (!ray) continue;
      const double sigma = pixel_sigma(camera.model, uncertainty, *ray).value();
      worst = std::max(worst, sigma);
      squares += sigma * sigma;
      ++count;
    }
  }
  EXPECT_GE(own->max_px, 0.99 * worst);
  EXPECT_LE(own->max_px, 1.1 * worst) << "the image ends between the rows that were tried";
  EXPECT_NEAR(own->rms_px / std::sqrt(squares / count), 1.0, 0.05);
}

TEST(Uncertainty, OfAnotherModelIsNotUsed) {
  const Uncertainty of_ds = calibrated(test::kalibr_ds(), 1.0);
  EXPECT_FALSE(pixel_sigma(test::tumvi().model, of_ds, {0.0, 0.0, 1.0}));
}

TEST(Uncertainty, ACovarianceHasNoNegativeVariance) {
  Uncertainty uncertainty = calibrated(test::tumvi(), 1.0);
  EXPECT_GT(least_variance(uncertainty), 0.0);
  const std::size_t count = uncertainty.sigmas.size();
  uncertainty.covariance[1] = uncertainty.covariance[count] = 1.5 * uncertainty.sigmas[0] * uncertainty.sigmas[1];
  EXPECT_LT(least_variance(uncertainty), -0.1);
}

}  // namespace
}  // namespace fca
