// SPDX-License-Identifier: BSD-3-Clause
// What OpenCV's keys mean: one question each, on small files spelled out here.
#include "formats/rigs.h"
#include "formats/test_files.h"
#include "id_and_arguments.h"

#include "opencv/names.h"

#include <fca/code.h>
#include <fca/formats/wording.h>

namespace fca::test {
namespace {

using opencv::name_of;
using opencv::Role;

std::string matrix(const std::string& key, int rows, int cols, const std::string& data, const std::string& type = "d") {
  return key + ": !!opencv-matrix\n   rows: " + std::to_string(rows) + "\n   cols: " + std::to_string(cols) +
         "\n   dt: " + type + "\n   data: [ " + data + " ]\n";
}

const std::string kHead = "%YAML:1.0\n---\n";
const std::string kSize = "image_width: 640\nimage_height: 480\n";
const std::string kMatrix = "500., 0., 320., 0., 501., 240., 0., 0., 1.";

std::string K(const std::string& key = "camera_matrix", const std::string& data = kMatrix) { return matrix(key, 3, 3, data); }
std::string D(int count, const std::string& data, const std::string& key = "distortion_coefficients") {
  return matrix(key, 1, count, data);
}

struct Read {
  std::optional<Calibration> calibration;
  Parsed parsed;
};

Read read(const std::string& bytes, const ReadOptions& options = {}) {
  Read result{std::nullopt, parse(bytes, "file.yml")};
  EXPECT_TRUE(result.parsed.document) << result.parsed.rendered() << bytes;
  if (result.parsed.document)
    result.calibration = read_calibration({*result.parsed.document}, find_format("opencv"), options, result.parsed.diagnostics);
  return result;
}

std::string codes(const std::string& bytes, const ReadOptions& options = {}) { return read(bytes, options).parsed.codes(); }

/// The only thing that is said of a file.
Message said(const std::string& bytes) {
  const Read result = read(bytes);
  const std::vector<Diagnostic>& entries = result.parsed.diagnostics.entries();
  EXPECT_EQ(entries.size(), 1U) << result.parsed.rendered();
  return entries.empty() ? Message{} : entries.front().facts;
}

CameraModel model(const std::string& bytes, const ReadOptions& options = {}) {
  const Read result = read(bytes, options);
  EXPECT_TRUE(result.calibration) << result.parsed.rendered();
  return result.calibration ? result.calibration->rig.cameras.at(0).model : CameraModel();
}

const ReadOptions kPinhole{std::nullopt, OpenCvModel::kPinhole};
const ReadOptions kFisheye{std::nullopt, OpenCvModel::kFisheye};

TEST(OpenCvRead, TheLengthOfDChoosesTheModel) {
  const std::string head = kHead + kSize + K();
  EXPECT_EQ(model(head + D(5, "0.1, 0.2, 0.3, 0.4, 0.5")),
            model_of("radtan", {500.0, 501.0, 320.0, 240.0, 0.1, 0.2, 0.3, 0.4, 0.5}));
  const CameraModel rational = model_of("rational", {500.0, 501.0, 320.0, 240.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8});
  EXPECT_EQ(model(head + D(8, "0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8")), rational);
  EXPECT_EQ(model(head + D(12, "0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0., 0., 0., 0.")), rational);
  EXPECT_EQ(model(head + D(14, "0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0., 0., 0., 0., 0., 0.")), rational);
  EXPECT_EQ(model(head + D(14, "0.1, 0.2, 0.3, 0.4, 0.5, 0., 0., 0., 0., 0., 0., 0., 0., 0.")),
            model_of("radtan", {500.0, 501.0, 320.0, 240.0, 0.1, 0.2, 0.3, 0.4, 0.5}));
  EXPECT_EQ(model(head + D(5, "0., 0., 0., 0., 0.")), model_of("pinhole", {500.0, 501.0, 320.0, 240.0}));
  EXPECT_EQ(model(head + matrix("distortion_coefficients", 0, 0, "")), model_of("pinhole", {500.0, 501.0, 320.0, 240.0}));
  EXPECT_EQ(codes(head), "distortion-missing");
}

TEST(OpenCvRead, NoTermIsDropped) {
  const std::string head = kHead + kSize + K();
  const auto opencv14 = [](double s3, double tau_y) {
    return model_of("opencv14",
                    {500.0, 501.0, 320.0, 240.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.0, 0.0, s3, 0.0, 0.0, tau_y});
  };
  EXPECT_EQ(model(head + D(12, "0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0., 0., 0.25, 0.")), opencv14(0.25, 0.0));
  EXPECT_EQ(model(head + D(14, "0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0., 0., 0., 0., 0., 0.125")), opencv14(0.0, 0.125));
  const std::string skewed = kHead + kSize + K("camera_matrix", "500., 0.5, 320., 0., 501., 240., 0., 0., 1.");
  EXPECT_EQ(model(skewed + D(5, "0., 0., 0., 0., 0.")),
            model_of("radtan-skew", {500.0, 501.0, 320.0, 240.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5}));
  EXPECT_EQ(model(skewed + D(4, "0.1, 0., 0., 0.") + "xi: 1.5\n"),
            model_of("mei-skew", {500.0, 501.0, 320.0, 240.0, 1.5, 0.1, 0.0, 0.0, 0.0, 0.5}));
  EXPECT_EQ(model(skewed + D(12, "0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.25, 0., 0., 0.")),
            model_of("opencv14-skew",
                     {500.0, 501.0, 320.0, 240.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.25, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5}));
  for (const char* count : {"1", "2", "3", "6", "7", "9", "13"}) {
    std::string zeros = "0.5";
    for (int i = 1; i < std::stoi(count); ++i) zeros += ", 0.";
    EXPECT_EQ(codes(head + D(std::stoi(count), zeros)), "wrong-length") << count;
  }
}

TEST(OpenCvRead, FourNumbersAreNotGuessed) {
  const std::string head = kHead + kSize + K();
  const std::string four = D(4, "0.1, 0.2, 0.3, 0.4");
  const CameraModel fisheye = model_of("kb4", {500.0, 501.0, 320.0, 240.0, 0.1, 0.2, 0.3, 0.4});
  const CameraModel pinhole = model_of("radtan", {500.0, 501.0, 320.0, 240.0, 0.1, 0.2, 0.3, 0.4, 0.0});
  EXPECT_EQ(codes(head + four), "ambiguous-model");
  EXPECT_EQ(said(head + four), (Message{Code::kOpencvAmbiguousModel, {"distortion_coefficients", 0.1, 0.2, 0.3, 0.4}}));
  EXPECT_EQ(model(head + four, kFisheye), fisheye);
  EXPECT_EQ(model(head + four, kPinhole), pinhole);
  // Who says so.
  EXPECT_EQ(model(head + "fisheye_model: 1\n" + four), fisheye);
  EXPECT_EQ(model(head + "fisheye_model: 0\n" + four), pinhole);
  EXPECT_EQ(model(head + "distortion_model: \"equidistant\"\n" + four), fisheye);
  EXPECT_EQ(model(head + "distortion_model: \"plumb_bob\"\n" + four), pinhole);
  EXPECT_EQ(model(head + D(4, "0.1, 0.2, 0.3, 0.4", "fisheye_dist_coeffs")), fisheye);
  EXPECT_EQ(model(kHead + K("K_fisheye") + D(4, "0.1, 0.2, 0.3, 0.4", "D")), fisheye);
  EXPECT_EQ(codes(head + "fisheye_model: 0\n" + four, kFisheye), "model-contradicts");
  EXPECT_EQ(codes(head + "fisheye_model: 1\n" + D(5, "0.1, 0.2, 0.3, 0.4, 0.5")), "wrong-length");
  // The option is for four numbers only.
  EXPECT_EQ(model_info(model(head + D(5, "0.1, 0.2, 0.3, 0.4, 0.5"), kFisheye)).id, "radtan");
}

// What is told of a camera and cannot be so is not passed over.
TEST(OpenCvRead, FisheyeWithoutFourNumbersIsSaidToHaveNoEffect) {
  const std::string head = kHead + kSize + K();
  const std::string five = D(5, "0.1, 0.2, 0.3, 0.4, 0.5");
  EXPECT_EQ(codes(head, kFisheye), "distortion-missing model-contradicts");
  EXPECT_EQ(codes(head, kPinhole), "distortion-missing");
  EXPECT_EQ(codes(head + five, kFisheye), "model-contradicts");
  EXPECT_EQ(codes(head + five, kPinhole), "");
  EXPECT_EQ(codes(head + D(4, "0.1, 0.2, 0.3, 0.4") + "xi: 1.5\n", kFisheye), "model-contradicts");
  EXPECT_EQ(model(head + five, kFisheye), model(head + five));
}

TEST(OpenCvRead, ModelsOfOthersAreNamedAndNotRead) {
  const std::string head = kHead + kSize + K();
  const std::string five = D(5, "0.1, 0.2, 0.3, 0.4, 0.5");
  for (const char* key : {"distortion_model: radial_division\n", "distortion_type: 5\n", "camera_model: fov\n",
                          "fisheye_model: 2\n", "distortion_model: \"kb6\"\n"}) {
    SCOPED_TRACE(key);
    EXPECT_EQ(codes(head + five + key), "unknown-model");
    EXPECT_EQ(model(head + five + key, kPinhole), model(head + five));
  }
  for (const char* key : {"distortion_model: plumb_bob\n", "distortion_model: none\n", "distortion_type: 0\n",
                          "camera_model: \"acA1920-40gm\"\n", "calibration_type: industrial\n", "pattern_type: dots\n",
                          "distortion_model: radial-tangential\n", "distortion_model: rational_polynomial\n"}) {
    EXPECT_EQ(codes(head + five + key), "") << key;
  }
}

TEST(OpenCvRead, XiIsOmnidir) {
  const CameraModel expected = model_of("mei", {500.0, 501.0, 320.0, 240.0, 1.5, 0.1, 0.2, 0.3, 0.4});
  const std::string body = K() + D(4, "0.1, 0.2, 0.3, 0.4");
  EXPECT_EQ(model(kHead + body + "xi: 1.5\n"), expected);
  EXPECT_EQ(model(kHead + body + matrix("xi", 1, 1, "1.5")), expected);
  EXPECT_EQ(codes(kHead + K() + D(5, "0.1, 0.2, 0.3, 0.4, 0.5") + "xi: 1.5\n"), "wrong-length");
  const std::string pair = K("camera_matrix_1") + D(4, "0.1, 0.2, 0.3, 0.4", "distortion_coefficients_1") + "xi_1: 1.5\n" +
                           K("camera_matrix_2") + D(4, "0.1, 0.2, 0.3, 0.4", "distortion_coefficients_2") + "xi_2: 1.25\n";
  const Read both = read(kHead + pair + matrix("om", 3, 1, "0., 0., 1.5707963267948966") + "T: [ 1., 2., 3. ]\n");
  ASSERT_TRUE(both.calibration) << both.parsed.rendered();
  EXPECT_EQ(parameter(both.calibration->rig.cameras.at(1).model, "xi"), 1.25);
  const Transform expected_pose = {{0, -1, 0, 1, 1, 0, 0, 2, 0, 0, 1, 3, 0, 0, 0, 1}};
  EXPECT_LE(element_difference(both.calibration->rig.poses.at(0).T_a_b, expected_pose), 1e-15);
}

TEST(OpenCvRead, NamesInManySpellings) {
  struct Case {
    const char* key;
    Role role;
    const char* side;
  };
  constexpr Case kCases[] = {
      {"camera_matrix", Role::kMatrix, ""},
      {"Camera_Matrix", Role::kMatrix, ""},
      {"cameraMatrix1", Role::kMatrix, "1"},
      {"K", Role::kMatrix, ""},
      {"M2", Role::kMatrix, "2"},
      {"K_left", Role::kMatrix, "left"},
      {"left_camera_matrix", Role::kMatrix, "left"},
      {"cameraMatrixL", Role::kMatrix, "l"},
      {"distCoeffsR", Role::kDistortion, "r"},
      {"D1", Role::kDistortion, "1"},
      {"dist_coeffs", Role::kDistortion, ""},
      {"distCoeffs0", Role::kDistortion, "0"},
      {"IntrinsicMatrix1", Role::kMatrix, "1"},
      {"Intrisic", Role::kMatrix, ""},
      {"xi_2", Role::kXi, "2"},
      {"cam0_K", Role::kMatrix, "0"},
      {"camera1_matrix", Role::kMatrix, "1"},
      {"camera", Role::kNone, ""},
      {"camera_0", Role::kNone, ""},
      {"R1", Role::kNone, ""},
      {"P2", Role::kNone, ""},
      {"LEFT.K", Role::kNone, ""},
      {"new_camera_matrix", Role::kNone, ""},
      {"mask", Role::kNone, ""},
      {"kr1", Role::kNone, ""},
  };
  for (const Case& row : kCases) {
    EXPECT_EQ(name_of(row.key).role, row.role) << row.key;
    EXPECT_EQ(name_of(row.key).side, row.side) << row.key;
  }
}

TEST(OpenCvRead, PairsUnderAnyNames) {
  const std::string pose = matrix("R", 3, 3, "1., 0., 0., 0., 0., -1., 0., 1., 0.") + matrix("T", 3, 1, "1., 2., 3.");
  const Transform expected = {{1, 0, 0, 1, 0, 0, -1, 2, 0, 1, 0, 3, 0, 0, 0, 1}};
  struct Names {
    const char* K1;
    const char* D1;
    const char* K2;
    const char* D2;
  };
  constexpr Names kNames[] = {
      {"M1", "D1", "M2", "D2"},
      {"K1", "D1", "K2", "D2"},
      {"cameraMatrixL", "distCoeffsL", "cameraMatrixR", "distCoeffsR"},
      {"left_camera_matrix", "left_distortion_coefficients", "right_camera_matrix", "right_distortion_coefficients"},
      {"camera_matrix_0", "dist_coeffs_0", "camera_matrix_1", "dist_coeffs_1"}};
  for (const Names& names : kNames) {
    SCOPED_TRACE(names.K1);
    // The second one first: order is by name.
    const Read result = read(kHead + K(names.K2, "600., 0., 320., 0., 601., 240., 0., 0., 1.") +
                             D(5, "0., 0., 0., 0., 1.", names.D2) + K(names.K1) + D(5, "0., 0., 0., 0., 2.", names.D1) + pose);
    ASSERT_TRUE(result.calibration) << result.parsed.rendered();
    const Rig& rig = result.calibration->rig;
    ASSERT_EQ(rig.cameras.size(), 2U);
    EXPECT_EQ(rig.cameras[0].model, model_of("radtan", {500.0, 501.0, 320.0, 240.0, 0.0, 0.0, 0.0, 0.0, 2.0}));
    EXPECT_EQ(rig.cameras[1].model, model_of("radtan", {600.0, 601.0, 320.0, 240.0, 0.0, 0.0, 0.0, 0.0, 1.0}));
    ASSERT_EQ(rig.poses.size(), 1U);
    EXPECT_EQ(rig.poses[0], (PoseEdge{"cam1", "cam0", expected}));
  }
}

TEST(OpenCvRead, APoseAloneIsJoinedWithItsCameras) {
  Diagnostics diagnostics;
  const std::string head = kHead + K("M1") + D(5, "0., 0., 0., 0., 1.", "D1") + K("M2") + D(5, "0., 0., 0., 0., 1.", "D2");
  const std::string pose = kHead + matrix("R", 3, 3, "1., 0., 0., 0., 1., 0., 0., 0., 1.") + "T: [ -0.125, 0., 0. ]\n";
  const std::optional<Calibration> calibration =
      read_calibration({document_of(head), document_of(pose)}, nullptr, {}, diagnostics);
  ASSERT_TRUE(calibration);
  EXPECT_EQ(calibration->rig.cameras.size(), 2U);
  EXPECT_EQ(calibration->rig.resolve("cam1", "cam0").value()(0, 3), -0.125);
}

TEST(OpenCvRead, MatlabsMatricesAreTransposed) {
  const std::string bytes =
      kHead + matrix("IntrinsicMatrix1", 3, 3, "811., 0., 0., 0., 810., 0., 332., 256., 1.", "f") +
      matrix("RadialDistortion1", 1, 2, "0.0625, 0.5", "f") + matrix("TangentialDistortion1", 1, 2, "0.25, 0.125", "f") +
      matrix("IntrinsicMatrix2", 3, 3, "812., 0., 0., 0., 810., 0., 327., 235., 1.", "f") +
      matrix("RadialDistortion2", 1, 3, "0.0625, 0.5, 0.75", "f") + matrix("TangentialDistortion2", 1, 2, "0., 0.", "f") +
      matrix("ImageSize", 1, 2, "480., 640.", "f") +
      matrix("RotationOfCamera2", 3, 3, "1., 0., 0., 0., 0., -1., 0., 1., 0.", "f") +
      matrix("TranslationOfCamera2", 1, 3, "-2., 0., 0.", "f");
  const Read result = read(bytes);
  ASSERT_TRUE(result.calibration) << result.parsed.rendered();
  const Rig& rig = result.calibration->rig;
  EXPECT_EQ(rig.cameras.at(0).model, model_of("radtan", {811.0, 810.0, 332.0, 256.0, 0.0625, 0.5, 0.25, 0.125, 0.0}));
  EXPECT_EQ(rig.cameras.at(1).model, model_of("radtan", {812.0, 810.0, 327.0, 235.0, 0.0625, 0.5, 0.0, 0.0, 0.75}));
  EXPECT_EQ(rig.cameras.at(0).image_size, (ImageSize{640, 480}));
  EXPECT_EQ(rig.poses.at(0).T_a_b, (Transform{{1, 0, 0, -2, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1}}));
  EXPECT_EQ(result.parsed.codes(), "matlab-origin matlab-origin");
}

TEST(OpenCvRead, SizesInManySpellings) {
  const std::string body = K() + D(5, "0., 0., 0., 0., 1.");
  for (const std::string& size :
       {std::string("image_width: 640\nimage_height: 480\n"), std::string("image_Width: 640\nimage_Height: 480\n"),
        std::string("img_width: 640\nimg_height: 480\n"), std::string("image_size: [ 640, 480 ]\n"),
        std::string("imageSize: [ 640, 480 ]\n"), std::string("resolution: [ 640, 480 ]\n"),
        matrix("resolution", 2, 1, "640, 480", "i")}) {
    const Read result = read(kHead + size + body);
    ASSERT_TRUE(result.calibration) << result.parsed.rendered();
    EXPECT_EQ(result.calibration->rig.cameras.at(0).image_size, (ImageSize{640, 480})) << size;
    EXPECT_TRUE(result.calibration->rig.extra_fields.empty()) << size;
  }
  EXPECT_FALSE(read(kHead + body).calibration->rig.cameras.at(0).image_size);
  EXPECT_EQ(read(kHead + body, {ImageSize{320, 200}, std::nullopt}).calibration->rig.cameras.at(0).image_size,
            (ImageSize{320, 200}));
}

// cv::FileStorage holds floats where dt says so: the numbers are those, not the digits.
TEST(OpenCvRead, FloatsAreFloats) {
  const CameraModel read_model = model(kHead + matrix("K", 3, 3, "500.1, 0., 320.3, 0., 501.7, 240.9, 0., 0., 1.", "f") +
                                       matrix("D", 1, 5, "0.1, 0.2, 0.3, 0.4, 0.5", "f"));
  EXPECT_EQ(parameter(read_model, "fx"), static_cast<double>(500.1F));
  EXPECT_EQ(parameter(read_model, "p2"), static_cast<double>(0.4F));
}

TEST(OpenCvRead, LongBaselinesAreProbablyMillimetres) {
  const std::string pair = K("M1") + D(5, "0., 0., 0., 0., 1.", "D1") + K("M2") + D(5, "0., 0., 0., 0., 1.", "D2") +
                           matrix("R", 3, 3, "1., 0., 0., 0., 1., 0., 0., 0., 1.");
  EXPECT_EQ(codes(kHead + pair + "T: [ -69.8, 0.5, 0.5 ]\n"), "units-not-stated");
  EXPECT_EQ(codes(kHead + pair + "T: [ -0.0698, 0.5, 0.5 ]\n"), "");
}

TEST(OpenCvRead, ExtraKeysAreKept) {
  const Calibration calibration = calibration_of(read_file(testdata_dir() / "opencv/good/k1d1.yml"));
  EXPECT_EQ(calibration.rig.extra_fields,
            (std::vector<ExtraField>{{"", "XR", "3 x 3 [0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, -1.0, 0.0]"},
                                     {"", "XT", "3 x 1 [0.0, 0.0, 0.28]"}}));
}

TEST(OpenCvRead, MapsKeepTheirReferenceFrame) {
  const Rig rig = calibration_of(read_file(testdata_dir() / "opencv/good/cameras.yml")).rig;
  ASSERT_EQ(rig.cameras.size(), 3U);
  EXPECT_EQ(model_info(rig.cameras[1].model).id, "kb4");
  EXPECT_EQ(rig.cameras[1].image_size, (ImageSize{1280, 800}));
  // camera -> reference, and the reference is where camera_0 is.
  ASSERT_NE(rig.stated("reference", "cam1"), nullptr);
  EXPECT_EQ((*rig.stated("reference", "cam1"))(0, 3), -0.69921875);
  EXPECT_EQ(rig.resolve("cam0", "cam1").value(), *rig.stated("reference", "cam1"));
}

// MC-Calib's camera_group says to which reference a pose is: part of the pose, and of no meaning without one.
TEST(OpenCvRead, AGroupIsPartOfItsPose) {
  const std::string file = read_file(testdata_dir() / "opencv/good/cameras.yml");
  for (const ExtraField& extra : calibration_of(file, "cameras.yml").rig.extra_fields)
    EXPECT_EQ(extra.key.find("camera_group"), std::string::npos) << extra.key;
  std::string other = file;
  other.replace(other.rfind("camera_group: 0"), 15, "camera_group: 1");
  const Rig rig = calibration_of(other, "cameras.yml").rig;
  EXPECT_FALSE(rig.resolve("cam0", "cam2")) << "the groups are not posed to each other";
  EXPECT_TRUE(rig.resolve("reference1", "cam2"));
  // A fresh file tells the references apart, too.
  WriteOptions options;
  options.layout = "cameras";
  Diagnostics diagnostics;
  const std::optional<Written> written = write_calibration(*find_format("opencv"), nullptr, rig, options, diagnostics);
  ASSERT_TRUE(written);
  EXPECT_TRUE(std::ranges::none_of(written->losses, [](const Loss& loss) { return id_of(loss) == "pose-dropped"; }));
  EXPECT_EQ(calibration_of(written->files.front().document.bytes(), "x.yml").rig.poses, rig.poses);
}

TEST(OpenCvDetect, TheKeyIsNamed) {
  Diagnostics ignored;
  const auto why = [&](const char* file) {
    return detect_format(document_of(read_file(testdata_dir() / file)), ignored).value_or(DetectedFormat{}).why;
  };
  EXPECT_TRUE(is_said_of(why("opencv/good/calibration.yml"), Code::kOpencvFoundCamera, {"camera_matrix"}));
  EXPECT_TRUE(is_said_of(why("opencv/good/cameras.yml"), Code::kOpencvFoundMap, {"camera_0"}));
  EXPECT_EQ(why("opencv/good/extrinsics.yml"), Message{Code::kOpencvFoundPose});
}

// ROS writes the same names, in plain YAML and without dt.
TEST(OpenCvDetect, RosCameraInfoIsSomethingElse) {
  const std::string ros =
      "image_width: 640\nimage_height: 480\ncamera_name: left\ncamera_matrix:\n  rows: 3\n  cols: 3\n  data: [500., 0, 320, 0, "
      "500, 240, 0, 0, 1]\ndistortion_model: plumb_bob\ndistortion_coefficients:\n  rows: 1\n  cols: 5\n  data: [0.1, 0, 0, 0, "
      "0]\n";
  EXPECT_EQ(find_format("opencv")->probe(document_of(ros)).score, 0);
}

TEST(OpenCvDetect, ALoneMatrixMustLookLikeACamera) {
  const auto score = [](const std::string& bytes) { return find_format("opencv")->probe(document_of(kHead + bytes)).score; };
  EXPECT_EQ(score(matrix("M", 3, 3, "1.1, 0.2, 30., 0.1, 0.9, -20., 0.0001, 0.0002, 1.")), 0) << "a homography";
  EXPECT_EQ(score(matrix("K", 6, 3, "1., 0., 0., 0., 1., 0., 0., 0., 1., 1., 0., 0., 0., 1., 0., 0., 0., 1.")), 0);
  EXPECT_GT(score(K("K")), 0);
  EXPECT_GT(score(matrix("camera_matrix", 3, 3, "1.1, 0.2, 30., 0.1, 0.9, -20., 0.0001, 0.0002, 1.")), 0);
}

class OpenCvGoodFiles : public testing::TestWithParam<fs::path> {};

TEST_P(OpenCvGoodFiles, AreReadWithoutAWordAndWrittenBackByteForByte) {
  const std::string bytes = read_file(GetParam());
  Parsed parsed = parse(bytes, GetParam().filename().string());
  ASSERT_TRUE(parsed.document) << parsed.rendered();
  const std::optional<Calibration> calibration = read_calibration({*parsed.document}, nullptr, {}, parsed.diagnostics);
  ASSERT_TRUE(calibration) << parsed.rendered();
  EXPECT_EQ(parsed.rendered(), "");
  EXPECT_EQ(calibration->format->id, "opencv");
  for (const Camera& camera : calibration->rig.cameras) EXPECT_TRUE(validate(camera.model).empty());
  Diagnostics diagnostics;
  const std::optional<Written> written =
      calibration->format->write(&calibration->documents.front(), calibration->rig, {}, diagnostics);
  ASSERT_TRUE(written);
  ASSERT_EQ(written->files.size(), 1U);
  EXPECT_EQ(written->files.front().document.bytes(), bytes);
  EXPECT_TRUE(written->losses.empty());
}

std::vector<fs::path> good_files() { return files_in(testdata_dir() / "opencv" / "good"); }

std::string test_name(const testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.filename().string();
  std::ranges::replace_if(
      name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Formats, OpenCvGoodFiles, testing::ValuesIn(good_files()), test_name);

// Its program calls cv2.fisheye; the file says so by its other keys.
TEST(OpenCvRead, ASurroundViewIsOfFisheyes) {
  const Calibration calibration =
      calibration_of(read_file(testdata_dir() / "opencv" / "surround-view" / "front.yml"), "front.yaml");
  ASSERT_EQ(calibration.rig.cameras.size(), 1U);
  EXPECT_EQ(model_info(calibration.rig.cameras.front().model).id, "kb4");
  EXPECT_EQ(calibration.rig.cameras.front().image_size, (ImageSize{960, 640}));
}

}  // namespace
}  // namespace fca::test
