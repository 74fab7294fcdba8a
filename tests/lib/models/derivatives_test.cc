// SPDX-License-Identifier: BSD-3-Clause
// What models offer to fits besides their formula is the formula: derivatives by hand against automatic ones, and linear terms.
#include "model_test_support.h"

#include <fca/convert/fit_target.h>

#include <ceres/jet.h>

namespace fca::test {
namespace {

template <CameraModelType M>
void expect_derivatives_of(const TestCamera<M>& camera, const Ray& ray) {
  constexpr std::size_t kCount = kParameterCount<M>;
  using Jet = ceres::Jet<double, int{kCount}>;
  std::array<Jet, kCount> parameters;
  for (std::size_t i = 0; i < kCount; ++i) parameters[i] = Jet(camera.p()[i], static_cast<int>(i));
  const Jet jet_ray[3] = {Jet(ray[0]), Jet(ray[1]), Jet(ray[2])};
  Jet expected[2];
  Pixel pixel{};
  double derivatives[2][kCount] = {};
  const bool has_pixel = M::formula(parameters.data(), jet_ray, expected);
  ASSERT_EQ(M::formula_and_derivatives(camera.p(), ray.data(), pixel.data(), derivatives[0], derivatives[1]), has_pixel);
  if (!has_pixel) return;
  const std::array<double, 2> centre = M::principal_point(camera.p());
  for (const std::size_t axis : {0U, 1U}) {
    const double size = 1.0 + std::abs(expected[axis].a - centre[axis]);
    EXPECT_NEAR(pixel[axis], expected[axis].a, 1e-12 * (size + std::abs(centre[axis])));
    for (std::size_t i = 0; i < kCount; ++i) {
      const double derivative = expected[axis].v[static_cast<int>(i)];
      const double largest = std::hypot(expected[0].v[static_cast<int>(i)], expected[1].v[static_cast<int>(i)]);
      EXPECT_NEAR(derivatives[axis][i], derivative, 1e-9 * (largest + 1.0)) << M::kParameters[i].name << " axis " << axis;
    }
  }
}

TEST(Derivatives, AgreeWithAutomaticDifferentiation) {
  int models = 0;
  for_each_model([&]<CameraModelType M>() {
    if constexpr (internal::HasDerivatives<M>) {
      ++models;
      for (const TestCamera<M>& camera : cameras_and_neighbours_of<M>(5)) {
        SCOPED_TRACE(camera.name);
        for (const double share : {0.0, 1e-6, 0.01, 0.2, 0.5, 0.8, 0.95}) {
          for (const double azimuth : some_azimuths()) {
            expect_derivatives_of<M>(camera, ray_at(share * M::max_angle(camera.p()), azimuth));
          }
        }
      }
    }
  });
  EXPECT_GE(models, 8);
}

TEST(Terms, MakeTheModelOfTheirCoefficients) {
  int models = 0;
  for_each_model([&]<CameraModelType M>() {
    const internal::FitTargetOf<M> target;
    if (target.terms() == 0) return;
    ++models;
    constexpr double kNoShape = 0.0;
    std::vector<double> shapes(target.shapes().begin(), target.shapes().end());
    if (shapes.empty()) shapes.push_back(kNoShape);
    for (const double shape : shapes) {
      const std::array<double, internal::kMostTerms> coefficients = {300.0, -31.0, 12.0, 0.2, -0.1, 3.0};
      constexpr double kAspect = 1.01;
      constexpr Pixel kPoint = {320.0, 241.0};
      internal::ParameterValues p{};
      target.from_terms(shape, coefficients.data(), kAspect, kPoint, p.data());
      for (const double angle : {0.0, 0.01, 0.4, 0.8, 1.2, 1.9}) {
        for (const double azimuth : some_azimuths()) {
          const Ray ray = ray_at(angle, azimuth);
          double along_u[internal::kMostTerms];
          double along_v[internal::kMostTerms];
          Pixel pixel{};
          const bool has_terms = target.terms(shape, ray.data(), along_u, along_v);
          ASSERT_EQ(has_terms, M::formula(p.data(), ray.data(), pixel.data())) << M::kId << " " << shape;
          if (!has_terms) continue;
          double u = kPoint[0];
          double v = kPoint[1];
          for (std::size_t i = 0; i < target.terms(); ++i) {
            u += coefficients[i] * along_u[i];
            v += kAspect * coefficients[i] * along_v[i];
          }
          EXPECT_NEAR(u, pixel[0], 1e-11 * (1.0 + std::abs(u)));
          EXPECT_NEAR(v, pixel[1], 1e-11 * (1.0 + std::abs(v)));
        }
      }
    }
  });
  EXPECT_EQ(models, 6);
}

}  // namespace
}  // namespace fca::test
