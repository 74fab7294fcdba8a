// SPDX-License-Identifier: BSD-3-Clause
// Many pixels at a time must say what the models say of each: to 1e-12, whichever SIMD version the processor runs.
#include "models/kernels/batch.h"
#include "convert/evaluation/scorer.h"
#include "known_cameras.h"
#include "random_model.h"

#include <fca/convert/convert.h>
#include <fca/convert/field_of_view.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

namespace fca {
namespace {

using internal::Batch;

constexpr double kRelative = 1e-12;
constexpr int kColumns = 16;
constexpr int kRows = 16;

/// The pixels of an image and of a margin around it, the centre of the lens among them.
void fill_pixels(const CameraModel& model, const ImageSize& size, Batch& batch) {
  const Pixel centre = principal_point(model);
  for (int j = 0; j < kRows; ++j) {
    for (int i = 0; i < kColumns; ++i) {
      const auto at = static_cast<std::size_t>(j * kColumns + i);
      batch.u[at] = i == 0 ? centre[0] : size.width * (1.2 * i / kColumns - 0.1);
      batch.v[at] = j == 0 ? centre[1] : size.height * (1.2 * j / kRows - 0.1);
    }
  }
}

/// Whether the rays found are the model's; how many of those that exist were not found.
struct Rays {
  bool right = true;
  int there = 0;
  int left_to_the_model = 0;
};

Rays compare_rays(const CameraModel& model, const ImageSize& size, double lens) {
  Batch batch;
  fill_pixels(model, size, batch);
  internal::BatchRays(model, lens)(batch, Batch::kSize);
  Rays result;
  for (std::size_t i = 0; i < Batch::kSize; ++i) {
    const std::optional<Ray> ray = unproject(model, {batch.u[i], batch.v[i]});
    const bool inside = ray && angle_from_axis(*ray) <= lens;
    result.there += inside ? 1 : 0;
    if (batch.z[i] == internal::kNoRay) {
      result.right = result.right && !inside;
    } else if (std::isfinite(batch.z[i])) {
      result.right = result.right && ray && std::abs(batch.x[i] - (*ray)[0]) <= kRelative &&
                     std::abs(batch.y[i] - (*ray)[1]) <= kRelative && std::abs(batch.z[i] - (*ray)[2]) <= kRelative;
    } else {
      result.left_to_the_model += inside ? 1 : 0;
    }
  }
  return result;
}

/// The same of pixels, for rays up to that angle.
struct Pixels {
  bool right = true;
  int left_to_the_model = 0;
};

Pixels compare_pixels(const CameraModel& model, double max_angle_rad) {
  Batch batch;
  for (std::size_t i = 0; i < Batch::kSize; ++i) {
    const double angle = max_angle_rad * static_cast<double>(i) / Batch::kSize;
    const double azimuth = 0.7 * static_cast<double>(i);
    batch.x[i] = std::sin(angle) * std::cos(azimuth);
    batch.y[i] = std::sin(angle) * std::sin(azimuth);
    batch.z[i] = std::cos(angle);
    batch.u[i] = batch.v[i] = 0.0;  // so that the error is the length of the pixel
  }
  internal::BatchErrors(model, max_angle_rad)(batch, Batch::kSize);
  Pixels result;
  for (std::size_t i = 0; i < Batch::kSize; ++i) {
    if (!std::isfinite(batch.error[i])) {
      ++result.left_to_the_model;
      continue;
    }
    const std::optional<Pixel> pixel = project(model, {batch.x[i], batch.y[i], batch.z[i]});
    if (!pixel) {
      result.right = false;
      continue;
    }
    const double length = std::hypot((*pixel)[0], (*pixel)[1]);
    const Pixel centre = principal_point(model);
    const double scale = length + std::hypot(centre[0], centre[1]);
    result.right = result.right && std::abs(batch.error[i] - length) <= kRelative * scale;
  }
  return result;
}

struct KnownLens {
  Camera camera;
  std::optional<double> max_angle_deg;
};

std::vector<KnownLens> known_lenses() {
  using namespace test;
  std::vector<KnownLens> lenses = {
      {kalibr_ds(), {}}, {kalibr_eucm(), {}}, {kalibr_kb4(), {}},         {kalibr_radtan(), {}},     {rational_lens(), {}},
      {tumvi(), 97.5},   {t265_like(), 83.0}, {ocamcalib_sample(), 95.0}, {woodscape_front(), 95.0}, {lens_220(), 110.0}};
  // The models that none of these has, and some that they have: EuRoC's lens.
  for (const ModelInfo& info : all_models()) {
    if (info.kept_only) continue;  // it has no kernels, as nobody fits it
    ConvertOptions options;
    options.model = info.id;
    Diagnostics diagnostics;
    if (std::optional<Conversion> conversion = convert(euroc(), options, diagnostics))
      lenses.push_back({conversion->camera, {}});
  }
  return lenses;
}

TEST(Batch, FindsNearlyEveryRayAndPixelOfKnownLenses) {
  for (const KnownLens& lens : known_lenses()) {
    const CameraModel& model = lens.camera.model;
    SCOPED_TRACE(model_info(model).id);
    std::optional<double> limit;
    if (lens.max_angle_deg) limit = *lens.max_angle_deg * test::kRadians;
    Diagnostics diagnostics;
    const std::optional<FieldOfView> field_of_view = field_of_view_of(lens.camera, limit, diagnostics);
    ASSERT_TRUE(field_of_view);
    const Rays rays = compare_rays(model, *lens.camera.image_size, field_of_view->max_angle_rad);
    EXPECT_TRUE(rays.right);
    EXPECT_GT(rays.there, 0);
    EXPECT_LE(rays.left_to_the_model, rays.there / 50);
    const Pixels pixels = compare_pixels(model, std::min(field_of_view->max_angle_rad, 0.99 * max_angle(model)));
    EXPECT_TRUE(pixels.right);
    EXPECT_LE(pixels.left_to_the_model, static_cast<int>(Batch::kSize) / 50);
  }
}

RC_GTEST_PROP(BatchProperty, SaysWhatTheModelSays, ()) {
  const CameraModel model = test::random_model(*rc::gen::inRange<std::size_t>(0, all_models().size()));
  const double lens = *rc::gen::inRange(20, 181) * test::kRadians;
  RC_ASSERT(compare_rays(model, {640, 480}, lens).right);
  RC_ASSERT(compare_pixels(model, std::min(lens, max_angle(model) - 1e-7)).right);
}

/// Pixels one by one, as the definition says.
RC_GTEST_PROP(BatchProperty, AScorerDecidesAsTheModelsDo, ()) {
  const Camera camera =
      test::make_camera(test::random_model(*rc::gen::inRange<std::size_t>(0, all_models().size())), {640, 480});
  const CameraModel target = test::random_model(*rc::gen::inRange<std::size_t>(0, all_models().size()));
  std::optional<double> limit;
  if (*rc::gen::arbitrary<bool>()) limit = *rc::gen::inRange(20, 120) * test::kRadians;
  Diagnostics diagnostics;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, limit, diagnostics);
  RC_PRE(field_of_view.has_value());
  const internal::Scorer scorer(camera.model, &target, nullptr, *field_of_view, 4.0);
  Batch batch;
  fill_pixels(camera.model, {640, 480}, batch);
  scorer.score(batch, Batch::kSize);
  for (std::size_t i = 0; i < Batch::kSize; ++i) {
    const Pixel pixel = {batch.u[i], batch.v[i]};
    const std::optional<Ray> ray = field_of_view->ray(camera.model, pixel);
    const std::optional<Pixel> image = ray ? project(target, *ray) : std::nullopt;
    RC_ASSERT((batch.verdict[i] == internal::Verdict::kOutsideLens) == !ray);
    RC_ASSERT((batch.verdict[i] == internal::Verdict::kScored) == image.has_value());
    if (!image) continue;
    const double error = std::hypot((*image)[0] - pixel[0], (*image)[1] - pixel[1]);
    // A ray that is 1e-12 from the other one: that far, on a target as steep as it may be there.
    const double steepness = 1.0 + error / 100.0;
    RC_ASSERT(std::abs(batch.error[i] - error) <= 1e-9 * steepness * steepness);
  }
}

}  // namespace
}  // namespace fca
