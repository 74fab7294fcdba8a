// SPDX-License-Identifier: BSD-3-Clause
// A rectified pair survives the formats that hold one, and is lost with a word in those that do not.
#include <fca/code.h>
#include <fca/formats/calibration.h>
#include <fca/formats/text/read_document.h>
#include <fca/rectify/rectify.h>
#include <fca/rig/rotation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace fca::test {
namespace {

Rig pair_rig(bool is_vertical) {
  Rig rig;
  for (const char* name : {"cam0", "cam1"}) {
    Camera camera;
    camera.name = name;
    camera.image_size = ImageSize{752, 480};
    camera.model = Intrinsics<Radtan>{{458.5, 457.25, 367.25, 248.5, -0.28, 0.07, 2e-4, 2e-5, 0.0}};
    rig.cameras.push_back(camera);
  }
  const std::array<double, 3> t = is_vertical ? std::array{0.001, -0.11, 0.002} : std::array{-0.11, 0.001, 0.002};
  rig.poses = {{"cam1", "cam0", pose_of(normalised({0.004, -0.01, 0.003, 1.0}), t)}};
  Diagnostics diagnostics;
  rig.rectified = rectify(rig.cameras[0], rig.cameras[1], rig.poses.front().T_a_b, {}, diagnostics);
  return rig;
}

std::optional<Written> written(const Rig& rig, std::string_view format) {
  Diagnostics diagnostics;
  return write_calibration(*find_format(format), nullptr, rig, {}, diagnostics);
}

std::optional<Calibration> read(std::vector<std::pair<std::string, std::string>> files, ReadOptions options = {}) {
  std::vector<text::Document> documents;
  Diagnostics diagnostics;
  for (const auto& [name, bytes] : files) {
    std::optional<text::Document> document = text::parse_document({name, bytes}, diagnostics);
    if (!document) return std::nullopt;
    documents.push_back(*std::move(document));
  }
  options.join = documents.size() > 1;
  return read_calibration(std::move(documents), nullptr, options, diagnostics);
}

std::optional<Calibration> read(const Written& files) {
  std::vector<std::pair<std::string, std::string>> named;
  for (const Written::File& file : files.files) named.emplace_back(file.document.source().name, file.document.bytes());
  return read(named);
}

bool drops_it(const Written& files) {
  return std::ranges::any_of(files.losses, [](const Loss& loss) { return loss.kind == Code::kRectificationDropped; });
}

class HoldsRectification : public testing::TestWithParam<std::string> {};

TEST_P(HoldsRectification, AsItWas) {
  for (const bool is_vertical : {false, true}) {
    const Rig rig = pair_rig(is_vertical);
    ASSERT_TRUE(rig.rectified);
    const std::optional<Written> files = written(rig, GetParam());
    ASSERT_TRUE(files);
    EXPECT_FALSE(drops_it(*files));
    const std::optional<Calibration> again = read(*files);
    ASSERT_TRUE(again && again->rig.rectified);
    const RectifiedPair& was = *rig.rectified;
    const RectifiedPair& is = *again->rig.rectified;
    EXPECT_EQ(is.is_vertical, is_vertical);
    EXPECT_NEAR(is.offset_m, was.offset_m, 1e-15);
    EXPECT_EQ(is.focal_lengths, was.focal_lengths);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(is.views.at(i).centre, was.views.at(i).centre);
      EXPECT_LE(largest_difference(is.views.at(i).T_rectified_camera, was.views.at(i).T_rectified_camera).distance, 1e-15);
    }
    EXPECT_TRUE(states_rectification(again->rig));
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, HoldsRectification, testing::Values("opencv", "ros"),
                         [](const auto& format) { return format.param; });

TEST(Rectification, IsLostWithAWordWhereThereIsNoPlace) {
  for (const char* format : {"kalibr", "tumvi"}) {
    const std::optional<Written> files = written(pair_rig(false), format);
    ASSERT_TRUE(files) << format;
    EXPECT_TRUE(drops_it(*files)) << format;
  }
}

TEST(Rectification, IsInTheUnitThatIsTold) {
  const std::optional<Written> files = written(pair_rig(false), "opencv");
  ASSERT_TRUE(files);
  ReadOptions options;
  options.length_unit_m = 1e-3;
  const std::optional<Calibration> calibration = read({{"stereo.yml", files->files.front().document.bytes()}}, options);
  ASSERT_TRUE(calibration && calibration->rig.rectified);
  EXPECT_NEAR(calibration->rig.rectified->offset_m, 1e-3 * pair_rig(false).rectified->offset_m, 1e-18);
  EXPECT_TRUE(states_rectification(calibration->rig));
}

// What is no rectification is a key without meaning, and no error: programs put all kinds of things next to a calibration.
TEST(Rectification, IsNoneWhereMatricesAreNone) {
  const std::optional<Written> files = written(pair_rig(false), "opencv");
  ASSERT_TRUE(files);
  const std::string good = files->files.front().document.bytes();
  const std::size_t R1 = good.find("R1:");
  ASSERT_NE(R1, std::string::npos);
  const std::size_t data = good.find("data: [", R1) + std::string("data: [").size();
  const std::string stretched = good.substr(0, data) + "7.0, " + good.substr(good.find(',', data) + 1);
  const std::optional<Calibration> calibration = read({{"stereo.yml", stretched}});
  ASSERT_TRUE(calibration);
  EXPECT_FALSE(calibration->rig.rectified);
  EXPECT_NE(calibration->rig.find_extra_field("", "R1"), nullptr);
  EXPECT_EQ(calibration->rig.cameras.size(), 2U);
}

}  // namespace
}  // namespace fca::test
