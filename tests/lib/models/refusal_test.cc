// SPDX-License-Identifier: BSD-3-Clause
// Pixels and rays without an answer: project and unproject say no, quickly, and never return a number that is not one.
#include "model_test_support.h"

#include <chrono>

namespace fca::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
const std::vector<double> kExtremes = {0.0,    -0.0,  1.0,   -1.0,   1e-308, 1e5,   -1e5, 1e12,
                                       -1e100, 1e100, 1e200, -1e308, 1e308,  -kInf, kInf, kNaN};

bool finite(double a, double b) { return std::isfinite(a) && std::isfinite(b); }
bool is_unit(const Ray& ray) { return std::abs(std::hypot(ray[0], ray[1], ray[2]) - 1.0) < 1e-14; }

TEST(Refusal, AnswersAreNumbersWhateverThePixel) {
  for_each_model([]<CameraModelType M>() {
    for (const TestCamera<M>& camera : cameras_and_neighbours_of<M>(2)) {
      SCOPED_TRACE(camera.name);
      for (const double u : kExtremes) {
        for (const double v : kExtremes) {
          const auto ray = unproject(camera.intrinsics, {u, v});
          SCOPED_TRACE(::testing::Message() << u << ' ' << v);
          EXPECT_TRUE(finite(u, v) || !ray);
          EXPECT_TRUE(!ray || is_unit(*ray));
        }
      }
    }
  });
}

// A pixel so far off that its square overflows is nobody's, least of all the axis'.
TEST(Refusal, NoPixelFarAwayIsOnTheAxis) {
  for_each_model([]<CameraModelType M>() {
    for (const TestCamera<M>& camera : cameras_and_neighbours_of<M>(2)) {
      for (const double u : {1e150, 1e160, 1e200, 1e300}) {
        const auto ray = unproject(camera.intrinsics, {u, 0.0});
        EXPECT_TRUE(!ray || angle_from_axis(*ray) > 0.1) << camera.name << " " << u;
      }
    }
  });
}

TEST(Refusal, AnswersAreNumbersWhateverTheRay) {
  for_each_model([]<CameraModelType M>() {
    for (const TestCamera<M>& camera : cameras_of<M>()) {
      SCOPED_TRACE(camera.name);
      const CameraModel model = camera.intrinsics;
      EXPECT_FALSE(project(model, {0.0, 0.0, 0.0}));
      for (const double x : kExtremes) {
        for (const double y : kExtremes) {
          for (const double z : kExtremes) {
            const auto pixel = project(model, {x, y, z});
            SCOPED_TRACE(::testing::Message() << x << ' ' << y << ' ' << z);
            EXPECT_TRUE((finite(x, y) && std::isfinite(z)) || !pixel);
            EXPECT_TRUE(!pixel || finite((*pixel)[0], (*pixel)[1]));
          }
        }
      }
    }
  });
}

// One parameter at a time is not a number, infinite or huge: any answer is a number, and it comes at once.
TEST(Refusal, AnswersAreNumbersWhateverTheParameters) {
  const auto start = std::chrono::steady_clock::now();
  for_each_model([]<CameraModelType M>() {
    for (const TestCamera<M>& camera : cameras_of<M>()) {
      for (std::size_t i = 0; i < kParameterCount<M>; ++i) {
        for (const double value : kExtremes) {
          SCOPED_TRACE(::testing::Message() << camera.name << ' ' << M::kParameters[i].name << ' ' << value);
          Intrinsics<M> broken = camera.intrinsics;
          broken.values[i] = value;
          const CameraModel model = broken;
          (void)max_angle(model);
          for (const Pixel& pixel : {Pixel{100, 50}, principal_point(camera.intrinsics), Pixel{-500, 2000}}) {
            const auto ray = unproject(model, pixel);
            EXPECT_TRUE(!ray || is_unit(*ray));
          }
          for (const double angle : {0.0, 0.5, 1.6, 3.0}) {
            const auto pixel = project(model, ray_at(angle, 0.4));
            EXPECT_TRUE(!pixel || finite((*pixel)[0], (*pixel)[1]));
          }
        }
      }
    }
  });
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

/// Does k1 = -0.4 have a radius with that image?
bool folding_lens_reaches(double image_radius) {
  // r - 0.4 r^3 is largest at r = 1 / sqrt(1.2), where it is 2/3 of that.
  return image_radius < 2.0 / 3.0 / std::sqrt(1.2);
}

// ERRATA: the authors' program never ends on this camera's corners.
TEST(Refusal, CornersThatNoRayHas) {
  const Intrinsics<Radtan> camera{{300, 300, 320, 240, -0.4, 0, 0, 0, 0}};
  int refused = 0;
  for (int u = 0; u < 640; u += 4) {
    for (int v = 0; v < 480; v += 4) {
      const bool reachable = folding_lens_reaches(std::hypot(u - 320, v - 240) / 300);
      EXPECT_EQ(unproject(camera, {double(u), double(v)}).has_value(), reachable) << u << ' ' << v;
      refused += reachable ? 0 : 1;
    }
  }
  EXPECT_GT(refused, 1000);
}

// Pixels beyond the image of the domain have no ray.
TEST(Refusal, PixelsBeyondTheImageOfTheDomain) {
  EXPECT_FALSE(unproject(Intrinsics<Ucm>{{250, 250, 320, 240, 1.0}}, {320 + 250.001, 240}));
  EXPECT_TRUE(unproject(Intrinsics<Ucm>{{250, 250, 320, 240, 1.0}}, {320 + 249.999, 240}));
  // EUCM: |m|^2 <= 1 / (beta (2 alpha - 1)) = 1 / 0.26
  EXPECT_FALSE(unproject(Intrinsics<Eucm>{{100, 100, 0, 0, 0.6, 1.3}}, {0, 100 / std::sqrt(0.26) + 1e-6}));
  EXPECT_TRUE(unproject(Intrinsics<Eucm>{{100, 100, 0, 0, 0.6, 1.3}}, {0, 100 / std::sqrt(0.26) - 1e-6}));
  // Mei, xi = 2: |m| < 1 / sqrt(xi^2 - 1)
  EXPECT_FALSE(unproject(Intrinsics<Mei>{{100, 100, 0, 0, 2, 0, 0, 0, 0}}, {100 / std::sqrt(3.0) + 1e-6, 0}));
  EXPECT_TRUE(unproject(Intrinsics<Mei>{{100, 100, 0, 0, 2, 0, 0, 0, 0}}, {100 / std::sqrt(3.0) - 1e-6, 0}));
  // FOV: radius < pi / w
  EXPECT_FALSE(unproject(Intrinsics<Fov>{{100, 100, 0, 0, 1.0}}, {100 * std::numbers::pi + 1e-6, 0}));
  EXPECT_TRUE(unproject(Intrinsics<Fov>{{100, 100, 0, 0, 1.0}}, {100 * std::numbers::pi - 1e-6, 0}));
  // KB4, theta - 0.2 theta^3 is largest at 1 / sqrt(0.6), where it is 2/3 of that.
  EXPECT_FALSE(unproject(Intrinsics<Kb4>{{100, 100, 0, 0, -0.2, 0, 0, 0}}, {100 * 2.0 / 3.0 / std::sqrt(0.6) + 1e-6, 0}));
  EXPECT_TRUE(unproject(Intrinsics<Kb4>{{100, 100, 0, 0, -0.2, 0, 0, 0}}, {100 * 2.0 / 3.0 / std::sqrt(0.6) - 1e-6, 0}));
}

// For xi > 1 the lift of far pixels lies on the mirror image of the first sphere, which no ray reaches.
TEST(Refusal, DsMirrorImage) {
  const Intrinsics<Ds> camera{{100, 100, 0, 0, 0.4, 1.1}};
  double largest = 0.0;
  const double end = max_angle(camera);
  for (int i = 0; i < 1000; ++i) largest = std::max(largest, (*project(camera, ray_at(end * i / 1000, 0.0)))[0]);
  for (double u = largest + 1.0; u < 1e9; u *= 1.1) EXPECT_FALSE(unproject(camera, {u, 0.0})) << u;
}

}  // namespace
}  // namespace fca::test
