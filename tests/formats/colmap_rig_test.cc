// SPDX-License-Identifier: BSD-3-Clause
// COLMAP's rig_config.json: what its poses and lenses mean, by numbers worked out by hand, what is written comes back and is
// what COLMAP's reader holds, an edit keeps every other byte, and the corpus' files are read as a person reads them.
#include "formats/lost_facts.h"
#include "formats/rigs.h"
#include "formats/test_files.h"
#include "transforms.h"

#include <fca/code.h>
#include <fca/formats/proof.h>
#include <fca/rig/rotation.h>

#include <array>
#include <functional>

namespace fca::test {
namespace {

constexpr const char* kName = "rig_config.json";

const Format& colmap() { return *find_format("colmap"); }
std::string good(const char* name) { return read_file(testdata_dir() / "colmap" / "good" / name); }
Rig rig_of(const std::string& bytes) { return calibration_of(bytes, kName).rig; }

const Transform& pose(const Rig& rig, const std::string& a, const std::string& b) {
  static const Transform kNone = {};
  for (const PoseEdge& edge : rig.poses) {
    if (edge.a == a && edge.b == b) return edge.T_a_b;
  }
  ADD_FAILURE() << "no T_" << a << "_" << b;
  return kNone;
}

// A quarter turn about z takes x to y; -q is the same rotation as q.
TEST(ColmapRig, PosesTakeThePointsOfTheReference) {
  const Rig rig = rig_of(good("rig-config.json"));
  const Transform expected = {{0.0, -1.0, 0.0, -0.11, 1.0, 0.0, 0.0, 0.002, 0.0, 0.0, 1.0, 0.003, 0.0, 0.0, 0.0, 1.0}};
  EXPECT_LT(element_difference(pose(rig, "right", "cam0"), expected), 1e-15);
  ASSERT_EQ(rig.cameras.size(), 2U);
  EXPECT_EQ(rig.cameras[0].model,
            calibration_of("1 SIMPLE_RADIAL 640 480 500 320.5 240.5 -0.1\n", "cameras.txt").rig.cameras[0].model);
  EXPECT_EQ(model_info(rig.cameras[1].model).id, "eucm");
  EXPECT_FALSE(rig.cameras[0].image_size) << "COLMAP takes it from the images";
}

TEST(ColmapRig, CamerasWithoutALensAreInPosesAlone) {
  const Rig rig = rig_of(good("rig-poses-crlf.json"));
  EXPECT_TRUE(rig.cameras.empty());
  EXPECT_EQ(translation_of(pose(rig, "left", "right")), (std::array{0.0, 0.25, 0.0}));
}

// Two rigs have a folder "left" each.
TEST(ColmapRig, SeveralRigsHaveTheirOwnReferences) {
  const std::string bytes = good("two-rigs.json");
  Rig rig = rig_of(bytes);
  ASSERT_EQ(rig.cameras.size(), 4U);
  EXPECT_EQ(rig.cameras[3].name, "rear/right");
  EXPECT_EQ(translation_of(pose(rig, "front/right", "front/left")), (std::array{-0.12, 0.0, 0.0}));
  EXPECT_EQ(translation_of(pose(rig, "rear/right", "rear/left")), (std::array{-0.2, 0.01, 0.005}));
  EXPECT_FALSE(rig.resolve("rear/left", "front/left"));
  const consumers::ConsumerView view = consumers::find_consumer("colmap-rig")->load(bytes, {});
  ASSERT_EQ(view.poses.size(), 2U);
  EXPECT_EQ(view.poses[1].a, "rear/right");

  for (Camera& camera : rig.cameras) camera.image_size = ImageSize{640, 480};
  rig.poses[1].T_a_b(0, 3) = -0.25;
  Diagnostics diagnostics;
  const text::Document base = document_of(bytes, kName);
  const std::optional<Written> written = write_calibration(colmap(), &base, rig, {}, diagnostics);
  ASSERT_TRUE(written);
  EXPECT_EQ(written->files.front().document.bytes(), with_replaced(bytes, "-0.2,", "-0.25,"));
  // A fresh file has both again.
  const std::optional<Written> fresh = write_calibration(colmap(), nullptr, rig, {}, diagnostics);
  ASSERT_TRUE(fresh);
  const Rig back = rig_of(fresh->files.at(1).document.bytes());
  ASSERT_EQ(back.poses.size(), 2U);
  EXPECT_EQ(back.poses[1].a, "cam3");
  EXPECT_EQ(back.poses[1].b, "cam2");
}

// cameras.txt has the lenses and sizes, the file next to it how the cameras sit to each other.
TEST(ColmapRig, AFreshOneComesBackAndIsWhatColmapHolds) {
  Rig rig = sample_rig("kb4", {true, false});
  for (Camera& camera : rig.cameras) camera.topic.clear();
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(colmap(), nullptr, rig, {}, diagnostics);
  ASSERT_TRUE(written);
  ASSERT_EQ(written->files.size(), 5U);
  EXPECT_EQ(written->files[1].place, kName);
  EXPECT_EQ(written->files[2].place, "rigs.txt");
  EXPECT_TRUE(std::ranges::none_of(written->losses, [](const Loss& loss) { return info(loss.kind).id == "pose-dropped"; }));
  const std::string bytes = written->files[1].document.bytes();
  const Rig back = rig_of(bytes);
  ASSERT_EQ(back.cameras.size(), rig.cameras.size());
  const std::string& first = rig.cameras.front().name;
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
    EXPECT_EQ(back.cameras[i].name, rig.cameras[i].name);
    EXPECT_EQ(back.cameras[i].model, rig.cameras[i].model);
    if (i == 0) continue;
    EXPECT_LT(element_difference(pose(back, rig.cameras[i].name, first), *rig.resolve(rig.cameras[i].name, first)), 1e-12);
  }
  const ProofResult proof = prove(*consumers::find_consumer("colmap-rig"), bytes, {}, back);
  EXPECT_TRUE(proof.agrees());
  EXPECT_EQ(proof.poses.size(), rig.cameras.size() - 1);
  // Both files together are the rig again.
  std::vector<text::Document> documents;
  for (std::size_t i = 0; i < 2; ++i)
    documents.push_back(document_of(written->files[i].document.bytes(), written->files[i].place));
  const std::optional<Calibration> both = read_calibration(std::move(documents), nullptr, {}, diagnostics);
  ASSERT_TRUE(both) << message_of(diagnostics.entries().back());
  EXPECT_EQ(both->rig.cameras, rig.cameras);
}

TEST(ColmapRig, WithoutAPoseThereIsNone) {
  Rig rig = sample_rig("kb4", {true, false});
  rig.poses.clear();
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(colmap(), nullptr, rig, {}, diagnostics);
  ASSERT_TRUE(written);
  for (const Written::File& file : written->files) EXPECT_EQ(file.place.find("rig"), std::string::npos) << file.place;
}

std::string edited(const std::function<void(Rig&)>& edit) {
  const std::string bytes = good("rig-config.json");
  Rig rig = rig_of(bytes);
  edit(rig);
  for (Camera& camera : rig.cameras) camera.image_size = ImageSize{640, 480};
  const text::Document base = document_of(bytes, kName);
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(colmap(), &base, rig, {}, diagnostics);
  EXPECT_TRUE(written);
  return written ? written->files.front().document.bytes() : "";
}

TEST(ColmapRig, AnEditChangesNumbersAlone) {
  const std::string bytes = good("rig-config.json");
  EXPECT_EQ(edited([](Rig&) {}), bytes);
  EXPECT_EQ(edited([](Rig& rig) { rig.poses.front().T_a_b(0, 3) = -0.12; }), with_replaced(bytes, "-0.11", "-0.12"));
  EXPECT_EQ(edited([](Rig& rig) { EXPECT_TRUE(set_parameter(rig.cameras[0].model, "k1", -0.2)); }),
            with_replaced(bytes, "-0.10", "-0.2"));
  // The quaternion keeps its sign.
  const std::string turned = edited([](Rig& rig) { rig.poses.front().T_a_b = Transform{}; });
  EXPECT_NE(turned.find("\"cam_from_rig_rotation\": [-1.0, "), std::string::npos) << turned;
}

TEST(ColmapRig, TheCorpusIsReadAsAPersonReadsIt) {
  const fs::path corpus = shared_dir() / "corpus" / "extra" / "colmap_rig";
  if (!fs::exists(corpus)) GTEST_SKIP() << "no corpus beside the repository: " << corpus;
  struct Expected {
    const char* file;
    std::size_t poses;
    const char* last;
    std::array<double, 3> translation;
  };
  constexpr std::array kExpected = {Expected{"Delikal__cdgs__rig_config.json", 17, "rs09pri", {0.5, 3.717, 0.0}},
                                    Expected{"Delikal__cdgs__rig_config2.json", 9, "rs04pri", {0.5, 1.652, 0.0}}};
  for (const Expected& expected : kExpected) {
    SCOPED_TRACE(expected.file);
    const std::string bytes = read_file(corpus / expected.file);
    const Rig rig = rig_of(bytes);
    ASSERT_EQ(rig.poses.size(), expected.poses);
    EXPECT_EQ(rig.poses.front().b, "ls00pri");
    EXPECT_EQ(rig.poses.back().a, expected.last);
    EXPECT_EQ(translation_of(rig.poses.back().T_a_b), expected.translation);
    EXPECT_NEAR(rig.poses.back().T_a_b(0, 0), -1.0, 1e-15) << "half a turn about y";
  }
}

}  // namespace
}  // namespace fca::test
