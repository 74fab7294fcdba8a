// SPDX-License-Identifier: BSD-3-Clause
// The linear start of a fit: what every model promises, and what those that are linear find exactly.
#include "model_test_support.h"

#include <fca/diagnostics.h>

namespace fca::test {
namespace {

/// Exact samples of a camera, all azimuths, evenly spaced angles up to `last`.
template <CameraModelType M>
std::vector<Correspondence> samples_of(const TestCamera<M>& camera, double last) {
  std::vector<Correspondence> samples;
  constexpr int kAngles = 20;
  for (int i = 0; i <= kAngles; ++i) {
    for (const double azimuth : some_azimuths()) {
      Correspondence sample;
      sample.ray = ray_at(last * i / kAngles, azimuth);
      EXPECT_TRUE(M::project(camera.p(), sample.ray.data(), sample.pixel.data()));
      samples.push_back(sample);
    }
  }
  for (Correspondence& sample : samples) sample.weight = 1.0 / static_cast<double>(samples.size());
  return samples;
}

/// What a fit gives to initialise(): nothing of the lens.
template <CameraModelType M>
LensCentre centre_of(const TestCamera<M>& source) {
  return {M::central_focal_lengths(source.p()), M::principal_point(source.p())};
}

template <CameraModelType M>
void expect_found_exactly() {
  for (const TestCamera<M>& camera : cameras_of<M>()) {
    SCOPED_TRACE(std::string(M::kId) + " " + camera.name);
    const double last = std::min(1.2, 0.8 * M::max_angle(camera.p()));
    Intrinsics<M> found;
    M::initialise(samples_of(camera, last), centre_of(camera), 0, found.values.data());
    for (std::size_t i = 0; i < kParameterCount<M>; ++i) {
      const double expected = std::clamp(camera.p()[i], M::kParameters[i].lower, M::kParameters[i].upper);
      EXPECT_NEAR(found.values[i], expected, 1e-6 * (1.0 + std::abs(expected))) << M::kParameters[i].name;
    }
  }
}

TEST(Initialise, LinearModelsFindTheirOwnParameters) {
  expect_found_exactly<Pinhole>();
  expect_found_exactly<Kb4>();
  expect_found_exactly<Radtan>();
  expect_found_exactly<Woodscape>();
}

/// Where parameters are not unique (N = D) or held, the pixels are what counts.
template <CameraModelType M>
void expect_pixels_found(double largest_angle, double tolerance) {
  for (const TestCamera<M>& camera : cameras_of<M>()) {
    SCOPED_TRACE(std::string(M::kId) + " " + camera.name);
    const double last = std::min(largest_angle, 0.8 * M::max_angle(camera.p()));
    const std::vector<Correspondence> samples = samples_of(camera, last);
    Intrinsics<M> found;
    M::initialise(samples, centre_of(camera), 0, found.values.data());
    for (const Correspondence& s : samples) {
      Pixel pixel;
      ASSERT_TRUE(M::project(found.values.data(), s.ray.data(), pixel.data()));
      EXPECT_LE(std::hypot(pixel[0] - s.pixel[0], pixel[1] - s.pixel[1]), tolerance);
    }
  }
}

// Numerator and denominator nearly cancel: normal equations know their coefficients to a fraction of a pixel, no better.
TEST(Initialise, RationalStartsNearItsOwnPixels) { expect_pixels_found<Rational>(0.9, 0.5); }

TEST(Initialise, OcamcalibOfDegree4FindsItsOwnPolynomial) {
  for (TestCamera<Ocamcalib> camera : cameras_of<Ocamcalib>()) {
    SCOPED_TRACE(camera.name);
    for (const ParameterId not_found : ParameterIds{"d", "e", "a1", "a5", "a6", "a7", "a8"}) {
      CameraModel model = camera.intrinsics;
      set_parameter(model, not_found, 0.0);
      camera.intrinsics = std::get<Intrinsics<Ocamcalib>>(model);
    }
    const double last = std::min(1.9, 0.8 * Ocamcalib::max_angle(camera.p()));
    Intrinsics<Ocamcalib> found;
    Ocamcalib::initialise(samples_of(camera, last), centre_of(camera), 0, found.values.data());
    for (std::size_t i = 0; i < found.values.size(); ++i) {
      const double expected = camera.p()[i];
      // Below a millionth of |a0| at a radius of |a0|, a coefficient is noise.
      const double noise = 1e-6 * std::pow(std::abs(camera.p()[5]), i > 5 ? 6.0 - static_cast<double>(i) : 1.0);
      EXPECT_NEAR(found.values[i], expected, 1e-6 * std::abs(expected) + noise) << Ocamcalib::kParameters[i].name;
    }
  }
}

TEST(Initialise, UcmFindsAlphaInsideItsClamp) {
  for (TestCamera<Ucm> camera : cameras_of<Ucm>()) {
    const double alpha = std::clamp(camera.p()[4], 0.05, 0.95);
    camera.intrinsics.values[4] = alpha;
    Intrinsics<Ucm> found;
    Ucm::initialise(samples_of(camera, 0.8 * Ucm::max_angle(camera.p())), centre_of(camera), 0, found.values.data());
    EXPECT_NEAR(found.values[4], alpha, 1e-12) << camera.name;
  }
}

// Every start of every model is a camera with the given centre and central focal length, from samples of a kb4 lens.
TEST(Initialise, StartsAreCamerasWithTheGivenCentre) {
  for (const TestCamera<Kb4>& lens : cameras_of<Kb4>()) {
    const std::vector<Correspondence> samples = samples_of(lens, std::min(1.2, 0.9 * Kb4::max_angle(lens.p())));
    for_each_model([&]<CameraModelType M>() {
      for (int start = 0; start < M::kStarts; ++start) {
        const LensCentre centre = centre_of(lens);
        Intrinsics<M> found;
        M::initialise(samples, centre, start, found.values.data());
        EXPECT_TRUE(validate(found).empty()) << lens.name << ": " << id_of(validate(found)[0]);
        if constexpr (requires { M::kStartsFindCentre; }) {
          // What it finds does not depend on the focal length that it is given.
          LensCentre longer = centre;
          for (double& focal : longer.focal) focal *= 1.25;
          Intrinsics<M> again;
          M::initialise(samples, longer, start, again.values.data());
          for (const std::size_t axis : {0U, 1U}) {
            EXPECT_NEAR(central_focal_lengths(found)[axis], central_focal_lengths(again)[axis], 1e-3 * centre.focal[axis]);
            EXPECT_NEAR(principal_point(found)[axis], principal_point(again)[axis], 1e-3 * centre.focal[axis]);
          }
        } else {
          for (const std::size_t axis : {0U, 1U}) {
            EXPECT_NEAR(central_focal_lengths(found)[axis], centre.focal[axis], 1e-9 * centre.focal[axis]) << lens.name;
          }
          EXPECT_EQ(principal_point(found), centre.point);
        }
      }
    });
  }
}

// Samples that say nothing about the lens still give a camera: none at all, only the axis, one ray often.
TEST(Initialise, PoorSamplesGiveACamera) {
  const Correspondence axis{{0, 0, 1}, {320, 240}, 1.0};
  const Correspondence side{{1, 0, 0}, {900, 240}, 1.0};
  const Correspondence behind{{0.6, 0, -0.8}, {1200, 240}, 1.0};
  for (const std::vector<Correspondence>& samples :
       {std::vector<Correspondence>{}, {axis}, {axis, axis, axis}, {side}, {side, side}, {axis, behind}}) {
    for_each_model([&]<CameraModelType M>() {
      for (int start = 0; start < M::kStarts; ++start) {
        Intrinsics<M> found;
        M::initialise(samples, {{300, 300}, {320, 240}}, start, found.values.data());
        EXPECT_TRUE(validate(found).empty()) << samples.size() << ": " << id_of(validate(found)[0]);
      }
    });
  }
}

}  // namespace
}  // namespace fca::test
