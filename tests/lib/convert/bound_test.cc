// SPDX-License-Identifier: BSD-3-Clause
// The bound of an error must never be below an error that occurs, and is worth something only if it is close to the largest.
#include "convert/bound/bound.h"
#include "known_cameras.h"
#include "random_model.h"

#include <fca/convert/convert.h>
#include <fca/convert/evaluate.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace fca {
namespace {

/// Largest error on a lattice of the whole image with that spacing, then on one of a quarter pixel around its worst points.
class DenseSearch {
 public:
  DenseSearch(const CameraModel& source, const CameraModel& target, const FieldOfView& field_of_view)
      : source_(source), target_(target), field_of_view_(field_of_view) {}

  [[nodiscard]] double largest(double spacing) const {
    const Pixel last = {field_of_view_.size.width - 1.0, field_of_view_.size.height - 1.0};
    std::vector<std::pair<double, Pixel>> worst;
    visit({0.0, 0.0}, last, spacing, [&](double error, const Pixel& pixel) {
      if (worst.size() >= kWorst && error <= worst.back().first) return;
      worst.emplace_back(error, pixel);
      std::ranges::sort(worst, std::ranges::greater{}, &std::pair<double, Pixel>::first);
      if (worst.size() > kWorst) worst.pop_back();
    });
    double result = 0.0;
    for (const auto& [error, pixel] : worst) {
      result = std::max(result, error);
      visit({pixel[0] - spacing, pixel[1] - spacing}, {pixel[0] + spacing, pixel[1] + spacing}, 0.25,
            [&](double closer, const Pixel& /*at*/) { result = std::max(result, closer); });
    }
    return result;
  }

 private:
  static constexpr std::size_t kWorst = 20;

  template <class F>
  void visit(const Pixel& from, const Pixel& to, double spacing, const F& f) const {
    // One step too far: clamped to the far border, which belongs to the image whatever the spacing.
    for (double y = from[1]; y < to[1] + spacing; y += spacing) {
      for (double x = from[0]; x < to[0] + spacing; x += spacing) {
        const Pixel pixel = {std::clamp(x, 0.0, field_of_view_.size.width - 1.0),
                             std::clamp(y, 0.0, field_of_view_.size.height - 1.0)};
        const std::optional<Ray> ray = field_of_view_.ray(source_, pixel);
        if (!ray) continue;
        const std::optional<Pixel> image = project(target_, *ray);
        if (image) f(std::hypot((*image)[0] - pixel[0], (*image)[1] - pixel[1]), pixel);
      }
    }
  }

  const CameraModel& source_;
  const CameraModel& target_;
  const FieldOfView& field_of_view_;
};

struct TableCamera {
  const char* name;
  Camera camera;
  std::optional<double> max_angle_deg;
};

std::vector<TableCamera> table() {
  using namespace test;
  return {{"kalibr_ds", kalibr_ds(), {}},
          {"kalibr_eucm", kalibr_eucm(), {}},
          {"kalibr_kb4", kalibr_kb4(), {}},
          {"kalibr_radtan", kalibr_radtan(), {}},
          {"euroc", euroc(), {}},
          {"rational_lens", rational_lens(), {}},
          {"ocamcalib_95", ocamcalib_sample(), 95.0},
          {"ocamcalib_80", ocamcalib_sample(), 80.0},
          {"ocamcalib_60", ocamcalib_sample(), 60.0},
          {"tumvi", tumvi(), {}},
          {"tumvi_97", tumvi(), 97.5},
          {"tumvi_80", tumvi(), 80.0},
          {"tumvi_ds_97", tumvi_ds(), 97.5},
          {"tumvi_lit", with_image_circle(tumvi(), {230.0, 275.0}, 215.0), {}},
          {"kalibr_ds_lit", with_image_circle(kalibr_ds(), {420.0, 200.0}, 300.0), {}},
          {"t265_83", t265_like(), 83.0},
          {"t265_60", t265_like(), 60.0},
          {"woodscape_95", woodscape_front(), 95.0},
          {"woodscape_60", woodscape_front(), 60.0},
          {"oak_tilted", oak_tilted(), {}},
          {"scheimpflug", scheimpflug(), {}},
          {"skewed_omnidir", skewed_omnidir(), {}},
          {"skewed_fisheye", skewed_fisheye(), 95.0},
          {"lens_220", lens_220(), 110.0},
          {"lens_220_60", lens_220(), 60.0}};
}

class BoundTest : public testing::TestWithParam<TableCamera> {};

TEST_P(BoundTest, IsNeverBelowTheMaximumAndCloseToIt) {
  const TableCamera& c = GetParam();
  for (const ModelInfo& target : all_models()) {
    if (target.kept_only && target.id != model_info(c.camera.model).id) continue;  // nobody fits it
    SCOPED_TRACE(target.id);
    ConvertOptions options;
    options.model = target.id;
    if (c.max_angle_deg) options.max_angle_rad = *c.max_angle_deg * test::kRadians;
    Diagnostics diagnostics;
    const std::optional<Conversion> conversion = convert(c.camera, options, diagnostics);
    const std::optional<FieldOfView> field_of_view = field_of_view_of(c.camera, options.max_angle_rad, diagnostics);
    ASSERT_TRUE(conversion && field_of_view);
    const ErrorSummary& error = conversion->report.statistics.error;
    EXPECT_GE(error.bound, error.max);
    // A perspective target of a lens that passes 90 degrees has errors without limit.
    constexpr double kUnlimited = 1e5;  // px
    if (error.max < kUnlimited) {
      EXPECT_LE(error.bound, 1.1 * error.max + 1e-9);
    }

    // Without what convert() knows of the maximum: the bound proper.
    const CameraModel& model = conversion->camera.model;
    const internal::ErrorBound bare = internal::bound_error(c.camera.model, model, *field_of_view, 4.0, 0.0);
    const double largest = DenseSearch(c.camera.model, model, *field_of_view).largest(2.0);
    EXPECT_GE(bare.bound, largest);
    EXPECT_LE(bare.seen, bare.bound);
  }
}

INSTANTIATE_TEST_SUITE_P(Cameras, BoundTest, testing::ValuesIn(table()),
                         [](const testing::TestParamInfo<TableCamera>& camera) { return camera.param.name; });

TEST(Bound, IsInfiniteWhereTheErrorIs) {
  // A pinhole's radius has no limit near 90 degrees, where this lens goes on.
  const Camera camera = test::tumvi();
  Diagnostics diagnostics;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, {}, diagnostics);
  ASSERT_TRUE(field_of_view);
  const CameraModel pinhole = Intrinsics<Pinhole>{{190, 190, 255, 256}};
  EXPECT_TRUE(std::isinf(evaluate(camera.model, pinhole, *field_of_view).error.bound));
}

TEST(Bound, IsLooseAndTrueWhenTheBudgetEnds) {
  const Camera camera = test::kalibr_ds();
  Diagnostics diagnostics;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, {}, diagnostics);
  ASSERT_TRUE(field_of_view);
  const CameraModel shifted = Intrinsics<Ds>{{340, 350, 366, 250, 0.55, -0.25}};
  const double largest = DenseSearch(camera.model, shifted, *field_of_view).largest(2.0);
  double before = std::numeric_limits<double>::infinity();
  for (const int budget : {1, 100, 500, 700, 1000, 20'000}) {
    const double bound = internal::bound_error(camera.model, shifted, *field_of_view, 4.0, 0.0, budget).bound;
    EXPECT_GE(bound, largest) << budget;
    EXPECT_LE(bound, before) << budget;
    before = bound;
  }
  EXPECT_LE(before, 1.02 * largest);
}

TEST(Bound, OfAProgramIsNotProven) {
  const Camera camera = test::kalibr_ds();
  Diagnostics diagnostics;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, {}, diagnostics);
  ASSERT_TRUE(field_of_view);
  const Projection program = [&](const Ray& ray) { return project(camera.model, ray); };
  EXPECT_TRUE(std::isinf(evaluate(camera.model, program, *field_of_view).error.bound));
}

RC_GTEST_PROP(BoundProperty, IsNeverBelowAnErrorThatOccurs, ()) {
  const Camera camera =
      test::make_camera(test::random_model(*rc::gen::inRange<std::size_t>(0, all_models().size())), {640, 480});
  // Unrelated models, mostly: errors of any size and shape, at the limits of both.
  const CameraModel target = test::random_model(*rc::gen::inRange<std::size_t>(0, all_models().size()));
  std::optional<double> limit;
  if (*rc::gen::arbitrary<bool>()) limit = *rc::gen::inRange(20, 120) * test::kRadians;
  Diagnostics diagnostics;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, limit, diagnostics);
  RC_PRE(field_of_view.has_value());
  const double bound = internal::bound_error(camera.model, target, *field_of_view, 4.0, 0.0).bound;
  const double largest = DenseSearch(camera.model, target, *field_of_view).largest(8.0);
  RC_ASSERT(bound >= largest);
  RC_CLASSIFY(bound <= 1.1 * largest + 1e-9, "close");
  RC_CLASSIFY(std::isinf(bound), "infinite");
}

RC_GTEST_PROP(BoundProperty, IsNeverBelowTheErrorOfAFit, ()) {
  const Camera camera =
      test::make_camera(test::random_model(*rc::gen::inRange<std::size_t>(0, all_models().size())), {640, 480});
  ConvertOptions options;
  options.model = all_models()[*rc::gen::inRange<std::size_t>(0, all_models().size())].id;
  options.bound = false;
  Diagnostics diagnostics;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, {}, diagnostics);
  RC_PRE(field_of_view.has_value());
  const std::optional<Conversion> conversion = convert(camera, options, diagnostics);
  RC_PRE(conversion.has_value());
  const CameraModel& target = conversion->camera.model;
  const internal::ErrorBound bound = internal::bound_error(camera.model, target, *field_of_view, 4.0, 0.0);
  const double largest = DenseSearch(camera.model, target, *field_of_view).largest(8.0);
  RC_ASSERT(bound.bound >= largest);
  RC_ASSERT(bound.seen <= bound.bound);
  RC_CLASSIFY(bound.bound <= 1.1 * largest + 1e-9, "close");
  RC_CLASSIFY(std::isinf(bound.bound), "infinite");
}

}  // namespace
}  // namespace fca
