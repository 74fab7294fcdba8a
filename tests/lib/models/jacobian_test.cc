// SPDX-License-Identifier: BSD-3-Clause
// Automatic derivatives of project() by parameters and ray against central differences, for every model of the list.
#include "model_test_support.h"

namespace fca::test {
namespace {

/// Central differences with steps h, h/2, h/4, extrapolated to error O(h^6): d pixel / d input by one entry of (parameters,
/// ray).
double step_of(double input) { return 4e-5 * (input == 0.0 ? 1.0 : std::abs(input)); }

template <CameraModelType M>
std::optional<Pixel> difference(const std::array<double, kParameterCount<M> + 3>& inputs, std::size_t index) {
  const double h = step_of(inputs[index]);
  const auto central = [&](double step) -> std::optional<Pixel> {
    Pixel pixels[2];
    for (const int side : {0, 1}) {
      auto moved = inputs;
      moved[index] += side == 0 ? -step : step;
      if (!M::project(moved.data(), moved.data() + kParameterCount<M>, pixels[side].data())) return std::nullopt;
    }
    return Pixel{(pixels[1][0] - pixels[0][0]) / (2 * step), (pixels[1][1] - pixels[0][1]) / (2 * step)};
  };
  const auto a = central(h);
  const auto b = central(h / 2);
  const auto c = central(h / 4);
  if (!a || !b || !c) return std::nullopt;
  const auto extrapolated = [&](int i) {
    const auto row = static_cast<std::size_t>(i);
    return ((*a)[row] - 20 * (*b)[row] + 64 * (*c)[row]) / 45;
  };
  return Pixel{extrapolated(0), extrapolated(1)};
}

TEST(Jacobian, AgreesWithDifferences) {
  for_each_model([]<CameraModelType M>() {
    constexpr std::size_t kInputs = kParameterCount<M> + 3;
    using Jet = ceres::Jet<double, int{kInputs}>;
    int compared = 0;
    for (const TestCamera<M>& camera : cameras_of<M>()) {
      const double end = M::max_angle(camera.p());
      for (const double share : {0.0, 0.01, 0.2, 0.5, 0.8}) {
        for (const double azimuth : some_azimuths()) {
          const Ray ray = ray_at(share * end, azimuth, 1.3);
          std::array<double, kInputs> inputs;
          std::array<Jet, kInputs> jets;
          for (std::size_t i = 0; i < kInputs; ++i) {
            inputs[i] = i < kParameterCount<M> ? camera.p()[i] : ray[i - kParameterCount<M>];
            jets[i] = Jet(inputs[i], static_cast<int>(i));
          }
          Jet pixel[2];
          ASSERT_TRUE(M::project(jets.data(), jets.data() + kParameterCount<M>, pixel));
          for (std::size_t i = 0; i < kInputs; ++i) {
            const bool is_parameter = i < kParameterCount<M>;
            // A coefficient of a power of pixels has no natural step at 0.
            if (is_parameter && inputs[i] == 0.0 && M::kParameters[i].unit.starts_with("1/px")) continue;
            SCOPED_TRACE(::testing::Message() << camera.name << " angle " << share * end << " azimuth " << azimuth << " d/d"
                                              << (is_parameter ? M::kParameters[i].name : "ray"));
            const auto index = static_cast<int>(i);
            for (const Jet& j : pixel) ASSERT_TRUE(std::isfinite(j.v[index]));
            const auto expected = difference<M>(inputs, i);
            if (!expected) continue;  // a step out of the domain or off the parameter's range
            ++compared;
            // Relative 1e-6, and what the rounding of the pixels adds to the difference.
            const double rounding = 1e-15 * std::hypot(pixel[0].a, pixel[1].a) / step_of(inputs[i]);
            const double tolerance = 1e-6 * std::hypot((*expected)[0], (*expected)[1]) + 4.0 * rounding;
            EXPECT_NEAR(pixel[0].v[index], (*expected)[0], tolerance);
            EXPECT_NEAR(pixel[1].v[index], (*expected)[1], tolerance);
          }
        }
      }
    }
    EXPECT_GT(compared, 500);
  });
}

// On the axis r has no derivative, but the pixel has: by x and y the central focal length, by everything else of the lens 0.
TEST(Jacobian, OnTheAxis) {
  for_each_model([]<CameraModelType M>() {
    constexpr std::size_t kInputs = kParameterCount<M> + 3;
    using Jet = ceres::Jet<double, int{kInputs}>;
    for (const TestCamera<M>& camera : cameras_of<M>()) {
      SCOPED_TRACE(camera.name);
      std::array<Jet, kInputs> jets;
      for (std::size_t i = 0; i < kInputs; ++i)
        jets[i] = Jet(i < kParameterCount<M> ? camera.p()[i] : 0.0, static_cast<int>(i));
      jets[kInputs - 1].a = 2.0;
      Jet pixel[2];
      ASSERT_TRUE(M::project(jets.data(), jets.data() + kParameterCount<M>, pixel));
      const std::array<double, 2> focal = M::central_focal_lengths(camera.p());
      for (std::size_t i = 0; i < kInputs; ++i) {
        const auto index = static_cast<int>(i);
        const bool of_centre = i < kParameterCount<M> && M::kParameters[i].group == ParameterGroup::kPrincipalPoint;
        const double du = i == kParameterCount<M> ? focal[0] / 2.0 : (of_centre && M::kParameters[i].name == "cx" ? 1.0 : 0.0);
        const double dv =
            i == kParameterCount<M> + 1 ? focal[1] / 2.0 : (of_centre && M::kParameters[i].name == "cy" ? 1.0 : 0.0);
        // Shear mixes the axes: ocamcalib counts its radius along u, and u has e; ftheta counts it along v, and u has d.
        const bool along_v = i == kParameterCount<M> + 1;
        const bool counts_along_v = M::kId == "ftheta";
        const double radius = focal[counts_along_v ? 1 : 0] / 2.0;
        const double of_u = parameter(camera.intrinsics, counts_along_v ? "d" : "e").value_or(0.0);
        const double of_v = parameter(camera.intrinsics, counts_along_v ? "e" : "d").value_or(0.0);
        double shear_u = along_v ? radius * of_u : 0.0;
        double shear_v = i == kParameterCount<M> ? radius * of_v : 0.0;
        // So does a tilted image plane.
        const double tilt_x = std::tan(parameter(camera.intrinsics, "tau_x").value_or(0.0));
        const double tilt_y = std::tan(parameter(camera.intrinsics, "tau_y").value_or(0.0));
        if (i == kParameterCount<M>) shear_v -= parameter(camera.intrinsics, "fy").value_or(0.0) / 2.0 * tilt_x * tilt_y;
        // So does a skew, of what moves along v.
        const double skew = parameter(camera.intrinsics, "skew").value_or(0.0);
        if (i >= kParameterCount<M> && skew != 0.0)
          shear_u += skew * (dv + shear_v) / parameter(camera.intrinsics, "fy").value();
        EXPECT_NEAR(pixel[0].v[index], du + shear_u, 1e-12 * (1.0 + focal[0])) << i;
        EXPECT_NEAR(pixel[1].v[index], dv + shear_v, 1e-12 * (1.0 + focal[1])) << i;
      }
    }
  });
}

}  // namespace
}  // namespace fca::test
