// SPDX-License-Identifier: BSD-3-Clause
// A turn of the camera that is fitted together with its model.
#include "known_cameras.h"

#include <fca/code.h>
#include <fca/convert/convert.h>
#include <fca/convert/field_of_view.h>
#include <fca/convert/sample.h>
#include <fca/rig/rotation.h>

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

namespace fca {
namespace {

using test::make_camera;

Transform turn_by(double x, double y, double z) {
  const Eigen::Vector3d vector(x, y, z);
  const Eigen::Matrix3d R = Eigen::AngleAxisd(vector.norm(), vector.normalized()).toRotationMatrix();
  Transform T;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) T(row, column) = R(row, column);
  }
  return T;
}

/// The camera as a table of rays that another frame sees.
Camera table_of(const Camera& camera, const Transform& T_frame_camera) {
  Diagnostics diagnostics;
  const std::optional<FieldOfView> field_of_view = field_of_view_of(camera, 85.0 * test::kRadians, diagnostics);
  Camera table = camera;
  table.rays = sample(camera.model, *field_of_view, 600);
  for (Correspondence& entry : table.rays) entry.ray = rotated(T_frame_camera, entry.ray);
  table.model = Intrinsics<Pinhole>{{300, 300, principal_point(camera.model)[0], principal_point(camera.model)[1]}};
  return table;
}

ConvertOptions turned_to(const char* model) {
  ConvertOptions options;
  options.model = model;
  options.absorb_turn = true;
  options.bound = false;
  return options;
}

/// With tangential terms, which kb4, ds and eucm cannot hold.
std::vector<Camera> tilted_lenses() {
  return {make_camera(Intrinsics<Radtan>{{460, 458, 367, 248, -0.28, 0.07, 0.002, -0.0015, 0.0}}, {752, 480}),
          make_camera(Intrinsics<Radtan>{{700, 700, 500, 420, -0.1, 0.02, -0.003, 0.002, 0.001}}, {1024, 768}),
          make_camera(Intrinsics<Mei>{{800, 801, 512, 500, 1.1, -0.05, 0.02, 0.003, -0.004}}, {1024, 1024})};
}

// c, d and e can turn the image: a turn about the axis would be any number.
TEST(Turn, IsATiltWhereTheModelHasAnAffinePart) {
  for (const Camera& camera : tilted_lenses()) {
    Diagnostics diagnostics;
    ConvertOptions options = turned_to("ocamcalib");
    options.degree = 4;
    const std::optional<Conversion> found = convert(camera, options, diagnostics);
    ASSERT_TRUE(found);
    if (!found->report.turn) continue;
    const std::array<double, 3> vector = rotation_vector(found->report.turn->T_target_source);
    EXPECT_LT(std::abs(vector[2]), 1e-3 * std::hypot(vector[0], vector[1]) + 1e-6);
  }
}

TEST(Turn, OfAKnownLensIsFound) {
  const Camera lens = make_camera(Intrinsics<Kb4>{{280, 282, 320, 240, -0.01, 0.004, -0.002, 0.0003}}, {640, 480});
  const Transform T_frame_camera = turn_by(0.01, -0.02, 0.015);
  for (const char* target : {"kb4", "ds", "eucm", "mei"}) {
    Diagnostics diagnostics;
    const std::optional<Conversion> found = convert(table_of(lens, T_frame_camera), turned_to(target), diagnostics);
    ASSERT_TRUE(found && found->report.turn) << target;
    // Back into the lens's own frame. A model that is not the lens's fits a frame next to it as well.
    const Transform rest = found->report.turn->T_target_source * T_frame_camera;
    const double off = angle_between(rest, Transform());
    EXPECT_LT(off, std::string(target) == "kb4" ? 1e-6 : 1e-3) << target;
    if (std::string(target) == "kb4") {
      EXPECT_LT(found->report.statistics.error.rms, 1e-6);
    }
  }
}

TEST(Turn, IsTheBestOne) {
  constexpr double kBeside = 2e-4;  // rad
  for (const Camera& lens : tilted_lenses()) {
    for (const char* target : {"kb4", "ds", "eucm"}) {
      SCOPED_TRACE(std::string(model_info(lens.model).id) + " -> " + target);
      Diagnostics diagnostics;
      const Camera table = table_of(lens, Transform());
      const std::optional<Conversion> found = convert(table, turned_to(target), diagnostics);
      ASSERT_TRUE(found && found->report.turn);
      const double rms = found->report.statistics.error.rms;
      EXPECT_LT(rms, found->report.turn->rms_before_px);
      // Fits to rays that are turned by a little more, or less, are worse.
      for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-kBeside, kBeside}) {
          const Transform beside = turn_by(axis == 0 ? side : 0.0, axis == 1 ? side : 0.0, axis == 2 ? side : 0.0);
          ConvertOptions straight = turned_to(target);
          straight.absorb_turn = false;
          const Camera turned = table_of(lens, beside * found->report.turn->T_target_source);
          const std::optional<Conversion> other = convert(turned, straight, diagnostics);
          ASSERT_TRUE(other);
          EXPECT_GT(other->report.statistics.error.rms, rms * (1.0 - 1e-4)) << axis << " " << side;
        }
      }
    }
  }
}

TEST(Turn, IsWhatTheReportSaysOverTheImage) {
  for (const Camera& lens : tilted_lenses()) {
    for (const char* target : {"kb4", "eucm"}) {
      Diagnostics diagnostics;
      const std::optional<Conversion> found = convert(lens, turned_to(target), diagnostics);
      ASSERT_TRUE(found && found->report.turn);
      double squares = 0.0;
      int count = 0;
      const ImageSize size = *lens.image_size;
      for (int v = 0; v < size.height; v += 3) {
        for (int u = 0; u < size.width; u += 3) {
          const Pixel pixel = {static_cast<double>(u), static_cast<double>(v)};
          const std::optional<Ray> ray = unproject(lens.model, pixel);
          const std::optional<Pixel> there =
              ray ? project(found->camera.model, rotated(found->report.turn->T_target_source, *ray)) : std::nullopt;
          if (!there) continue;
          squares += std::pow((*there)[0] - pixel[0], 2) + std::pow((*there)[1] - pixel[1], 2);
          ++count;
        }
      }
      EXPECT_NEAR(found->report.statistics.error.rms, std::sqrt(squares / count), 0.01 * std::sqrt(squares / count));
      EXPECT_LT(rotation_defect(found->report.turn->T_target_source), 1e-12);
    }
  }
}

TEST(Turn, IsOfferedForWhatItGains) {
  int offers = 0;
  for (const Camera& lens : tilted_lenses()) {
    for (const char* target : {"kb4", "eucm", "mei"}) {
      SCOPED_TRACE(std::string(model_info(lens.model).id) + " -> " + target);
      Diagnostics diagnostics;
      ConvertOptions straight = turned_to(target);
      straight.absorb_turn = false;
      const std::optional<Conversion> before = convert(lens, straight, diagnostics);
      const std::optional<Conversion> after = convert(lens, turned_to(target), diagnostics);
      ASSERT_TRUE(before && after);
      const double gain = after->report.statistics.error.rms / before->report.statistics.error.rms;
      if (before->report.turn_offer) {
        ++offers;
        EXPECT_NEAR(before->report.turn_offer->rms_px, after->report.statistics.error.rms,
                    0.1 * before->report.statistics.error.rms);
      } else {
        constexpr double kVisible = 0.02;  // px
        EXPECT_TRUE(gain > 0.7 || before->report.statistics.error.rms < kVisible) << gain;
      }
    }
  }
  EXPECT_GE(offers, 2);
}

TEST(Turn, IsForTheRmsOnly) {
  ConvertOptions options = turned_to("kb4");
  options.objective = Objective::kMax;
  Diagnostics diagnostics;
  EXPECT_FALSE(convert(tilted_lenses().front(), options, diagnostics));
  ASSERT_FALSE(diagnostics.entries().empty());
  EXPECT_EQ(diagnostics.entries().front().facts.code, Code::kTurnedForRms);
}

}  // namespace
}  // namespace fca
