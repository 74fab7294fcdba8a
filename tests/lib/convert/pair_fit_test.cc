// SPDX-License-Identifier: BSD-3-Clause
// A pair fitted together against the two separate fits: what stereo feels is computed here without our rectification.
#include "known_cameras.h"

#include <fca/convert/evaluate.h>
#include <fca/convert/field_of_view.h>
#include <fca/convert/pair_fit.h>
#include <fca/rig/rotation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include <Eigen/Geometry>

namespace fca {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d vector(const Ray& ray) { return {ray[0], ray[1], ray[2]}; }

Matrix3d rotation_in(const Transform& T) {
  Matrix3d R;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) R(row, column) = T(row, column);
  }
  return R;
}

Vector3d translation_in(const Transform& T) {
  const std::array<double, 3> t = translation_of(T);
  return {t[0], t[1], t[2]};
}

struct Pair {
  std::array<Camera, 2> cameras;
  Transform T_second_first;
};

Transform pose(double x, double y, double z, const std::array<double, 3>& t) {
  const Matrix3d R = (Eigen::AngleAxisd(x, Vector3d::UnitX()) * Eigen::AngleAxisd(y, Vector3d::UnitY()) *
                      Eigen::AngleAxisd(z, Vector3d::UnitZ()))
                         .toRotationMatrix();
  Transform T;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) T(row, column) = R(row, column);
    T(row, 3) = t.at(static_cast<std::size_t>(row));
  }
  return T;
}

/// TUM VI's two fisheyes.
Pair wide() {
  Camera second = test::make_camera(
      Intrinsics<Kb4>{{190.44236969414825, 190.4344384721956, 252.59949716835982, 254.91723064636983, 0.0034003170790442797,
                       0.001766278153469831, -0.00266312569781606, 0.0003299517423931039}},
      {512, 512});
  second.name = "cam1";
  return {{test::tumvi(), second}, pose(0.047, 0.0007, 0.0008, {-0.101, -0.002, -0.0012})};
}

/// Lenses with tangential terms of different sizes.
Pair tilted() {
  Camera first = test::make_camera(
      Intrinsics<Radtan>{{458.654, 457.296, 367.215, 248.375, -0.28340811, 0.07395907, 0.0021, -0.0009}}, {752, 480});
  Camera second = test::make_camera(
      Intrinsics<Radtan>{{457.587, 456.134, 379.999, 255.238, -0.28368365, 0.07451284, -0.0012, 0.0004}}, {752, 480});
  second.name = "cam1";
  return {{first, second}, pose(0.004, -0.01, 0.002, {-0.11, 0.0004, -0.0008})};
}

constexpr double kWide = 95.0 * test::kRadians;

std::array<SeparateFit, 2> separate(const Pair& pair, const std::string& model, std::optional<double> max_angle_rad = {}) {
  ConvertOptions options;
  options.model = model;
  options.max_angle_rad = max_angle_rad;
  std::array<SeparateFit, 2> fits;
  for (std::size_t i = 0; i < 2; ++i) {
    Diagnostics diagnostics;
    fits.at(i) = {pair.cameras.at(i), convert(pair.cameras.at(i), options, diagnostics).value(), options};
  }
  return fits;
}

using Conversions = std::array<Conversion, 2>;

Matrix3d turn_of(const Conversion& conversion) {
  return conversion.report.turn ? rotation_in(conversion.report.turn->T_target_source) : Matrix3d::Identity();
}

/// Root mean square of the rows by which matches differ in images whose rows are parallel to the baseline, in pixels of the
/// middle: of matches at infinity and of near ones the larger. Rays within 60 deg of the rectified axis.
double epipolar_rms(const Pair& pair, const Conversions& conversions) {
  constexpr int kSteps = 60;
  const auto& [first, second] = pair.cameras;
  const Matrix3d R = rotation_in(pair.T_second_first);
  const Vector3d t = translation_in(pair.T_second_first);
  const Matrix3d R_meant = turn_of(conversions[1]) * R * turn_of(conversions[0]).transpose();
  const Vector3d across = (turn_of(conversions[1]) * t).normalized();
  const Vector3d axis = Vector3d::UnitZ() + R_meant * Vector3d::UnitZ();
  const Vector3d ahead = (axis - axis.dot(across) * across).normalized();
  const Vector3d down = ahead.cross(across);
  const double focal = 0.5 * (central_focal_lengths(first.model)[1] + central_focal_lengths(second.model)[1]);
  std::array<double, 2> worst{};
  for (std::size_t k = 0; k < 2; ++k) {
    double sum = 0.0;
    int count = 0;
    for (int i = 0; i < kSteps; ++i) {
      for (int j = 0; j < kSteps; ++j) {
        const Pixel pixel = {(first.image_size->width - 1.0) * i / (kSteps - 1),
                             (first.image_size->height - 1.0) * j / (kSteps - 1)};
        const std::optional<Ray> ray = unproject(first.model, pixel);
        if (!ray) continue;
        const Vector3d x = k == 0 ? Vector3d(R * vector(*ray)) : Vector3d(10.0 * t.norm() * (R * vector(*ray)) + t);
        const std::optional<Pixel> match = project(second.model, Ray{x[0], x[1], x[2]});
        if (!match || !second.image_size->holds(*match)) continue;
        const std::optional<Ray> here = unproject(conversions[0].camera.model, pixel);
        const std::optional<Ray> there = unproject(conversions[1].camera.model, *match);
        if (!here || !there) continue;
        const Vector3d a = R_meant * vector(*here);
        const Vector3d b = vector(*there);
        if (a.dot(ahead) < 0.5 * a.norm() || b.dot(ahead) < 0.5 * b.norm()) continue;
        const double off = focal * (b.dot(down) / b.dot(ahead) - a.dot(down) / a.dot(ahead));
        sum += off * off;
        ++count;
      }
    }
    worst.at(k) = std::sqrt(sum / std::max(count, 1));
  }
  return std::max(worst[0], worst[1]);
}

Conversions before(const std::array<SeparateFit, 2>& fits) { return {fits[0].conversion, fits[1].conversion}; }

TEST(PairFit, LowersWhatStereoFeels) {
  for (const std::string model : {"ds", "eucm"}) {
    const Pair pair = wide();
    const std::array<SeparateFit, 2> fits = separate(pair, model, kWide);
    const std::optional<PairFit> together = fit_pair(fits, pair.T_second_first);
    ASSERT_TRUE(together) << model;
    EXPECT_LT(together->after.rms_px(), 0.8 * together->before.rms_px()) << model;
    EXPECT_LT(epipolar_rms(pair, together->conversions), 0.9 * epipolar_rms(pair, before(fits))) << model;
    // The weight of rows limits what pixels may pay: a sum of squares, of which rows count nine times.
    for (std::size_t i = 0; i < 2; ++i) {
      const double rms = together->conversions.at(i).report.statistics.error.rms;
      const double alone = fits.at(i).conversion.report.statistics.error.rms;
      const double rows = together->before.rms_px();
      EXPECT_GE(rms, (1.0 - 1e-3) * alone) << model;
      EXPECT_LT(rms * rms, alone * alone + 18.0 * rows * rows) << model;
    }
  }
}

TEST(PairFit, TurnsWhereLensesAreTilted) {
  const Pair pair = tilted();
  const std::array<SeparateFit, 2> fits = separate(pair, "kb4");
  const std::optional<PairFit> together = fit_pair(fits, pair.T_second_first);
  ASSERT_TRUE(together);
  EXPECT_TRUE(together->conversions[0].report.turn);
  EXPECT_TRUE(together->conversions[1].report.turn);
  EXPECT_LT(epipolar_rms(pair, together->conversions), 0.9 * epipolar_rms(pair, before(fits)));
  // The report is about the turned camera: its error, computed here.
  for (std::size_t i = 0; i < 2; ++i) {
    const Conversion& conversion = together->conversions.at(i);
    const Camera& source = pair.cameras.at(i);
    double sum = 0.0;
    int count = 0;
    constexpr double kStep = 4.0;
    for (double u = 0.5 * (kStep - 1.0); u < source.image_size->width; u += kStep) {
      for (double v = 0.5 * (kStep - 1.0); v < source.image_size->height; v += kStep) {
        const Ray ray = unproject(source.model, {u, v}).value();
        const Vector3d turned = turn_of(conversion) * vector(ray);
        const Pixel pixel = project(conversion.camera.model, {turned[0], turned[1], turned[2]}).value();
        sum += std::pow(pixel[0] - u, 2) + std::pow(pixel[1] - v, 2);
        ++count;
      }
    }
    EXPECT_NEAR(conversion.report.statistics.error.rms, std::sqrt(sum / count), 0.02 * std::sqrt(sum / count));
  }
}

/// The sum of squares that is made small.
double sum_of(const Pair& pair, const std::array<CameraModel, 2>& models) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    Diagnostics diagnostics;
    const FieldOfView field_of_view = field_of_view_of(pair.cameras.at(i), kWide, diagnostics).value();
    const double rms =
        evaluate(pair.cameras.at(i).model, models.at(i), field_of_view, {.every_pixel = true, .bound = false}).error.rms;
    sum += rms * rms;
  }
  const PairError error =
      pair_error({pair.cameras[0], models[0]}, {pair.cameras[1], models[1]}, pair.T_second_first, pair.T_second_first).value();
  const double far_away = error.disparity.at_infinity.rms_px;
  const double near = error.disparity.at_ten_baselines.rms_px;
  return sum + 9.0 * 0.5 * (far_away * far_away + near * near);
}

TEST(PairFit, IsTheOptimumOfBothCameras) {
  const Pair pair = wide();
  const std::array<SeparateFit, 2> fits = separate(pair, "eucm", kWide);
  const std::optional<PairFit> together = fit_pair(fits, pair.T_second_first);
  ASSERT_TRUE(together);
  ASSERT_FALSE(together->conversions[0].report.turn);
  const auto models = [](const Conversions& conversions) {
    return std::array<CameraModel, 2>{conversions[0].camera.model, conversions[1].camera.model};
  };
  const double best = sum_of(pair, models(together->conversions));
  EXPECT_LT(best, 0.9 * sum_of(pair, models(before(fits))));
  // No step of all parameters leads further down, but for the difference of samples and pixels.
  constexpr double kSampling = 0.02;
  std::mt19937_64 engine(11);
  std::normal_distribution<double> normal;
  int higher = 0;
  for (int i = 0; i < 40; ++i) {
    std::array<CameraModel, 2> other = models(together->conversions);
    for (CameraModel& model : other) {
      for (double& each : parameter_values(model)) each *= 1.0 + 2e-5 * normal(engine);
    }
    const double sum = sum_of(pair, other);
    EXPECT_GT(sum, (1.0 - kSampling) * best) << i;
    higher += sum > (1.0 + kSampling) * best ? 1 : 0;
  }
  EXPECT_GT(higher, 10);  // else the steps were too small to tell
}

TEST(PairFit, IsNoneWhereNothingWasFitted) {
  const Pair pair = wide();
  EXPECT_FALSE(fit_pair(separate(pair, "kb4"), pair.T_second_first));
}

TEST(PairFit, IsNoneWithoutABaseline) {
  const Pair pair = wide();
  EXPECT_FALSE(fit_pair(separate(pair, "ds"), Transform()));
}

}  // namespace
}  // namespace fca
