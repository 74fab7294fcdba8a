// SPDX-License-Identifier: BSD-3-Clause
// Models outside the list, lenses that are functions, and tables of rays: the same answers as for models of the list.
#include "known_cameras.h"

#include <fca/convert/convert.h>
#include <fca/convert/evaluate.h>
#include <fca/convert/fit.h>
#include <fca/convert/ray_table.h>
#include <fca/convert/sample.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace fca {
namespace {

/// EUCM as a stranger would write it: the formula alone, without derivatives, in another order of parameters.
struct OwnEucm {
  static constexpr std::string_view kId = "own-eucm";
  static constexpr std::string_view kTitle = "EUCM, again";
  static constexpr std::array<std::string_view, 0> kAliases = {};
  static constexpr std::array kParameters = {Parameter{"alpha", "", 0.0, 1.0, ParameterGroup::kLens},
                                             Parameter{"beta", "", 0.0, 1e6, ParameterGroup::kLens, true},
                                             common_parameter::kCx,
                                             common_parameter::kCy,
                                             common_parameter::kFx,
                                             common_parameter::kFy};
  template <class T>
  static bool formula(const T* p, const T* ray, T* pixel) {
    using std::sqrt;
    const T d = sqrt(p[1] * (ray[0] * ray[0] + ray[1] * ray[1]) + ray[2] * ray[2]);
    const T denominator = p[0] * d + (T(1.0) - p[0]) * ray[2];
    if (!(denominator > T(0.0))) return false;
    pixel[0] = p[4] * ray[0] / denominator + p[2];
    pixel[1] = p[5] * ray[1] / denominator + p[3];
    return true;
  }
  template <class T>
  static bool project(const T* p, const T* ray, T* pixel) {
    return formula(p, ray, pixel);
  }
  static bool unproject(const double* p, const double* pixel, double* ray) {
    return Eucm::unproject(eucm(p).data(), pixel, ray);
  }
  static double max_angle(const double* p) { return Eucm::max_angle(eucm(p).data()); }
  static std::array<double, 2> principal_point(const double* p) { return {p[2], p[3]}; }
  static std::array<double, 2> central_focal_lengths(const double* p) { return {p[4], p[5]}; }
  static constexpr int kStarts = 1;
  static void initialise(std::span<const Correspondence> /*samples*/, const LensCentre& centre, int /*start*/, double* p) {
    p[0] = 0.6;
    p[1] = 1.0;
    for (std::size_t i = 0; i < 2; ++i) {
      p[2 + i] = centre.point[i];
      p[4 + i] = centre.focal[i];
    }
  }
  static std::array<double, 6> eucm(const double* p) { return {p[4], p[5], p[2], p[3], p[0], p[1]}; }
};
static_assert(CameraModelType<OwnEucm>);

FieldOfView field_of_view_of(const Camera& camera, double degrees) {
  Diagnostics diagnostics;
  return fca::field_of_view_of(camera, degrees * test::kRadians, diagnostics).value();
}

TEST(OwnModel, IsFittedToTheOptimumOfTheSameModelInTheList) {
  for (const auto& [camera, degrees] :
       {std::pair{test::tumvi(), 97.5}, {test::kalibr_ds(), 180.0}, {test::lens_220(), 110.0}}) {
    const FieldOfView field_of_view = field_of_view_of(camera, degrees);
    const std::vector<Correspondence> samples = sample(camera.model, field_of_view);
    const std::optional<Fitted<OwnEucm>> own = fit<OwnEucm>(samples, Lens(camera.model).centre());
    const std::optional<Fitted<Eucm>> listed = fit<Eucm>(samples, Lens(camera.model).centre());
    ASSERT_TRUE(own && listed);
    EXPECT_NEAR(own->rms_px, listed->rms_px, 1e-9);
    const ErrorStatistics a = evaluate(camera.model, projection_of(own->model), field_of_view);
    const ErrorStatistics b = evaluate(camera.model, CameraModel(listed->model), field_of_view);
    // A fit ends where a step gains a billionth of the cost: its parameters, and the error at one pixel, to the root of that.
    constexpr double kEnd = 1e-9;
    EXPECT_NEAR(a.error.rms, b.error.rms, 10.0 * kEnd * b.error.rms);
    EXPECT_NEAR(a.error.max, b.error.max, 10.0 * std::sqrt(kEnd) * b.error.max);
    EXPECT_TRUE(std::isinf(a.error.bound)) << "nothing encloses a stranger's formula";
    EXPECT_NEAR(a.coverage.scored, b.coverage.scored, 1e-12);
  }
}

TEST(OwnModel, RangesHoldAParameter) {
  const Camera camera = test::tumvi();
  const std::vector<Correspondence> samples = sample(camera.model, field_of_view_of(camera, 80.0));
  const std::vector<ParameterRange> ranges = {{"beta", 1.0, 1.0}};
  const std::optional<Fitted<OwnEucm>> own = fit<OwnEucm>(samples, Lens(camera.model).centre(), ranges);
  const std::optional<Fitted<Ucm>> ucm = fit<Ucm>(samples, Lens(camera.model).centre());
  ASSERT_TRUE(own && ucm);
  EXPECT_EQ(own->model.values[1], 1.0);
  EXPECT_NEAR(own->rms_px, ucm->rms_px, 1e-9) << "eucm with beta = 1 is ucm";
}

TEST(OwnModel, IsASourceLikeAnyOther) {
  const Intrinsics<Eucm> listed{{460.9, 459.6, 365.8, 248.9, 0.586, 1.139}};
  const Intrinsics<OwnEucm> own{{0.586, 1.139, 365.8, 248.9, 460.9, 459.6}};
  const CameraModel model = listed;
  const Lens lens(own);
  const Lens function([&model](const Pixel& pixel) { return unproject(model, pixel); }, lens.centre(), max_angle(model));
  Diagnostics diagnostics;
  const std::optional<FieldOfView> field_of_view = fca::field_of_view_of(model, {752, 480}, {}, "cam0", diagnostics);
  ASSERT_TRUE(field_of_view);
  const std::vector<Correspondence> samples = sample(model, *field_of_view);
  const std::optional<Fitted<Kb4>> kb4 = fit<Kb4>(samples, Lens(model).centre());
  ASSERT_TRUE(kb4);
  const ErrorStatistics expected = evaluate(model, CameraModel(kb4->model), *field_of_view);
  for (const Lens* source : {&lens, &function}) {
    const std::optional<FieldOfView> same = fca::field_of_view_of(*source, {752, 480}, {}, "cam0", diagnostics);
    ASSERT_TRUE(same);
    EXPECT_EQ(same->max_angle_rad, field_of_view->max_angle_rad);
    const std::vector<Correspondence> theirs = sample(*source, *same);
    ASSERT_EQ(theirs.size(), samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) EXPECT_EQ(theirs[i].ray, samples[i].ray);
    const ErrorStatistics evaluated = evaluate(*source, CameraModel(kb4->model), *same);
    // The listed model's pixels are computed many at a time: the same to 1e-12 of the image's width, not to the last bit.
    EXPECT_NEAR(evaluated.error.rms, expected.error.rms, 1e-12 * 752);
    EXPECT_NEAR(evaluated.error.max, expected.error.max, 1e-6 * expected.error.max);
  }
}

TEST(RayTable, GivesTheCameraItWasMadeFrom) {
  std::mt19937 random(4);
  for (const Camera& camera : {test::tumvi(), test::euroc(), test::kalibr_ds(), test::lens_220()}) {
    std::vector<Correspondence> table = sample(camera.model, field_of_view_of(camera, 100.0), 400);
    std::ranges::shuffle(table, random);
    const std::optional<LensCentre> centre = centre_of(table);
    ASSERT_TRUE(centre);
    const LensCentre truth = Lens(camera.model).centre();
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(centre->focal[i], truth.focal[i], 0.05 * truth.focal[i]);
      EXPECT_NEAR(centre->point[i], truth.point[i], 0.02 * truth.focal[i]);
    }
    std::visit(
        [&]<class M>(const Intrinsics<M>& /*model*/) {
          const std::optional<Fitted<M>> fitted = fit<M>(table, *centre);
          ASSERT_TRUE(fitted);
          EXPECT_LE(evaluate(table, projection_of(fitted->model)).max, 1e-7) << M::kId;
        },
        camera.model);
  }
}

TEST(RayTable, IsEvaluatedByItsWeights) {
  std::vector<Correspondence> table = {
      {{0.0, 0.0, 1.0}, {10.0, 10.0}, 3.0}, {{0.1, 0.0, 1.0}, {20.0, 10.0}, 1.0}, {{0.0, 0.0, -1.0}, {0.0, 0.0}, 5.0}};
  const Projection target = [](const Ray& ray) {
    if (ray[2] < 0.0) return std::optional<Pixel>();
    return std::optional<Pixel>(ray[0] == 0.0 ? Pixel{10.0, 11.0} : Pixel{23.0, 14.0});
  };
  const ErrorSummary error = evaluate(table, target);
  EXPECT_DOUBLE_EQ(error.rms, std::sqrt((3.0 * 1.0 + 1.0 * 25.0) / 4.0));
  EXPECT_DOUBLE_EQ(error.mean, (3.0 * 1.0 + 1.0 * 5.0) / 4.0);
  EXPECT_DOUBLE_EQ(error.max, 5.0);
  EXPECT_EQ(error.max_at, (Pixel{20.0, 10.0}));
}

TEST(RayTable, WithoutRaysAroundTheAxisHasNoCentre) {
  EXPECT_FALSE(centre_of({}));
  const std::vector<Correspondence> one(8, Correspondence{{0.1, 0.2, 1.0}, {20.0, 10.0}, 1.0});
  EXPECT_FALSE(centre_of(one));
}

}  // namespace
}  // namespace fca
