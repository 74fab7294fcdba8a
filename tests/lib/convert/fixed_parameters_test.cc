// SPDX-License-Identifier: BSD-3-Clause
// Parameters that a fit leaves alone, and ranges that published cameras keep.
#include "known_cameras.h"

#include <fca/code.h>
#include <fca/convert/convert.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace fca {
namespace {

using test::make_camera;

Camera lens() { return make_camera(Intrinsics<Kb4>{{280, 284, 322, 237, -0.01, 0.004, -0.002, 0.0003}}, {640, 480}); }

std::optional<Conversion> converted(const Camera& camera, ConvertOptions options, const char* model) {
  options.model = model;
  options.bound = false;
  Diagnostics diagnostics;
  return convert(camera, options, diagnostics);
}

double value_of(const Conversion& conversion, ParameterId name) { return parameter(conversion.camera.model, name).value(); }

TEST(FixedParameters, StayWhereTheyAreAsked) {
  for (const char* target : {"ds", "eucm", "mei", "kb4", "radtan"}) {
    ConvertOptions options;
    options.max_angle_rad = 50.0 * test::kRadians;
    options.fixed.kept = {"cx"};
    options.fixed.at = {{"cy", 239.5, 239.5}};
    const std::optional<Conversion> found = converted(lens(), options, target);
    ASSERT_TRUE(found) << target;
    EXPECT_EQ(value_of(*found, "cx"), 322.0) << target;
    EXPECT_EQ(value_of(*found, "cy"), 239.5) << target;
  }
}

TEST(FixedParameters, OneFocalLengthIsTheBest) {
  for (const char* target : {"ds", "eucm", "kb4", "mei"}) {
    ConvertOptions options;
    options.fixed.one_focal_length = true;
    const std::optional<Conversion> found = converted(lens(), options, target);
    ASSERT_TRUE(found) << target;
    const double f = value_of(*found, "fx");
    EXPECT_EQ(f, value_of(*found, "fy")) << target;
    const double rms = found->report.statistics.error.rms;
    for (const double beside : {0.999 * f, 1.001 * f}) {
      ConvertOptions there;
      there.ranges = {{"fx", beside, beside}, {"fy", beside, beside}};
      const std::optional<Conversion> other = converted(lens(), there, target);
      ASSERT_TRUE(other) << target;
      EXPECT_GT(other->report.statistics.error.rms, rms) << target << " " << beside;
    }
  }
}

TEST(FixedParameters, AreRefusedWhereThereAreNone) {
  Diagnostics diagnostics;
  ConvertOptions options;
  options.model = "ds";
  options.fixed.kept = {"k3"};
  EXPECT_FALSE(convert(make_camera(Intrinsics<Ucm>{{200, 201, 310, 250, 0.6}}, {640, 480}), options, diagnostics));
  ASSERT_FALSE(diagnostics.entries().empty());
  EXPECT_EQ(diagnostics.entries().front().facts.code, Code::kNothingToKeep);
}

/// Is each parameter where published cameras have it?
bool is_usual(const CameraModel& model) {
  const ModelInfo& info = model_info(model);
  const auto values = parameter_values(model);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] < info.parameters[i].usual[0] || values[i] > info.parameters[i].usual[1]) return false;
  }
  return true;
}

TEST(UsualRanges, AreKeptOrReported) {
  int reported = 0;
  const std::vector<Camera> cameras = {
      test::euroc(), test::tumvi(), test::t265_like(), test::kalibr_radtan(), test::kalibr_eucm(), lens(),
      make_camera(Intrinsics<Radtan>{{460, 458, 367, 248, -0.05, 0.01, 0.0, 0.0, 0.0}}, {752, 480}),
      // radius = f angle, and f 2 tan(angle / 2): a narrow and a parabolic one
      make_camera(Intrinsics<Kb4>{{900, 900, 320, 240, 0.0, 0.0, 0.0, 0.0}}, {640, 480}),
      make_camera(Intrinsics<Kb4>{{250, 250, 320, 240, 0.0834, 0.0083, 0.0009, 0.0}}, {640, 480})};
  for (const Camera& camera : cameras) {
    for (const char* target : {"ds", "mei", "eucm"}) {
      SCOPED_TRACE(std::string(model_info(camera.model).id) + " -> " + target);
      const std::optional<Conversion> found = converted(camera, {}, target);
      ASSERT_TRUE(found);
      if (found->report.exact || found->report.statistics.error.rms < 1e-6) continue;
      EXPECT_EQ(is_usual(found->camera.model), found->report.unusual.empty());
      for (const UnusualParameter& each : found->report.unusual) {
        ++reported;
        EXPECT_TRUE(each.rms_inside_px == 0.0 || each.rms_inside_px > 1.01 * found->report.statistics.error.rms) << each.name;
      }
    }
  }
  RecordProperty("reported", reported);
}

}  // namespace
}  // namespace fca
