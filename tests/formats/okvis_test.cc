// SPDX-License-Identifier: BSD-3-Clause
// Configurations of OKVIS: what their numbers mean, what is written comes back and starts the program, edits keep every other
// byte, and the corpus' files are read with the values that a person reads in them.
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

const Format& okvis() { return *find_format("okvis"); }
std::string good(const std::string& file) { return read_file(testdata_dir() / "okvis" / "good" / file); }

/// Does each program load the file and mean the same?
void expect_proven(const Written& written, const Rig& rig) {
  for (const Written::File& file : written.files) {
    EXPECT_FALSE(file.programs.empty());
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
  Written written = written_by(okvis(), &calibration.documents.front(), rig);
  expect_proven(written, rig);
  return written;
}

// p_imu = T_SC p_cam: a point 2 m before the camera is where this says, worked out by hand.
TEST(Okvis, PosesTakePointsOfTheCameraToTheImu) {
  const Rig rig = calibration_of(good("pair.yaml")).rig;
  const Transform* pose = rig.stated("imu0", "cam0");
  ASSERT_NE(pose, nullptr);
  EXPECT_NEAR((*pose)(0, 2) * 2.0 + (*pose)(0, 3), -1.966806472466, 1e-12);
  EXPECT_NEAR((*pose)(1, 2) * 2.0 + (*pose)(1, 3), -0.076939253197, 1e-12);
  EXPECT_NEAR((*pose)(2, 2) * 2.0 + (*pose)(2, 3), -0.0650218473222, 1e-12);
  EXPECT_EQ((*rig.stated("imu0", "cam1"))(0, 3), -0.0788);
}

// t_imu = t_cam - image_delay.
TEST(Okvis, ADelayIsATimeOffsetTurnedRound) {
  for (const Camera& camera : calibration_of(good("pair.yaml")).rig.cameras) EXPECT_EQ(camera.time_offset_s, 0.0025);
  EXPECT_EQ(calibration_of(good("okvis1-crlf.yaml")).rig.cameras[0].time_offset_s, -0.0045);
  Rig rig = sample_rig("radtan", {.two = true, .imu = true});
  for (Camera& camera : rig.cameras) camera.time_offset_s = 0.0125;
  EXPECT_NE(written_by(okvis(), nullptr, rig).files.front().document.bytes().find("    image_delay: -0.0125\n"),
            std::string::npos);
  rig.cameras[1].time_offset_s = 0.0135;
  EXPECT_TRUE(loses(written_by(okvis(), nullptr, rig), Code::kOtherTimeOffset, {"cam1", 0.0135, 0.0125}));
}

TEST(Okvis, NoiseIsDensitiesInSiUnits) {
  EXPECT_EQ(calibration_of(good("pair.yaml")).rig.imus.front(),
            (Imu{"imu0", 2.25e-4, 2.5e-6, 3.125e-3, 1.5e-4, std::nullopt, ""}));
  EXPECT_EQ(calibration_of(good("okvis1-crlf.yaml")).rig.imus.front(),
            (Imu{"imu0", 2.25e-4, 2.5e-6, 3.125e-3, 1.5e-4, 250.0, ""}));
  EXPECT_EQ(calibration_of(good("okvis1-crlf.yaml")).rig.cameras.front().frame_rate_hz, 25.0);
}

TEST(Okvis, LensesHaveTwoNames) {
  const Rig rig = calibration_of(good("okvis2-x.yaml")).rig;
  ASSERT_EQ(rig.cameras.size(), 3U);
  EXPECT_EQ(model_info(rig.cameras[0].model).id, "kb4");
  EXPECT_EQ(model_info(rig.cameras[1].model).id, "eucm");
  EXPECT_EQ(parameter(rig.cameras[1].model, "alpha"), 0.5625);
  EXPECT_EQ(parameter(rig.cameras[1].model, "beta"), 1.0625);
  EXPECT_EQ(model_info(rig.cameras[2].model).id, "rational");
  EXPECT_EQ(parameter(rig.cameras[2].model, "k4"), 0.1875);
  const ExtraField* lidar = rig.find_extra_field("", "lidar");
  ASSERT_NE(lidar, nullptr);
  const ExtraField* body = rig.find_extra_field("imu0", "T_BS");
  ASSERT_NE(body, nullptr) << "the body is not the IMU";
  EXPECT_TRUE(body->value.starts_with("[1.0, 0.0, 0.0, 0.25,")) << body->value;
  EXPECT_EQ(calibration_of(good("pair.yaml")).rig.find_extra_field("imu0", "T_BS"), nullptr);
}

CameraModel model_for(std::string_view id) {
  if (id != "rational") return sample_model(std::string(id));
  return model_of("rational", {458.6, 457.3, 367.2, 248.4, -0.28, 0.07, 0.0002, 0.00002, 0.001, 0.01, 0.002, 0.0005});
}

TEST(Okvis, TheFirstGenerationIsWrittenInItsLayout) {
  WriteOptions options;
  options.layout = "okvis1";
  for (const std::string_view model : {"radtan", "kb4", "rational"}) {
    SCOPED_TRACE(model);
    Rig rig = sample_rig("radtan", {.two = true, .imu = true});
    for (Camera& camera : rig.cameras) camera.model = model_for(model);
    const Written written = written_by(okvis(), nullptr, rig, options);
    ASSERT_EQ(written.files.size(), 1U);
    EXPECT_EQ(written.files.front().programs, std::vector<std::string>{"okvis"});
    expect_proven(written, rig);
    const Rig back = calibration_of(written.files.front().document.bytes()).rig;
    ASSERT_EQ(back.cameras.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(back.cameras[i].model, rig.cameras[i].model);
    EXPECT_EQ(back.imus.front().gyroscope_noise_density, rig.imus.front().gyroscope_noise_density);
  }
}

TEST(Okvis, AFileInTheLayoutThatIsAskedForIsEdited) {
  for (const auto& [file, own, other] :
       {std::array{"okvis1-crlf.yaml", "okvis1", "okvis2"}, std::array{"pair.yaml", "okvis2", "okvis1"}}) {
    SCOPED_TRACE(file);
    const Calibration calibration = calibration_of(good(file));
    const text::Document& base = calibration.documents.front();
    WriteOptions options;
    options.layout = own;
    EXPECT_EQ(written_by(okvis(), &base, calibration.rig, options).files.front().document.bytes(), good(file));
    options.layout = other;
    const Written moved = written_by(okvis(), &base, calibration.rig, options);
    EXPECT_NE(moved.files.front().document.bytes(), good(file));
    expect_proven(moved, calibration.rig);
  }
}

TEST(Okvis, EveryModelComesBackAndStartsTheProgram) {
  for (const StoredModel& stored : okvis().models) {
    SCOPED_TRACE(stored.model);
    Rig rig = sample_rig("radtan", {.two = true, .imu = true});
    for (Camera& camera : rig.cameras) camera.model = model_for(stored.model);
    const Written written = written_by(okvis(), nullptr, rig);
    ASSERT_EQ(written.files.size(), 1U);
    const Calibration back = calibration_of(written.files.front().document.bytes());
    EXPECT_EQ(back.format->id, "okvis");
    ASSERT_EQ(back.rig.cameras.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(back.rig.cameras[i].model, rig.cameras[i].model);
      EXPECT_EQ(back.rig.cameras[i].image_size, rig.cameras[i].image_size);
    }
    const std::optional<Transform> pose = back.rig.resolve("cam1", "cam0");
    ASSERT_TRUE(pose);
    EXPECT_LT(element_difference(*pose, T_cam1_cam0()), 1e-12);
    expect_proven(written, rig);
    const std::vector<std::string> programs =
        stored.model == "eucm" ? std::vector<std::string>{"okvis2-x"} : std::vector<std::string>{"okvis2", "okvis2-x"};
    EXPECT_EQ(written.files.front().programs, programs);
  }
}

// OKVIS2 knows no cam_model: it must not take an EUCM for a pinhole.
TEST(Okvis, Okvis2RefusesAnEucm) {
  Rig rig = sample_rig("eucm", {.two = false, .imu = true});
  const Written written = written_by(okvis(), nullptr, rig);
  const ProofResult proof = prove(*consumers::find_consumer("okvis2"), written.files.front().document.bytes(), {}, rig, 0.9);
  EXPECT_FALSE(proof.loads);
}

TEST(Okvis, WhatNothingStatesIsMadeUpAndSaid) {
  const Written written = written_by(okvis(), nullptr, sample_rig("radtan", {.two = false, .imu = false}));
  std::set<std::string> keys;
  for (const DefaultedValue& value : written.defaults) keys.insert(value.key.substr(0, value.key.find('(')));
  EXPECT_EQ(keys, (std::set<std::string>{"cam0 T_SC", "cam0 camera_type", "cam0 slam_use", "sync_cameras", "IMU sigma_g_c",
                                         "IMU sigma_a_c", "IMU sigma_gw_c", "IMU sigma_aw_c", "tuning "}));
}

TEST(Okvis, RatesAndTopicsAreLost) {
  Rig rig = sample_rig("radtan", {.two = true, .imu = true});
  rig.imus.front().rate_hz = 250.0;
  rig.cameras[1].frame_rate_hz = 25.0;
  const Written written = written_by(okvis(), nullptr, rig);
  EXPECT_TRUE(loses(written, Code::kNotCarriedValue, {"imu0", "rate", "250"}));
  EXPECT_TRUE(loses(written, Code::kFrameRateDropped, {"cam1", 25.0}));
}

// What tunes OKVIS2 is taken over into a fresh file, and nothing else is made up.
TEST(Okvis, TuningIsKept) {
  const Calibration calibration = calibration_of(good("pair.yaml"));
  WriteOptions options;
  options.rewrite = true;
  Diagnostics diagnostics;
  const std::optional<Written> written =
      write_calibration(okvis(), &calibration.documents.front(), calibration.rig, options, diagnostics);
  ASSERT_TRUE(written);
  const std::string bytes = written->files.front().document.bytes();
  for (const char* line : {"    a_max: 150.0\n", "    enforce_realtime: true\n", "        sigma_r: 0.02\n",
                           "    a0: [-0.05, 0.09, 0.01]\n", "    max_num_keypoints: 500\n"})
    EXPECT_NE(bytes.find(line), std::string::npos) << line << bytes;
  EXPECT_FALSE(loses_anything_of(*written, "okvis."));
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

TEST(Okvis, AnEditChangesOneNumberAndNoOtherByte) {
  using Pair = std::pair<std::string, std::string>;
  const auto changed = [](const std::string& file, const std::function<void(Rig&)>& change) {
    return difference(good(file), edited(file, change).files.front().document.bytes());
  };
  EXPECT_EQ(changed("pair.yaml", [](Rig& rig) { set_parameter(rig.cameras[1].model, "fx", 522.5); }), Pair("4", "5"));
  EXPECT_EQ(changed("pair.yaml", [](Rig& rig) { rig.poses[0].T_a_b(0, 3) = 0.0412; }), Pair("3", "4"));
  EXPECT_EQ(changed("pair.yaml", [](Rig& rig) { rig.cameras[0].image_size->width = 740; }), Pair("6", "7"));
  EXPECT_EQ(changed("pair.yaml", [](Rig& rig) { rig.imus[0].gyroscope_noise_density = 2.75e-4; }), Pair("2.25e-4", "0.000275"));
  EXPECT_EQ(changed("pair.yaml",
                    [](Rig& rig) {
                      for (Camera& camera : rig.cameras) camera.time_offset_s = 0.0035;
                    }),
            Pair("2", "3"));
  EXPECT_EQ(changed("okvis1-crlf.yaml", [](Rig& rig) { rig.cameras[0].time_offset_s = -0.0035; }), Pair("4", "3"));
  EXPECT_EQ(changed("okvis1-crlf.yaml", [](Rig& rig) { rig.cameras[0].frame_rate_hz = 75.0; }), Pair("2", "7"));
  EXPECT_EQ(changed("okvis1-crlf.yaml", [](Rig& rig) { rig.imus[0].rate_hz = 750.0; }), Pair("2", "7"));
  EXPECT_EQ(changed("okvis2-x.yaml", [](Rig& rig) { set_parameter(rig.cameras[1].model, "alpha", 0.5675); }), Pair("2", "7"));
}

// Four coefficients become eight, and a lens of OKVIS2-X the first entries of a braced list.
TEST(Okvis, AnotherLensIsNamed) {
  for (const char* file : {"pair.yaml", "okvis2-x.yaml", "okvis1-crlf.yaml"}) {
    for (const char* model : {"kb4", "radtan", "rational", "eucm"}) {
      if (model == std::string("eucm") && file == std::string("okvis1-crlf.yaml")) continue;
      SCOPED_TRACE(std::string(file) + " " + model);
      const Calibration calibration = calibration_of(good(file));
      for (std::size_t i = 0; i < calibration.rig.cameras.size(); ++i) {
        Rig rig = calibration.rig;
        rig.cameras[i].model = model_for(model);
        const Written written = written_by(okvis(), &calibration.documents.front(), rig);
        const Calibration back = calibration_of(written.files.front().document.bytes());
        EXPECT_EQ(back.rig.cameras, rig.cameras) << written.files.front().document.bytes();
      }
    }
  }
}

/// What a person reads in a file of the corpus.
struct Expected {
  const char* file;
  std::size_t cameras;
  const char* model;  ///< Of the first.
  double fx;
  int width;
  double x;  ///< T_SC(0, 3)
  double offset;
  double noise;  ///< Of the gyroscope.
};

constexpr std::array kExpected = {
    Expected{"ethz-asl__maplab__maplab-launch__config__alphasense-dev-kit__calib__alphasense-dev-kit-okvis.yaml", 2, "kb4",
             350.4831235139715, 720, 0.050014815850033034, -0.0018037773858212566, 1.805e-4},
    Expected{"ethz-asl__okvis__config__config_fpga_p2_euroc.yaml", 2, "radtan", 458.654880721, 752, -0.0216401454975, 0.0,
             12.0e-4},
    Expected{"luohongk__OKVIS2-X__config__fisheye4__okvis2.yaml", 4, "kb4", 395.00109560, 1088, -0.09141318, 0.0, 0.0},
    Expected{"luohongk__OKVIS2-X__config__vbr__okvis2.yaml", 2, "radtan", 1282.79698152, 1388, 0.0879708589133336, 0.0,
             80.0e-4},
    Expected{"luohongk__OKVIS2-X__config__replica__okvis2.yaml", 3, "radtan", 600.0, 1200, 0.0, 0.0, 0.00278},
};

TEST(Okvis, TheCorpusIsReadAsAPersonReadsIt) {
  const fs::path corpus = shared_dir() / "corpus" / "extra" / "okvis";
  if (!fs::exists(corpus)) GTEST_SKIP() << "no corpus beside the repository: " << corpus;
  for (const Expected& expected : kExpected) {
    SCOPED_TRACE(expected.file);
    const Rig rig = calibration_of(read_file(corpus / expected.file), expected.file).rig;
    ASSERT_EQ(rig.cameras.size(), expected.cameras);
    const Camera& camera = rig.cameras.front();
    EXPECT_EQ(model_info(camera.model).id, expected.model);
    EXPECT_EQ(parameter(camera.model, "fx"), expected.fx);
    EXPECT_EQ(camera.image_size.value().width, expected.width);
    EXPECT_EQ(camera.time_offset_s, expected.offset);
    EXPECT_EQ((*rig.stated("imu0", "cam0"))(0, 3), expected.x);
    if (expected.noise > 0.0) {
      EXPECT_EQ(rig.imus.front().gyroscope_noise_density, expected.noise);
    }
  }
}

}  // namespace
}  // namespace fca::test
