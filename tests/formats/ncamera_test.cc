// SPDX-License-Identifier: BSD-3-Clause
// ncamera files of SVO and maplab: what their numbers mean, what is written comes back and starts the program, edits keep every
// other byte, and the corpus' files are read with the values that a person reads in them.
#include "formats/lost_facts.h"
#include "formats/oracle_table.h"
#include "formats/rigs.h"

#include <fca/code.h>
#include <fca/formats/proof.h>
#include <fca/rig/rotation.h>

#include <array>
#include <functional>
#include <set>

namespace fca::test {
namespace {

const Format& ncamera() { return *find_format("ncamera"); }
std::string good(const std::string& file) { return read_file(testdata_dir() / "ncamera" / "good" / file); }

/// Does each program load the file and mean the same?
void expect_proven(const Written& written, const Rig& rig) {
  for (const Written::File& file : written.files) {
    for (const std::string& id : file.programs) {
      const consumers::Consumer* program = consumers::find_consumer(id);
      ASSERT_NE(program, nullptr) << id;
      const ProofResult proof = prove(*program, file.document.bytes(), {}, rig, file.cameras, 0.9);
      EXPECT_TRUE(proof.agrees()) << id << ": " << (proof.loads ? "other numbers" : "refused") << "\n" << file.document.bytes();
    }
  }
}

Written edited(const std::string& file, const std::function<void(Rig&)>& change) {
  const Calibration calibration = calibration_of(good(file));
  Rig rig = calibration.rig;
  change(rig);
  Written written = written_by(ncamera(), &calibration.documents.front(), rig);
  expect_proven(written, rig);
  return written;
}

// p_body = T_B_C p_camera: a point 2 m before the camera is where this says, worked out by hand.
TEST(Ncamera, PosesTakePointsOfTheCameraToTheBody) {
  const Rig rig = calibration_of(good("pair.yaml")).rig;
  const Transform* pose = rig.stated("imu0", "left");
  ASSERT_NE(pose, nullptr);
  EXPECT_NEAR((*pose)(0, 2) * 2.0 + (*pose)(0, 3), -1.966806472466, 1e-12);
  EXPECT_NEAR((*pose)(1, 2) * 2.0 + (*pose)(1, 3), -0.076939253197, 1e-12);
  EXPECT_NEAR((*pose)(2, 2) * 2.0 + (*pose)(2, 3), -0.0650218473222, 1e-12);
}

// p_camera = T_C_B p_body: the camera is at -R^T t of the body, here (-0.25, -0.0125, -0.5).
TEST(Ncamera, APoseMayTakePointsOfTheBodyToTheCamera) {
  const Rig rig = calibration_of(good("unified.yaml")).rig;
  ASSERT_NE(rig.stated("cam1", "imu0"), nullptr);
  const std::optional<Transform> pose = rig.resolve("imu0", "cam1");
  ASSERT_TRUE(pose);
  EXPECT_EQ(translation_of(*pose), (std::array{-0.25, -0.0125, -0.5}));
}

// t_imu = t_cam - delay_imu_cam.
TEST(Ncamera, ADelayIsATimeOffsetTurnedRound) {
  for (const Camera& camera : calibration_of(good("pair.yaml")).rig.cameras) EXPECT_EQ(camera.time_offset_s, 0.0025);
  Rig rig = sample_rig("radtan", {.two = true, .imu = true});
  for (Camera& camera : rig.cameras) camera.time_offset_s = 0.0125;
  EXPECT_NE(written_by(ncamera(), nullptr, rig).files.front().document.bytes().find("  delay_imu_cam: -0.0125\n"),
            std::string::npos);
}

TEST(Ncamera, NoiseIsDensitiesInSiUnits) {
  EXPECT_EQ(calibration_of(good("pair.yaml")).rig.imus.front(), (Imu{"imu0", 2.25e-4, 2.5e-6, 3.125e-3, 1.5e-4, 250.0, ""}));
  EXPECT_EQ(calibration_of(good("sensors.yaml")).rig.imus.front(),
            (Imu{"imu0", 2.25e-4, 2.5e-6, 3.125e-3, 1.5e-4, std::nullopt, "/imu0"}));
}

// "fisheye" is no fisheye of OpenCV's.
TEST(Ncamera, FisheyeIsTheFovModel) {
  const Rig rig = calibration_of(good("every.yaml")).rig;
  EXPECT_EQ(model_info(rig.cameras[0].model).id, "pinhole");
  EXPECT_EQ(model_info(rig.cameras[1].model).id, "fov");
  EXPECT_EQ(parameter(rig.cameras[1].model, "w"), 0.9325);
}

TEST(Ncamera, UnifiedProjectionsBeginWithXi) {
  const Rig rig = calibration_of(good("unified.yaml")).rig;
  EXPECT_EQ(model_info(rig.cameras[0].model).id, "mei");
  EXPECT_EQ(parameter(rig.cameras[0].model, "xi"), 1.5);
  EXPECT_EQ(parameter(rig.cameras[0].model, "fx"), 731.25);
  EXPECT_EQ(parameter(rig.cameras[0].model, "cy"), 239.25);
  EXPECT_EQ(rig.cameras[1].topic, "/cam1/image_raw");
  const ExtraField* delay = rig.find_extra_field("cam0", "line-delay-nanoseconds");
  ASSERT_NE(delay, nullptr);
  EXPECT_EQ(delay->value, "29000");
}

// SVO's 24 numbers are an OCamCalib camera as it is: a0 .. a4, column and row of the centre, c, d, e.
TEST(Ncamera, OmniIsOcamcalib) {
  const Rig rig = calibration_of(good("omni.yaml")).rig;
  const CameraModel& model = rig.cameras[0].model;
  EXPECT_EQ(model_info(model).id, "ocamcalib");
  EXPECT_EQ(parameter(model, "a0"), -206.5);
  EXPECT_EQ(parameter(model, "a4"), 1.875e-08);
  EXPECT_EQ(parameter(model, "cx"), 394.5);
  EXPECT_EQ(parameter(model, "c"), 1.00025);
  EXPECT_EQ(parameter(model, "e"), 0.000125);
  const ExtraField* inverse = rig.find_extra_field("cam0", "inverse polynomial");
  ASSERT_NE(inverse, nullptr);
  EXPECT_TRUE(inverse->value.starts_with("294.070745198 151.846069706 ")) << inverse->value;
}

CameraModel model_for(std::string_view id) {
  return id == "ocamcalib" ? calibration_of(good("omni.yaml")).rig.cameras[0].model : sample_model(std::string(id));
}

TEST(Ncamera, EveryModelComesBackAndStartsTheProgram) {
  for (const StoredModel& stored : ncamera().models) {
    SCOPED_TRACE(stored.model);
    Rig rig = sample_rig("radtan", {.two = true, .imu = true});
    for (Camera& camera : rig.cameras) camera.model = model_for(stored.model);
    const Written written = written_by(ncamera(), nullptr, rig);
    ASSERT_EQ(written.files.size(), 1U);
    const Calibration back = calibration_of(written.files.front().document.bytes());
    EXPECT_EQ(back.format->id, "ncamera");
    ASSERT_EQ(back.rig.cameras.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(back.rig.cameras[i].model, rig.cameras[i].model);
      EXPECT_EQ(back.rig.cameras[i].name, rig.cameras[i].name);
      EXPECT_EQ(back.rig.cameras[i].image_size, rig.cameras[i].image_size);
    }
    const std::optional<Transform> pose = back.rig.resolve("cam1", "cam0");
    ASSERT_TRUE(pose);
    EXPECT_LT(element_difference(*pose, T_cam1_cam0()), 1e-12);
    expect_proven(written, rig);
    EXPECT_EQ(written.files.front().programs, std::vector<std::string>{stored.model == "mei" ? "maplab" : "svo"});
  }
}

// maplab reads what SVO reads, and tells sensors apart by ids that are always the same.
TEST(Ncamera, MaplabReadsTheFileToo) {
  const Rig rig = sample_rig("kb4", {.two = true, .imu = true});
  const std::string bytes = written_by(ncamera(), nullptr, rig).files.front().document.bytes();
  EXPECT_EQ(written_by(ncamera(), nullptr, rig).files.front().document.bytes(), bytes);
  const std::vector<std::string> names = {"cam0", "cam1"};
  EXPECT_TRUE(prove(*consumers::find_consumer("maplab"), bytes, {}, rig, names, 0.9).agrees()) << bytes;
}

TEST(Ncamera, WhatNothingStatesIsMadeUpAndSaid) {
  const Written written = written_by(ncamera(), nullptr, sample_rig("radtan", {.two = false, .imu = false}));
  std::set<std::string> keys;
  for (const DefaultedValue& value : written.defaults) keys.insert(value.key);
  EXPECT_EQ(keys, (std::set<std::string>{"label", "id", "cam0 id", "cam0 T_B_C"}));
  EXPECT_EQ(written.files.front().document.bytes().find("imu_params"), std::string::npos);
}

// The first twelve numbers of another lens' inverse polynomial are not its own.
TEST(Ncamera, AnotherOmniLensHasAnotherInverse) {
  const Written written = edited("omni.yaml", [](Rig& rig) { set_parameter(rig.cameras[0].model, "a0", -216.5); });
  const Rig back = calibration_of(written.files.front().document.bytes()).rig;
  EXPECT_EQ(parameter(back.cameras[0].model, "a0"), -216.5);
  EXPECT_FALSE(back.find_extra_field("cam0", "inverse polynomial")->value.starts_with("294.070745198"));
}

TEST(Ncamera, IdsAndTuningAreKept) {
  const Calibration calibration = calibration_of(good("pair.yaml"));
  WriteOptions options;
  options.rewrite = true;
  Diagnostics diagnostics;
  const std::optional<Written> written =
      write_calibration(ncamera(), &calibration.documents.front(), calibration.rig, options, diagnostics);
  ASSERT_TRUE(written);
  const std::string bytes = written->files.front().document.bytes();
  for (const char* line : {"label: \"Bench\"\n", "    id: 5a1d0f3c9b7e42688d1c0a5be3f79c01\n", "  omega_max: 17\n",
                           "  velocity_sigma: 2.0\n", "  imu_rate: 250.0\n", "    label: \"right\"\n"})
    EXPECT_NE(bytes.find(line), std::string::npos) << line << bytes;
  EXPECT_FALSE(loses_anything_of(*written, "svo."));
  for (const DefaultedValue& value : written->defaults) ADD_FAILURE() << value.key;
  expect_proven(*written, calibration.rig);
}

/// Where two texts differ: from the first byte on, up to the last.
std::pair<std::string, std::string> difference(const std::string& a, const std::string& b) {
  std::size_t begin = 0;
  while (begin < std::min(a.size(), b.size()) && a[begin] == b[begin]) ++begin;
  std::size_t end = 0;
  while (end < std::min(a.size(), b.size()) - begin && a[a.size() - 1 - end] == b[b.size() - 1 - end]) ++end;
  return {a.substr(begin, a.size() - begin - end), b.substr(begin, b.size() - begin - end)};
}

TEST(Ncamera, AnEditChangesOneNumberAndNoOtherByte) {
  using Pair = std::pair<std::string, std::string>;
  const auto changed = [](const std::string& file, const std::function<void(Rig&)>& change) {
    return difference(good(file), edited(file, change).files.front().document.bytes());
  };
  for (const char* file : {"pair.yaml", "pair-crlf.yaml"}) {
    EXPECT_EQ(changed(file, [](Rig& rig) { set_parameter(rig.cameras[0].model, "fx", 521.375); }), Pair("4", "5"));
    EXPECT_EQ(changed(file, [](Rig& rig) { rig.poses[0].T_a_b(0, 3) = 0.0412; }), Pair("3", "4"));
    EXPECT_EQ(changed(file, [](Rig& rig) { rig.cameras[0].image_size->width = 740; }), Pair("6", "7"));
    EXPECT_EQ(changed(file, [](Rig& rig) { rig.imus[0].rate_hz = 450.0; }), Pair("25", "450."));
    EXPECT_EQ(changed(file,
                      [](Rig& rig) {
                        for (Camera& camera : rig.cameras) camera.time_offset_s = 0.0035;
                      }),
              Pair("2", "3"));
  }
  EXPECT_EQ(changed("sensors.yaml", [](Rig& rig) { set_parameter(rig.cameras[1].model, "fx", 522.375); }), Pair("4", "5"));
  EXPECT_EQ(changed("sensors.yaml", [](Rig& rig) { rig.imus[0].accelerometer_noise_density = 4.125e-3; }),
            Pair("3.125e-3", "0.004125"));
  EXPECT_EQ(changed("single.yaml", [](Rig& rig) { set_parameter(rig.cameras[0].model, "fx", 521.375); }), Pair("4", "5"));
  EXPECT_EQ(changed("unified.yaml", [](Rig& rig) { set_parameter(rig.cameras[0].model, "xi", 1.75); }), Pair("", "7"));
  EXPECT_EQ(changed("unified.yaml", [](Rig& rig) { rig.poses[1].T_a_b(2, 3) = 0.75; }), Pair("", "7"));
}

TEST(Ncamera, AnotherLensIsNamed) {
  for (const char* file : {"pair.yaml", "every.yaml", "unified.yaml", "sensors.yaml", "single.yaml", "omni.yaml"}) {
    for (const char* model : {"kb4", "radtan", "fov", "pinhole", "mei", "ocamcalib"}) {
      SCOPED_TRACE(std::string(file) + " " + model);
      const Calibration calibration = calibration_of(good(file));
      Rig rig = calibration.rig;
      rig.cameras.back().model = model_for(model);
      const Written written = written_by(ncamera(), &calibration.documents.front(), rig);
      const Calibration back = calibration_of(written.files.front().document.bytes());
      ASSERT_EQ(back.rig.cameras.size(), rig.cameras.size());
      EXPECT_EQ(back.rig.cameras.back().model, rig.cameras.back().model) << written.files.front().document.bytes();
    }
  }
}

// maplab's NCAMERA need not sit where its IMU does: T_B_S takes its points to the IMU.
TEST(Ncamera, TheCamerasOfAListHaveABodyOfTheirOwn) {
  const Rig rig = calibration_of(good("sensors-apart.yaml")).rig;
  const Rig same = calibration_of(good("sensors.yaml")).rig;
  const Transform* body = rig.stated("imu0", "ncamera");
  ASSERT_NE(body, nullptr);
  EXPECT_EQ((*body)(0, 1), -1.0);
  const std::optional<Transform> apart = rig.resolve("imu0", "cam0");
  ASSERT_TRUE(apart);
  EXPECT_LT(element_difference(*apart, *body * *same.stated("imu0", "cam0")), 1e-15);
  // An edit of a pose in the IMU stands in the file as one in the body.
  const Written written = edited("sensors-apart.yaml", [](Rig& changed) {
    for (PoseEdge& pose : changed.poses) {
      if (pose.b == "cam1") pose.T_a_b(1, 3) = 0.0206;
    }
  });
  EXPECT_EQ(difference(good("sensors-apart.yaml"), written.files.front().document.bytes()),
            (std::pair<std::string, std::string>("1", "2")));
}

// vikit's older files: plain keys under the camera's name, and a pose as a quaternion. They are read, not edited.
TEST(Ncamera, OlderFilesAreRead) {
  const std::string bytes =
      "front:\n  cam_model: PinholeAtan\n  cam_width: 752\n  cam_height: 480\n  cam_fx: 383.0\n  cam_fy: 382.375\n"
      "  cam_cx: 344.75\n  cam_cy: 244.375\n  cam_d0: 0.9325\n  T_cam_body:\n    tx: 0.5\n    ty: 0.25\n    tz: -0.125\n"
      "    qx: 0.0\n    qy: 0.0\n    qz: 1.0\n    qw: 0.0\n";
  const Calibration calibration = calibration_of(bytes);
  EXPECT_EQ(calibration.format->id, "ncamera");
  ASSERT_EQ(calibration.rig.cameras.size(), 1U);
  EXPECT_EQ(calibration.rig.cameras[0].name, "front");
  EXPECT_EQ(calibration.rig.cameras[0].model, model_of("fov", {383.0, 382.375, 344.75, 244.375, 0.9325}));
  const std::optional<Transform> pose = calibration.rig.resolve("imu0", "front");
  ASSERT_TRUE(pose);
  EXPECT_NEAR((*pose)(0, 3), 0.5, 1e-15) << "half a turn about z";
  EXPECT_NEAR((*pose)(2, 3), 0.125, 1e-15);
  const text::Document base = document_of(bytes);
  EXPECT_EQ(written_by(ncamera(), &base, calibration.rig).files.front().document.bytes(), bytes);
  Rig moved = calibration.rig;
  set_parameter(moved.cameras[0].model, "fx", 384.0);
  const Written written = written_by(ncamera(), &base, moved);
  EXPECT_TRUE(written.files.front().document.bytes().starts_with("label: "));
  expect_proven(written, moved);
}

// Two cameras are not called the same.
TEST(Ncamera, ALabelThatIsTakenNamesNoCamera) {
  const Rig rig = calibration_of(with_replaced(good("pair.yaml"), "label: right", "label: left")).rig;
  EXPECT_EQ(rig.cameras[0].name, "left");
  EXPECT_EQ(rig.cameras[1].name, "cam1");
  EXPECT_NE(rig.find_extra_field("cam1", "label"), nullptr);
}

TEST(Ncamera, OtherSensorsAreKept) {
  const Rig rig = calibration_of(good("sensors.yaml")).rig;
  EXPECT_NE(rig.find_extra_field("", "LIDAR 5a1d0f3c9b7e42688d1c0a5be3f79c06"), nullptr);
}

// A file without the section gets it, with what SVO wants besides the noise.
TEST(Ncamera, AnImuIsAddedToAFileWithout) {
  const Written written = edited("every.yaml", [](Rig& rig) {
    rig.imus.push_back(Imu{"imu0", 2.25e-4, 2.5e-6, 3.125e-3, 1.5e-4, 250.0, ""});
  });
  const std::string bytes = written.files.front().document.bytes();
  EXPECT_TRUE(bytes.starts_with(good("every.yaml"))) << bytes;
  EXPECT_EQ(calibration_of(bytes).rig.imus.front(), (Imu{"imu0", 2.25e-4, 2.5e-6, 3.125e-3, 1.5e-4, 250.0, ""}));
}

/// What a person reads in a file of the corpus.
struct Expected {
  const char* file;
  std::size_t cameras;
  const char* model;  ///< Of the first.
  ParameterId parameter;
  double value;
  int width;
  double x;  ///< T_B_C(0, 3)
  double offset;
};

constexpr std::array kExpected = {
    Expected{"vikit_svo/uzh-rpg__rpg_svo_pro_open__svo_ros__param__calib__davis_flyingroom.yaml", 1, "kb4", "fx",
             198.71975957912073, 346, 0.0023346688143100354, 0.002608748303665296},
    Expected{"vikit_svo/uzh-rpg__rpg_svo_pro_open__svo_ros__param__calib__euroc_stereo.yaml", 2, "radtan", "fx",
             458.6548807207614, 752, -0.0216401454975, 0.0},
    Expected{"vikit_svo/uzh-rpg__rpg_svo_pro_open__svo_ros__param__calib__svo_test_pinhole.yaml", 1, "fov", "w", 0.932, 752,
             0.0, 0.0},
    Expected{"vikit_svo/uzh-rpg__rpg_svo_pro_open__svo_ros__param__calib__bluefox_25000826_fisheye.yaml", 1, "ocamcalib", "a0",
             -206.5170, 752, 0.0, 0.0},
    Expected{"maplab_ncamera/"
             "ethz-asl__maplab__maplab-launch__config__alphasense-dev-kit__calib__alphasense-dev-kit-sensors.yaml",
             5, "kb4", "fx", 350.4831235139715, 720, 0.050014815850033034, 0.0},
    Expected{"maplab_ncamera/ethz-asl__maplab__applications__rovioli__share__ncamera-zr300.yaml", 1, "kb4", "k1",
             0.009021128160543755, 640, 0.01527316092305903, 0.0},
};

TEST(Ncamera, TheCorpusIsReadAsAPersonReadsIt) {
  const fs::path corpus = shared_dir() / "corpus" / "extra";
  if (!fs::exists(corpus / "vikit_svo")) GTEST_SKIP() << "no corpus beside the repository: " << corpus;
  for (const Expected& expected : kExpected) {
    SCOPED_TRACE(expected.file);
    const Rig rig = calibration_of(read_file(corpus / expected.file), expected.file).rig;
    ASSERT_EQ(rig.cameras.size(), expected.cameras);
    const Camera& camera = rig.cameras.front();
    EXPECT_EQ(model_info(camera.model).id, expected.model);
    EXPECT_EQ(parameter(camera.model, expected.parameter), expected.value);
    EXPECT_EQ(camera.image_size.value().width, expected.width);
    EXPECT_EQ(camera.time_offset_s.value_or(0.0), expected.offset);
    const std::optional<Transform> pose = rig.resolve("imu0", camera.name);
    ASSERT_TRUE(pose);
    EXPECT_EQ((*pose)(0, 3), expected.x);
  }
}

}  // namespace
}  // namespace fca::test
