// SPDX-License-Identifier: BSD-3-Clause
// Camchains written from rigs: our reader gives back the same doubles, Kalibr loads them and understands the same.
#include "formats/rigs.h"
#include "formats/test_files.h"
#include "pyyaml.h"

#include <fca/formats/proof.h>
#include <fca/formats/wording.h>

namespace fca::test {
namespace {

const Format& kalibr() { return *find_format("kalibr"); }

Written write(const Rig& rig) {
  Diagnostics diagnostics;
  std::optional<Written> written = kalibr().write(nullptr, rig, {}, diagnostics);
  EXPECT_TRUE(written) << (diagnostics.entries().empty() ? "" : message_of(diagnostics.entries().front()));
  return written ? *std::move(written) : Written();
}

std::string chain_of(const Written& written) { return written.files.empty() ? "" : written.files.front().document.bytes(); }

const std::vector<std::string> kModels = {"radtan", "kb4", "mei", "eucm", "ds", "fov"};
constexpr RigShape kShapes[] = {{false, false}, {false, true}, {true, false}, {true, true}};

TEST(KalibrWrite, EveryModelIsStored) {
  for (const StoredModel& row : kalibr().models)
    EXPECT_FALSE(parameter_values(sample_model(std::string(row.model))).empty()) << row.model;
  EXPECT_GE(kalibr().models.size(), 8U);
}

TEST(KalibrWrite, ReadsBackBitEqual) {
  for (const std::string& model : kModels) {
    for (const RigShape shape : kShapes) {
      Rig rig = sample_rig(model, shape);
      for (Camera& camera : rig.cameras) camera.time_offset_s = -0.0021 * (camera.name == "cam0" ? 1.0 : 2.0);
      const std::string bytes = chain_of(write(rig));
      SCOPED_TRACE(bytes);
      const Rig back = calibration_of(bytes).rig;
      EXPECT_TRUE(back.cameras == rig.cameras);
      if (shape.two) {
        EXPECT_EQ(back.resolve("cam1", "cam0"), rig.resolve("cam1", "cam0"));
      }
      if (shape.imu) {
        EXPECT_EQ(back.resolve("cam0", "imu0"), rig.resolve("cam0", "imu0"));
      }
      EXPECT_EQ(back.poses.empty(), rig.poses.empty());
    }
  }
}

// ucm is written as eucm with beta = 1, pinhole as radtan with zeros: other names, the same pixels.
TEST(KalibrWrite, ModelsKalibrHasNotAreWrittenAsTheirEquals) {
  for (const auto& [model, stored] : {std::pair{"ucm", "eucm"}, std::pair{"pinhole", "radtan"}}) {
    const Rig rig = sample_rig(model, {true, false});
    const Rig back = calibration_of(chain_of(write(rig))).rig;
    ASSERT_EQ(back.cameras.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(model_info(back.cameras[i].model).id, stored);
      for (const Ray& ray : {Ray{0.1, 0.2, 1.0}, Ray{-0.5, 0.3, 1.0}, Ray{0.0, 0.0, 1.0}}) {
        const std::optional<Pixel> theirs = project(back.cameras[i].model, ray);
        const std::optional<Pixel> ours = project(rig.cameras[i].model, ray);
        ASSERT_TRUE(ours && theirs);
        EXPECT_NEAR((*ours)[0], (*theirs)[0], 1e-10);
        EXPECT_NEAR((*ours)[1], (*theirs)[1], 1e-10);
      }
    }
  }
}

TEST(KalibrWrite, KalibrLoadsItAndAgrees) {
  for (const StoredModel& row : kalibr().models) {
    for (const RigShape shape : kShapes) {
      const Rig rig = sample_rig(std::string(row.model), shape);
      const Written written = write(rig);
      EXPECT_EQ(written.files.front().programs, std::vector<std::string>{"kalibr"});
      const ProofResult proof = prove(*consumers::find_consumer("kalibr"), chain_of(written), {}, rig);
      EXPECT_TRUE(proof.loads) << row.model << ": " << (proof.refusals.empty() ? "" : sentence_of(proof.refusals.front()));
      EXPECT_TRUE(proof.agrees()) << row.model << ": " << proof.max_diff_px << " px, poses " << proof.max_diff_pose;
      // FovDistortion.hpp replaces atan by its argument for r^2 < 1e-5: (2 tan(w/2) r)^3 f / (3 w) = 3e-6 px of Kalibr's own
      // error.
      EXPECT_LE(proof.max_diff_px, row.model == "fov" ? 3e-6 : 1e-9) << row.model;
      EXPECT_GT(proof.compared_share, 0.5) << row.model;
    }
  }
}

// ConfigReader.py: fu, fv, pu, pv and the time shift are Python floats, the resolution ints (FORMATS.md 1.1).
TEST(KalibrWrite, WholeNumbersStayFloats) {
  Rig rig = sample_rig("kb4", {true, true});
  for (Camera& camera : rig.cameras) {
    for (double& value : parameter_values(camera.model)) value = std::round(value);
    camera.time_offset_s = 0.0;
  }
  rig.poses.front().T_a_b = Transform{};
  const std::string bytes = chain_of(write(rig));
  const consumers::pyyaml::Loaded loaded = consumers::pyyaml::safe_load(bytes);
  ASSERT_TRUE(loaded.root) << text::text_of(loaded.error);
  const auto expect_floats = [](const consumers::pyyaml::Value* list) {
    ASSERT_NE(list, nullptr);
    for (const auto& item : list->items) {
      if (item->kind == consumers::pyyaml::Kind::kList) {
        for (const auto& number : item->items) EXPECT_EQ(number->kind, consumers::pyyaml::Kind::kFloat) << number->text;
      } else {
        EXPECT_EQ(item->kind, consumers::pyyaml::Kind::kFloat) << item->text;
      }
    }
  };
  for (const char* name : {"cam0", "cam1"}) {
    const consumers::pyyaml::Value* camera = loaded.root->find(name);
    ASSERT_NE(camera, nullptr);
    expect_floats(camera->find("intrinsics"));
    expect_floats(camera->find("distortion_coeffs"));
    expect_floats(camera->find("T_cam_imu"));
    EXPECT_EQ(camera->find("timeshift_cam_imu")->kind, consumers::pyyaml::Kind::kFloat);
    EXPECT_EQ(camera->find("rostopic")->kind, consumers::pyyaml::Kind::kString);
    for (const auto& side : camera->find("resolution")->items) EXPECT_EQ(side->kind, consumers::pyyaml::Kind::kInt);
  }
}

// "The number of cameras is the number of top-level keys": nothing else may stand there.
TEST(KalibrWrite, TheRootHoldsCamerasOnly) {
  Rig rig = sample_rig("ds", {true, true});
  rig.cameras[0].name = "left";
  rig.cameras[1].name = "right";
  for (PoseEdge& edge : rig.poses) {
    for (std::string* end : {&edge.a, &edge.b}) {
      if (*end == "cam0") *end = "left";
      if (*end == "cam1") *end = "right";
    }
  }
  const text::Document document = document_of(chain_of(write(rig)));
  std::vector<std::string> keys;
  for (const text::Entry& entry : document.root().entries) keys.push_back(entry.key.value);
  EXPECT_EQ(keys, (std::vector<std::string>{"cam0", "cam1"}));
  const Rig back = calibration_of(document.bytes()).rig;
  EXPECT_EQ(back.resolve("cam1", "cam0"), T_cam1_cam0());
  EXPECT_EQ(back.resolve("cam0", "imu0"), T_cam0_imu());
}

// T_cam_imu of every camera, also where only the chain says it; the two statements agree.
TEST(KalibrWrite, PosesOfAllCamerasAgree) {
  const std::string bytes = chain_of(write(sample_rig("kb4", {true, true})));
  const Rig back = calibration_of(bytes).rig;
  ASSERT_NE(back.stated("cam0", "imu0"), nullptr);
  ASSERT_NE(back.stated("cam1", "imu0"), nullptr);
  ASSERT_NE(back.stated("cam1", "cam0"), nullptr);
  EXPECT_LE(element_difference(*back.stated("cam1", "imu0"), T_cam1_cam0() * T_cam0_imu()), 1e-15);
}

TEST(KalibrWrite, PosesStatedTheOtherWayRoundAreInverted) {
  Rig rig = sample_rig("kb4", {true, true});
  for (PoseEdge& edge : rig.poses) {
    std::swap(edge.a, edge.b);
    edge.T_a_b = inverse(edge.T_a_b).value();
  }
  const Rig back = calibration_of(chain_of(write(rig))).rig;
  EXPECT_LE(element_difference(back.resolve("cam1", "cam0").value(), T_cam1_cam0()), 1e-12);
  EXPECT_LE(element_difference(back.resolve("cam0", "imu0").value(), T_cam0_imu()), 1e-12);
}

TEST(KalibrWrite, TheImuGoesToItsOwnFile) {
  const Written written = write(sample_rig("kb4", {true, true}));
  ASSERT_EQ(written.files.size(), 2U);
  const std::string bytes = written.files[1].document.bytes();
  EXPECT_TRUE(consumers::find_consumer("kalibr-imu")->load(bytes, {}).loads()) << bytes;
  const Rig back = calibration_of(bytes).rig;
  ASSERT_EQ(back.imus.size(), 1U);
  EXPECT_EQ(back.imus.front(), tumvi_imu());
}

TEST(KalibrWrite, OddTopicsSurvive) {
  for (const char* topic : {"/cam0/image_raw", "cam0", "/a b", "a: b # c", "true", "1.5", "it's \"quoted\"", "back\\slash",
                            "/c\xC3\xA4m", "- x", "null", "/x:y"}) {
    Rig rig = sample_rig("kb4", {false, false});
    rig.cameras[0].topic = topic;
    const std::string bytes = chain_of(write(rig));
    EXPECT_EQ(calibration_of(bytes).rig.cameras.at(0).topic, topic);
    const consumers::pyyaml::Loaded loaded = consumers::pyyaml::safe_load(bytes);
    ASSERT_TRUE(loaded.root) << topic << text::text_of(loaded.error);
    EXPECT_EQ(loaded.root->find("cam0")->find("rostopic")->kind, consumers::pyyaml::Kind::kString) << topic;
  }
}

TEST(KalibrWrite, WhatItCannotHoldIsALossOrAnError) {
  Rig rig = sample_rig("kb4", {false, false});
  rig.cameras[0].frame_rate_hz = 20.0;
  rig.baseline_m = 0.1;
  const Written written = write(rig);
  const auto has = [&written](const std::string& code) {
    return std::ranges::any_of(written.losses, [&code](const Loss& loss) { return id_of(loss) == code; });
  };
  EXPECT_TRUE(has("frame-rate-dropped"));
  EXPECT_TRUE(has("baseline-dropped"));

  rig.cameras[0].image_size.reset();
  Diagnostics diagnostics;
  EXPECT_FALSE(kalibr().write(nullptr, rig, {}, diagnostics));
  EXPECT_EQ(id_of(diagnostics.entries().at(0)), "image-size-missing");
  Diagnostics without;
  EXPECT_FALSE(kalibr().write(nullptr, Rig(), {}, without));
  EXPECT_EQ(id_of(without.entries().at(0)), "no-camera");
}

// Kalibr's radtan has no k3 (FORMATS.md 1.1): a camera with one is not silently written without.
TEST(KalibrWrite, ARadtanWithK3IsNotCutShort) {
  Rig rig = sample_rig("radtan", {false, false});
  ASSERT_TRUE(set_parameter(rig.cameras[0].model, "k3", 0.01));
  EXPECT_FALSE(within(rig.cameras[0].model, find_stored_model(kalibr(), "radtan", true)->ranges)) << "the caller is to fit it";
  // The writer is the last guard: a k3 it would drop is refused.
  Diagnostics diagnostics;
  EXPECT_FALSE(kalibr().write(nullptr, rig, {}, diagnostics));
  EXPECT_TRUE(diagnostics.has_errors());
}

}  // namespace
}  // namespace fca::test
