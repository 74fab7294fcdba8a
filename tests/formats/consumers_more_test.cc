// SPDX-License-Identifier: BSD-3-Clause
// The consumers of OpenCV, OCamCalib, WoodScape and DSO on bytes of our own: what they load, refuse, warn of and misread.
// Pixels were computed apart, from the formulas as documented.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <opencv2/core.hpp>
#include <random>
#include <string>
#include <vector>

#include <unistd.h>

#include "complaints.h"
#include "test_files.h"

namespace fca::consumers {
namespace {

using Ray = std::array<double, 3>;
using test::with_replaced;

ConsumerView load(const char* id, const std::string& bytes, const LoadOptions& options = {}) {
  return find_consumer(id)->load(bytes, options);
}

ConsumerView load_told(const std::string& bytes, OpenCvModel model) {
  LoadOptions options;
  options.opencv_model = model;
  return load("opencv", bytes, options);
}

void expect_pixel(const ConsumerView& view, std::size_t camera, const Ray& ray, double u, double v, double tolerance = 1e-10) {
  ASSERT_TRUE(view.loads()) << joined(view.refusals);
  ASSERT_LT(camera, view.cameras.size());
  const auto pixel = view.cameras[camera].project(ray);
  ASSERT_TRUE(pixel);
  EXPECT_NEAR((*pixel)[0], u, tolerance);
  EXPECT_NEAR((*pixel)[1], v, tolerance);
}

constexpr Ray kRay = {0.1, -0.2, 1.0};

// --- OpenCV -----------------------------------------------------------------------------------------------------------------

std::string matrix(const std::string& key, int rows, int cols, const std::string& data, const std::string& dt = "d") {
  return key + ": !!opencv-matrix\n   rows: " + std::to_string(rows) + "\n   cols: " + std::to_string(cols) + "\n   dt: " + dt +
         "\n   data: [ " + data + " ]\n";
}

const std::string kHead = "%YAML:1.0\n---\n";
const std::string kK = "400., 0., 320., 0., 410., 240., 0., 0., 1.";
const std::string kSkewedK = "400., 1.5, 320., 0., 410., 240., 0., 0., 1.";
const std::string kD5 = "-0.1, 0.01, 0.001, -0.002, 0.";
const std::string kD4 = "-0.1, 0.01, 0.001, -0.002";
const std::string kFisheye = "0.01, -0.02, 0.003, -0.001";
const std::string kSize = "image_width: 640\nimage_height: 480\n";

std::string mono(const std::string& D, int count, const std::string& more = "", const std::string& K = kK) {
  return kHead + kSize + matrix("camera_matrix", 3, 3, K) + matrix("distortion_coefficients", count, 1, D) + more;
}

TEST(OpenCvConsumer, ReadsTheSameFromYamlXmlAndJson) {
  const std::string xml =
      "<?xml version=\"1.0\"?>\n<opencv_storage>\n<image_width>640</image_width>\n<image_height>480</image_height>\n"
      "<camera_matrix type_id=\"opencv-matrix\">\n<rows>3</rows>\n<cols>3</cols>\n<dt>d</dt>\n<data>\n400. 0. 320. 0. 410. "
      "240. "
      "0. 0. 1.</data></camera_matrix>\n<distortion_coefficients "
      "type_id=\"opencv-matrix\"><rows>5</rows><cols>1</cols><dt>d</dt><data>-0.1 0.01 0.001 -0.002 "
      "0.</data></distortion_coefficients>\n</opencv_storage>\n";
  const std::string json =
      "{\"image_width\": 640, \"image_height\": 480, \"camera_matrix\": {\"type_id\": \"opencv-matrix\", \"rows\": 3, "
      "\"cols\": "
      "3, \"dt\": \"d\", \"data\": [" +
      kK +
      "]}, \"distortion_coefficients\": {\"type_id\": \"opencv-matrix\", \"rows\": 5, \"cols\": 1, \"dt\": \"d\", \"data\": [" +
      kD5 + "]}}";
  for (const std::string& bytes : {mono(kD5, 5), xml, json}) {
    const ConsumerView view = load("opencv", bytes);
    expect_pixel(view, 0, kRay, 359.729, 158.49405);
    EXPECT_TRUE(view.warnings.empty()) << joined(view.warnings);
    EXPECT_EQ(view.cameras.at(0).width, 640);
    EXPECT_EQ(view.cameras.at(0).height, 480);
    EXPECT_FALSE(view.cameras.at(0).misread);
  }
}

TEST(OpenCvConsumer, FourCoefficientsAreWhatTheCallerSays) {
  expect_warning(load("opencv", mono(kD4, 4)), Code::kCvFourNumbers, "distortion_coefficients");
  expect_pixel(load("opencv", mono(kD4, 4)), 0, kRay, 359.729, 158.49405);
  EXPECT_TRUE(load_told(mono(kD4, 4), OpenCvModel::kPinhole).warnings.empty());
  expect_pixel(load_told(mono(kFisheye, 4), OpenCvModel::kFisheye), 0, kRay, 359.36986018344106, 159.29178662394585);
  expect_pixel(load("opencv", mono(kFisheye, 4, "fisheye_model: 1\n")), 0, kRay, 359.36986018344106, 159.29178662394585);
  EXPECT_TRUE(load("opencv", mono(kD4, 4, "fisheye_model: 0\n")).warnings.empty());
  expect_warning(load_told(mono(kD4, 4, "fisheye_model: 1\n"), OpenCvModel::kPinhole), Code::kCvGivenOtherwise,
                 "distortion_coefficients", {"fisheye", "pinhole"});
  expect_refused(load("opencv", mono(kD5, 5, "fisheye_model: 1\n")), Code::kCvCoefficientsNotFour, "camera_matrix",
                 {5, "cv::fisheye"});
}

TEST(OpenCvConsumer, FisheyeMirrorsRaysFromBehind) {
  const ConsumerView view = load("opencv", mono(kFisheye, 4, "fisheye_model: 1\n"));
  const double behind = 100.0 * M_PI / 180.0;
  const auto mirrored = view.cameras.at(0).project({-std::sin(behind), 0.0, -std::cos(behind)});
  const auto wrong = view.cameras.at(0).project({std::sin(behind), 0.0, std::cos(behind)});
  ASSERT_TRUE(mirrored && wrong);
  EXPECT_NEAR((*wrong)[0], (*mirrored)[0], 1e-9);
  EXPECT_LT((*wrong)[0], 320.0) << "left of the centre, for a ray to the right";
}

TEST(OpenCvConsumer, OldKeysAndPairs) {
  std::string old = kHead + "image_Width: 640\nimage_Height: 480\n" + matrix("Camera_Matrix", 3, 3, kK) +
                    matrix("Distortion_Coefficients", 5, 1, kD5);
  expect_pixel(load("opencv", old), 0, kRay, 359.729, 158.49405);
  EXPECT_EQ(load("opencv", old).cameras.at(0).height, 480);
  const std::string pose = matrix("R", 3, 3, "0., -1., 0., 1., 0., 0., 0., 0., 1.") + matrix("T", 3, 1, "-0.5, 0.25, 0.125");
  const std::string left = matrix("M1", 3, 3, kK) + matrix("D1", 1, 5, kD5);
  const std::string stereo =
      left + matrix("M2", 3, 3, "1., 0., 2., 0., 3., 4., 0., 0., 1.") + matrix("D2", 1, 5, "0., 0., 0., 0., 0.");
  const ConsumerView view = load("opencv", kHead + stereo + pose);
  expect_pixel(view, 0, kRay, 359.729, 158.49405);
  expect_pixel(view, 1, kRay, 2.1, 3.4);
  ASSERT_EQ(view.poses.size(), 1U);
  EXPECT_EQ(view.poses[0].a + " " + view.poses[0].b, "cam1 cam0");
  EXPECT_EQ(view.poses[0].T_a_b, (std::array<double, 16>{0, -1, 0, -0.5, 1, 0, 0, 0.25, 0, 0, 1, 0.125, 0, 0, 0, 1}));
  EXPECT_EQ(
      load("opencv", kHead + stereo + with_replaced(pose, matrix("T", 3, 1, "-0.5, 0.25, 0.125"), "T: [ -0.5, 0.25, 0.125 ]\n"))
          .poses.at(0)
          .T_a_b,
      view.poses[0].T_a_b);
  EXPECT_TRUE(load("opencv", kHead + stereo).poses.empty());
  expect_refused(load("opencv", kHead + left), Code::kCvPairIncomplete, "M2");
  expect_refused(load("opencv", kHead + stereo + matrix("R", 3, 3, kK)), Code::kCvHalfAPose, "T", {"R"});
  expect_refused(load("opencv", kHead + stereo + matrix("T", 3, 1, "1., 2., 3.")), Code::kCvHalfAPose, "R", {"T"});
  expect_refused(load("opencv", kHead + pose), Code::kCvNoCameraMatrix);
}

TEST(OpenCvConsumer, LeftAndRight) {
  std::string bytes = kHead + "image_size: [ 640, 480 ]\n" + matrix("camera_matrix_left", 3, 3, kK) +
                      matrix("dist_coeffs_left", 5, 1, kD5) + matrix("camera_matrix_right", 3, 3, kK) +
                      matrix("dist_coeffs_right", 5, 1, kD5);
  const ConsumerView view = load("opencv", bytes);
  expect_pixel(view, 1, kRay, 359.729, 158.49405);
  EXPECT_EQ(view.cameras.at(1).width, 640);
}

TEST(OpenCvConsumer, Omnidir) {
  const std::string with_xi = mono(kD4, 4, "xi: 1.2\n", kSkewedK);
  expect_pixel(load("opencv", with_xi), 0, kRay, 337.7733018343287, 203.27693717970422);
  EXPECT_TRUE(load("opencv", with_xi).warnings.empty()) << "cv::omnidir uses the skew";
  expect_pixel(load("opencv", mono(kD4, 4, matrix("xi", 1, 1, "1.2"), kSkewedK)), 0, kRay, 337.7733018343287,
               203.27693717970422);
  expect_warning(load_told(with_xi, OpenCvModel::kFisheye), Code::kCvOmnidirMeant, "xi", {"fisheye"});
  expect_refused(load("opencv", mono(kD5, 5, "xi: 1.2\n")), Code::kCvCoefficientsNotFour, "camera_matrix", {5, "cv::omnidir"});
  expect_refused(load("opencv", mono(kD4, 4, "xi: \"1.2\"\n")), Code::kCvXiNoNumber, "xi");
  std::string pair = kHead;
  for (const std::string i : {"_1", "_2"})
    pair +=
        matrix("camera_matrix" + i, 3, 3, kSkewedK) + matrix("distortion_coefficients" + i, 1, 4, kD4) + "xi" + i + ": 1.2\n";
  const ConsumerView view =
      load("opencv", pair + matrix("om", 3, 1, "0., 0., 1.5707963267948966") + matrix("T", 3, 1, "1., 2., 3."));
  expect_pixel(view, 1, kRay, 337.7733018343287, 203.27693717970422);
  ASSERT_EQ(view.poses.size(), 1U);
  const std::array<double, 16> expected = {0, -1, 0, 1, 1, 0, 0, 2, 0, 0, 1, 3, 0, 0, 0, 1};
  for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(view.poses[0].T_a_b.at(i), expected.at(i), 1e-15);
}

std::string indented(const std::string& block) {
  std::string result;
  for (const std::string& line : test::split(block, '\n')) result += "   " + line + "\n";
  return result;
}

std::string mc_calib(int count) {
  std::string bytes = kHead + "nb_camera: " + std::to_string(count) + "\n";
  for (int i = 0; i < 2; ++i) {
    const std::string shift = i == 0 ? "0." : "0.5";
    bytes +=
        "camera_" + std::to_string(i) + ":\n" +
        indented(
            matrix("camera_matrix", 3, 3, kK) + matrix("distortion_vector", 1, i == 0 ? 5 : 4, i == 0 ? kD5 : kFisheye) +
            "distortion_type: " + std::to_string(i) + "\nimg_width: 640\nimg_height: 480\n" +
            matrix("camera_pose_matrix", 4, 4, "1., 0., 0., " + shift + ", 0., 1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1."));
  }
  return bytes;
}

TEST(OpenCvConsumer, McCalib) {
  const ConsumerView view = load("opencv", mc_calib(2));
  expect_pixel(view, 0, kRay, 359.729, 158.49405);
  expect_pixel(view, 1, kRay, 359.36986018344106, 159.29178662394585);
  EXPECT_TRUE(view.warnings.empty()) << joined(view.warnings);
  EXPECT_EQ(view.cameras.at(1).width, 640);
  ASSERT_EQ(view.poses.size(), 1U);
  EXPECT_EQ(view.poses[0].a + " " + view.poses[0].b, "cam0 cam1");
  EXPECT_EQ(view.poses[0].T_a_b.at(3), 0.5);
  expect_refused(load("opencv", mc_calib(3)), Code::kCvCameraCount, "nb_camera", {3, 2});
  std::string broken = mc_calib(2);
  broken.replace(broken.find("distortion_vector"), 17, "distortion_things");
  expect_refused(load("opencv", broken), Code::kCvKeyMissing, "camera_0/distortion_vector", {"camera_0.distortion_vector"});
}

TEST(OpenCvConsumer, WarnsOfWhatIsNotUsed) {
  const ConsumerView skewed = load("opencv", mono(kD5, 5, "", kSkewedK));
  expect_warning(skewed, Code::kCvSkewUnused, "camera_matrix", {1.5, "cv::projectPoints", 0.88});
  EXPECT_TRUE(skewed.cameras.at(0).misread);
  expect_pixel(skewed, 0, kRay, 359.729, 158.49405);
  expect_warning(load("opencv", mono(kD5, 5, "", "400., 0., 0., 0., 410., 0., 320., 240., 1.")), Code::kCvMatrixTransposed,
                 "camera_matrix");
  expect_warning(load("opencv", kHead + matrix("camera_matrix", 3, 3, kK)), Code::kCvDistortionMissing,
                 "distortion_coefficients");
  expect_warning(load("opencv", mono(kD5, 5, matrix("M1", 3, 3, kK))), Code::kCvOtherMatrixFirst, "M1", {"camera_matrix"});
}

TEST(OpenCvConsumer, RefusesWhatItsFunctionsAssert) {
  expect_refused(load("opencv", mono("1., 2., 3., 4., 5., 6.", 6)), Code::kCvDistortionSize, "distortion_coefficients", {6, 1});
  expect_refused(load("opencv", kHead + matrix("camera_matrix", 3, 3, "400, 0, 320, 0, 410, 240, 0, 0, 1", "i")),
                 Code::kCvCameraMatrixSize, "camera_matrix", {Message{Code::kCvNotReal}});
  expect_refused(load("opencv", kHead + matrix("camera_matrix", 2, 3, "1., 2., 3., 4., 5., 6.")), Code::kCvCameraMatrixSize,
                 "camera_matrix", {2, 3});
  expect_refused(load("opencv", kHead + matrix("camera_matrix", 3, 3, "1., 2.")), Code::kCvUnreadableMatrix, "camera_matrix",
                 {Message{Code::kStorageTooFewNumbers, {2, 9}}});
  expect_refused(load("opencv", kHead + matrix("camera_matrix", 1000000, 1000000, "1., 2.")), Code::kCvUnreadableMatrix,
                 "camera_matrix", {Message{Code::kStorageTooFewNumbers, {2, 1000000000000}}});
  expect_refused(load("opencv", kHead + matrix("camera_matrix", 100000000, 3, "1., 2.")), Code::kCvUnreadableMatrix,
                 "camera_matrix", {Message{Code::kStorageNoCount, {"rows"}}});
  expect_refused(load("opencv", kHead + matrix("camera_matrix", 2, 3, "1., 2., 3., 4., 5., 6., 7.")), Code::kCvUnreadableMatrix,
                 "camera_matrix");
  expect_refused(load("opencv", kHead + "camera_matrix: [ 1., 2., 3. ]\n"), Code::kCvNoMatrix, "camera_matrix");
}

TEST(OpenCvConsumer, RefusesBytesThatOpenCvDoesNotTake) {
  expect_refused(load("opencv", ""), Code::kProgramFileEmpty);
  expect_refused(load("opencv", "camera_matrix: 1\n"), Code::kStorageNotTaken, "", {"cv::FileStorage"});
  expect_refused(load("opencv", kHead + std::string(70, '[')), Code::kStorageNestedTooDeep);
  expect_refused(load("opencv", "{\"a\":" + std::string(100000, '[')), Code::kStorageNestedTooDeep);
  std::string deep = "<?xml version=\"1.0\"?>\n<opencv_storage>";
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  expect_refused(load("opencv", deep), Code::kStorageTooManyElements);
  expect_refused(load("opencv", "\xEF\xBB\xBF" + deep), Code::kStorageTooManyElements);
  expect_refused(load("opencv", kHead + std::string("a\0b", 3)), Code::kStorageZeroByte);
  expect_refused(load("opencv", std::string((2U << 20U) + 1, ' ')), Code::kProgramFileTooLarge);
  // A line of JSON with many keys nests nothing.
  std::string flat = "{";
  for (int i = 0; i < 100; ++i) flat += "\"k" + std::to_string(i) + "\": 1, ";
  expect_refused(load("opencv", flat + "\"z\": 1}"), Code::kCvNoCameraMatrix);
}

// cv::FileStorage decides: about a file, as programs open it, and not about bytes in memory.
TEST(OpenCvConsumer, TakesTheFilesThatFileStorageTakes) {
  const std::string yaml = mono(kD5, 5);
  const std::string xml =
      "<?xml version=\"1.0\"?>\n<opencv_storage>\n<camera_matrix type_id=\"opencv-matrix\">\n<rows>3</rows>\n<cols>3</cols>\n"
      "<dt>d</dt>\n<data>\n400. 0. 320. 0. 410. 240. 0. 0. 1.</data></camera_matrix>\n</opencv_storage>\n";
  const std::string json =
      "{\"camera_matrix\": {\"type_id\": \"opencv-matrix\", \"rows\": 3, \"cols\": 3, \"dt\": \"d\", \"data\": [" + kK + "]}}";
  const auto opened = [](const std::string& bytes) {
    std::string path = (std::filesystem::temp_directory_path() / "fca-io-test-XXXXXX").string();
    const int file = ::mkstemp(path.data());
    EXPECT_EQ(::write(file, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    ::close(file);
    bool good = false;
    try {
      good = cv::FileStorage(path, cv::FileStorage::READ).isOpened();
    } catch (const std::exception&) {
    }
    std::filesystem::remove(path);
    return good;
  };
  for (const std::string& bytes : {yaml, xml, json}) {
    for (const char* before : {"", "\xEF\xBB\xBF", "\n", " ", "# a remark\n"}) {
      const ConsumerView view = load("opencv", before + bytes);
      EXPECT_EQ(view.loads(), opened(before + bytes)) << before << bytes << joined(view.refusals);
    }
  }
}

// --- OCamCalib --------------------------------------------------------------------------------------------------------------

// An equidistant lens, rho = 300 * angle: exact in the inverse polynomial, a Taylor series in the direct one.
const std::string kOcam =
    "#direct\n\n5 -3.000000e+02 0.0 1.1111111111111111e-03 0.0 8.2304526748971e-10\n\n#inverse\n\n2 471.23889803846896 "
    "300.0\n\n"
    "#centre: row column\n\n238.25 361.5\n\n#affine\n\n1.01 0.002 -0.003\n\n#size: height width\n\n480 752\n\n";

TEST(OCamCalibConsumer, ProjectsByTheInversePolynomial) {
  const ConsumerView view = load("ocamcalib", kOcam);
  expect_pixel(view, 0, kRay, 391.1915712071441, 178.68977067990383);
  EXPECT_EQ(view.cameras.at(0).width, 752);
  EXPECT_EQ(view.cameras.at(0).height, 480);
  expect_pixel(view, 0, {0, 0, 1}, 361.5, 238.25);
  expect_pixel(view, 0, {0, 0, -1}, 361.5, 238.25);  // also straight backwards
  std::string crlf;
  for (const char c : kOcam) crlf += c == '\n' ? "\r\n" : std::string(1, c);
  expect_pixel(load("ocamcalib", crlf), 0, kRay, 391.1915712071441, 178.68977067990383);
}

Message words(const char* text) { return {Code::kOcamWords, {text}}; }
Message number_of_coefficients(const char* polynomial) { return {Code::kOcamNumberOfCoefficients, {polynomial}}; }

TEST(OCamCalibConsumer, SkipsExactlyOneLineBeforeEachBlock) {
  expect_refused(load("ocamcalib", "#two lines\n" + kOcam), Code::kOcamLosesWay, "",
                 {words("#direct"), number_of_coefficients("direct polynomial")});
  expect_refused(load("ocamcalib", with_replaced(kOcam, "#direct\n\n", "")), Code::kOcamLosesWay, "",
                 {words("#inverse"), number_of_coefficients("direct polynomial")});
  expect_refused(load("ocamcalib", with_replaced(kOcam, "#affine", "#affine\n#c d e")), Code::kOcamLosesWay, "",
                 {words("#c d e"), "affine parameter c"});
  expect_refused(load("ocamcalib", with_replaced(kOcam, "#direct", "#" + std::string(1500, 'x'))), Code::kOcamLosesWay, "",
                 {number_of_coefficients("direct polynomial")});
  EXPECT_TRUE(load("ocamcalib", with_replaced(kOcam, "#direct", "any text, 1 2 3")).loads());
  EXPECT_TRUE(load("ocamcalib", with_replaced(kOcam, "#direct", "#" + std::string(1000, 'x'))).loads());
}

TEST(OCamCalibConsumer, RefusesWhereItWouldGoOnWithGarbage) {
  expect_refused(load("ocamcalib", with_replaced(kOcam, "480 752", "480.0 752.0")), Code::kOcamLosesWay, "",
                 {words(".0 752.0"), "image width"});
  expect_refused(load("ocamcalib", with_replaced(kOcam, "5 -3", "6 -3")), Code::kOcamLosesWay, "",
                 {words("#inverse"), Message{Code::kOcamCoefficient, {5, "direct polynomial"}}});
  expect_refused(load("ocamcalib", with_replaced(kOcam, "5 -3", "4 -3")), Code::kOcamLosesWay, "",
                 {words("#inverse"), number_of_coefficients("inverse polynomial")});
  expect_refused(load("ocamcalib", with_replaced(kOcam, "2 471", "65 471")), Code::kOcamCoefficientCount, "",
                 {"inverse polynomial", 65});
  expect_refused(load("ocamcalib", with_replaced(kOcam, "2 471", "0 471")), Code::kOcamCoefficientCount, "",
                 {"inverse polynomial", 0});
  expect_refused(load("ocamcalib", with_replaced(kOcam, "238.25 361.5", "238,25 361,5")), Code::kOcamLosesWay, "",
                 {"column of the centre"});
  expect_refused(load("ocamcalib", with_replaced(kOcam, "238.25", "nan")), Code::kOcamNotFinite);
  expect_refused(load("ocamcalib", with_replaced(kOcam, "480 752", "480")), Code::kOcamLosesWay, "",
                 {Message{Code::kOcamEndOfFile}, "image width"});
  expect_refused(load("ocamcalib", with_replaced(kOcam, "480 752", "0 752")), Code::kOcamSizeNotPositive);
  expect_refused(load("ocamcalib", ""), Code::kProgramFileEmpty);
}

TEST(OCamCalibConsumer, Warnings) {
  expect_warning(load("ocamcalib", with_replaced(kOcam, "-3.000000e+02", "3.000000e+02")), Code::kOcamOtherSign);
  expect_warning(load("ocamcalib", with_replaced(kOcam, "238.25 361.5", "361.5 238.25")), Code::kOcamCentreSwapped);
  const ConsumerView far = load("ocamcalib", with_replaced(kOcam, "471.23889803846896 300.0", "461.0 290.0"));
  expect_warning(far, Code::kOcamInverseFarOff);
  EXPECT_EQ(far.cameras.at(0).approximation_px, 0.0) << "another lens is no approximation";
}

// --- WoodScape --------------------------------------------------------------------------------------------------------------

const std::string kWoodScape =
    "{\"extrinsic\": {\"quaternion\": [0.0, 0.0, 1.4142135623730951, 1.4142135623730951], \"translation\": [3.0, 0.5, 0.25]}, "
    "\"intrinsic\": {\"aspect_ratio\": 1.1, \"cx_offset\": 4.0, \"cy_offset\": -3.0, \"height\": 966.0, \"k1\": 340.0, \"k2\": "
    "-30.0, \"k3\": 45.0, \"k4\": -7.0, \"model\": \"radial_poly\", \"poly_order\": 4, \"width\": 1280.0}, \"name\": \"FV\"}";

TEST(WoodScapeConsumer, ReadsCameraAndPose) {
  const ConsumerView view = load("woodscape", kWoodScape);
  expect_pixel(view, 0, kRay, 676.5073856716081, 406.8837515224622);
  expect_pixel(view, 0, {0, 0, 1}, 643.5, 479.5);
  EXPECT_TRUE(view.warnings.empty()) << joined(view.warnings);
  EXPECT_EQ(view.cameras.at(0).width, 1280);
  EXPECT_FALSE(view.cameras.at(0).project({0, 0, 0}));
  ASSERT_EQ(view.poses.size(), 1U);
  EXPECT_EQ(view.poses[0].a + " " + view.poses[0].b, "vehicle cam0");
  const std::array<double, 16> expected = {0, -1, 0, 3, 1, 0, 0, 0.5, 0, 0, 1, 0.25, 0, 0, 0, 1};
  for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(view.poses[0].T_a_b.at(i), expected.at(i), 1e-15) << i;
  EXPECT_EQ(load("woodscape", with_replaced(kWoodScape, "1280.0", "1280.9")).cameras.at(0).width, 1280) << "cut, not rounded";
}

TEST(WoodScapeConsumer, KeyErrorsAreRefusals) {
  for (const std::string key : {"k1", "k2", "k3", "k4", "width", "height", "cx_offset", "cy_offset", "aspect_ratio"})
    expect_refused(load("woodscape", with_replaced(kWoodScape, "\"" + key + "\"", "\"x\"")), Code::kPythonKeyMissing,
                   "intrinsic/" + key, {"intrinsic." + key, key});
  expect_refused(load("woodscape", with_replaced(kWoodScape, "\"translation\"", "\"translation used in CARLA\"")),
                 Code::kPythonKeyMissing, "extrinsic/translation",
                 {"extrinsic.translation", "translation", Message{Code::kPythonSimilarKey, {"translation used in CARLA"}}});
  expect_refused(load("woodscape", with_replaced(kWoodScape, "\"quaternion\"", "\"q\"")), Code::kPythonKeyMissing,
                 "extrinsic/quaternion", {"quaternion"});
  expect_refused(load("woodscape", with_replaced(kWoodScape, "\"extrinsic\"", "\"e\"")), Code::kPythonKeyMissing, "extrinsic");
  EXPECT_TRUE(load("woodscape", with_replaced(kWoodScape, "\"name\"", "\"n\"")).loads());
  EXPECT_TRUE(load("woodscape", with_replaced(kWoodScape, "\"model\"", "\"m\"")).loads());
}

TEST(WoodScapeConsumer, JsonAsPythonReadsIt) {
  expect_refused(load("woodscape", kWoodScape + "x"), Code::kPythonJsonNotParsed);
  expect_refused(load("woodscape", with_replaced(kWoodScape, "-7.0,", "-7.0,,")), Code::kPythonJsonNotParsed);
  expect_refused(load("woodscape", with_replaced(kWoodScape, "\"name\"", "// comment\n\"name\"")), Code::kPythonJsonNotParsed);
  expect_refused(load("woodscape", "\xEF\xBB\xBF" + kWoodScape), Code::kPythonJsonBom);
  expect_refused(load("woodscape", "[1]"), Code::kPythonJsonNoObject);
  expect_refused(load("woodscape", ""), Code::kPythonJsonNotParsed);
  expect_refused(load("woodscape", std::string(200000, '[')), Code::kPythonJsonTooDeep);
  expect_refused(load("woodscape", with_replaced(kWoodScape, "340.0", "\"340.0\"")), Code::kPythonNotANumber, "intrinsic/k1",
                 {"intrinsic.k1"});
  expect_refused(load("woodscape", with_replaced(kWoodScape, "1280.0", "NaN")), Code::kProjectionPySizeNotInt);
  expect_refused(load("woodscape", with_replaced(kWoodScape, "0.0, 0.0, 1.4142135623730951, 1.4142135623730951", "0, 0, 0, 0")),
                 Code::kProjectionPyNoRotation, "extrinsic/quaternion");
  expect_refused(load("woodscape", with_replaced(kWoodScape, "[3.0, 0.5, 0.25]", "[3.0, 0.5]")), Code::kPythonNotNumbers,
                 "extrinsic/translation", {3});
  // The last of two equal keys wins.
  expect_pixel(load("woodscape", with_replaced(kWoodScape, "\"k1\": 340.0", "\"k1\": 1.0, \"k1\": 340.0")), 0, kRay,
               676.5073856716081, 406.8837515224622);
}

TEST(WoodScapeConsumer, LooksAtNumbersNotAtTheModel) {
  expect_warning(load("woodscape", with_replaced(kWoodScape, "340.0", "0.18")), Code::kProjectionPyNormalised, "intrinsic/k1");
  expect_warning(load("woodscape", with_replaced(kWoodScape, "radial_poly", "ucm")), Code::kProjectionPyOtherModel,
                 "intrinsic/model");
}

TEST(OmnidetConsumer, IsHalfAPixelOff) {
  const ConsumerView view = load("woodscape-omnidet", kWoodScape);
  expect_warning(view, Code::kOmnidetCentre, "", {0.707114});
  expect_warning(view, Code::kOmnidetAspectRatio);
  expect_pixel(view, 0, {0, 0, 1}, 644.0, 480.0);
  EXPECT_TRUE(view.cameras.at(0).misread);
  EXPECT_TRUE(view.poses.empty());
  EXPECT_TRUE(load("woodscape-omnidet", with_replaced(kWoodScape, "\"translation\"", "\"t\"")).loads()) << "no pose is read";
  expect_refused(load("woodscape-omnidet", with_replaced(kWoodScape, "\"name\"", "\"n\"")), Code::kOmnidetNameMissing, "name");
}

TEST(OmnidetConsumer, TakesValuesByTheirPlace) {
  const std::string swapped = with_replaced(kWoodScape, "\"k1\": 340.0, \"k2\": -30.0", "\"k2\": -30.0, \"k1\": 340.0");
  expect_warning(load("woodscape-omnidet", swapped), Code::kOmnidetOtherOrder, "intrinsic", {4, "k2", "k1"});
  EXPECT_EQ(load("woodscape", swapped).warnings.size(), 0U);
  expect_refused(load("woodscape-omnidet", with_replaced(kWoodScape, "\"k4\": -7.0, \"model\": \"radial_poly\"",
                                                         "\"model\": \"radial_poly\", \"k4\": -7.0")),
                 Code::kOmnidetValueNoNumber, "intrinsic", {7, "model", "k4"});
  expect_refused(load("woodscape-omnidet", "{\"intrinsic\": {\"k1\": 1}, \"name\": \"FV\"}"), Code::kOmnidetTooFewValues,
                 "intrinsic", {1});
  expect_warning(load("woodscape-omnidet", with_replaced(kWoodScape, "1280.0", "640.0")), Code::kOmnidetOtherSize);
  // The last of two equal keys gives the value, the first the place.
  const ConsumerView twice =
      load("woodscape-omnidet", with_replaced(kWoodScape, "\"k1\": 340.0", "\"k1\": 1.0, \"k1\": 340.0"));
  for (const Complaint& warning : twice.warnings) {
    EXPECT_NE(warning.facts.code, Code::kOmnidetOtherOrder);
    EXPECT_NE(warning.facts.code, Code::kOmnidetWidthNotLast);
  }
}

// --- DSO --------------------------------------------------------------------------------------------------------------------

std::string camera_txt(const std::string& first, const std::string& mode = "crop", const std::string& output = "640 480") {
  return first + "\n640 480\n" + mode + "\n" + output + "\n";
}

TEST(DsoConsumer, ItsLenses) {
  constexpr double kFloat = 2e-4;
  const std::string numbers = "400 410 320 240 ";
  for (const std::string name : {"RadTan ", ""})
    expect_pixel(load("dso", camera_txt(name + numbers + "-0.1 0.01 0.001 -0.002")), 0, kRay, 359.729, 158.49405, kFloat);
  for (const std::string name : {"EquiDistant ", "KannalaBrandt ", "EquiDistant"})
    expect_pixel(load("dso", camera_txt(name + numbers + "0.01 -0.02 0.003 -0.001")), 0, kRay, 359.36986018344106,
                 159.29178662394585, kFloat);
  for (const std::string name : {"Pinhole ", ""})
    expect_pixel(load("dso", camera_txt(name + numbers + "0")), 0, kRay, 360, 158, kFloat);
  for (const std::string name : {"FOV ", ""}) {
    const double r = std::hypot(0.1, 0.2);
    const double factor = std::atan(2.0 * r * std::tan(0.45)) / (0.9 * r);
    expect_pixel(load("dso", camera_txt(name + numbers + "0.9")), 0, kRay, 320 + 40 * factor, 240 - 82 * factor, kFloat);
  }
  EXPECT_FALSE(load("dso", camera_txt("Pinhole " + numbers + "0")).cameras.at(0).project({0.1, 0.1, -1.0}));
  expect_warning(load("dso", camera_txt("Pinhole " + numbers + "0.9")), Code::kDsoFifthNumberIgnored);
}

TEST(DsoConsumer, RelativeWhereTheCentreIsBelowOne) {
  const ConsumerView view = load("dso", camera_txt("Pinhole 0.625 0.8541666666666666 0.50078125 0.5010416666666667 0"));
  expect_pixel(view, 0, kRay, 320 + 40, 240 - 82, 2e-4);  // 0.50078125 * 640 - 0.5 = 320
  expect_warning(load("dso", camera_txt("Pinhole 400 410 0.5 0.5 0")), Code::kDsoSharesByCentre);
  expect_warning(load("dso", camera_txt("Pinhole 0.625 0.854 320 0.5 0")), Code::kDsoPixelsBelowOne);
}

TEST(DsoConsumer, NonePassesImagesThrough) {
  const ConsumerView view = load("dso", camera_txt("RadTan 400 410 320 240 -0.1 0.01 0.001 -0.002", "none"));
  expect_warning(view, Code::kDsoNotRectified);
  EXPECT_TRUE(view.cameras.at(0).misread);
  expect_pixel(view, 0, kRay, 360, 158, 2e-4);
  const ConsumerView pinhole = load("dso", camera_txt("Pinhole 400 410 320 240 0", "none"));
  EXPECT_TRUE(pinhole.warnings.empty());
  EXPECT_FALSE(pinhole.cameras.at(0).misread);
}

TEST(DsoConsumer, Refusals) {
  const std::string good = "RadTan 400 410 320 240 -0.1 0.01 0.001 -0.002";
  expect_refused(load("dso", camera_txt("RadTan 400 410 320 240 -0.1 0.01 0.001")), Code::kDsoUnknownLens);
  expect_refused(load("dso", camera_txt("Radtan 400 410 320 240 -0.1 0.01 0.001 0")), Code::kDsoUnknownLens);
  expect_refused(load("dso", camera_txt("# comment\n" + good)), Code::kDsoUnknownLens, "", {R"("# comment")"});
  expect_refused(load("dso", camera_txt(good, "crop\r")), Code::kDsoOutputUnknown, "", {R"("crop\r")"});
  expect_refused(load("dso", camera_txt(good, "full")), Code::kDsoFullUnfinished);
  expect_refused(load("dso", camera_txt(good, "none", "320 240")), Code::kDsoSizesDiffer);
  expect_refused(load("dso", camera_txt(good, "crop", "")), Code::kDsoSizeNotRead, "", {4, "output"});
  expect_refused(load("dso", good + "\n640.5 480\ncrop\n640 480\n"), Code::kDsoSizeNotRead, "", {2, "image"});
  expect_refused(load("dso", ""), Code::kProgramFileEmpty);
  expect_warning(load("dso", camera_txt(good, "400 410 320 240 0")), Code::kDsoOutputShares);
  EXPECT_TRUE(load("dso", camera_txt(good, "0.5 0.5 0.5 0.5 0")).warnings.empty());
}

// --- all --------------------------------------------------------------------------------------------------------------------

TEST(Consumers, TumViFilesAreReadByKalibrAndDso) {
  std::vector<std::string> ids;
  for (const Consumer& consumer : all_consumers()) {
    if (consumer.reads("tumvi")) ids.emplace_back(consumer.id);
  }
  EXPECT_EQ(ids, (std::vector<std::string>{"kalibr", "kalibr-imu", "dso"}));
  EXPECT_FALSE(find_consumer("opencv")->reads(""));
}

constexpr const char* kTransforms =
    R"({"camera_model": "OPENCV", "camera_angle_x": 1.2, "fl_x": 400, "fl_y": 410, "cx": 320, "cy": 240, "w": 640, "h": 480,
"k1": 0.1, "k2": 0.02, "p1": 0, "p2": 0, "is_fisheye": false,
"frames": [{"file_path": "a.png", "transform_matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]},
           {"file_path": "b.png", "transform_matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}]})";

// None throws or crashes, whatever the bytes are; and what loads can be asked.
TEST(Consumers, SurviveMutatedFiles) {
  const std::vector<std::pair<const char*, std::string>> files = {
      {"opencv", mono(kD5, 5, "xi: 1.2\n")},
      {"opencv", mc_calib(2)},
      {"ocamcalib", kOcam},
      {"woodscape", kWoodScape},
      {"woodscape-omnidet", kWoodScape},
      {"dso", camera_txt("FOV 400 410 320 240 0.9")},
      {"colmap", "1 EUCM 640 480 400 410 320 240 0.6 1.1\n2 FOV 640 480 400 410 320 240 0.9\n"},
      {"nerfstudio", kTransforms},
      {"instant-ngp", kTransforms},
      {"lichtfeld", kTransforms},
      {"3dgrut", kTransforms}};
  constexpr std::string_view kPieces = "0123456789.-+e[]{}:,\"\n \t#<>nai%/\\\xEF";
  std::mt19937 random(7);
  int loaded = 0;
  for (const auto& [id, bytes] : files) {
    for (int i = 0; i < 400; ++i) {
      std::string mutated = bytes;
      for (int change = 0; change < 1 + i % 4; ++change) {
        const std::size_t place = random() % mutated.size();
        const char piece = kPieces[random() % kPieces.size()];
        if (random() % 3 == 0) {
          mutated.erase(place, 1 + random() % 5);
        } else if (random() % 2 == 0) {
          mutated.insert(place, 1, piece);
        } else {
          mutated[place] = piece;
        }
        if (mutated.empty()) mutated = " ";
      }
      const ConsumerView view = load(id, mutated);
      loaded += view.loads() ? 1 : 0;
      EXPECT_EQ(view.cameras.empty(), !view.loads());
      for (const ConsumerCamera& camera : view.cameras) static_cast<void>(camera.project({0.3, 0.2, -0.5}));
    }
  }
  EXPECT_GT(loaded, 100);
}

}  // namespace
}  // namespace fca::consumers
