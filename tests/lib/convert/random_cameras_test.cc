// SPDX-License-Identifier: BSD-3-Clause
// Does a fit find the lowest minimum, whatever the lens? Seeded random cameras: a few in every run, 1,000 where
// FCA_ALL_RANDOM_CAMERAS is set (tests/bench/run).
#include "known_cameras.h"
#include "random_lens.h"
#include "sanitized.h"

#include <convert/evaluation/stages.h>
#include <convert/fitting/fit_model.h>
#include <convert/fitting/fitter.h>
#include <convert/fitting/jet_target.h>
#include <fca/convert/convert.h>
#include <fca/convert/field_of_view.h>
#include <fca/convert/sample.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <tuple>

namespace fca {
namespace {

using test::Random;

/// Sanitizers look at what a run does, not at how well it does on the whole.
int how_many(int usually) {
  if (std::getenv("FCA_ALL_RANDOM_CAMERAS") != nullptr) return 1000;
  return test::is_sanitized() ? std::max(usually / 5, 1) : usually;
}

struct Sampled {
  std::vector<Correspondence> samples;
  LensCentre centre;
};

/// The samples that a conversion would begin with; none where the camera sees too little of its image.
Sampled samples_of(const Camera& camera) {
  Diagnostics diagnostics;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, {}, diagnostics);
  if (!field_of_view) return {};
  return {sample(camera.model, *field_of_view), {central_focal_lengths(camera.model), principal_point(camera.model)}};
}

double largest_distance(const CameraModel& model, const std::vector<Correspondence>& samples) {
  double largest = 0.0;
  for (const Correspondence& s : samples) {
    const std::optional<Pixel> pixel = project(model, s.ray);
    if (!pixel) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, std::hypot((*pixel)[0] - s.pixel[0], (*pixel)[1] - s.pixel[1]));
  }
  return largest;
}

// The model's own pixels: what is left is the fit's fault. (A conversion from ds to ds is a copy and proves nothing.)
TEST(RandomCameras, DsIsFoundFromItsOwnPixels) {
  Random random(20);
  const int count = how_many(1000);
  int tried = 0;
  double largest = 0.0;
  while (tried < count) {
    const double xi = random.between(-0.9, 0.9);
    const double focal = random.between(150.0, 600.0) * (1.0 + xi);
    const Intrinsics<Ds> ds{{focal, focal * random.between(0.98, 1.02), random.between(300.0, 340.0),
                             random.between(220.0, 260.0), random.between(0.0, 1.0), xi}};
    const Sampled sampled = samples_of(test::make_camera(ds, {640, 480}));
    if (sampled.samples.size() < 100) continue;
    ++tried;
    const auto fitted = internal::fit_model("ds", sampled.samples, sampled.centre, {});
    ASSERT_TRUE(fitted);
    const double distance = largest_distance(fitted->model, sampled.samples);
    EXPECT_LE(distance, 1e-6) << fitted->rms_px << " px rms " << ::testing::PrintToString(ds.values) << " -> "
                              << ::testing::PrintToString(std::get<Intrinsics<Ds>>(fitted->model).values);
    largest = std::max(largest, distance);
  }
  std::printf("  %d cameras, largest distance %.1e px\n", tried, largest);
}

/// Lenses that somebody may have: pincushions to fisheyes, of every model that has a size of its own.
Camera plausible_camera(Random& random) {
  const double fx = random.between(180.0, 700.0);
  const double fy = fx * random.between(0.97, 1.03);
  const double cx = random.between(290.0, 350.0);
  const double cy = random.between(210.0, 270.0);
  const auto model = [&]() -> CameraModel {
    switch (random.below(9)) {
      case 0:
        return Intrinsics<Kb4>{{fx, fy, cx, cy, random.between(-0.1, 0.1), random.between(-0.03, 0.03),
                                random.between(-0.01, 0.01), random.between(-0.002, 0.002)}};
      case 1:
        return Intrinsics<Radtan>{{fx, fy, cx, cy, random.between(-0.35, 0.2), random.between(-0.05, 0.15),
                                   random.between(-1e-3, 1e-3), random.between(-1e-3, 1e-3), random.between(-0.02, 0.02)}};
      case 2:
        return Intrinsics<Eucm>{{fx, fy, cx, cy, random.between(0.05, 0.8), random.between(0.5, 2.0)}};
      case 3: {
        const double xi = random.between(-0.4, 0.6);
        return Intrinsics<Ds>{{fx * (1.0 + xi), fy * (1.0 + xi), cx, cy, random.between(0.3, 0.8), xi}};
      }
      case 4:
        return Intrinsics<Woodscape>{
            {fx, random.between(-0.1, 0.1) * fx, random.between(-0.05, 0.1) * fx, 0.0, fy / fx, cx, cy}};
      case 5:
        return Intrinsics<Fov>{{fx, fy, cx, cy, random.between(0.3, 1.5)}};
      case 6: {
        const double xi = random.between(0.2, 2.0);
        return Intrinsics<Mei>{{fx * (1.0 + xi), fy * (1.0 + xi), cx, cy, xi, random.between(-0.2, 0.2),
                                random.between(-0.1, 0.1), random.between(-1e-3, 1e-3), random.between(-1e-3, 1e-3)}};
      }
      case 7: {
        const double a0 = -fx;
        return Intrinsics<Ocamcalib>{{cx, cy, fy / fx, random.between(-1e-3, 1e-3), random.between(-1e-3, 1e-3), a0, 0.0,
                                      random.between(0.2, 0.6) / fx, random.between(-0.1, 0.1) / (fx * fx), 0.0, 0.0, 0.0, 0.0,
                                      0.0}};
      }
      default:
        return Intrinsics<Rational>{{fx, fy, cx, cy, random.between(-0.2, 0.6), random.between(-0.1, 0.1),
                                     random.between(-1e-3, 1e-3), random.between(-1e-3, 1e-3), random.between(0.0, 0.02),
                                     random.between(0.0, 0.6), random.between(0.0, 0.1), random.between(0.0, 0.02)}};
    }
  };
  return test::make_camera(model(), {640, 480});
}

/// A start of the model anywhere among its plausible parameters.
template <CameraModelType M>
internal::ParameterValues random_start(const Sampled& sampled, Random& random) {
  LensCentre centre = sampled.centre;
  const double scale = random.between(0.8, 1.25);
  for (double& focal : centre.focal) focal *= scale;
  internal::ParameterValues p{};
  M::initialise(sampled.samples, centre, random.below(M::kStarts), p.data());
  if constexpr (std::is_same_v<M, Ucm> || std::is_same_v<M, Eucm> || std::is_same_v<M, Ds>) p[4] = random.between(0.05, 0.95);
  if constexpr (std::is_same_v<M, Eucm>) p[5] = std::exp(random.between(-1.5, 1.5));
  const auto set_xi = [&](double& xi, double value) {
    for (const std::size_t i : {0U, 1U}) p[i] *= (1.0 + value) / (1.0 + xi);
    xi = value;
  };
  if constexpr (std::is_same_v<M, Ds>) set_xi(p[5], random.between(-0.8, 0.9));
  if constexpr (std::is_same_v<M, Mei>) set_xi(p[4], random.between(0.05, 4.0));
  return p;
}

template <CameraModelType M>
struct Reference {
  Intrinsics<M> model{};
  double rms_px = std::numeric_limits<double>::infinity();
};

/// The best that 20 starts lead to, if it projects all samples; infinitely bad if none does.
template <CameraModelType M>
Reference<M> reference_fit(const Sampled& sampled, Random& random) {
  constexpr int kStarts = 20;
  Reference<M> best;
  const internal::JetTarget<M> target;
  internal::Fitter fitter(target, sampled.samples, {});
  for (int i = 0; i < kStarts; ++i) {
    const std::optional<internal::FoundFit> fit = fitter.fit_from(random_start<M>(sampled, random));
    if (!fit || !fit->reaches_all) continue;
    Intrinsics<M> model;
    std::copy_n(fit->parameters.begin(), model.values.size(), model.values.begin());
    if (fit->rms_px < best.rms_px && validate(model).empty()) best = {model, fit->rms_px};
  }
  return best;
}

/// One fit next to its reference. False where no start of the reference leads anywhere.
template <CameraModelType M>
bool expect_no_worse_than_reference(const Camera& camera, const Sampled& sampled, Random& random) {
  const std::optional<internal::FittedModel> fitted = internal::fit_model(M::kId, sampled.samples, sampled.centre, {});
  if (fitted) {
    EXPECT_TRUE(std::isfinite(fitted->rms_px));
    EXPECT_TRUE(validate(fitted->model).empty());
  }
  const double reference = reference_fit<M>(sampled, random).rms_px;
  if (!std::isfinite(reference)) return false;
  constexpr double kNobodySees = 1e-4;  // px
  // A fit prefers to leave out a few rays to a camera that is useless for all of them.
  constexpr double kUseless = 4.0;
  EXPECT_TRUE(fitted && fitted->rms_px <= 1.02 * reference + kNobodySees &&
              (fitted->reaches_all || kUseless * fitted->rms_px < reference))
      << model_info(camera.model).id << " "
      << ::testing::PrintToString(
             std::vector<double>(parameter_values(camera.model).begin(), parameter_values(camera.model).end()))
      << " -> " << M::kId << ": " << (fitted ? fitted->rms_px : NAN) << " px, "
      << (fitted && fitted->reaches_all ? "all" : "not all") << ", reference " << reference;
  return true;
}

TEST(RandomCameras, NoFitIsWorseThanTwentyStarts) {
  Random random(21);
  const int count = how_many(25);
  int compared = 0;
  for (int i = 0; i < count;) {
    const Camera camera = plausible_camera(random);
    const Sampled sampled = samples_of(camera);
    if (sampled.samples.size() < 100) continue;
    SCOPED_TRACE(++i);
    ModelList::for_each([&]<CameraModelType M>() {
      // Nobody fits a skew: it is held, and the rest is a fit of the straight model.
      if constexpr (!kIsSkewed<M>) compared += expect_no_worse_than_reference<M>(camera, sampled, random) ? 1 : 0;
    });
  }
  std::printf("  %d cameras, %d fits compared\n", count, compared);
}

/// Over every pixel of the field of view; infinite where one is out of the model's reach.
double rms_over_pixels(const Camera& camera, const CameraModel& model, const FieldOfView& field_of_view) {
  const internal::Scorer scorer(camera.model, &model, nullptr, field_of_view, std::numbers::pi);
  const ErrorStatistics statistics = internal::score_every_pixel(scorer).statistics;
  return statistics.coverage.unrepresentable > 0.0 ? std::numeric_limits<double>::infinity() : statistics.error.rms;
}

/// The field of view's pixels: in blocks of 4 x 4 one place for all, next to the image's border and the lens's edge each of
/// them.
std::vector<Correspondence> dense_lattice(const CameraModel& source, const FieldOfView& field_of_view) {
  constexpr int kBlock = 4;
  const Lens lens(source);
  std::vector<Correspondence> lattice;
  const auto add = [&](double u, double v, double weight) {
    if (const std::optional<Ray> ray = field_of_view.ray(lens, {u, v})) lattice.push_back({*ray, {u, v}, weight});
  };
  const auto smooth = [&](int u, int v) {
    for (const int y : {v - kBlock, v + 2 * kBlock}) {
      for (const int x : {u - kBlock, u + 2 * kBlock}) {
        const bool in_image = x >= 0 && y >= 0 && x < field_of_view.size.width && y < field_of_view.size.height;
        if (!in_image || !field_of_view.ray(lens, {1.0 * x, 1.0 * y})) return false;
      }
    }
    return true;
  };
  for (int v = 0; v < field_of_view.size.height; v += kBlock) {
    for (int u = 0; u < field_of_view.size.width; u += kBlock) {
      if (smooth(u, v)) {
        add(u + 0.5 * (kBlock - 1), v + 0.5 * (kBlock - 1), kBlock * kBlock);
        continue;
      }
      for (int y = v; y < std::min(v + kBlock, field_of_view.size.height); ++y) {
        for (int x = u; x < std::min(u + kBlock, field_of_view.size.width); ++x) add(x, y, 1.0);
      }
    }
  }
  double total = 0.0;
  for (const Correspondence& s : lattice) total += s.weight;
  for (Correspondence& s : lattice) s.weight /= total;
  return lattice;
}

/// The best of 20 starts, fitted once more to the dense lattice.
template <CameraModelType M>
double reference_over_pixels(const Camera& camera, const FieldOfView& field_of_view, Random& random) {
  const Sampled sampled = samples_of(camera);
  const Reference<M> reference = reference_fit<M>(sampled, random);
  double best = rms_over_pixels(camera, reference.model, field_of_view);
  const auto finer = internal::fit_from(reference.model, dense_lattice(camera.model, field_of_view), {});
  if (finer) best = std::min(best, rms_over_pixels(camera, finer->model, field_of_view));
  return std::isfinite(reference.rms_px) ? best : reference.rms_px;
}

/// One conversion, evaluated by every pixel, next to its reference.
template <CameraModelType M>
bool expect_no_worse_over_pixels(const Camera& camera, Random& random) {
  ConvertOptions options;
  options.model = M::kId;
  options.bound = false;
  options.every_pixel = true;
  Diagnostics diagnostics;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, {}, diagnostics);
  const std::optional<Conversion> conversion = convert(camera, options, diagnostics);
  if (!field_of_view || !conversion) return false;
  const double reference = reference_over_pixels<M>(camera, *field_of_view, random);
  // Nobody sees it. What was fitted to a cone leaves out the worst pixels.
  constexpr double kNobodySees = 1e-4;
  const double rms = conversion->report.statistics.error.rms;
  EXPECT_LE(rms, 1.02 * reference + kNobodySees)
      << model_info(camera.model).id << " "
      << ::testing::PrintToString(
             std::vector<double>(parameter_values(camera.model).begin(), parameter_values(camera.model).end()))
      << " -> " << M::kId << ", scored to " << conversion->report.scored_to_deg << " of "
      << field_of_view->max_angle_rad / test::kRadians << " deg";
  return std::isfinite(reference);
}

// The samples of a fit may hide what the image shows: here every pixel counts, and the reference is the best over the image.
TEST(RandomCameras, NoConversionIsWorseOverTheImage) {
  Random random(24);
  const int count = how_many(10);
  int compared = 0;
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE(i);
    const Camera plausible = plausible_camera(random);
    ModelList::for_each([&]<CameraModelType M>() {
      if constexpr (!kIsSkewed<M>) compared += expect_no_worse_over_pixels<M>(plausible, random) ? 1 : 0;
    });
    compared += expect_no_worse_over_pixels<Rational>(test::wide_camera(random), random) ? 1 : 0;
  }
  std::printf("  %d cameras, %d conversions compared\n", 2 * count, compared);
}

// Lenses of 71 to 88 degrees: those of ds end inside the image, the second in its corners. The others' first samples agree with
// the image by chance.
TEST(RandomCameras, RationalOfHardLensesOverTheImage) {
  Random random(25);
  for (const CameraModel& model :
       std::vector<CameraModel>{Intrinsics<Ds>{{133.5677629389186, 135.23867440987095, 342.1421671569585, 264.34053674938787,
                                                0.7025675221450794, -0.5568606152385887}},
                                Intrinsics<Ds>{{266.02288823311704, 273.03060888097923, 326.72983457755475, 230.4811594450797,
                                                0.7584994149379001, -0.3727726401776721}},
                                Intrinsics<Ds>{{207.68323992859888, 213.3849741826465, 298.65300483251326, 264.32952212044296,
                                                0.7978449645653399, -0.4398794999643145}},
                                Intrinsics<Ds>{{210.04773885555102, 211.11391090851015, 292.40714506141524, 261.06849565560304,
                                                0.780260987949946, -0.5916783850886771}}}) {
    expect_no_worse_over_pixels<Rational>(test::make_camera(model, {640, 480}), random);
  }
}

// Of the 1,000 those that taught the fit something: two minima between two of mei's shapes, one at the largest xi that can be;
// a start of rational's that looks hopeless and is not; a fold inside the lens.
TEST(RandomCameras, HardOnes) {
  Random random(22);
  const auto expect = [&random]<CameraModelType M>(M /*target*/, const CameraModel& model) {
    const Camera camera = test::make_camera(model, {640, 480});
    EXPECT_TRUE(expect_no_worse_than_reference<M>(camera, samples_of(camera), random));
  };
  expect(Mei(),
         Intrinsics<Mei>{{513.779, 503.857, 330.714, 253.181, 1.65342, 0.159617, 0.00873686, -0.000964784, 9.30686e-06}});
  expect(Mei(), Intrinsics<Mei>{{555.988, 552.554, 310.324, 243.88, 1.29732, 0.0437729, -0.0994998, 0.000990423, 0.000289083}});
  expect(Mei(), Intrinsics<Ds>{{138.798, 140.695, 319.03, 212.314, 0.792803, -0.273195}});
  expect(Rational(), Intrinsics<Woodscape>{{262.247, 25.5039, -2.59828, 0.0, 1.00278, 299.581, 224.944}});
  expect(Rational(), Intrinsics<Woodscape>{{525.037, 21.2609, -2.79847, 0.0, 0.991137, 347.029, 228.315}});
  expect(Ocamcalib(),
         Intrinsics<Radtan>{{274.814, 271.434, 335.893, 232.96, -0.1291, -0.0054149, -0.000568722, 1.0277e-05, 0.0108489}});
}

// The whole of a conversion: no lens and no target leads to a number that is none, or to shares of the image that do not add
// up.
TEST(RandomCameras, ConversionsHoldTogether) {
  Random random(23);
  const int count = how_many(25);
  int conversions = 0;
  for (int i = 0; i < count; ++i) {
    const Camera camera = plausible_camera(random);
    for (const ModelInfo& target : all_models()) {
      ConvertOptions options;
      options.model = target.id;
      options.bound = false;
      Diagnostics diagnostics;
      const std::optional<Conversion> conversion = convert(camera, options, diagnostics);
      if (!conversion) {
        EXPECT_TRUE(diagnostics.has_errors());
        continue;
      }
      ++conversions;
      EXPECT_TRUE(validate(conversion->camera.model).empty());
      const auto& [coverage, error] = std::tie(conversion->report.statistics.coverage, conversion->report.statistics.error);
      EXPECT_NEAR(coverage.scored + coverage.outside_lens + coverage.unrepresentable, 1.0, 1e-9);
      for (const double number : {error.rms, error.mean, error.p50, error.p95, error.p99, error.max})
        EXPECT_TRUE(number >= 0.0 && std::isfinite(number)) << target.id;
    }
  }
  std::printf("  %d cameras, %d conversions\n", count, conversions);
}

}  // namespace
}  // namespace fca
