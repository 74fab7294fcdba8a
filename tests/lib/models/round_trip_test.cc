// SPDX-License-Identifier: BSD-3-Clause
// project and unproject undo each other, for every model of the list and every camera of testdata/models (and neighbours of
// it).
#include "model_test_support.h"

namespace fca::test {
namespace {

constexpr int kNeighbours = 5;

// Every pixel of a lattice over the image and its surroundings that has a ray goes back to itself within 1e-9 px.
TEST(RoundTrip, PixelToRayToPixel) {
  for_each_model([]<CameraModelType M>() {
    double worst = 0.0;
    int count = 0;
    for (const TestCamera<M>& camera : cameras_and_neighbours_of<M>(kNeighbours)) {
      SCOPED_TRACE(camera.name);
      constexpr int kSteps = 40;
      for (int i = -kSteps; i <= 2 * kSteps; ++i) {
        for (int j = -kSteps; j <= 2 * kSteps; ++j) {
          const Pixel pixel = {camera.width * i / double{kSteps}, camera.height * j / double{kSteps}};
          Ray ray;
          if (!M::unproject(camera.p(), pixel.data(), ray.data())) continue;
          ++count;
          EXPECT_NEAR(std::hypot(ray[0], ray[1], ray[2]), 1.0, 1e-15);
          Pixel back;
          ASSERT_TRUE(M::project(camera.p(), ray.data(), back.data())) << pixel[0] << ' ' << pixel[1];
          const double error = std::hypot(back[0] - pixel[0], back[1] - pixel[1]);
          // At the end of OCamCalib's domain the radius grows ever faster with the angle: the rounding of the ray shows.
          double tolerance = 1e-9;
          if (error > tolerance) {
            const auto lens = radius_and_derivative<M>(camera.p(), std::atan2(std::hypot(ray[0], ray[1]), ray[2]), 0.0);
            ASSERT_TRUE(lens);
            tolerance +=
                8.0 * std::numeric_limits<double>::epsilon() * M::central_focal_lengths(camera.p())[0] * lens->derivative;
          }
          ASSERT_LE(error, tolerance) << pixel[0] << ' ' << pixel[1];
          worst = std::max(worst, error);
        }
      }
    }
    EXPECT_GT(count, 1000);
    ::testing::Test::RecordProperty(std::string(M::kId) + "_worst_px", std::to_string(worst));
    std::printf("  %-8s worst pixel error %.2g px over %d pixels\n", M::kId.data(), worst, count);
  });
}

// Every ray of the domain comes back parallel to itself within 1e-12 + 8 eps r / (dr/dangle) rad: r and its derivative are
// measured on the normalised plane; their ratio is in radians, so that the second term is the rounding of the pixel itself. The
// last microradian before the domain's end is left out: there a rounded pixel may lie outside the image of the domain.
TEST(RoundTrip, RayToPixelToRay) {
  for_each_model([]<CameraModelType M>() {
    double worst_share = 0.0;
    double worst = 0.0;
    double widest = 0.0;
    for (const TestCamera<M>& camera : cameras_and_neighbours_of<M>(kNeighbours)) {
      SCOPED_TRACE(camera.name);
      constexpr double kMargin = 1e-6;
      for (const double angle : angles_up_to(M::max_angle(camera.p()) - kMargin)) {
        for (const double azimuth : some_azimuths()) {
          for (const double length : {1e-3, 1.0, 1e3}) {
            const Ray ray = ray_at(angle, azimuth, length);
            Pixel pixel;
            ASSERT_TRUE(M::project(camera.p(), ray.data(), pixel.data())) << angle << ' ' << azimuth;
            Ray back;
            ASSERT_TRUE(M::unproject(camera.p(), pixel.data(), back.data())) << angle << ' ' << azimuth;
            const auto lens = radius_and_derivative<M>(camera.p(), std::max(angle, 1e-6), azimuth);
            ASSERT_TRUE(lens);
            const double tolerance =
                1e-12 + 8.0 * std::numeric_limits<double>::epsilon() * lens->radius / std::abs(lens->derivative);
            const double error = angle_between(ray, back);
            EXPECT_LE(error, tolerance) << "angle " << angle << " azimuth " << azimuth << " length " << length;
            worst_share = std::max(worst_share, error / tolerance);
            if (lens->radius < 10.0 * lens->derivative) worst = std::max(worst, error);
            widest = std::max(widest, angle);
          }
        }
      }
    }
    std::printf("  %-8s worst angle error %.2g rad, %.2g of its tolerance; widest angle %.1f deg\n", M::kId.data(), worst,
                worst_share, widest * 180.0 / std::numbers::pi);
  });
}

// The pixel does not depend on the length of the ray, down to lengths whose square underflows.
TEST(RoundTrip, PixelDoesNotDependOnLength) {
  for_each_model([]<CameraModelType M>() {
    for (const TestCamera<M>& camera : cameras_of<M>()) {
      SCOPED_TRACE(camera.name);
      const CameraModel model = camera.intrinsics;
      const double last = 0.9 * M::max_angle(camera.p());
      for (const double angle : {0.0, 0.3 * last, last}) {
        const auto expected = project(model, ray_at(angle, 0.6));
        ASSERT_TRUE(expected);
        for (const double length : {1e-300, 1e-200, 1e-100, 1e-3, 1e3, 1e100, 1e200, 1e300}) {
          const auto pixel = project(model, ray_at(angle, 0.6, length));
          ASSERT_TRUE(pixel) << length;
          const double tolerance = 1e-12 * (1.0 + std::hypot((*expected)[0], (*expected)[1]));
          EXPECT_LE(std::hypot((*pixel)[0] - (*expected)[0], (*pixel)[1] - (*expected)[1]), tolerance)
              << angle << ' ' << length;
        }
      }
    }
  });
}

// A principal point that is a pixel, and the ray on the axis, belong to each other.
TEST(RoundTrip, PrincipalPointIsTheAxis) {
  for_each_model([]<CameraModelType M>() {
    for (const TestCamera<M>& camera : cameras_of<M>()) {
      SCOPED_TRACE(camera.name);
      const Pixel centre = M::principal_point(camera.p());
      Ray ray;
      ASSERT_TRUE(M::unproject(camera.p(), centre.data(), ray.data()));
      EXPECT_EQ(ray, (Ray{0.0, 0.0, 1.0}));
      const Ray axis = {0.0, 0.0, 2.5};
      Pixel pixel;
      ASSERT_TRUE(M::project(camera.p(), axis.data(), pixel.data()));
      EXPECT_EQ(pixel, centre);
      const Ray behind = {0.0, 0.0, -1.0};
      EXPECT_FALSE(M::project(camera.p(), behind.data(), pixel.data()));
    }
  });
}

}  // namespace
}  // namespace fca::test
