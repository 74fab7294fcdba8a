// SPDX-License-Identifier: BSD-3-Clause
// The columns that two cameras share, against cameras whose overlap is plain geometry.
#include <fca/rig/overlap.h>

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace fca::test {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// An equidistant lens (pixels grow with the angle): 4 px per degree, 400 px wide, 100 degrees in full.
Camera equidistant(const std::string& name) {
  constexpr double kFocal = 4.0 / kDegree;
  return {name, ImageSize{400, 300}, Intrinsics<Kb4>{{kFocal, kFocal, 199.5, 149.5, 0, 0, 0, 0}}, {}, {}, {}};
}

/// T_other_camera of an other camera turned to the right (about y, which points down) by that angle.
Transform turned_right(double angle) {
  Transform T;
  T(0, 0) = std::cos(angle);
  T(0, 2) = -std::sin(angle);
  T(2, 0) = std::sin(angle);
  T(2, 2) = std::cos(angle);
  return T;
}

TEST(Overlap, ParallelCamerasShareEverything) {
  EXPECT_EQ(columns_shared(equidistant("a"), equidistant("b"), {}), (ColumnRange{0, 399}));
  Transform beside;
  beside(0, 3) = -0.1;
  EXPECT_EQ(columns_shared(equidistant("a"), equidistant("b"), beside), (ColumnRange{0, 399}));
}

// On the horizon a camera turned by d sees 50 degrees less d on the far side: d times 4 px/degree of columns are not shared.
// Off it the border bends outwards by a few pixels.
TEST(Overlap, ATurnedCameraSharesWhatItsFieldOfViewReaches) {
  for (const double degrees : {10.0, 30.0, 60.0}) {
    const Transform T = turned_right(degrees * kDegree);
    const std::optional<ColumnRange> columns = columns_shared(equidistant("a"), equidistant("b"), T);
    ASSERT_TRUE(columns);
    EXPECT_EQ(columns->last, 399) << degrees;
    EXPECT_LE(columns->first, 4.0 * degrees + 1.0) << degrees;
    EXPECT_GE(columns->first, 4.0 * degrees - 40.0) << degrees;
    const std::optional<ColumnRange> back = columns_shared(equidistant("b"), equidistant("a"), inverse(T).value());
    ASSERT_TRUE(back);
    EXPECT_EQ(back->first, 399 - columns->last) << degrees;
    EXPECT_EQ(back->last, 399 - columns->first) << degrees;
  }
}

/// Does any pixel of the column show what the other camera sees, too?
bool shares_any(const Camera& camera, const Camera& other, const Transform& T_other_camera, int column) {
  for (int row = 0; row < camera.image_size->height; ++row) {
    const std::optional<Ray> ray = unproject(camera.model, {static_cast<double>(column), static_cast<double>(row)});
    if (!ray) continue;
    Ray there{};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        there.at(static_cast<std::size_t>(i)) += T_other_camera(i, j) * ray->at(static_cast<std::size_t>(j));
    }
    const std::optional<Pixel> pixel = project(other.model, there);
    if (pixel && (*pixel)[0] >= -0.5 && (*pixel)[1] >= -0.5 && (*pixel)[0] <= other.image_size->width - 0.5 &&
        (*pixel)[1] <= other.image_size->height - 0.5)
      return true;
  }
  return false;
}

// Turned and rolled, so that the border is slanted and its outermost pixel in no particular row.
TEST(Overlap, TheColumnsAreThoseOfASearchOverEveryPixel) {
  for (const double degrees : {17.0, 43.0, 71.0}) {
    for (const double roll : {0.0, 9.0, 160.0}) {
      Transform rolled;
      rolled(0, 0) = rolled(1, 1) = std::cos(roll * kDegree);
      rolled(1, 0) = std::sin(roll * kDegree);
      rolled(0, 1) = -rolled(1, 0);
      const Transform T = rolled * turned_right(degrees * kDegree);
      const Camera a = equidistant("a");
      const Camera b = equidistant("b");
      int first = 0;
      while (first < 400 && !shares_any(a, b, T, first)) ++first;
      int last = 399;
      while (last > 0 && !shares_any(a, b, T, last)) --last;
      const std::optional<ColumnRange> columns = columns_shared(a, b, T);
      ASSERT_TRUE(columns);
      EXPECT_EQ(*columns, (ColumnRange{first, last})) << degrees << " rolled by " << roll;
    }
  }
}

TEST(Overlap, CamerasThatLookAwayShareNothing) {
  EXPECT_FALSE(columns_shared(equidistant("a"), equidistant("b"), turned_right(std::numbers::pi)));
  Camera sizeless = equidistant("b");
  sizeless.image_size.reset();
  EXPECT_FALSE(columns_shared(equidistant("a"), sizeless, {}));
}

// A lens of 20 degrees around the axis: 80 px to either side.
TEST(Overlap, TheLensEndsWhereItIsSaidTo) {
  const std::optional<ColumnRange> columns = columns_shared(equidistant("a"), equidistant("b"), {}, 20.0 * kDegree);
  ASSERT_TRUE(columns);
  EXPECT_NEAR(columns->first, 199.5 - 80.0, 1.0);
  EXPECT_NEAR(columns->last, 199.5 + 80.0, 1.0);
}

}  // namespace
}  // namespace fca::test
