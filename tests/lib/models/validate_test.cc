// SPDX-License-Identifier: BSD-3-Clause
// validate(): which parameters are a camera, and what is said of those that are not.
#include "model_test_support.h"

#include <fca/code.h>

namespace fca::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

CameraModel with(const char* id, std::initializer_list<double> values) {
  CameraModel model = *make_model(id);
  std::ranges::copy(values, parameter_values(model).begin());
  return model;
}

TEST(Validate, EveryCameraOfTheTablesIsOne) {
  for_each_model([]<CameraModelType M>() {
    for (const TestCamera<M>& camera : cameras_and_neighbours_of<M>(5)) {
      EXPECT_TRUE(validate(camera.intrinsics).empty()) << camera.name << ": " << id_of(validate(camera.intrinsics)[0]);
    }
  });
}

TEST(Validate, EveryParameterMustBeAReasonableNumber) {
  for_each_model([]<CameraModelType M>() {
    const TestCamera<M> camera = cameras_of<M>()[0];
    for (std::size_t i = 0; i < kParameterCount<M>; ++i) {
      for (const double value : {kNaN, kInf, -kInf, 1e308, -1e308}) {
        Intrinsics<M> broken = camera.intrinsics;
        broken.values[i] = value;
        const std::vector<Message> problems = validate(broken);
        ASSERT_EQ(problems.size(), 1U) << M::kParameters[i].name << ' ' << value;
        EXPECT_EQ(id_of(problems[0]), "not-a-camera");
        EXPECT_EQ(problems[0].arguments.at(0), Argument(M::kParameters[i].name));
      }
    }
  });
}

TEST(Validate, EveryParameterMustLieInItsRange) {
  for_each_model([]<CameraModelType M>() {
    const TestCamera<M> camera = cameras_of<M>()[0];
    for (std::size_t i = 0; i < kParameterCount<M>; ++i) {
      const Parameter& p = M::kParameters[i];
      SCOPED_TRACE(p.name);
      for (const auto& [bound, outwards] : {std::pair(p.lower, -1.0), std::pair(p.upper, 1.0)}) {
        if (!std::isfinite(bound)) continue;
        Intrinsics<M> changed = camera.intrinsics;
        changed.values[i] = bound + 1e-9 * outwards;
        EXPECT_EQ(validate(changed).size(), 1U);
        changed.values[i] = bound;
        EXPECT_EQ(validate(changed).size(), p.open ? 1U : 0U);
      }
    }
  });
}

// What validate() lets through projects: the ray on the axis has a pixel, the principal point.
TEST(Validate, ValidCamerasSeeTheAxis) {
  for_each_model([]<CameraModelType M>() {
    const TestCamera<M> camera = cameras_of<M>()[0];
    for (std::size_t i = 0; i < kParameterCount<M>; ++i) {
      if (M::kParameters[i].group != ParameterGroup::kLens) continue;
      for (const double value : {-2.0, -1.0, -0.999, 0.0, 1e-9, 0.5, 1.0, 3.0, std::numbers::pi, 4.0}) {
        Intrinsics<M> changed = camera.intrinsics;
        changed.values[i] = value;
        if (!validate(changed).empty()) continue;
        EXPECT_TRUE(project(changed, {0, 0, 1})) << M::kParameters[i].name << ' ' << value;
        EXPECT_TRUE(unproject(changed, principal_point(changed))) << M::kParameters[i].name << ' ' << value;
        EXPECT_GT(max_angle(changed), 0.0);
      }
    }
  });
}

TEST(Validate, SaysWhatIsWrong) {
  using Problems = std::vector<Message>;
  const Problems of_pinhole = validate(with("pinhole", {-400, 0, 320, kNaN}));
  ASSERT_EQ(of_pinhole.size(), 3U);
  EXPECT_EQ(of_pinhole[0], (Message{Code::kFocalLengthNotPositive, {"fx", -400.0}}));
  EXPECT_EQ(of_pinhole[1], (Message{Code::kFocalLengthNotPositive, {"fy", 0.0}}));
  EXPECT_EQ(of_pinhole[2].code, Code::kParameterNotFinite);
  EXPECT_EQ(of_pinhole[2].arguments.at(0), Argument("cy"));
  EXPECT_EQ(validate(with("eucm", {400, 400, 320, 240, 1.5, 0})),
            (Problems{{Code::kParameterOutOfRange, {"alpha", 1.5, Message{Code::kLieWithin, {0.0, 1.0}}}},
                      {Code::kParameterOutOfRange, {"beta", 0.0, Message{Code::kBeGreaterThan, {0.0}}}}}));
  EXPECT_EQ(validate(with("ds", {400, 400, 320, 240, 0.5, -1})),
            (Problems{{Code::kParameterOutOfRange, {"xi", -1.0, Message{Code::kBeGreaterThan, {-1.0}}}}}));
  EXPECT_EQ(validate(with("ocamcalib", {320, 240, 0, 0, 0, 209.3})),
            (Problems{{Code::kParameterOutOfRange, {"c", 0.0, Message{Code::kBeGreaterThan, {0.0}}}},
                      {Code::kParameterOutOfRange, {"a0", 209.3, Message{Code::kBeLessThan, {0.0}}}}}));
  EXPECT_EQ(validate(with("woodscape", {-339, 0, 0, 0, -1, 640, 480})),
            (Problems{{Code::kFocalLengthNotPositive, {"k1", -339.0}},
                      {Code::kParameterOutOfRange, {"aspect_ratio", -1.0, Message{Code::kBeGreaterThan, {0.0}}}}}));
  EXPECT_EQ(validate(with("mei", {400, 400, 320, 240, -0.5, 0, 0, 0, 1e308})),
            (Problems{{Code::kParameterOutOfRange, {"xi", -0.5, Message{Code::kBeAtLeast, {0.0}}}},
                      {Code::kParameterTooLarge, {"p2", 1e308}}}));
}

}  // namespace
}  // namespace fca::test
