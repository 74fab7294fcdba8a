// SPDX-License-Identifier: BSD-3-Clause
// mrcal's .cameramodel: what its numbers mean, what is written comes back, edits keep every other byte, and what mrcal says.
#include "formats/lost_facts.h"
#include "formats/rigs.h"
#include "formats/test_files.h"

#include <fca/code.h>
#include <fca/formats/proof.h>
#include <fca/rig/rotation.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace fca::test {
namespace {

const Format& mrcal() { return *find_format("mrcal"); }
std::string good(const std::string& name) { return read_file(testdata_dir() / "mrcal" / "good" / name); }

/// The files as cameras of one rig.
Calibration joined(const std::vector<std::pair<std::string, std::string>>& files, Diagnostics& diagnostics) {
  std::vector<text::Document> documents;
  for (const auto& [name, bytes] : files) documents.push_back(document_of(bytes, name));
  ReadOptions options;
  options.join = true;
  std::optional<Calibration> calibration = read_calibration(std::move(documents), nullptr, options, diagnostics);
  EXPECT_TRUE(calibration);
  return calibration ? *std::move(calibration) : Calibration();
}

Calibration joined(const Written& written) {
  std::vector<std::pair<std::string, std::string>> files;
  for (const Written::File& file : written.files) files.emplace_back(file.document.source().name, file.document.bytes());
  Diagnostics diagnostics;
  return joined(files, diagnostics);
}

Written fresh(const Rig& rig) {
  Diagnostics diagnostics;
  std::optional<Written> written = write_calibration(mrcal(), nullptr, rig, {}, diagnostics);
  EXPECT_TRUE(written) << (diagnostics.entries().empty() ? "" : message_of(diagnostics.entries().front()));
  return written ? *std::move(written) : Written();
}

/// The base with the change.
Written with(const std::string& bytes, const std::function<void(Rig&)>& change) {
  Rig rig = calibration_of(bytes, "a.cameramodel").rig;
  change(rig);
  const text::Document base = document_of(bytes, "a.cameramodel");
  Diagnostics diagnostics;
  std::optional<Written> written = write_calibration(mrcal(), &base, rig, {}, diagnostics);
  EXPECT_TRUE(written);
  if (!written) return {};
  EXPECT_EQ(written->files.size(), 1U);
  return *std::move(written);
}

void expect_proven(const Written& written, const Rig& rig) {
  const consumers::Consumer& program = *consumers::find_consumer("mrcal");
  for (const Written::File& file : written.files) {
    const ProofResult proof = prove(program, file.document.bytes(), {}, rig, file.cameras, 0.9);
    EXPECT_TRUE(proof.agrees()) << (proof.loads ? "other numbers" : "refused") << "\n" << file.document.bytes();
  }
}

/// A camera of a model that mrcal has.
CameraModel opencv_model(const std::string& id, int camera = 0) {
  if (id == "pinhole" || id == "radtan") return sample_model(id, camera);
  CameraModel model = *make_model(id);
  const CameraModel all = sample_model("opencv14", camera);
  for (const Parameter& each : model_info(model).parameters) {
    const ParameterId name(each);
    const bool is_tilt = name == ParameterId("tau_x") || name == ParameterId("tau_y");
    if (is_tilt) continue;
    EXPECT_TRUE(set_parameter(model, name, parameter(all, name).value()));
  }
  return model;
}

Rig opencv_rig(const std::string& id, bool two) {
  Rig rig = sample_rig("radtan", {two, false});
  for (std::size_t i = 0; i < rig.cameras.size(); ++i) rig.cameras[i].model = opencv_model(id, static_cast<int>(i));
  return rig;
}

void expect_parameters(const CameraModel& model, const std::vector<ParameterValue>& wanted) {
  for (const auto& [id, value] : wanted) EXPECT_EQ(parameter(model, id), value) << id.name();
}

TEST(Mrcal, CoefficientsStandInOpenCvsOrder) {
  const Camera four = calibration_of(good("camera-0.cameramodel"), "camera-0.cameramodel").rig.cameras.front();
  EXPECT_EQ(model_info(four.model).id, "radtan");
  EXPECT_EQ(four.image_size, (ImageSize{1280, 960}));
  expect_parameters(four.model, {{"fx", 812.25},
                                 {"fy", 811.5},
                                 {"cx", 639.75},
                                 {"cy", 482.125},
                                 {"k1", -0.2875},
                                 {"k2", 0.0825},
                                 {"p1", 0.00035},
                                 {"p2", -0.0001875},
                                 {"k3", 0.0}});
  const Camera five = calibration_of(good("camera-1.cameramodel"), "camera-1.cameramodel").rig.cameras.front();
  EXPECT_EQ(parameter(five.model, "k3"), -0.0145);
  const Camera twelve = calibration_of(good("opencv12-crlf.cameramodel"), "a.cameramodel").rig.cameras.front();
  EXPECT_EQ(model_info(twelve.model).id, "opencv14");
  expect_parameters(twelve.model, {{"k3", 0.00225},
                                   {"k4", 0.7325},
                                   {"k6", 0.00525},
                                   {"s1", 0.00115},
                                   {"s2", -0.000175},
                                   {"s3", -0.000625},
                                   {"s4", 0.0004375},
                                   {"tau_x", 0.0},
                                   {"tau_y", 0.0}});
  EXPECT_EQ(model_info(calibration_of(good("inputs.cameramodel"), "a.cameramodel").rig.cameras.front().model).id, "rational");
}

TEST(Mrcal, CamerasAreNamedByTheirFiles) {
  const auto name = [](const char* path) { return calibration_of(good("pinhole.cameramodel"), path).rig.cameras.front().name; };
  EXPECT_EQ(name("out/camera-3.cameramodel"), "cam3");
  EXPECT_EQ(name("cam1.opencv8.cameramodel"), "cam1");
  EXPECT_EQ(name("left.cameramodel"), "cam0");
}

// A quarter turn about y: the reference's x axis, to the right, is the camera's -z, behind it.
TEST(Mrcal, PosesTakePointsOfTheReferenceToTheCamera) {
  const Rig rig = calibration_of(good("old-keys.cameramodel"), "a.cameramodel").rig;
  const Transform* T = rig.stated("cam0", "ref");
  ASSERT_NE(T, nullptr);
  const std::array<double, 3> x = rotated(*T, {1.0, 0.0, 0.0});
  EXPECT_NEAR(x[0], 0.0, 1e-15);
  EXPECT_NEAR(x[2], -1.0, 1e-15);
  EXPECT_EQ(translation_of(*T), (std::array{-0.5, 0.0, 0.5}));
  // The camera sits where it sees the origin of its own frame: -R^T t.
  const std::optional<Transform> place = rig.resolve("ref", "cam0");
  ASSERT_TRUE(place);
  EXPECT_NEAR((*place)(0, 3), 0.5, 1e-15);
  EXPECT_NEAR((*place)(2, 3), 0.5, 1e-15);
}

TEST(Mrcal, FilesOfARigShareTheirReference) {
  Diagnostics diagnostics;
  const Rig rig =
      joined({{"camera-0.cameramodel", good("camera-0.cameramodel")}, {"camera-1.cameramodel", good("camera-1.cameramodel")}},
             diagnostics)
          .rig;
  ASSERT_EQ(rig.cameras.size(), 2U);
  const std::optional<Transform> T = rig.resolve("cam1", "cam0");
  ASSERT_TRUE(T);
  EXPECT_EQ(translation_of(*T), (std::array{-0.1525, 0.00225, -0.00475})) << "cam1 is to the right";
  EXPECT_TRUE(diagnostics.entries().empty());
}

// Each camera calibrated alone is at the origin of a reference of its own.
TEST(Mrcal, CamerasCalibratedAloneHaveNoPoseToEachOther) {
  Diagnostics diagnostics;
  const Rig rig =
      joined({{"camera-0.cameramodel", good("camera-0.cameramodel")}, {"camera-1.cameramodel", good("camera-0.cameramodel")}},
             diagnostics)
          .rig;
  EXPECT_FALSE(rig.resolve("cam1", "cam0"));
  ASSERT_EQ(diagnostics.entries().size(), 1U);
  EXPECT_EQ(id_of(diagnostics.entries().front()), "pose-unstated");
}

TEST(Mrcal, WhatIsWrittenComesBack) {
  for (const char* model : {"pinhole", "radtan", "rational", "opencv14"}) {
    SCOPED_TRACE(model);
    for (const bool two : {false, true}) {
      Rig rig = opencv_rig(model, two);
      for (Camera& camera : rig.cameras) camera.topic.clear();
      const Written written = fresh(rig);
      ASSERT_EQ(written.files.size(), rig.cameras.size());
      EXPECT_TRUE(written.losses.empty());
      EXPECT_TRUE(written.defaults.empty());
      expect_proven(written, rig);
      const Rig back = joined(written).rig;
      ASSERT_EQ(back.cameras.size(), rig.cameras.size());
      for (std::size_t i = 0; i < back.cameras.size(); ++i) {
        EXPECT_EQ(back.cameras[i].model, rig.cameras[i].model);
        EXPECT_EQ(back.cameras[i].image_size, rig.cameras[i].image_size);
      }
      if (!two) continue;
      const std::optional<Transform> T = back.resolve("cam1", "cam0");
      ASSERT_TRUE(T);
      EXPECT_LT(angle_between(*T, *rig.stated("cam1", "cam0")), 1e-7);
      EXPECT_LT(distance_between(*T, *rig.stated("cam1", "cam0")), 1e-12);
    }
  }
}

TEST(Mrcal, AFreshFileIsLaidOutAsMrcalsOwn) {
  Rig rig;
  rig.cameras.push_back({"left", ImageSize{640, 480}, model_of("pinhole", {500.5, 501.0, 319.5, 239.5}), {}, {}, ""});
  const Written written = fresh(rig);
  EXPECT_EQ(written.files.front().document.source().name, "left.cameramodel");
  EXPECT_EQ(written.files.front().document.bytes(),
            "{\n    'lensmodel': 'LENSMODEL_PINHOLE',\n\n    # fx fy cx cy and OpenCV's distortion coefficients\n"
            "    'intrinsics': [500.5, 501.0, 319.5, 239.5],\n\n"
            "    # rotation vector and translation of the reference in the camera\n"
            "    'rt_cam_ref': [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],\n"
            "    'extrinsics': [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],  # for mrcal before 2.5\n\n    'imagersize': [640, 480],\n}\n");
}

// Any rotation, near half a turn and near none, too.
TEST(Mrcal, RotationVectorsSayEveryRotation) {
  for (const double angle : {0.0, 1e-12, 1e-6, 0.3, 1.5, 3.0, std::numbers::pi - 1e-9, std::numbers::pi}) {
    for (const std::array<double, 3>& axis : {std::array{1.0, 0.0, 0.0}, {0.6, -0.8, 0.0}, {-0.48, 0.6, 0.64}}) {
      SCOPED_TRACE(angle);
      Rig rig = sample_rig("pinhole", {true, false});
      const double s = std::sin(0.5 * angle);
      rig.poses.front().T_a_b =
          pose_of(Quaternion{s * axis[0], s * axis[1], s * axis[2], std::cos(0.5 * angle)}, {0.1, 0.2, 0.3});
      const Written written = fresh(rig);
      expect_proven(written, rig);
      const std::optional<Transform> T = joined(written).rig.resolve("cam1", "cam0");
      ASSERT_TRUE(T);
      EXPECT_LT(largest_difference(*T, rig.poses.front().T_a_b).distance, 1e-14);
    }
  }
}

TEST(Mrcal, ThePoseOfAnImuIsLostAndSaid) {
  const Written written = fresh(sample_rig("radtan", {true, true}));
  EXPECT_TRUE(loses_anything_of(written, "imu0"));
  EXPECT_TRUE(joined(written).rig.resolve("cam1", "cam0"));
}

TEST(Mrcal, AnUnknownPoseBesideKnownOnesIsADefault) {
  Rig rig = sample_rig("radtan", {true, false});
  Camera alone = rig.cameras.front();
  alone.name = "alone";
  rig.cameras.push_back(alone);
  const Written written = fresh(rig);
  ASSERT_EQ(written.defaults.size(), 1U) << "the first camera is the reference";
  EXPECT_EQ(written.defaults.front().key, "alone extrinsics");
  EXPECT_TRUE(written.defaults.front().invented);
}

// Zeros in all files say as little as the input.
TEST(Mrcal, CamerasWithoutPosesAreEachAtItsOrigin) {
  Rig rig = sample_rig("radtan", {true, false});
  rig.poses.clear();
  const Written written = fresh(rig);
  EXPECT_TRUE(written.defaults.empty());
  EXPECT_FALSE(joined(written).rig.resolve("cam1", "cam0"));
}

TEST(Mrcal, AMirrorImageIsRefused) {
  Rig rig = sample_rig("radtan", {true, false});
  for (int row = 0; row < 3; ++row) rig.poses.front().T_a_b(row, 0) *= -1.0;
  Diagnostics diagnostics;
  EXPECT_FALSE(write_calibration(mrcal(), nullptr, rig, {}, diagnostics));
  EXPECT_EQ(diagnostics.entries().front().facts.code, Code::kPoseMirrors);
}

TEST(Mrcal, EditsChangeTheirNumbersAlone) {
  const std::string bytes = good("camera-1.cameramodel");
  const auto edited = [&bytes](const std::function<void(Rig&)>& change) {
    return with(bytes, change).files.front().document.bytes();
  };
  EXPECT_EQ(edited([](Rig&) {}), bytes);
  EXPECT_EQ(edited([](Rig& rig) { set_parameter(rig.cameras[0].model, "cx", 640.5); }), with_replaced(bytes, "642.5", "640.5"));
  EXPECT_EQ(edited([](Rig& rig) { rig.cameras[0].image_size = ImageSize{1280, 720}; }), with_replaced(bytes, "960", "720"));
  // Under both keys, and the rotation as it stands.
  std::string moved = bytes;
  for (std::size_t at = 0; (at = moved.find("-0.1525", at)) != std::string::npos;) moved.replace(at, 7, "-0.25");
  EXPECT_EQ(edited([](Rig& rig) { rig.poses[0].T_a_b(0, 3) = -0.25; }), moved);
  // k3 goes: the file's own lens has room for that.
  EXPECT_EQ(edited([](Rig& rig) { set_parameter(rig.cameras[0].model, "k3", 0.0); }), with_replaced(bytes, "-0.0145", "0.0"));
  const std::string four = good("camera-0.cameramodel");
  EXPECT_EQ(with(four, [](Rig& rig) { set_parameter(rig.cameras[0].model, "k3", 0.25); }).files.front().document.bytes(),
            with_replaced(with_replaced(four, "'LENSMODEL_OPENCV4'", "'LENSMODEL_OPENCV5'"),
                          "[ 812.25, 811.5, 639.75, 482.125, -0.2875, 0.0825, 0.00035, -0.0001875,]",
                          "[812.25, 811.5, 639.75, 482.125, -0.2875, 0.0825, 0.00035, -0.0001875, 0.25]"));
}

TEST(Mrcal, OldKeysKeepTheirNames) {
  const std::string bytes = good("old-keys.cameramodel");
  const Written written = with(bytes, [](Rig& rig) { rig.cameras[0].model = opencv_model("rational"); });
  const std::string edited = written.files.front().document.bytes();
  EXPECT_EQ(edited.find("{ 'distortion_model': 'LENSMODEL_OPENCV8', 'intrinsics': ["), 0U) << edited;
  EXPECT_EQ(calibration_of(edited, "a.cameramodel").rig.cameras.front().model, opencv_model("rational"));
}

// The bytes of the blob stay, whatever they look like; of another lens they are stale.
TEST(Mrcal, OptimizationInputsStayAndAreToldStale) {
  const std::string bytes = good("inputs.cameramodel");
  const Rig rig = calibration_of(bytes, "a.cameramodel").rig;
  const ExtraField* inputs = rig.find_extra_field("cam0", "optimization_inputs");
  ASSERT_NE(inputs, nullptr);
  EXPECT_EQ(inputs->value, "65 characters");
  const Written lens = with(bytes, [](Rig& r) { set_parameter(r.cameras[0].model, "fx", 2050.0); });
  EXPECT_EQ(lens.files.front().document.bytes(), with_replaced(bytes, "2048.5", "2050.0"));
  EXPECT_TRUE(loses(lens, Code::kMrcalStale, {"optimization_inputs"}));
  EXPECT_TRUE(loses(lens, Code::kMrcalStale, {"valid_intrinsics_region"}));
  const Written moved = with(bytes, [](Rig& r) { r.poses[0].T_a_b(2, 3) = -4.0; });
  EXPECT_EQ(moved.files.front().document.bytes(), with_replaced(bytes, "-3., ]", "-4.0, ]"));
  EXPECT_TRUE(moved.losses.empty());
  // In another file they are lost.
  EXPECT_TRUE(loses_anything_of(fresh(rig), "optimization_inputs"));
}

consumers::ConsumerView said_by_mrcal(const std::string& bytes) { return consumers::find_consumer("mrcal")->load(bytes, {}); }

TEST(Mrcal, TheProgramReadsAsPythonDoes) {
  const std::string bytes = good("camera-1.cameramodel");
  EXPECT_TRUE(said_by_mrcal(bytes).loads());
  EXPECT_TRUE(said_by_mrcal(bytes).warnings.empty());
  // After the first line a blank before the root means something.
  EXPECT_FALSE(said_by_mrcal("# c\n  " + bytes.substr(bytes.find('{'))).loads());
  EXPECT_TRUE(said_by_mrcal("  " + bytes.substr(bytes.find('{'))).loads());
  EXPECT_FALSE(said_by_mrcal("\xEF\xBB\xBF" + bytes).loads());
  EXPECT_FALSE(said_by_mrcal(with_replaced(bytes, "815.5", "0815")).loads());
  EXPECT_TRUE(said_by_mrcal(with_replaced(bytes, "815.5", "8_15.5e0")).loads());
  EXPECT_EQ(said_by_mrcal(with_replaced(bytes, "815.5", "0x10")).cameras.at(0).project({1.0, 0.0, 1.0}).has_value(), true);
  EXPECT_FALSE(said_by_mrcal(with_replaced(bytes, "815.5", "nan")).loads());
  EXPECT_FALSE(said_by_mrcal(with_replaced(bytes, "815.5", "8 15")).loads());
  EXPECT_FALSE(said_by_mrcal(bytes + "x").loads());
  EXPECT_FALSE(said_by_mrcal(bytes.substr(0, bytes.size() / 2)).loads());
  EXPECT_FALSE(said_by_mrcal(std::string(1000, '[')).loads());
}

// mrcal.project of Debian's 2.2: a point from behind has its mirror image's pixel, one at z = 0 is not a number.
TEST(Mrcal, TheProgramMirrorsWhatIsBehind) {
  const consumers::ConsumerView view = said_by_mrcal(good("pinhole.cameramodel"));
  ASSERT_EQ(view.cameras.size(), 1U);
  const auto behind = view.cameras.front().project({0.1, 0.2, -1.0});
  ASSERT_TRUE(behind);
  EXPECT_NEAR((*behind)[0], 1508.625 - 240.575, 1e-9);
  EXPECT_FALSE(view.cameras.front().project({0.1, 0.2, 0.0}));
}

TEST(Mrcal, WhatTheVersionsSayOfPoses) {
  const std::string bytes = good("camera-1.cameramodel");
  const std::size_t old_key = bytes.find("    'extrinsics'");
  const std::string only_new = bytes.substr(0, old_key) + bytes.substr(bytes.find('\n', old_key) + 1);
  const consumers::ConsumerView view = said_by_mrcal(only_new);
  EXPECT_TRUE(view.loads());
  ASSERT_EQ(view.warnings.size(), 1U);
  EXPECT_EQ(view.warnings.front().facts.code, Code::kMrcalSaysOnlyNewPose);
  // What it skips, or stops at since 2.5, is a warning.
  const auto warning = [&bytes](const std::string& entry) {
    const consumers::ConsumerView said = said_by_mrcal(with_replaced(bytes, "    'imagersize'", entry + ",\n    'imagersize'"));
    EXPECT_TRUE(said.loads());
    return said.warnings.size() == 1 ? said.warnings.front().facts.code : Code::kNone;
  };
  EXPECT_EQ(warning("'icam_intrinsics': 0"), Code::kMrcalSaysNumberWithoutInputs);
  EXPECT_EQ(warning("'valid_intrinsics_region': [[0, 0], [9, 0], [9, 9], [0, 9]]"), Code::kMrcalSaysRegion);
  EXPECT_EQ(warning("'valid_intrinsics_region': [[0, 0], [9, 0], [9, 9], [0, 0]]"), Code::kNone);
  const std::string differ = bytes.substr(0, old_key) + with_replaced(bytes.substr(old_key), "0.00225", "0.00235");
  ASSERT_EQ(said_by_mrcal(differ).refusals.size(), 1U);
  EXPECT_EQ(said_by_mrcal(differ).refusals.front().facts.code, Code::kMrcalSaysPosesDiffer);
}

TEST(Mrcal, ReadsTheCorpus) {
  const std::vector<fs::path> files = corpus_files_of("mrcal");
  if (files.empty()) GTEST_SKIP() << "no corpus in '" FCA_SHARED_DIR "'";
  for (const fs::path& path : files) {
    SCOPED_TRACE(path.filename().string());
    const std::string bytes = read_file(path);
    Parsed parsed = parse(bytes, path.filename().string());
    ASSERT_TRUE(parsed.document) << parsed.rendered();
    const std::optional<Calibration> calibration = read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics);
    ASSERT_TRUE(calibration) << parsed.rendered();
    EXPECT_EQ(calibration->format->id, "mrcal");
    EXPECT_EQ(calibration->rig.cameras.front().rays.empty(), bytes.find("LENSMODEL_SPLINED") == std::string::npos);
    EXPECT_EQ(with(bytes, [](Rig&) {}).files.front().document.bytes(), bytes);
  }
}

}  // namespace
}  // namespace fca::test
