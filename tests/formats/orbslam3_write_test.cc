// SPDX-License-Identifier: BSD-3-Clause
// Settings written from rigs: complete, of exactly the types the parser checks, in the right directions, read as meant.
#include "formats/lost_facts.h"
#include "formats/rigs.h"
#include "formats/test_files.h"

#include <fca/code.h>
#include <fca/formats/proof.h>
#include <fca/formats/wording.h>

#include <cmath>
#include <map>
#include <set>

#include <opencv2/core.hpp>
#include <opencv2/core/persistence.hpp>

namespace fca::test {
namespace {

const Format& orbslam3() { return *find_format("orbslam3"); }

WriteOptions as(const std::string& sensor) {
  WriteOptions options;
  options.sensor = sensor;
  return options;
}

Written write(const Rig& rig, const std::string& sensor = "") {
  Diagnostics diagnostics;
  std::optional<Written> written = orbslam3().write(nullptr, rig, as(sensor), diagnostics);
  EXPECT_TRUE(written) << sensor << ": " << (diagnostics.entries().empty() ? "" : message_of(diagnostics.entries().front()));
  return written ? *std::move(written) : Written();
}

std::string bytes_of(const Written& written) { return written.files.empty() ? "" : written.files.front().document.bytes(); }

cv::FileStorage opened(const std::string& bytes) { return {bytes, cv::FileStorage::READ | cv::FileStorage::MEMORY}; }

/// What Settings.cc of V1.0 asks for a key (FORMATS.md 3.2): readParameter<float> wants isReal(), <int> isInt(), <string>
/// isString(), <cv::Mat> a matrix that is then read with at<float>.
enum class Type { kText, kInt, kReal, kMatrixOfFloat };

Type type_of(const cv::FileNode& node) {
  if (node.isReal()) return Type::kReal;
  if (node.isInt()) return Type::kInt;
  if (node.isString()) return Type::kText;
  const cv::Mat matrix = node.mat();
  EXPECT_EQ(matrix.type(), CV_32F) << node.name();
  EXPECT_EQ(matrix.rows, 4) << node.name();
  EXPECT_EQ(matrix.cols, 4) << node.name();
  return Type::kMatrixOfFloat;
}

using Keys = std::map<std::string, Type>;

void add(Keys& keys, const std::string& prefix, std::initializer_list<const char*> names, Type type) {
  for (const char* name : names) keys[prefix + name] = type;
}

/// Every key V1.0 exits without in that mode, plus the optional ones we write: all of FORMATS.md 3.2's table.
Keys keys_of_v1(const std::string& type, const std::string& sensor) {
  const bool stereo = sensor.starts_with("stereo");
  const bool depth = sensor.starts_with("rgbd");
  Keys keys = {{"File.version", Type::kText}, {"Camera.type", Type::kText}, {"Camera.width", Type::kInt},
               {"Camera.height", Type::kInt}, {"Camera.fps", Type::kInt},   {"Camera.RGB", Type::kInt}};
  const auto add_camera = [&](const std::string& prefix) {
    add(keys, prefix, {"fx", "fy", "cx", "cy"}, Type::kReal);
    if (type == "KannalaBrandt8") add(keys, prefix, {"k1", "k2", "k3", "k4"}, Type::kReal);
    if (type == "PinHole with lens") add(keys, prefix, {"k1", "k2", "p1", "p2"}, Type::kReal);
    if (type == "KannalaBrandt8" && stereo) add(keys, prefix, {"overlappingBegin", "overlappingEnd"}, Type::kInt);
  };
  add_camera("Camera1.");
  if (stereo && type != "Rectified") {
    add_camera("Camera2.");
    keys["Stereo.T_c1_c2"] = Type::kMatrixOfFloat;
  }
  if (stereo || depth) keys["Stereo.ThDepth"] = Type::kReal;
  if (depth || (stereo && type == "Rectified")) keys["Stereo.b"] = Type::kReal;
  if (depth) keys["RGBD.DepthMapFactor"] = Type::kReal;
  if (sensor.ends_with("inertial")) {
    add(keys, "IMU.", {"NoiseGyro", "NoiseAcc", "GyroWalk", "AccWalk", "Frequency"}, Type::kReal);
    keys["IMU.T_b_c1"] = Type::kMatrixOfFloat;
  }
  add(keys, "ORBextractor.", {"nFeatures", "nLevels", "iniThFAST", "minThFAST"}, Type::kInt);
  keys["ORBextractor.scaleFactor"] = Type::kReal;
  add(keys, "Viewer.",
      {"KeyFrameSize", "KeyFrameLineWidth", "GraphLineWidth", "PointSize", "CameraSize", "CameraLineWidth", "ViewpointX",
       "ViewpointY", "ViewpointZ", "ViewpointF"},
      Type::kReal);
  return keys;
}

/// Whole numbers everywhere, the hardest case for "float": 200 must become 200.0.
Rig whole_numbers(Rig rig) {
  for (Camera& camera : rig.cameras) {
    for (const ParameterId name : ParameterIds{"fx", "fy", "cx", "cy"})
      set_parameter(camera.model, name, std::round(parameter(camera.model, name).value()));
    for (const ParameterId name : ParameterIds{"k1", "p1"}) set_parameter(camera.model, name, 0.0);
  }
  for (Imu& imu : rig.imus) imu.gyroscope_noise_density = 1.0;
  if (rig.baseline_m) rig.baseline_m = 1.0;
  for (PoseEdge& edge : rig.poses) edge.T_a_b = Transform{};
  return rig;
}

struct Mode {
  const char* model;
  const char* type;  ///< As keys_of_v1 names it.
  const char* sensor;
  RigShape shape;
  bool baseline = false;
};

// KannalaBrandt8 with rgbd-inertial is absent: V1.0 dereferences a second camera that is not there (FORMATS.md 3.2).
constexpr Mode kModes[] = {
    {"kb4", "KannalaBrandt8", "mono", {false, false}},
    {"kb4", "KannalaBrandt8", "stereo", {true, false}},
    {"kb4", "KannalaBrandt8", "rgbd", {false, false}, true},
    {"kb4", "KannalaBrandt8", "mono-inertial", {false, true}},
    {"kb4", "KannalaBrandt8", "stereo-inertial", {true, true}},
    {"radtan", "PinHole with lens", "mono", {false, false}},
    {"radtan", "PinHole with lens", "stereo", {true, false}},
    {"radtan", "PinHole with lens", "rgbd", {false, false}, true},
    {"radtan", "PinHole with lens", "mono-inertial", {false, true}},
    {"radtan", "PinHole with lens", "stereo-inertial", {true, true}},
    {"radtan", "PinHole with lens", "rgbd-inertial", {false, true}, true},
    {"pinhole", "PinHole", "mono", {false, false}},
    {"pinhole", "PinHole", "stereo", {true, false}},
    {"pinhole", "PinHole", "rgbd", {false, false}, true},
    {"pinhole", "PinHole", "mono-inertial", {false, true}},
    {"pinhole", "PinHole", "stereo-inertial", {true, true}},
    {"pinhole", "PinHole", "rgbd-inertial", {false, true}, true},
    {"pinhole", "Rectified", "stereo", {false, false}, true},
    {"pinhole", "Rectified", "stereo-inertial", {false, true}, true},
};

Rig rig_of(const Mode& mode) {
  Rig rig = sample_rig(mode.model, mode.shape);
  if (mode.baseline) rig.baseline_m = 0.11007784219;
  return rig;
}

TEST(OrbSlam3Write, EveryModeHasExactlyTheKeysAndTypesOfV1) {
  for (const Mode& mode : kModes) {
    for (const bool whole : {false, true}) {
      SCOPED_TRACE(std::string(mode.type) + " " + mode.sensor + (whole ? " in whole numbers" : ""));
      const std::string bytes = bytes_of(write(whole ? whole_numbers(rig_of(mode)) : rig_of(mode), mode.sensor));
      const cv::FileStorage storage = opened(bytes);
      ASSERT_TRUE(storage.isOpened()) << bytes;
      const Keys expected = keys_of_v1(mode.type, mode.sensor);
      for (const auto& [key, type] : expected) {
        const cv::FileNode node = storage[key];
        ASSERT_FALSE(node.empty()) << key << " is missing in\n" << bytes;
        EXPECT_EQ(static_cast<int>(type_of(node)), static_cast<int>(type)) << key;
      }
      std::set<std::string> seen;
      const text::Document document = document_of(bytes);
      for (const text::Entry& entry : document.root().entries) {
        EXPECT_TRUE(expected.contains(entry.key.value)) << entry.key.value << " is no key of this mode";
        EXPECT_TRUE(seen.insert(entry.key.value).second) << entry.key.value << " stands twice";
      }
      const std::string type = static_cast<std::string>(storage["Camera.type"]);
      EXPECT_EQ(type, std::string(mode.type).substr(0, std::string(mode.type).find(' ')));
      EXPECT_EQ(static_cast<std::string>(storage["File.version"]), "1.0");
    }
  }
}

TEST(OrbSlam3Write, OrbSlam3LoadsItInItsModeAndAgrees) {
  for (const Mode& mode : kModes) {
    SCOPED_TRACE(std::string(mode.type) + " " + mode.sensor);
    const Rig rig = rig_of(mode);
    const Written written = write(rig, mode.sensor);
    EXPECT_EQ(written.sensor, mode.sensor);
    EXPECT_EQ(written.files.front().programs, std::vector<std::string>{"orbslam3"});
    const ProofResult proof = prove(*consumers::find_consumer("orbslam3"), bytes_of(written), {mode.sensor}, rig);
    EXPECT_TRUE(proof.loads) << (proof.refusals.empty() ? "" : sentence_of(proof.refusals.front()));
    EXPECT_TRUE(proof.agrees()) << proof.max_diff_px << " px, poses " << proof.max_diff_pose << ", compared "
                                << proof.compared_share;
    EXPECT_GT(proof.compared_share, 0.5);
  }
}

TEST(OrbSlam3Write, ReadsBackBitEqual) {
  for (const Mode& mode : kModes) {
    SCOPED_TRACE(std::string(mode.type) + " " + mode.sensor);
    const Rig rig = rig_of(mode);
    const Rig back = calibration_of(bytes_of(write(rig, mode.sensor))).rig;
    ASSERT_EQ(back.cameras.size(), rig.cameras.size());
    for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
      EXPECT_EQ(back.cameras[i].model, rig.cameras[i].model);
      EXPECT_EQ(back.cameras[i].image_size, rig.cameras[i].image_size);
    }
    EXPECT_EQ(back.baseline_m, rig.baseline_m);
    if (std::string(mode.sensor).ends_with("inertial")) {
      Imu expected = tumvi_imu();
      expected.topic.clear();
      ASSERT_EQ(back.imus.size(), 1U);
      EXPECT_EQ(back.imus.front(), expected);
    }
  }
}

// Figures: a RealSense T265 as upstream's Examples/Monocular/RealSense_T265.yaml specifies it. Its lens bends more than
// TUM-VI's and its image is wider: float arithmetic alone costs 2.6e-4 px there, which is no disagreement.
TEST(OrbSlam3Write, AT265Agrees) {
  Rig rig = sample_rig("kb4", {false, false});
  rig.cameras[0].model = model_of("kb4", {283.794586181641, 284.952392578125, 424.865386962891, 396.590911865234,
                                          -0.0027128029614687, 0.0366887785494328, -0.0354852788150311, 0.00590010220184922});
  rig.cameras[0].image_size = ImageSize{848, 800};
  const ProofResult proof = prove(*consumers::find_consumer("orbslam3"), bytes_of(write(rig)), {"mono"}, rig);
  EXPECT_TRUE(proof.agrees()) << proof.max_diff_px << " px, compared " << proof.compared_share;
  EXPECT_LT(proof.max_diff_px, 1e-3);
}

// FORMATS.md 3.2: T_c1_c2 = inverse of Kalibr's T_cn_cnm1, T_b_c1 = inverse of T_cam_imu. The numbers of TUM-VI as upstream's
// Examples/Stereo-Inertial/TUM-VI.yaml specifies them, to the digits it prints.
TEST(OrbSlam3Write, PosesPointTheRightWay) {
  const cv::FileStorage storage = opened(bytes_of(write(sample_rig("kb4", {true, true}))));
  const cv::Mat T_c1_c2 = storage["Stereo.T_c1_c2"].mat();
  const cv::Mat T_b_c1 = storage["IMU.T_b_c1"].mat();
  const float stereo[] = {0.999999445773493F,  0.000791687752817F,  0.000694034010224F, 0.101063427414194F,
                          -0.000823363992158F, 0.998899461915674F,  0.046895490788700F, 0.001946204678584F,
                          -0.000656143613644F, -0.046896036240590F, 0.998899560146304F, 0.001015350132563F};
  const float imu[] = {-0.9995250378696743F,   0.0075019185074052044F, -0.02989013031643309F, 0.045574835649698026F,
                       0.029615343885863205F,  -0.03439736061393144F,  -0.998969345370175F,   -0.071161801837997044F,
                       -0.008522328211654736F, -0.9993800792498829F,   0.03415885127385616F,  -0.044681254117144367F};
  for (int i = 0; i < 12; ++i) {
    EXPECT_NEAR(T_c1_c2.at<float>(i / 4, i % 4), stereo[i], 1e-7F) << i;
    EXPECT_NEAR(T_b_c1.at<float>(i / 4, i % 4), imu[i], 1e-7F) << i;
  }
  const Rig back = calibration_of(bytes_of(write(sample_rig("kb4", {true, true})))).rig;
  EXPECT_LE(element_difference(back.resolve("cam1", "cam0").value(), T_cam1_cam0()), 1e-12);
  EXPECT_LE(element_difference(back.resolve("cam0", "imu0").value(), T_cam0_imu()), 1e-12);
}

TEST(OrbSlam3Write, WithoutASensorTheRichestServedModeIsWritten) {
  const auto sensor_of = [](RigShape shape) { return write(sample_rig("kb4", shape)).sensor; };
  EXPECT_EQ(sensor_of({false, false}), "mono");
  EXPECT_EQ(sensor_of({true, false}), "stereo");
  EXPECT_EQ(sensor_of({false, true}), "mono-inertial");
  EXPECT_EQ(sensor_of({true, true}), "stereo-inertial");
  Rig without_noise = sample_rig("kb4", {true, true});
  without_noise.imus.front().accelerometer_random_walk.reset();
  const Written poorer = write(without_noise);
  EXPECT_EQ(poorer.sensor, "stereo");
  const Message lacks = {Code::kOrbslam3ModeLacks, {"stereo-inertial", Message{Code::kOrbslam3LacksImuNoise}}};
  EXPECT_TRUE(is_said_of(poorer.headline, Code::kOrbslam3Headline, {"stereo", lacks})) << text::text_of(poorer.headline);
}

// Facts are never made up (CLI.md): a mode that the rig does not serve is refused, whatever is asked.
TEST(OrbSlam3Write, FactsAreNeverDefaulted) {
  const auto refused = [](Rig rig, const std::string& sensor) {
    Diagnostics diagnostics;
    EXPECT_FALSE(orbslam3().write(nullptr, rig, as(sensor), diagnostics)) << sensor;
    EXPECT_TRUE(diagnostics.has_errors()) << sensor;
  };
  const Rig mono = sample_rig("kb4", {false, false});
  for (const char* sensor : {"stereo", "rgbd", "mono-inertial", "stereo-inertial", "rgbd-inertial"}) refused(mono, sensor);
  Rig no_rate = sample_rig("kb4", {false, true});
  no_rate.imus.front().rate_hz.reset();
  refused(no_rate, "mono-inertial");
  Rig no_pose = sample_rig("kb4", {true, true});
  no_pose.poses.clear();
  refused(no_pose, "stereo");
  refused(no_pose, "mono-inertial");
  Rig no_size = mono;
  no_size.cameras[0].image_size.reset();
  refused(no_size, "mono");
}

TEST(OrbSlam3Write, TheFrameRateIsTheInputsElseADefaultToLookAt) {
  Rig rig = sample_rig("kb4", {false, false});
  const Written defaulted = write(rig);
  const auto fps = std::ranges::find(defaulted.defaults, "Camera.fps", &DefaultedValue::key);
  ASSERT_NE(fps, defaulted.defaults.end());
  EXPECT_TRUE(fps->look_at_it);
  rig.cameras[0].frame_rate_hz = 25.0;
  const Written stated = write(rig);
  EXPECT_EQ(std::ranges::find(stated.defaults, "Camera.fps", &DefaultedValue::key), stated.defaults.end());
  EXPECT_EQ(static_cast<int>(opened(bytes_of(stated))["Camera.fps"]), 25);
}

// "with the upstream default and a comment saying that it is a default"
TEST(OrbSlam3Write, DefaultsAreMarkedInTheFile) {
  const std::string bytes = bytes_of(write(sample_rig("kb4", {true, true})));
  const std::vector<std::string> lines = split(bytes, '\n');
  for (const char* key : {"Camera.fps:", "Camera.RGB:", "Stereo.ThDepth:"}) {
    const auto line = std::ranges::find_if(lines, [key](const std::string& l) { return l.starts_with(key); });
    ASSERT_NE(line, lines.end()) << key;
    ASSERT_NE(line, lines.begin());
    EXPECT_NE((line - 1)->find("Default"), std::string::npos) << key << " behind '" << *(line - 1) << "'";
  }
  for (const char* key : {"ORBextractor.nFeatures", "Viewer.KeyFrameSize"}) {
    const std::size_t at = bytes.find(key);
    const std::size_t comment = bytes.rfind('#', at);
    EXPECT_NE(bytes.substr(comment, at - comment).find("upstream"), std::string::npos) << key;
  }
}

// Back to back, and lenses of 60 degrees from the axis.
TEST(OrbSlam3Write, CamerasThatSeeNothingInCommonAreWarnedOf) {
  Rig rig = sample_rig("kb4", {true, false});
  const auto warned = [&rig](double max_angle_rad) {
    WriteOptions options;
    options.max_angle_rad = max_angle_rad;
    options.sensor = "stereo";  // by itself the writer makes no pair of them
    Diagnostics diagnostics;
    EXPECT_TRUE(write_calibration(*find_format("orbslam3"), nullptr, rig, options, diagnostics));
    return std::ranges::any_of(diagnostics.entries(), [](const Diagnostic& entry) { return id_of(entry) == "nothing-shared"; });
  };
  EXPECT_FALSE(warned(1.0));
  rig.poses.front().T_a_b = {{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1}};
  EXPECT_TRUE(warned(1.0));
  EXPECT_FALSE(warned(1.9)) << "with wider lenses they share a ring";
}

struct Dialect {
  const char* model;
  const char* program;
  const char* type;
};
constexpr Dialect kDialects[] = {{"eucm", "slam_no_opt", "EUCM"}, {"ds", "urbste", "DoubleSphere"}};

// A dialect never says File.version: V1.0 would exit with "EUCM not known" (FORMATS.md 3.4).
TEST(OrbSlam3Write, DialectsAreReadByTheirForkAndNotByStock) {
  for (const Dialect& dialect : kDialects) {
    for (const bool two : {false, true}) {
      const char* sensor = two ? "stereo" : "mono";
      SCOPED_TRACE(std::string(dialect.model) + " " + sensor);
      const Rig rig = sample_rig(dialect.model, {two, false});
      const Written written = write(rig, sensor);
      const std::string bytes = bytes_of(written);
      EXPECT_EQ(written.files.front().programs, std::vector<std::string>{dialect.program});
      EXPECT_TRUE(is_said_of(written.headline, Code::kOrbslam3Headline, {sensor, Message{Code::kOrbslam3StockByModel}}))
          << text::text_of(written.headline);
      const cv::FileStorage storage = opened(bytes);
      ASSERT_TRUE(storage.isOpened());
      EXPECT_TRUE(storage["File.version"].empty());
      EXPECT_EQ(static_cast<std::string>(storage["Camera.type"]), dialect.type);
      const ProofResult proof = prove(*consumers::find_consumer(dialect.program), bytes, {sensor}, rig);
      EXPECT_TRUE(proof.loads) << (proof.refusals.empty() ? "" : sentence_of(proof.refusals.front()));
      EXPECT_TRUE(proof.agrees()) << proof.max_diff_px << " px, poses " << proof.max_diff_pose;
      EXPECT_FALSE(consumers::find_consumer("orbslam3")->load(bytes, {sensor}).loads());
      const Rig back = calibration_of(bytes).rig;
      ASSERT_EQ(back.cameras.size(), rig.cameras.size());
      for (std::size_t i = 0; i < rig.cameras.size(); ++i) EXPECT_EQ(back.cameras[i].model, rig.cameras[i].model);
      if (two) {
        EXPECT_LE(element_difference(back.resolve("cam1", "cam0").value(), T_cam1_cam0()), 1e-12);
      }
    }
  }
}

TEST(OrbSlam3Write, TheEucmDialectHasItsNumbersInK1AndK2) {
  const cv::FileStorage storage = opened(bytes_of(write(sample_rig("eucm", {false, false}))));
  EXPECT_EQ(static_cast<double>(storage["Camera.k1"]), 0.6291060881178562);
  EXPECT_EQ(static_cast<double>(storage["Camera.k2"]), 1.0418067381860868);
  EXPECT_EQ(static_cast<double>(storage["Camera.p1"]), 0.0);
  EXPECT_EQ(static_cast<double>(storage["Camera.p2"]), 0.0);
  for (const char* key : {"Camera.fx", "Camera.k1", "Camera.k2", "Camera.p1", "Camera.p2", "Camera.bf"}) {
    const cv::FileNode node = storage[key];
    EXPECT_TRUE(node.empty() || node.isReal()) << key;
  }
}

// Both forks compute 1 / (beta (2 alpha - 1)) unguarded: at alpha <= 0.5 every point is rejected. Nothing in the registry may
// let such a camera through as it is.
TEST(OrbSlam3Write, EucmAtOrBelowOneHalfIsOutsideTheStoredRange) {
  const StoredModel* row = find_stored_model(orbslam3(), "eucm", false);
  ASSERT_NE(row, nullptr);
  EXPECT_FALSE(row->stock);
  for (const auto& [alpha, good] : {std::pair{0.3, false}, std::pair{0.5, false}, std::pair{0.63, true}}) {
    CameraModel model = sample_model("eucm");
    set_parameter(model, "alpha", alpha);
    EXPECT_EQ(within(model, row->ranges), good) << alpha;
  }
}

// The writer itself is the last guard.
TEST(OrbSlam3Write, EucmAtOrBelowOneHalfIsRefused) {
  Rig rig = sample_rig("eucm", {false, false});
  set_parameter(rig.cameras[0].model, "alpha", 0.45);
  Diagnostics diagnostics;
  EXPECT_FALSE(orbslam3().write(nullptr, rig, as("mono"), diagnostics));
  EXPECT_TRUE(diagnostics.has_errors());
}

TEST(OrbSlam3Write, StockModelsAreNeverADialect) {
  for (const char* model : {"kb4", "radtan", "pinhole"}) EXPECT_TRUE(find_stored_model(orbslam3(), model, true)) << model;
  for (const char* model : {"eucm", "ds", "ucm", "mei", "fov"})
    EXPECT_FALSE(find_stored_model(orbslam3(), model, true)) << model;
}

TEST(OrbSlam3Write, LossesAreListed) {
  Rig rig = sample_rig("kb4", {true, true});
  rig.cameras[0].time_offset_s = 0.0021;
  rig.cameras[1].time_offset_s = -0.0035;
  rig.cameras[0].frame_rate_hz = 29.97;
  const Written written = write(rig, "mono");
  std::set<std::string> codes;
  for (const Loss& loss : written.losses) {
    codes.insert(id_of(loss));
    EXPECT_FALSE(what_of(loss).empty() || why_of(loss).empty()) << id_of(loss);
  }
  for (const char* code : {"time-offset-dropped", "camera-dropped", "imu-dropped", "topic-dropped", "frame-rate-rounded"})
    EXPECT_TRUE(codes.contains(code)) << code;
  // t_imu = t_cam + offset: the stamp to write is t_cam + offset, so the sign stays (FORMATS.md, "Time offset").
  const Written stereo = write(rig, "stereo-inertial");
  EXPECT_TRUE(loses(stereo, Code::kTimeOffsetDropped, {"cam0", 0.0021}));
  EXPECT_TRUE(loses(stereo, Code::kTimeOffsetDropped, {"cam1", -0.0035}));
}

TEST(OrbSlam3Write, WhatOneFileCannotHoldIsRefused) {
  const auto code_of = [](const Rig& rig) {
    Diagnostics diagnostics;
    EXPECT_FALSE(orbslam3().write(nullptr, rig, as("stereo"), diagnostics));
    return diagnostics.entries().empty() ? std::string("nothing said") : id_of(diagnostics.entries().front());
  };
  Rig sizes = sample_rig("kb4", {true, false});
  sizes.cameras[1].image_size = ImageSize{640, 480};
  EXPECT_EQ(code_of(sizes), "sensor-not-served");
  Rig models = sample_rig("kb4", {true, false});
  models.cameras[1].model = sample_model("radtan", 1);
  EXPECT_EQ(code_of(models), "models-differ");
  Rig foreign = sample_rig("kb4", {true, false});
  foreign.cameras[1].model = sample_model("mei", 1);
  EXPECT_EQ(code_of(foreign), "model-not-storable");
}

// Sophus aborts on a matrix that is no rotation to 1e-5; V1.0's own layout does not go through it.
TEST(OrbSlam3Write, BeforeV1ARotationOfFewDigitsIsTheNearestOne) {
  Rig rig = sample_rig("kb4", {true, true});
  for (PoseEdge& edge : rig.poses) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) edge.T_a_b(row, column) = std::round(edge.T_a_b(row, column) * 1e3) / 1e3;
    }
  }
  WriteOptions options = as("stereo-inertial");
  options.layout = "old";
  Diagnostics diagnostics;
  const std::optional<Written> written = orbslam3().write(nullptr, rig, options, diagnostics);
  ASSERT_TRUE(written);
  EXPECT_EQ(written->restated.size(), 1U);
  EXPECT_TRUE(std::ranges::any_of(written->losses, [](const Loss& loss) { return loss.kind == Code::kPoseRecomputed; }));
  EXPECT_TRUE(consumers::find_consumer("orbslam3")->load(bytes_of(*written), {"stereo-inertial"}).loads());
  options.layout = "v1";
  const std::optional<Written> v1 = orbslam3().write(nullptr, rig, options, diagnostics);
  ASSERT_TRUE(v1);
  EXPECT_TRUE(v1->restated.empty());
}

}  // namespace
}  // namespace fca::test
