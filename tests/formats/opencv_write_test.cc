// SPDX-License-Identifier: BSD-3-Clause
// OpenCV calibrations written from rigs: through every layout and syntax they read back bit-equal, cv::FileStorage finds the
// types its programs ask for, and the program's own formula gives our pixels.
#include "formats/rigs.h"
#include "formats/test_files.h"

#include <fca/formats/proof.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/wording.h>

#include <cmath>
#include <set>

#include <rapidcheck/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/core/persistence.hpp>

namespace fca::test {
namespace {

const Format& opencv_format() { return *find_format("opencv"); }

WriteOptions options_for(const std::string& layout, const std::string& extension = "") {
  WriteOptions options;
  options.layout = layout;
  options.extension = extension;
  return options;
}

std::optional<Written> try_write(const Rig& rig, const std::string& layout, const std::string& extension, std::string& codes) {
  Diagnostics diagnostics;
  std::optional<Written> written = opencv_format().write(nullptr, rig, options_for(layout, extension), diagnostics);
  for (const Diagnostic& entry : diagnostics.entries()) codes += (codes.empty() ? "" : " ") + id_of(entry);
  return written;
}

Written write(const Rig& rig, const std::string& layout = "", const std::string& extension = "") {
  std::string codes;
  std::optional<Written> written = try_write(rig, layout, extension, codes);
  EXPECT_TRUE(written) << codes;
  return written ? *std::move(written) : Written();
}

std::string bytes_of(const Written& written, std::size_t file = 0) {
  return file < written.files.size() ? written.files[file].document.bytes() : "";
}

Rig read_back(const std::string& bytes, const std::string& name) {
  Parsed parsed = parse(bytes, name);
  EXPECT_TRUE(parsed.document) << parsed.rendered() << bytes;
  if (!parsed.document) return {};
  const std::optional<Calibration> calibration = read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics);
  EXPECT_TRUE(calibration) << parsed.rendered() << bytes;
  EXPECT_EQ(parsed.rendered(), "") << bytes;
  if (!calibration) return {};
  EXPECT_EQ(calibration->format->id, "opencv");
  return calibration->rig;
}

cv::FileStorage opened(const std::string& bytes) { return {bytes, cv::FileStorage::READ | cv::FileStorage::MEMORY}; }

constexpr const char* kSyntaxes[] = {".yml", ".yaml", ".xml", ".json"};
constexpr const char* kModels[] = {"pinhole", "radtan", "rational", "kb4", "mei"};

/// A real of any exponent a calibration might hold, with all its bits.
double any_real(double largest) {
  const double mantissa = *rc::gen::map(rc::gen::arbitrary<std::int64_t>(),
                                        [](std::int64_t n) { return static_cast<double>(n) / 9223372036854775808.0; });
  return mantissa * largest * std::pow(10.0, -*rc::gen::inRange(0, 9));
}

CameraModel any_model(const std::string& id) {
  CameraModel model = *make_model(id);
  const std::span<double> values = parameter_values(model);
  for (double& value : values) value = any_real(2.0);
  for (const ParameterId name : ParameterIds{"fx", "fy", "cx", "cy"})
    set_parameter(model, name, 200.0 + std::abs(any_real(900.0)));
  if (id == "mei") set_parameter(model, "xi", std::abs(any_real(3.0)));
  // Were all zero, the file would say a pinhole.
  if (id != "pinhole") values[id == "mei" ? 5 : 4] += 0.0078125;
  return model;
}

Transform any_pose() {
  // A rotation by halves of angles whose sines are rational: exact enough, of all directions.
  const double a = any_real(1.0);
  const double b = any_real(1.0);
  const double c = any_real(1.0);
  const double n = 1.0 + a * a + b * b + c * c;
  Transform T;
  T(0, 0) = (1 + a * a - b * b - c * c) / n, T(0, 1) = 2 * (a * b - c) / n, T(0, 2) = 2 * (a * c + b) / n;
  T(1, 0) = 2 * (a * b + c) / n, T(1, 1) = (1 - a * a + b * b - c * c) / n, T(1, 2) = 2 * (b * c - a) / n;
  T(2, 0) = 2 * (a * c - b) / n, T(2, 1) = 2 * (b * c + a) / n, T(2, 2) = (1 - a * a - b * b + c * c) / n;
  for (int row = 0; row < 3; ++row) T(row, 3) = any_real(2.0);
  return T;
}

/// Cameras of one model ("" for several), one size, posed as the layout specifies it.
Rig any_rig(std::size_t cameras, const std::string& model, bool to_reference) {
  Rig rig;
  const ImageSize size = {*rc::gen::inRange(1, 5000), *rc::gen::inRange(1, 5000)};
  for (std::size_t i = 0; i < cameras; ++i) {
    const std::string id =
        model.empty() ? *rc::gen::elementOf(std::vector<std::string>{"pinhole", "radtan", "rational", "kb4"}) : model;
    rig.cameras.push_back({"cam" + std::to_string(i), size, any_model(id), std::nullopt, std::nullopt, ""});
    if (to_reference) rig.poses.push_back({"reference", "cam" + std::to_string(i), any_pose()});
  }
  if (!to_reference && cameras == 2) rig.poses.push_back({"cam1", "cam0", any_pose()});
  return rig;
}

void expect_proof(const std::string& bytes, const Rig& rig) {
  const ProofResult proof = prove(*consumers::find_consumer("opencv"), bytes, {}, rig);
  RC_ASSERT(proof.loads);
  RC_ASSERT(proof.poses_agree);
  RC_ASSERT(proof.warnings.empty());
}

RC_GTEST_PROP(OpenCvWrite, OneCameraReadsBackBitEqual, ()) {
  const std::string model = *rc::gen::elementOf(std::vector<std::string>(std::begin(kModels), std::end(kModels)));
  const std::string syntax = *rc::gen::elementOf(std::vector<std::string>(std::begin(kSyntaxes), std::end(kSyntaxes)));
  const std::string layout = model == "mei" ? *rc::gen::elementOf(std::vector<std::string>{"", "calibration", "omnidir"})
                                            : *rc::gen::elementOf(std::vector<std::string>{"", "calibration", "cameras"});
  const Rig rig = any_rig(1, model, false);
  const Written written = write(rig, layout, syntax);
  RC_ASSERT(written.files.size() == 1U);
  const Rig back = read_back(bytes_of(written), "x" + syntax);
  RC_ASSERT(back.cameras == rig.cameras);
  RC_ASSERT(back.poses.empty());
  RC_ASSERT(back.extra_fields.empty());
  expect_proof(bytes_of(written), rig);
}

RC_GTEST_PROP(OpenCvWrite, PairsReadBackBitEqual, ()) {
  const std::string model = *rc::gen::elementOf(std::vector<std::string>(std::begin(kModels), std::end(kModels)));
  const std::string syntax = *rc::gen::elementOf(std::vector<std::string>(std::begin(kSyntaxes), std::end(kSyntaxes)));
  const std::string layout = model == "mei" ? *rc::gen::elementOf(std::vector<std::string>{"", "stereo", "omnidir"})
                                            : *rc::gen::elementOf(std::vector<std::string>{"", "stereo", "left-right"});
  const Rig rig = any_rig(2, model, false);
  const Written written = write(rig, layout, syntax);
  RC_ASSERT(written.files.size() == 1U);
  const Rig back = read_back(bytes_of(written), "x" + syntax);
  RC_ASSERT(back.cameras == rig.cameras);
  RC_ASSERT(back.poses == rig.poses);
  expect_proof(bytes_of(written), rig);
}

RC_GTEST_PROP(OpenCvWrite, MapsReadBackBitEqual, ()) {
  const std::string syntax = *rc::gen::elementOf(std::vector<std::string>(std::begin(kSyntaxes), std::end(kSyntaxes)));
  const Rig rig = any_rig(*rc::gen::inRange<std::size_t>(1, 6), "", true);
  const Written written = write(rig, "cameras", syntax);
  RC_ASSERT(written.files.size() == 1U);
  const Rig back = read_back(bytes_of(written), "x" + syntax);
  RC_ASSERT(back.cameras == rig.cameras);
  RC_ASSERT(back.poses == rig.poses);
  expect_proof(bytes_of(written), rig);
}

// One changed number changes its own bytes and no other.
RC_GTEST_PROP(OpenCvWrite, AnEditTouchesOneNumber, ()) {
  const std::string syntax = *rc::gen::elementOf(std::vector<std::string>(std::begin(kSyntaxes), std::end(kSyntaxes)));
  const bool maps = *rc::gen::arbitrary<bool>();
  const std::string model = maps ? "" : *rc::gen::elementOf(std::vector<std::string>(std::begin(kModels), std::end(kModels)));
  Rig rig = any_rig(2, model, maps);
  Parsed parsed = parse(bytes_of(write(rig, maps ? "cameras" : "", syntax)), "x" + syntax);
  RC_ASSERT(parsed.document.has_value());
  const std::vector<const text::Node*> before = scalars_of(*parsed.document);
  const auto camera = *rc::gen::inRange<std::size_t>(0, 2);
  const std::span<double> values = parameter_values(rig.cameras[camera].model);
  const auto place = *rc::gen::inRange<std::size_t>(0, values.size());
  values[place] += 0.015625;
  Diagnostics diagnostics;
  const std::optional<Written> written = opencv_format().write(&*parsed.document, rig, {}, diagnostics);
  RC_ASSERT(written.has_value());
  const std::string bytes = bytes_of(*written);
  Parsed again = parse(bytes, "x" + syntax);
  RC_ASSERT(again.document.has_value());
  const std::vector<const text::Node*> after = scalars_of(*again.document);
  RC_ASSERT(after.size() == before.size());
  int changed = 0;
  for (std::size_t i = 0; i < after.size(); ++i) changed += after[i]->value != before[i]->value ? 1 : 0;
  RC_ASSERT(changed == 1);
  // Put back, the bytes are the old ones.
  values[place] = *text::parse_real("0");
  const Rig old = read_back(parsed.document->source().bytes, "x" + syntax);
  const std::optional<Written> undone = opencv_format().write(&*again.document, old, {}, diagnostics);
  RC_ASSERT(undone.has_value());
  RC_ASSERT(bytes_of(*undone) == parsed.document->source().bytes);
}

std::string type_of(const cv::FileNode& node) {
  if (node.isInt()) return "int";
  if (node.isReal()) return "real";
  if (!node.isMap()) return node.empty() ? "none" : "other";
  if (node["data"].empty()) return "map";
  const cv::Mat matrix = node.mat();
  EXPECT_EQ(matrix.type(), CV_64F) << node.name();
  return std::to_string(matrix.rows) + " x " + std::to_string(matrix.cols);
}

/// Whole numbers everywhere, the hardest case for "real": 200 must become 200.0.
Rig whole_numbers(Rig rig) {
  for (Camera& camera : rig.cameras) {
    for (double& value : parameter_values(camera.model)) value = std::round(value);
    set_parameter(camera.model, "k2", 1.0);
    set_parameter(camera.model, "xi", 2.0);
  }
  for (PoseEdge& edge : rig.poses) edge.T_a_b = Transform{};
  return rig;
}

using Keys = std::vector<std::pair<const char*, const char*>>;

void expect_keys(const Rig& rig, const std::string& layout, const Keys& keys) {
  for (const char* syntax : kSyntaxes) {
    const Written written = write(whole_numbers(rig), layout, syntax);
    const cv::FileStorage storage = opened(bytes_of(written));
    ASSERT_TRUE(storage.isOpened()) << layout << syntax << bytes_of(written);
    for (const auto& [key, type] : keys) EXPECT_EQ(type_of(storage[key]), type) << layout << " " << syntax << " " << key;
    EXPECT_EQ(storage.root().size(), keys.size()) << layout << " " << syntax;
  }
}

TEST(OpenCvWrite, TypesAreThoseCvFileStorageWants) {
  expect_keys(sample_rig("radtan", {}), "calibration",
              {{"image_width", "int"},
               {"image_height", "int"},
               {"fisheye_model", "int"},
               {"camera_matrix", "3 x 3"},
               {"distortion_coefficients", "5 x 1"}});
  expect_keys(sample_rig("kb4", {}), "",
              {{"image_width", "int"},
               {"image_height", "int"},
               {"fisheye_model", "int"},
               {"camera_matrix", "3 x 3"},
               {"distortion_coefficients", "4 x 1"}});
  expect_keys(sample_rig("mei", {}), "",
              {{"image_width", "int"},
               {"image_height", "int"},
               {"camera_matrix", "3 x 3"},
               {"distortion_coefficients", "1 x 4"},
               {"xi", "real"}});
  expect_keys(sample_rig("kb4", {true, false}), "",
              {{"image_width", "int"},
               {"image_height", "int"},
               {"fisheye_model", "int"},
               {"M1", "3 x 3"},
               {"D1", "1 x 4"},
               {"M2", "3 x 3"},
               {"D2", "1 x 4"},
               {"R", "3 x 3"},
               {"T", "3 x 1"}});
  expect_keys(sample_rig("radtan", {true, false}), "left-right",
              {{"image_width", "int"},
               {"image_height", "int"},
               {"fisheye_model", "int"},
               {"camera_matrix_left", "3 x 3"},
               {"dist_coeffs_left", "5 x 1"},
               {"camera_matrix_right", "3 x 3"},
               {"dist_coeffs_right", "5 x 1"},
               {"R", "3 x 3"},
               {"T", "3 x 1"}});
  expect_keys(sample_rig("radtan", {true, false}), "cameras", {{"nb_camera", "int"}, {"camera_0", "map"}, {"camera_1", "map"}});
  const cv::FileStorage maps = opened(bytes_of(write(sample_rig("kb4", {true, false}), "cameras")));
  const cv::FileNode camera = maps["camera_1"];
  EXPECT_EQ(static_cast<int>(camera["distortion_type"]), 1);
  EXPECT_EQ(type_of(camera["distortion_vector"]), "1 x 4");
  EXPECT_EQ(type_of(camera["camera_pose_matrix"]), "4 x 4");
  EXPECT_EQ(type_of(camera["img_width"]), "int");
}

// Inside the image, with real lenses: our pixels are OpenCV's.
TEST(OpenCvWrite, EveryFileIsProven) {
  for (const char* model : {"pinhole", "radtan", "kb4", "mei"}) {
    for (const bool two : {false, true}) {
      for (const char* layout : {"", "calibration", "stereo", "omnidir", "cameras", "left-right"}) {
        for (const char* syntax : kSyntaxes) {
          SCOPED_TRACE(std::string(model) + (two ? " two " : " one ") + layout + syntax);
          const Rig rig = sample_rig(model, {two, false});
          std::string codes;
          const std::optional<Written> written = try_write(rig, layout, syntax, codes);
          if (!written) {
            EXPECT_EQ(codes, "layout-not-served");
            continue;
          }
          std::size_t cameras = 0;
          for (const Written::File& file : written->files) {
            EXPECT_EQ(file.programs, std::vector<std::string>{"opencv"});
            const ProofResult proof = prove(*consumers::find_consumer("opencv"), file.document.bytes(), {}, rig, file.cameras);
            EXPECT_TRUE(proof.agrees()) << proof.max_diff_px << " px, poses " << proof.max_diff_pose;
            EXPECT_TRUE(proof.warnings.empty()) << sentence_of(proof.warnings.front());
            EXPECT_GT(proof.compared_share, 0.5);
            cameras += file.cameras.size();
          }
          EXPECT_EQ(cameras, rig.cameras.size());
        }
      }
    }
  }
}

TEST(OpenCvWrite, TheDefaultLayout) {
  const auto keys = [](const Rig& rig) {
    std::string text;
    for (const Written::File& file : write(rig).files) {
      text += file.document.source().name + ":";
      for (const text::Entry& entry : file.document.root().entries) text += " " + entry.key.value;
      text += "\n";
    }
    return text;
  };
  EXPECT_EQ(keys(sample_rig("radtan", {})),
            "cam0.yml: image_width image_height fisheye_model camera_matrix distortion_coefficients\n");
  EXPECT_EQ(keys(sample_rig("mei", {})), "cam0.yml: image_width image_height camera_matrix distortion_coefficients xi\n");
  EXPECT_EQ(keys(sample_rig("kb4", {true, false})), "stereo.yml: image_width image_height fisheye_model M1 D1 M2 D2 R T\n");
  EXPECT_EQ(keys(sample_rig("mei", {true, false})),
            "stereo.yml: image_width image_height camera_matrix_1 distortion_coefficients_1 xi_1 camera_matrix_2 "
            "distortion_coefficients_2 xi_2 R T\n");
  // No pose, two sizes, two kinds, three cameras.
  Rig unposed = sample_rig("kb4", {true, false});
  unposed.poses.clear();
  EXPECT_EQ(keys(unposed), "cameras.yml: nb_camera camera_0 camera_1\n");
  Rig sizes = sample_rig("kb4", {true, false});
  sizes.cameras[1].image_size = ImageSize{640, 480};
  EXPECT_EQ(keys(sizes), "cameras.yml: nb_camera camera_0 camera_1\n");
  Rig kinds = sample_rig("kb4", {true, false});
  kinds.cameras[1].model = sample_model("radtan", 1);
  EXPECT_EQ(keys(kinds), "cameras.yml: nb_camera camera_0 camera_1\n");
  Rig three = sample_rig("kb4", {true, false});
  three.cameras.push_back({"cam2", ImageSize{640, 480}, sample_model("radtan"), std::nullopt, std::nullopt, ""});
  EXPECT_EQ(keys(three), "cameras.yml: nb_camera camera_0 camera_1 camera_2\n");
  three.cameras[2].model = sample_model("mei");
  EXPECT_EQ(write(three).files.size(), 3U);
}

TEST(OpenCvWrite, OneFilePerCamera) {
  const Written written = write(sample_rig("kb4", {true, false}), "calibration", ".xml");
  ASSERT_EQ(written.files.size(), 2U);
  EXPECT_EQ(written.files[0].document.source().name, "cam0.xml");
  EXPECT_EQ(written.files[1].cameras, std::vector<std::string>{"cam1"});
}

TEST(OpenCvWrite, PosesThatPassThroughTheImu) {
  Rig rig = sample_rig("kb4", {true, true});
  rig.poses = {{"cam0", "imu0", T_cam0_imu()}, {"cam1", "imu0", T_cam1_cam0() * T_cam0_imu()}};
  const Rig back = read_back(bytes_of(write(rig)), "x.yml");
  EXPECT_LE(element_difference(back.resolve("cam1", "cam0").value(), T_cam1_cam0()), 1e-12);
  const Rig maps = read_back(bytes_of(write(rig, "cameras")), "x.yml");
  EXPECT_LE(element_difference(maps.resolve("cam1", "cam0").value(), T_cam1_cam0()), 1e-12);
}

TEST(OpenCvWrite, LossesAreListed) {
  Rig rig = sample_rig("kb4", {true, true});
  rig.cameras[0].time_offset_s = 0.0021;
  rig.cameras[0].frame_rate_hz = 29.97;
  rig.extra_fields.push_back({"cam0", "line_delay", "0.00002"});
  std::set<std::string> codes;
  for (const Loss& loss : write(rig).losses) {
    codes.insert(id_of(loss));
    EXPECT_FALSE(what_of(loss).empty() || why_of(loss).empty()) << id_of(loss);
  }
  EXPECT_EQ(codes, (std::set<std::string>{"time-offset-dropped", "topic-dropped", "frame-rate-dropped", "imu-dropped",
                                          "not-carried"}));
}

TEST(OpenCvWrite, WhatCannotBeHeldIsRefused) {
  const auto codes_of = [](const Rig& rig, const std::string& layout) {
    std::string codes;
    EXPECT_FALSE(try_write(rig, layout, "", codes));
    return codes;
  };
  EXPECT_EQ(codes_of(sample_rig("eucm", {}), ""), "model-not-storable");
  EXPECT_EQ(codes_of(sample_rig("kb4", {}), "stereo"), "layout-not-served");
  EXPECT_EQ(codes_of(sample_rig("kb4", {}), "omnidir"), "layout-not-served");
  EXPECT_EQ(codes_of(sample_rig("mei", {}), "cameras"), "layout-not-served");
  EXPECT_EQ(codes_of(sample_rig("mei", {true, false}), "left-right"), "layout-not-served");
  EXPECT_EQ(codes_of(sample_rig("kb4", {}), "v1"), "unknown-layout");
  Rig kinds = sample_rig("kb4", {true, false});
  kinds.cameras[1].model = sample_model("radtan", 1);
  EXPECT_EQ(codes_of(kinds, "stereo"), "layout-not-served");
  Rig none;
  EXPECT_EQ(codes_of(none, ""), "no-camera");
}

// OpenCV demands no image size, and a rig without one is written without.
TEST(OpenCvWrite, SizesAreNotInvented) {
  Rig rig = sample_rig("radtan", {});
  rig.cameras[0].image_size.reset();
  EXPECT_EQ(bytes_of(write(rig)).find("width"), std::string::npos);
}

}  // namespace
}  // namespace fca::test
