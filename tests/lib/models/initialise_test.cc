// SPDX-License-Identifier: BSD-3-Clause
// The linear start of a fit: what every model promises, and what those that are linear find exactly.
#include "model_test_support.h"

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

/// What a fit gives to initialise(): the centre and the central focal lengths of the source, nothing of the lens.
template <CameraModelType M>
Intrinsics<M> given_by_the_fit(const TestCamera<M>& source) {
  Intrinsics<M> start;
  start.values[0] = M::central_focal_length(source.p());
  start.values[1] = start.values[0] * source.p()[1] / source.p()[0];
  start.values[2] = source.p()[2];
  start.values[3] = source.p()[3];
  return start;
}

template <CameraModelType M>
void expect_found_exactly() {
  for (const TestCamera<M>& camera : cameras_of<M>()) {
    SCOPED_TRACE(std::string(M::kId) + " " + camera.name);
    const double last = std::min(1.2, 0.8 * M::max_angle(camera.p()));
    Intrinsics<M> found = given_by_the_fit(camera);
    M::initialise(samples_of(camera, last), 0, found.values.data());
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
}

TEST(Initialise, UcmFindsAlphaInsideItsClamp) {
  for (TestCamera<Ucm> camera : cameras_of<Ucm>()) {
    const double alpha = std::clamp(camera.p()[4], 0.05, 0.95);
    camera.intrinsics.values[4] = alpha;
    Intrinsics<Ucm> found = given_by_the_fit(camera);
    Ucm::initialise(samples_of(camera, 0.8 * Ucm::max_angle(camera.p())), 0, found.values.data());
    EXPECT_NEAR(found.values[4], alpha, 1e-12) << camera.name;
  }
}

// Every start of every model is a camera with the given centre and central focal length, from samples of a kb4 lens.
TEST(Initialise, StartsAreCamerasWithTheGivenCentre) {
  for (const TestCamera<Kb4>& lens : cameras_of<Kb4>()) {
    const std::vector<Correspondence> samples = samples_of(lens, std::min(1.2, 0.9 * Kb4::max_angle(lens.p())));
    for_each_model([&]<CameraModelType M>() {
      for (int start = 0; start < M::kStarts; ++start) {
        Intrinsics<M> found;
        std::copy_n(lens.p(), 4, found.values.begin());
        M::initialise(samples, start, found.values.data());
        EXPECT_TRUE(validate(found).empty()) << lens.name << ": " << validate(found)[0];
        EXPECT_NEAR(M::central_focal_length(found.values.data()), lens.p()[0], 1e-9 * lens.p()[0]) << lens.name;
        EXPECT_EQ(found.values[2], lens.p()[2]);
        EXPECT_EQ(found.values[3], lens.p()[3]);
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
        found.values[0] = found.values[1] = 300.0;
        found.values[2] = 320.0;
        found.values[3] = 240.0;
        M::initialise(samples, start, found.values.data());
        EXPECT_TRUE(validate(found).empty()) << samples.size() << ": " << validate(found)[0];
      }
    });
  }
}

}  // namespace
}  // namespace fca::test
