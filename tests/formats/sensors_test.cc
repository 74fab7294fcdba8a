// SPDX-License-Identifier: BSD-3-Clause
// EuRoC's sensor.yaml and Kimera-VIO's parameters: what their numbers mean, what is written comes back, edits keep every other
// byte, and the corpus' files are read with the values that a person reads in them.
#include "formats/lost_facts.h"
#include "formats/oracle_table.h"
#include "formats/rigs.h"

#include <fca/code.h>
#include <fca/formats/proof.h>
#include <fca/rig/rotation.h>

#include <array>
#include <functional>
#include <iostream>
#include <set>

namespace fca::test {
namespace {

const Format& format(const std::string& id) { return *find_format(id); }
std::string good(const std::string& path) { return read_file(testdata_dir() / path); }

/// The rig of several files, each under its name, read as cameras of one.
Calibration joined(const std::vector<std::pair<std::string, std::string>>& files) {
  std::vector<text::Document> documents;
  for (const auto& [name, bytes] : files) documents.push_back(document_of(bytes, name));
  Diagnostics diagnostics;
  ReadOptions options;
  options.join = true;
  std::optional<Calibration> calibration = read_calibration(std::move(documents), nullptr, options, diagnostics);
  EXPECT_TRUE(calibration);
  return calibration ? *std::move(calibration) : Calibration();
}

Calibration joined(const Written& written) {
  std::vector<std::pair<std::string, std::string>> files;
  for (const Written::File& file : written.files) files.emplace_back(file.place, file.document.bytes());
  return joined(files);
}

std::vector<std::string> places_of(const Written& written) {
  std::vector<std::string> places;
  for (const Written::File& file : written.files) places.push_back(file.place);
  return places;
}

/// Does each file's program load it and mean the same?
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

TEST(Euroc, SensorsAreNamedByTheirPaths) {
  const std::string camera = good("euroc/good/cam0.yaml");
  EXPECT_EQ(calibration_of(camera, "data/mav0/cam1/sensor.yaml").rig.cameras.front().name, "cam1");
  EXPECT_EQ(calibration_of(camera, "sensor_cam3.yaml").rig.cameras.front().name, "cam3");
  EXPECT_EQ(calibration_of(camera, "cam7/left.yaml").rig.cameras.front().name, "cam7");
  EXPECT_EQ(calibration_of(camera, "left.yaml").rig.cameras.front().name, "cam0");
  EXPECT_EQ(calibration_of(good("euroc/good/imu.yaml"), "mav0/imu1/sensor.yaml").rig.imus.front().name, "imu1");
}

// p_body = T_BS p_sensor, and the body is the IMU.
TEST(Euroc, PosesTakePointsOfTheSensorToTheImu) {
  const Calibration calibration = calibration_of(good("euroc/good/cam0.yaml"), "cam0.yaml");
  const Transform* pose = calibration.rig.stated("imu0", "cam0");
  ASSERT_NE(pose, nullptr);
  EXPECT_EQ((*pose)(1, 3), -0.0475);
  EXPECT_EQ(calibration.rig.cameras.front().frame_rate_hz, 25.0);
  EXPECT_EQ(model_info(calibration.rig.cameras.front().model).id, "radtan");
}

TEST(Euroc, NoiseIsDensitiesInSiUnits) {
  const Rig rig = calibration_of(good("euroc/good/imu.yaml"), "imu.yaml").rig;
  ASSERT_EQ(rig.imus.size(), 1U);
  EXPECT_EQ(rig.imus.front(), (Imu{"imu0", 2.25e-4, 2.5e-6, 3.125e-3, 1.5e-4, 250.0, ""}));
}

// cuVSLAM's fisheye: the numbers are equidistant, whatever distortion_model says; and its poses stand in cam0.
TEST(Euroc, CuvslamsDialectIsToldApart) {
  const Calibration rig = joined({{"sensor_cam0.yaml", good("euroc/dialect/sensor_cam0.yaml")},
                                  {"sensor_cam1.yaml", good("euroc/dialect/sensor_cam1.yaml")},
                                  {"sensor_imu0.yaml", good("euroc/dialect/sensor_imu0.yaml")}});
  ASSERT_EQ(rig.rig.cameras.size(), 2U);
  for (const Camera& camera : rig.rig.cameras) EXPECT_EQ(model_info(camera.model).id, "kb4");
  const Transform* pose = rig.rig.stated("cam0", "cam1");
  ASSERT_NE(pose, nullptr);
  EXPECT_EQ((*pose)(0, 3), 0.11025);
  EXPECT_TRUE(rig.rig.resolve("imu0", "cam1"));
  Parsed parsed = parse(good("euroc/dialect/sensor_cam0.yaml"), "sensor_cam0.yaml");
  ASSERT_TRUE(parsed.document);
  EXPECT_TRUE(read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics));
  EXPECT_EQ(parsed.codes(), "program-ignores");
}

/// The base with the change, by its own format.
std::string rig_file_with(const std::string& bytes, const std::function<void(Rig&)>& change) {
  Rig rig = calibration_of(bytes, "rig.yaml").rig;
  change(rig);
  const text::Document base = document_of(bytes, "rig.yaml");
  WriteOptions options;
  options.keeps_layout = true;
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(format("euroc"), &base, rig, options, diagnostics);
  EXPECT_TRUE(written);
  if (written) expect_proven(*written, rig);
  return written ? written->files.front().document.bytes() : "";
}

// p_rig = transform p_camera; left and right by turns.
TEST(CuvslamRig, PairsHavePosesOnTheRig) {
  const std::string bytes = good("euroc/cuvslam-rig/pairs.yaml");
  const Calibration calibration = calibration_of(bytes, "frame.yaml");
  EXPECT_EQ(calibration.format->id, "euroc");
  EXPECT_TRUE(calibration.rig.cameras.empty());
  ASSERT_EQ(calibration.rig.poses.size(), 4U);
  ASSERT_NE(calibration.rig.stated("rig", "cam2"), nullptr);
  EXPECT_EQ(translation_of(*calibration.rig.stated("rig", "cam2")), (std::array{-0.0915, 0.0, 0.0725}));
  const std::optional<Transform> pair = calibration.rig.resolve("cam3", "cam2");
  ASSERT_TRUE(pair);
  EXPECT_NEAR((*pair)(0, 3), -0.065, 1e-15) << "the right camera is to the right";
  EXPECT_EQ(rig_file_with(bytes, [](Rig&) {}), bytes);
  EXPECT_EQ(rig_file_with(bytes, [](Rig& rig) { rig.poses[2].T_a_b(0, 3) = -0.095; }),
            with_replaced(bytes, "[0, 0, 1, -0.0915] # 0018's left", "[0, 0, 1, -0.095] # 0018's left"));
}

TEST(CuvslamRig, AColourCameraIsAPinhole) {
  const std::string bytes = good("euroc/cuvslam-rig/colour.yaml");
  const Rig rig = calibration_of(bytes, "rig.yaml").rig;
  ASSERT_EQ(rig.cameras.size(), 1U);
  EXPECT_EQ(model_info(rig.cameras[0].model).id, "pinhole");
  EXPECT_EQ(parameter(rig.cameras[0].model, "fy"), 522.25);
  EXPECT_EQ(parameter(rig.cameras[0].model, "cx"), 318.5);
  EXPECT_EQ(rig.cameras[0].image_size, (ImageSize{640, 480}));
  EXPECT_EQ(rig_file_with(bytes, [](Rig&) {}), bytes);
  EXPECT_EQ(rig_file_with(bytes, [](Rig& edited) { EXPECT_TRUE(set_parameter(edited.cameras[0].model, "fx", 520.5)); }),
            with_replaced(bytes, "521.75", "520.5"));
}

std::vector<std::string> extras_of(const Rig& rig) {
  std::vector<std::string> extras;
  for (const ExtraField& field : rig.extra_fields) extras.push_back(field.owner + "/" + field.key + "=" + field.value);
  return extras;
}

// What a person added for a program of their own.
TEST(CuvslamRig, KeysThatAreNotReadAreKeptAsTheyAre) {
  const std::string bytes = good("euroc/cuvslam-rig/more-keys.yaml");
  const std::vector<std::string> extras = extras_of(calibration_of(bytes, "rig.yaml").rig);
  EXPECT_EQ(extras, (std::vector<std::string>{"cam0/intrinsics=[401.5, 402.25, 318.0, 241.5]", "cam1/model=wide",
                                              "cam0/serial=21", "cam0/note=on the mast", "/imu={rate: 200}"}));
  EXPECT_EQ(rig_file_with(bytes, [](Rig&) {}), bytes);
}

// Its program takes the lens for a pinhole; the numbers are told and lost, not dropped without a word.
TEST(CuvslamRig, TheDistortionOfAColourCameraIsTold) {
  const std::string bytes = good("euroc/bad/colour-distorted.yaml");
  const auto codes = [](const std::string& text) {
    Parsed parsed = parse(text, "rig.yaml");
    EXPECT_TRUE(parsed.document && read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics));
    return parsed.codes();
  };
  EXPECT_EQ(codes(bytes), "program-ignores");
  EXPECT_EQ(codes(with_replaced(bytes, "[0.15, -0.25, 0.0, 0.001, 0.002]", "[0, 0, 0.0, 0, 0]")), "");
  EXPECT_EQ(codes(with_replaced(bytes, "distortion: [0.15, -0.25, 0.0, 0.001, 0.002]", "k1: 0.15")), "program-ignores");
  const Rig rig = calibration_of(bytes, "rig.yaml").rig;
  EXPECT_EQ(extras_of(rig).size(), 4U);
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(format("kalibr"), nullptr, rig, {}, diagnostics);
  ASSERT_TRUE(written);
  EXPECT_TRUE(std::ranges::any_of(written->losses, [](const Loss& loss) { return loss.key == "distortion"; }));
}

TEST(CuvslamRig, TheCorpusIsReadAsAPersonReadsIt) {
  const fs::path corpus = shared_dir() / "corpus" / "extra" / "cuvslam_rig";
  if (!fs::exists(corpus)) GTEST_SKIP() << "no corpus beside the repository: " << corpus;
  for (const auto& [name, z] : {std::pair("agx", -0.074), {"nano", -0.078}}) {
    const std::string file = "NVlabs__PyCuVSLAM__examples__realsense__frame_" + std::string(name) + "_rig.yaml";
    const Rig rig = calibration_of(read_file(corpus / file), file).rig;
    ASSERT_EQ(rig.poses.size(), 6U) << file;
    EXPECT_EQ((*rig.stated("rig", "cam2"))(0, 3), z) << file;
    EXPECT_EQ((*rig.stated("rig", "cam0"))(0, 3), -0.025) << file;
  }
  const std::string file = "NVlabs__PyCuVSLAM__examples__tum__freiburg3_rig.yaml";
  const Rig rig = calibration_of(read_file(corpus / file), file).rig;
  ASSERT_EQ(rig.cameras.size(), 1U);
  EXPECT_EQ(parameter(rig.cameras[0].model, "fx"), 535.4);
  EXPECT_EQ(rig.cameras[0].image_size, (ImageSize{640, 480}));
  EXPECT_EQ(files_in(corpus).size(), 3U);
}

TEST(Euroc, ACameraThatIsNotWhereCam0IsIsCam1) {
  const Rig rig = calibration_of(good("euroc/dialect/sensor_cam1.yaml"), "sensor.yaml").rig;
  EXPECT_EQ(rig.cameras.front().name, "cam1");
  EXPECT_NE(rig.stated("cam0", "cam1"), nullptr);
}

TEST(Euroc, EveryModelComesBack) {
  for (const StoredModel& stored : format("euroc").models) {
    SCOPED_TRACE(stored.model);
    const Rig rig = sample_rig(std::string(stored.model), {.two = true, .imu = true});
    const Written written = written_by(format("euroc"), nullptr, rig);
    EXPECT_EQ(places_of(written),
              (std::vector<std::string>{"mav0/cam0/sensor.yaml", "mav0/cam1/sensor.yaml", "mav0/imu0/sensor.yaml"}));
    const Calibration back = joined(written);
    ASSERT_EQ(back.rig.cameras.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_TRUE(stored.model == "pinhole" || back.rig.cameras[i].model == rig.cameras[i].model);
      EXPECT_EQ(back.rig.cameras[i].image_size, rig.cameras[i].image_size);
    }
    const std::optional<Transform> pose = back.rig.resolve("cam1", "cam0");
    ASSERT_TRUE(pose);
    EXPECT_LT(element_difference(*pose, T_cam1_cam0()), 1e-12);
    Imu imu = rig.imus.front();
    imu.topic.clear();
    EXPECT_EQ(back.rig.imus, std::vector{imu});
    expect_proven(written, rig);
  }
}

// The one header that OpenCV, PyYAML and yaml-cpp all take.
TEST(Euroc, FilesBeginWithAHeaderForEveryReader) {
  const Written written = written_by(format("euroc"), nullptr, sample_rig("radtan", {.two = true, .imu = true}));
  for (const Written::File& file : written.files)
    EXPECT_TRUE(file.document.bytes().starts_with("%YAML 1.0\n---\nsensor_type: ")) << file.document.bytes();
}

TEST(Euroc, ATimeOffsetIsLost) {
  Rig rig = sample_rig("radtan", {.two = true, .imu = true});
  rig.cameras[0].time_offset_s = 0.0;
  rig.cameras[1].time_offset_s = 0.0125;
  const Written written = written_by(format("euroc"), nullptr, rig);
  EXPECT_TRUE(loses(written, Code::kTimeOffsetDropped, {"cam1", 0.0125}));
  EXPECT_FALSE(loses(written, Code::kTimeOffsetDropped, {"cam0"}));
}

TEST(Euroc, AnImuThatLacksNumbersHasNoFile) {
  Rig rig = sample_rig("radtan", {.two = true, .imu = true});
  rig.imus.front().gyroscope_random_walk.reset();
  const Written written = written_by(format("euroc"), nullptr, rig);
  EXPECT_EQ(written.files.size(), 2U);
  EXPECT_TRUE(loses(written, Code::kImuDropped, {"imu0"}));
}

// What is not in the input stands there as made up.
TEST(Euroc, APoseThatNothingStatesIsMadeUpAndSaid) {
  const Written written = written_by(format("euroc"), nullptr, sample_rig("radtan", {.two = true}));
  ASSERT_EQ(written.defaults.size(), 2U);
  for (const DefaultedValue& value : written.defaults) {
    EXPECT_TRUE(value.key.ends_with(" T_BS")) << value.key;
    EXPECT_TRUE(value.invented);
  }
}

TEST(Kimera, ThreeFilesUnderTheirStockNames) {
  for (const StoredModel& stored : format("kimera").models) {
    SCOPED_TRACE(stored.model);
    Rig rig = sample_rig(stored.model == "rational" ? "radtan" : std::string(stored.model), {.two = true, .imu = true});
    for (Camera& camera : rig.cameras) {
      camera.time_offset_s = 0.0075;
      camera.frame_rate_hz = 20.0;
      if (stored.model == "rational")
        camera.model =
            model_of("rational", {458.6, 457.3, 367.2, 248.4, -0.28, 0.07, 0.0002, 0.00002, 0.001, 0.01, 0.002, 0.0005});
    }
    const Written written = written_by(format("kimera"), nullptr, rig);
    EXPECT_EQ(places_of(written),
              (std::vector<std::string>{"LeftCameraParams.yaml", "RightCameraParams.yaml", "ImuParams.yaml"}));
    const Calibration back = joined(written);
    ASSERT_EQ(back.rig.cameras.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(back.rig.cameras[i].model, rig.cameras[i].model);
      EXPECT_EQ(back.rig.cameras[i].name, rig.cameras[i].name);
      EXPECT_EQ(back.rig.cameras[i].time_offset_s, 0.0075);
    }
    const std::optional<Transform> pose = back.rig.resolve("cam1", "cam0");
    ASSERT_TRUE(pose);
    EXPECT_LT(element_difference(*pose, T_cam1_cam0()), 1e-12);
    expect_proven(written, rig);
  }
}

TEST(Kimera, K3IsTheFifthCoefficient) {
  Rig rig = sample_rig("radtan", {.two = false, .imu = true});
  ASSERT_TRUE(set_parameter(rig.cameras.front().model, "k3", -0.0125));
  const Written written = written_by(format("kimera"), nullptr, rig);
  EXPECT_EQ(joined(written).rig.cameras.front().model, rig.cameras.front().model);
  expect_proven(written, rig);
}

// t_imu = t_cam + imu_time_shift, of all cameras: it stands in a file that has none.
TEST(Kimera, TheTimeShiftOfTheImuIsThatOfTheCameras) {
  const Calibration rig = joined({{"LeftCameraParams.yaml", good("kimera/good/left.yaml")},
                                  {"RightCameraParams.yaml", good("kimera/good/right-crlf.yaml")},
                                  {"ImuParams.yaml", good("kimera/good/imu.yaml")}});
  ASSERT_EQ(rig.rig.cameras.size(), 2U);
  for (const Camera& camera : rig.rig.cameras) EXPECT_EQ(camera.time_offset_s, 0.00625);
  EXPECT_EQ(rig.rig.cameras[0].name, "left_cam");
  EXPECT_EQ(rig.rig.cameras[1].name, "right_cam");
  EXPECT_EQ(rig.rig.find_extra_field("imu0", "imu_time_shift"), nullptr);
}

// What tunes Kimera-VIO is taken over into a fresh file.
TEST(Kimera, TuningIsKept) {
  const Rig rig = joined({{"a.yaml", good("kimera/good/left.yaml")}, {"ImuParams.yaml", good("kimera/good/imu.yaml")}}).rig;
  const Written written = written_by(format("kimera"), nullptr, rig);
  const std::string imu = written.files.back().document.bytes();
  EXPECT_NE(imu.find("imu_preintegration_type: 0\n"), std::string::npos) << imu;
  EXPECT_NE(imu.find("n_gravity: [0.0, 0.0, -9.8066]\n"), std::string::npos) << imu;
  EXPECT_NE(imu.find("imu_time_shift: 0.00625\n"), std::string::npos) << imu;
  for (const DefaultedValue& value : written.defaults) ADD_FAILURE() << value.key;
  EXPECT_FALSE(loses_anything_of(written, "kimera.")) << "all of it stands in the file";
}

TEST(Kimera, WhatNothingStatesIsMadeUpAndSaid) {
  Rig rig = sample_rig("radtan", {.two = false, .imu = false});
  const Written written = written_by(format("kimera"), nullptr, rig);
  ASSERT_EQ(written.files.size(), 2U);
  std::set<std::string> keys;
  for (const DefaultedValue& value : written.defaults) keys.insert(value.key.substr(0, value.key.find('(')));
  EXPECT_EQ(keys, (std::set<std::string>{"cam0 T_BS", "cam0 rate_hz", "IMU rate_hz", "IMU gyroscope_noise_density",
                                         "IMU gyroscope_random_walk", "IMU accelerometer_noise_density",
                                         "IMU accelerometer_random_walk", "tuning "}));
  EXPECT_TRUE(written.files.back().of_defaults);
  expect_proven(written, rig);
}

TEST(Kimera, AFractionalRateIsRoundedAndSaid) {
  Rig rig = sample_rig("radtan", {.two = false, .imu = true});
  rig.cameras.front().frame_rate_hz = 29.97;
  const Written written = written_by(format("kimera"), nullptr, rig);
  EXPECT_NE(written.files.front().document.bytes().find("rate_hz: 30\n"), std::string::npos);
  EXPECT_TRUE(loses(written, Code::kKimeraFrameRateRounded, {"cam0", 29.97, 30}));
}

/// Where two texts differ: from the first byte on, up to the last.
std::pair<std::string, std::string> difference(const std::string& a, const std::string& b) {
  std::size_t begin = 0;
  while (begin < std::min(a.size(), b.size()) && a[begin] == b[begin]) ++begin;
  std::size_t end = 0;
  while (end < std::min(a.size(), b.size()) - begin && a[a.size() - 1 - end] == b[b.size() - 1 - end]) ++end;
  return {a.substr(begin, a.size() - begin - end), b.substr(begin, b.size() - begin - end)};
}

TEST(Sensors, AnEditChangesOneNumberAndNoOtherByte) {
  const auto edited = [](const std::string& file, const std::function<void(Rig&)>& change) {
    const std::string bytes = good(file);
    const Calibration calibration = calibration_of(bytes, fs::path(file).filename().string());
    Rig rig = calibration.rig;
    change(rig);
    const Written written = written_by(*calibration.format, &calibration.documents.front(), rig);
    EXPECT_EQ(written.files.size(), 1U);
    return difference(bytes, written.files.front().document.bytes());
  };
  using Pair = std::pair<std::string, std::string>;
  for (const char* file : {"euroc/good/cam0.yaml", "kimera/good/left.yaml"}) {
    EXPECT_EQ(edited(file, [](Rig& rig) { set_parameter(rig.cameras[0].model, "fx", 521.375); }), Pair("4", "5"));
    EXPECT_EQ(edited(file, [](Rig& rig) { set_parameter(rig.cameras[0].model, "k2", 0.0725); }), Pair("6", "7"));
    EXPECT_EQ(edited(file, [](Rig& rig) { rig.poses[0].T_a_b(0, 3) = 0.0412; }), Pair("3", "4"));
    EXPECT_EQ(edited(file, [](Rig& rig) { rig.cameras[0].image_size->width = 740; }), Pair("6", "7"));
  }
  EXPECT_EQ(edited("euroc/good/cam1-crlf.yaml", [](Rig& rig) { set_parameter(rig.cameras[0].model, "k4", -0.0008); }),
            Pair("0.0006", "8.0e-04"));
  EXPECT_EQ(edited("kimera/good/right-crlf.yaml", [](Rig& rig) { rig.cameras[0].frame_rate_hz = 75.0; }), Pair("2", "7"));
  EXPECT_EQ(edited("kimera/good/five.yaml", [](Rig& rig) { set_parameter(rig.cameras[0].model, "k3", -0.0315); }),
            Pair("2", "3"));
  for (const char* file : {"euroc/good/imu.yaml", "kimera/good/imu.yaml"})
    EXPECT_EQ(edited(file, [](Rig& rig) { rig.imus[0].gyroscope_noise_density = 2.75e-4; }), Pair("2.25e-04", "0.000275"));
}

// An edit that makes another lens of the camera names it, in cuVSLAM's files, too.
TEST(Sensors, AnotherLensIsNamed) {
  for (const char* file : {"euroc/good/cam0.yaml", "euroc/dialect/sensor_cam0.yaml", "kimera/good/left.yaml"}) {
    SCOPED_TRACE(file);
    const Calibration calibration = calibration_of(good(file), fs::path(file).filename().string());
    for (const char* model : {"kb4", "radtan"}) {
      Rig rig = calibration.rig;
      rig.cameras.front().model = sample_model(model);
      const Written written = written_by(*calibration.format, &calibration.documents.front(), rig);
      const Calibration back = calibration_of(written.files.front().document.bytes(), "cam0.yaml");
      EXPECT_EQ(back.rig.cameras.front().model, rig.cameras.front().model);
    }
  }
}

/// What a person reads in a file of the corpus.
struct Expected {
  const char* file;
  const char* format;
  const char* model;  ///< Empty: an IMU's file.
  double fx;          ///< Of an IMU its rate.
  int width;
  int height;
  const char* frame;  ///< Of the pose; empty: none.
  double x;           ///< T(0, 3)
};

constexpr std::array kExpected = {
    Expected{"euroc_sensor/MIT-SPARK__Kimera-VIO__tests__data__MicroEurocDataset__mav0__cam0__sensor.yaml", "euroc", "radtan",
             458.654, 752, 480, "imu0", -0.0216401454975},
    Expected{"euroc_sensor/MIT-SPARK__Kimera-VIO__tests__data__MicroEurocDataset__mav0__cam1__sensor.yaml", "euroc", "radtan",
             457.587, 752, 480, "imu0", -0.0198435579556},
    Expected{"euroc_sensor/MIT-SPARK__Kimera-VIO__tests__data__MicroEurocDataset__mav0__imu0__sensor.yaml", "euroc", "", 200.0,
             0, 0, "", 0.0},
    Expected{"euroc_sensor/NVlabs__PyCuVSLAM__examples__euroc__sensor_cam0.yaml", "euroc", "kb4", 460.9855047976205, 752, 480,
             "", 0.0},
    Expected{"euroc_sensor/NVlabs__PyCuVSLAM__examples__euroc__sensor_cam1.yaml", "euroc", "kb4", 459.56983030590357, 752, 480,
             "cam0", 1.099839e-01},
    Expected{"euroc_sensor/NVlabs__PyCuVSLAM__examples__euroc__sensor_imu0.yaml", "euroc", "", 200.0, 0, 0, "cam0", 0.0683705},
    Expected{"euroc_sensor/andreruas__scratch_slam__mav0__cam0__sensor.yaml", "euroc", "radtan", 458.654, 752, 480, "imu0",
             -0.0216401454975},
    Expected{"euroc_sensor/andreruas__scratch_slam__mav0__cam1__sensor.yaml", "euroc", "radtan", 457.587, 752, 480, "imu0",
             -0.0198435579556},
    Expected{"kimera/MIT-SPARK__Kimera-VIO__params__D455__ImuParams.yaml", "kimera", "", 400.0, 0, 0, "", 0.0},
    Expected{"kimera/MIT-SPARK__Kimera-VIO__params__D455__LeftCameraParams.yaml", "kimera", "radtan", 377.229220831, 640, 480,
             "imu0", -0.02647408},
    Expected{"kimera/MIT-SPARK__Kimera-VIO__params__D455__RightCameraParams.yaml", "kimera", "radtan", 377.535257164, 640, 480,
             "imu0", 0.06845528},
    Expected{"kimera/MIT-SPARK__Kimera-VIO__params__EurocMono__ImuParams.yaml", "kimera", "", 200.0, 0, 0, "", 0.0},
    Expected{"kimera/MIT-SPARK__Kimera-VIO__params__Euroc__ImuParams.yaml", "kimera", "", 200.0, 0, 0, "", 0.0},
    Expected{"kimera/MIT-SPARK__Kimera-VIO__params__Euroc__LeftCameraParams.yaml", "kimera", "radtan", 458.654, 752, 480,
             "imu0", -0.0216401454975},
    Expected{"kimera/MIT-SPARK__Kimera-VIO__params__Euroc__RightCameraParams.yaml", "kimera", "radtan", 457.587, 752, 480,
             "imu0", -0.0198435579556},
    Expected{"kimera/MIT-SPARK__Kimera-VIO__params__KinectAzure__ImuParams.yaml", "kimera", "", 1630.0, 0, 0, "", 0.0},
    Expected{"kimera/MIT-SPARK__Kimera-VIO__params__KinectAzure__LeftCameraParams.yaml", "kimera", "radtan", 292.450703472, 640,
             360, "imu0", 0.00012095},
    Expected{"kimera/MIT-SPARK__Kimera-VIO__params__RealSenseIR__ImuParams.yaml", "kimera", "", 400.0, 0, 0, "", 0.0},
    Expected{"kimera/MIT-SPARK__Kimera-VIO__params__RealSenseIR__LeftCameraParams.yaml", "kimera", "kb4", 384.5697007030446,
             640, 480, "imu0", -0.00107491},
    Expected{"kimera/MIT-SPARK__Kimera-VIO__params__RealSenseIR__RightCameraParams.yaml", "kimera", "kb4", 384.6517877875679,
             640, 480, "imu0", 0.04882315},
    Expected{"kimera/MIT-SPARK__Kimera-VIO__params__uHumans1__ImuParams.yaml", "kimera", "", 200.0, 0, 0, "", 0.0},
    Expected{"kimera/MIT-SPARK__Kimera-VIO__params__uHumans1__LeftCameraParams.yaml", "kimera", "radtan", 415.69219381653056,
             720, 480, "imu0", -0.05},
    Expected{"kimera/MIT-SPARK__Kimera-VIO__params__uHumans1__RightCameraParams.yaml", "kimera", "radtan", 415.69219381653056,
             720, 480, "imu0", 0.05},
    Expected{"kimera/MIT-SPARK__Kimera-VIO__params__uHumans2__LeftCameraParams.yaml", "kimera", "radtan", 415.69219381653056,
             720, 480, "imu0", 0.0},
    Expected{"kimera/MIT-SPARK__Kimera-VIO__params__uHumans2__RightCameraParams.yaml", "kimera", "radtan", 415.69219381653056,
             720, 480, "imu0", 0.0},
    Expected{"kimera/MIT-SPARK__Kimera-VIO__tests__data__ForLoopClosureDetector__sensorLeft.yaml", "kimera", "radtan", 458.654,
             752, 480, "imu0", -0.0216401454975},
    Expected{"kimera/MIT-SPARK__Kimera-VIO__tests__data__ForLoopClosureDetector__sensorRight.yaml", "kimera", "radtan", 457.587,
             752, 480, "imu0", -0.0198435579556},
};

void expect_read(const Expected& expected, const Calibration& calibration) {
  const Rig& rig = calibration.rig;
  EXPECT_EQ(calibration.format->id, expected.format);
  const bool of_imu = std::string_view(expected.model).empty();
  ASSERT_EQ(rig.cameras.size(), of_imu ? 0U : 1U);
  ASSERT_EQ(rig.imus.size(), of_imu ? 1U : 0U);
  if (of_imu) {
    EXPECT_EQ(rig.imus.front().rate_hz, expected.fx);
  } else {
    const Camera& camera = rig.cameras.front();
    EXPECT_EQ(model_info(camera.model).id, expected.model);
    EXPECT_EQ(parameter(camera.model, "fx"), expected.fx);
    EXPECT_EQ(camera.image_size, (ImageSize{expected.width, expected.height}));
  }
  if (std::string_view(expected.frame).empty()) {
    EXPECT_TRUE(rig.poses.empty());
    return;
  }
  ASSERT_EQ(rig.poses.size(), 1U);
  EXPECT_EQ(rig.poses.front().a, expected.frame);
  EXPECT_EQ(rig.poses.front().b, of_imu ? "imu0" : rig.cameras.front().name);
  EXPECT_EQ(rig.poses.front().T_a_b(0, 3), expected.x);
}

TEST(Sensors, TheCorpusIsReadAsAPersonReadsIt) {
  const fs::path corpus = shared_dir() / "corpus" / "extra";
  if (!fs::exists(corpus / "kimera")) GTEST_SKIP() << "no corpus beside the repository: " << corpus;
  std::set<std::string> known = {"kimera/MIT-SPARK__Kimera-VIO__scripts__kalibr__templates__camera.yaml"};  // no YAML: refused
  for (const Expected& expected : kExpected) {
    SCOPED_TRACE(expected.file);
    known.insert(expected.file);
    const fs::path path = corpus / expected.file;
    ASSERT_TRUE(fs::exists(path));
    expect_read(expected, calibration_of(read_file(path), path.string()));
  }
  std::size_t files = 0;
  for (const char* folder : {"euroc_sensor", "kimera"}) {
    for (const fs::path& path : files_in(corpus / folder)) {
      ++files;
      EXPECT_TRUE(known.contains(std::string(folder) + "/" + path.filename().string())) << path;
    }
  }
  EXPECT_EQ(files, known.size());
  std::cout << kExpected.size() << " of " << files << " files read\n";
}

// Kimera-VIO itself would load all of them but the template and D455's ImuParams.yaml, which lacks a key.
TEST(Sensors, TheProgramLoadsTheCorpus) {
  const fs::path corpus = shared_dir() / "corpus" / "extra" / "kimera";
  if (!fs::exists(corpus)) GTEST_SKIP() << "no corpus beside the repository: " << corpus;
  for (const fs::path& path : files_in(corpus)) {
    const std::string name = path.filename().string();
    const bool of_imu = name.ends_with("ImuParams.yaml");
    const bool loads = consumers::find_consumer(of_imu ? "kimera-imu" : "kimera")->load(read_file(path), {}).loads();
    EXPECT_EQ(loads, name.find("templates") == std::string::npos && name.find("D455__Imu") == std::string::npos) << name;
  }
}

}  // namespace
}  // namespace fca::test
