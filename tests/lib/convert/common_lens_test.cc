// SPDX-License-Identifier: BSD-3-Clause
// One lens for two cameras: the least-squares optimum of both, against its neighbours and against what it replaces.
#include "known_cameras.h"

#include <fca/convert/common_lens.h>
#include <fca/convert/evaluate.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace fca {
namespace {

/// The second of TUM VI's cameras: another lens of the same kind.
Camera second() {
  Camera camera = test::make_camera(
      Intrinsics<Kb4>{{190.44236969414825, 190.4344384721956, 252.59949716835982, 254.91723064636983, 0.0034003170790442797,
                       0.001766278153469831, -0.00266312569781606, 0.0003299517423931039}},
      {512, 512});
  camera.name = "cam1";
  return camera;
}

double mean_square(const std::vector<Camera>& sources, const std::vector<CameraModel>& models) {
  double sum = 0.0;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    Diagnostics diagnostics;
    const FieldOfView field_of_view = field_of_view_of(sources[i], 95.0 * test::kRadians, diagnostics).value();
    const double rms = evaluate(sources[i].model, models[i], field_of_view, {.every_pixel = true, .bound = false}).error.rms;
    sum += rms * rms;
  }
  return sum;
}

std::vector<CameraModel> models_of(const std::vector<Camera>& cameras) {
  std::vector<CameraModel> models;
  for (const Camera& camera : cameras) models.push_back(camera.model);
  return models;
}

TEST(CommonLens, IsTheOptimumOfBothCameras) {
  const std::vector<Camera> sources = {test::tumvi(), second()};
  Diagnostics diagnostics;
  const auto fitted = fit_common_lens(sources, models_of(sources), 95.0 * test::kRadians, diagnostics);
  ASSERT_TRUE(fitted);
  for (const ParameterId id : {ParameterId("k1"), ParameterId("k2"), ParameterId("k3"), ParameterId("k4")})
    EXPECT_EQ(parameter((*fitted)[0], id), parameter((*fitted)[1], id)) << id.name();
  const double best = mean_square(sources, *fitted);
  EXPECT_LT(best, 0.5 * mean_square(sources, with_lens_of_first(models_of(sources))));
  // No step of all unknowns together leads further down, but for the difference of samples and pixels.
  std::mt19937_64 engine(7);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 30; ++i) {
    std::vector<CameraModel> other = *fitted;
    std::array<double, 4> common{};
    for (double& each : common) each = 1e-4 * normal(engine);
    for (CameraModel& model : other) {
      for (std::size_t k = 0; k < 4; ++k) {
        parameter_values(model)[k] += 0.02 * normal(engine);
        parameter_values(model)[4 + k] += common.at(k);
      }
    }
    EXPECT_GE(mean_square(sources, other), 0.995 * best);
  }
}

TEST(CommonLens, OfTwoLikeLensesChangesNothing) {
  Camera other = test::tumvi();
  other.name = "cam1";
  parameter_values(other.model)[2] += 3.0;
  const std::vector<Camera> sources = {test::tumvi(), other};
  Diagnostics diagnostics;
  const auto fitted = fit_common_lens(sources, models_of(sources), {}, diagnostics);
  ASSERT_TRUE(fitted);
  EXPECT_LE(mean_square(sources, *fitted), 1e-10);
}

TEST(CommonLens, NeedsTheSizeOfEachImage) {
  Camera other = second();
  other.image_size.reset();
  const std::vector<Camera> sources = {test::tumvi(), other};
  Diagnostics diagnostics;
  EXPECT_FALSE(fit_common_lens(sources, models_of(sources), {}, diagnostics));
  EXPECT_TRUE(diagnostics.has_errors());
}

}  // namespace
}  // namespace fca
