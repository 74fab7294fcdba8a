// SPDX-License-Identifier: BSD-3-Clause
// The independent readers by themselves: small texts, with pixels computed by other means (Python's mpmath, 30 digits, from the
// formulas of FORMATS.md), and the tables that the real programs printed, where they are next to the repository.
#include "formats/corpus_folders.h"
#include "formats/matrix/geometry.h"
#include "formats/matrix/ray_search.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

#include <gtest/gtest.h>

namespace fca::matrix {

namespace {

namespace fs = std::filesystem;

const Ray kAhead = {0.3, -0.2, 1.0};
const Ray kBehind = {1.0, 0.5, -0.1};  ///< 95 deg from the axis

void expect_pixel(const std::string& format, const std::string& bytes, std::size_t index, const Ray& ray, const Pixel& wanted) {
  const std::optional<PixelFormula> formula = find_reader(format)->camera(bytes, index);
  ASSERT_TRUE(formula) << bytes;
  const std::optional<Pixel> pixel = formula->pixel(ray);
  ASSERT_TRUE(pixel) << bytes;
  EXPECT_NEAR((*pixel)[0], wanted[0], 1e-10) << bytes;
  EXPECT_NEAR((*pixel)[1], wanted[1], 1e-10) << bytes;
}

std::string camchain(const std::string& camera, const std::string& intrinsics, const std::string& lens,
                     const std::string& coeffs) {
  return "cam0:\n  camera_model: " + camera + "\n  intrinsics: [" + intrinsics + "200.0, 210.0, 320.5, 239.25]\n" +
         "  distortion_model: " + lens + "\n  distortion_coeffs: [" + coeffs + "]\n  resolution: [640, 480]\n";
}

TEST(MatrixReaders, Kalibr) {
  const std::string kb = camchain("pinhole", "", "equidistant", "0.01, -0.02, 0.003, -0.0004");
  for (const char* format : {"kalibr", "tumvi"}) {
    expect_pixel(format, kb, 0, kAhead, {378.13842481427425, 198.90310263000802});
    expect_pixel(format, kb, 0, kBehind, {592.32757822833639, 381.95947856987661});
  }
  EXPECT_EQ(find_reader("kalibr")->camera(kb, 0)->size->width, 640);
  EXPECT_FALSE(find_reader("kalibr")->camera(kb, 1));
  expect_pixel("kalibr", camchain("pinhole", "", "none", ""), 0, kAhead, {380.5, 197.25});
  EXPECT_FALSE(find_reader("kalibr")->camera(camchain("pinhole", "", "none", ""), 0)->pixel(kBehind));
  expect_pixel("kalibr", camchain("pinhole", "", "radtan", "-0.28, 0.07, 0.0002, -0.0001"), 0, kAhead, {378.37598, 198.740454});
  expect_pixel("kalibr", camchain("pinhole", "", "fov", "0.9"), 0, kAhead, {382.47695086161522, 195.86613439686935});
  const std::string omni = camchain("omni", "0.9, ", "radtan", "-0.1, 0.05, 0.0005, -0.0003");
  expect_pixel("kalibr", omni, 0, kAhead, {351.05332757227938, 217.86480979200943});
  expect_pixel("kalibr", omni, 0, kBehind, {531.96223598358383, 350.47360581679891});
  const std::string eucm = camchain("eucm", "0.6, 1.1, ", "none", "");
  expect_pixel("kalibr", eucm, 0, kAhead, {378.11103909417765, 198.92227263407564});
  expect_pixel("kalibr", eucm, 0, kBehind, {620.74794275911034, 396.88016994853293});
  const std::string ds = camchain("ds", "-0.2, 0.6, ", "none", "");
  expect_pixel("kalibr", ds, 0, kAhead, {392.39313327377373, 188.92480670835839});
  expect_pixel("kalibr", ds, 0, kBehind, {672.17660327731386, 423.88021672058977});
}

TEST(MatrixReaders, TumViCameraTxt) {
  const std::string absolute = "EquiDistant 200 210 320.5 239.25 0.01 -0.02 0.003 -0.0004\n640 480\ncrop\n640 480\n";
  expect_pixel("tumvi", absolute, 0, kBehind, {592.32757822833639, 381.95947856987661});
  const std::string relative = "EquiDistant 0.4 0.5 0.49 0.51 0.01 -0.02 0.003 -0.0004\n512 512\nfull\n512 512\n";
  expect_pixel("tumvi", relative, 0, kAhead, {309.40174700981684, 211.43521082515264});
  expect_pixel("tumvi", relative, 0, kBehind, {528.73144010581647, 434.58965006613529});
  const std::string kannala = "KannalaBrandt 200 210 320.5 239.25 0.01 -0.02 0.003 -0.0004\n640 480\n";
  expect_pixel("tumvi", kannala, 0, kAhead, {378.13842481427425, 198.90310263000802});
  expect_pixel("tumvi", "RadTan 200 210 320.5 239.25 -0.28 0.07 0.0002 -0.0001\n640 480\n", 0, kAhead, {378.37598, 198.740454});
  expect_pixel("tumvi", "FOV 200 210 320.5 239.25 0.9\n640 480\n", 0, kAhead, {382.47695086161522, 195.86613439686935});
  expect_pixel("tumvi", "Pinhole 200 210 320.5 239.25 0\n640 480\n", 0, kAhead, {380.5, 197.25});
}

/// `lines`: Camera keys; the prefix is put in front of each.
std::string settings(const std::string& head, const std::string& prefix, const std::vector<std::string>& lines) {
  std::string text = "%YAML:1.0\n" + head + "\n";
  for (const char* line : {"fx: 200.", "fy: 210.", "cx: 320.5", "cy: 239.25"}) text += prefix + line + "\n";
  for (const std::string& line : lines) text += prefix + line + "\n";
  return text + "Camera.width: 640\nCamera.height: 480\n";
}

TEST(MatrixReaders, OrbSlam3) {
  const std::string kb = settings("File.version: \"1.0\"\nCamera.type: \"KannalaBrandt8\"", "Camera1.",
                                  {"k1: 0.01", "k2: -0.02", "k3: 0.003", "k4: -0.0004"});
  expect_pixel("orbslam3", kb, 0, kAhead, {378.13842481427425, 198.90310263000802});
  expect_pixel("orbslam3", kb, 0, kBehind, {592.32757822833639, 381.95947856987661});
  EXPECT_FALSE(find_reader("orbslam3")->camera(kb, 1));
  const std::string pinhole = settings("File.version: \"1.0\"\nCamera.type: \"PinHole\"", "Camera1.",
                                       {"k1: -0.28", "k2: 0.07", "p1: 0.0002", "p2: -0.0001", "k3: 0.015"});
  expect_pixel("orbslam3", pinhole, 0, kAhead, {378.3779573, 198.73906989});
  expect_pixel("orbslam3", settings("", "Camera.", {"k1: -0.28", "k2: 0.07", "p1: 0.0002", "p2: -0.0001"}), 0, kAhead,
               {378.37598, 198.740454});
  expect_pixel("orbslam3", settings("File.version: \"1.0\"\nCamera.type: \"Rectified\"", "Camera1.", {}), 0, kAhead,
               {380.5, 197.25});
  const std::string eucm = settings("Camera.type: EUCM # a comment", "Camera.", {"k1: 0.6", "k2: 1.1", "p1: 0.", "p2: 0."});
  expect_pixel("orbslam3", eucm, 0, kBehind, {620.74794275911034, 396.88016994853293});
  const std::string ds = settings("Camera.type: \"DoubleSphere\"", "Camera.", {"xi: -0.2", "alpha: 0.6"});
  expect_pixel("orbslam3", ds, 0, kBehind, {672.17660327731386, 423.88021672058977});
  const std::string fork_kb = settings("Camera.type: KB", "Camera.", {"k1: 0.01", "k2: -0.02", "p1: 0.003", "p2: -0.0004"});
  expect_pixel("orbslam3", fork_kb, 0, kBehind, {592.32757822833639, 381.95947856987661});
}

TEST(MatrixReaders, Colmap) {
  const auto line = [](const std::string& words) { return "# 1 comment\n\n3 " + words + "\n"; };
  const std::string fisheye = line("OPENCV_FISHEYE 640 480 200 210 321 239.75 0.01 -0.02 0.003 -0.0004");
  expect_pixel("colmap", fisheye, 0, kAhead, {378.13842481427425, 198.90310263000802});
  expect_pixel("colmap", fisheye, 0, kBehind, {592.32757822833639, 381.95947856987661});
  EXPECT_FALSE(find_reader("colmap")->camera(fisheye, 1));
  expect_pixel("colmap", fisheye + "5 PINHOLE 640 480 200 210 321 239.75\n", 1, kAhead, {380.5, 197.25});
  expect_pixel("colmap", line("OPENCV 640 480 200 210 321 239.75 -0.28 0.07 0.0002 -0.0001"), 0, kAhead,
               {378.37598, 198.740454});
  expect_pixel("colmap", line("FULL_OPENCV 640 480 200 210 321 239.75 0.1 0.02 0.001 -0.002 0.003 0.05 0.01 0.002"), 0, kAhead,
               {380.74961835604846, 197.06616715076608});
  expect_pixel("colmap", line("FOV 640 480 200 210 321 239.75 0.9"), 0, kAhead, {382.47695086161522, 195.86613439686935});
  const std::string eucm = line("EUCM 640 480 200 210 321 239.75 0.6 1.1");
  expect_pixel("colmap", eucm, 0, kAhead, {378.11103909417765, 198.92227263407564});
  expect_pixel("colmap", eucm, 0, kBehind, {620.74794275911034, 396.88016994853293});
}

TEST(MatrixReaders, Nerfstudio) {
  const std::string numbers = R"("fl_x": 200, "fl_y": 210, "cx": 321, "cy": 239.75, "w": 640, "h": 480)";
  const std::string lens = R"(, "k1": 0.01, "k2": -0.02, "k3": 0.003, "k4": -0.0004)";
  const std::string fisheye = R"({"camera_model": "OPENCV_FISHEYE", )" + numbers + lens + R"(, "frames": [{}, {}]})";
  expect_pixel("nerfstudio", fisheye, 0, kAhead, {378.13842481427425, 198.90310263000802});
  expect_pixel("nerfstudio", fisheye, 0, kBehind, {592.32757822833639, 381.95947856987661});
  EXPECT_FALSE(find_reader("nerfstudio")->camera(fisheye, 1));
  const std::string brown = R"(, "k1": -0.28, "k2": 0.07, "p1": 0.0002, "p2": -0.0001)";
  const std::string frames = R"({"frames": [{)" + numbers + "}, {" + numbers + "}, {" + numbers + brown + "}]}";
  expect_pixel("nerfstudio", frames, 0, kAhead, {380.5, 197.25});
  expect_pixel("nerfstudio", frames, 1, kAhead, {378.37598, 198.740454});
}

std::string matrix_node(const std::string& name, int rows, int columns, const std::string& data) {
  return name + ": !!opencv-matrix\n   rows: " + std::to_string(rows) + "\n   cols: " + std::to_string(columns) +
         "\n   dt: d\n   data: [ " + data + " ]\n";
}

TEST(MatrixReaders, OpenCv) {
  const std::string K = "200., 0., 320.5, 0., 210., 239.25, 0., 0., 1.";
  const std::string head = "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\n";
  const std::string matrix = matrix_node("camera_matrix", 3, 3, K);
  const auto D = [](int n, const std::string& data) { return matrix_node("distortion_coefficients", n, 1, data); };
  expect_pixel("opencv", head + matrix + D(4, "-0.28, 0.07, 0.0002, -0.0001"), 0, kAhead, {378.37598, 198.740454});
  expect_pixel("opencv", head + matrix + D(5, "-0.28, 0.07, 0.0002, -0.0001, 0.015"), 0, kAhead, {378.3779573, 198.73906989});
  expect_pixel("opencv", head + matrix + D(8, "0.1, 0.02, 0.001, -0.002, 0.003, 0.05, 0.01, 0.002"), 0, kAhead,
               {380.74961835604846, 197.06616715076608});
  expect_pixel("opencv",
               head + matrix +
                   D(14, "0.1, 0.02, 0.001, -0.002, 0.003, 0.05, 0.01, 0.002, 0.0011, -0.0012, 0.0013, -0.0014, 0.02, -0.03"),
               0, kAhead, {381.10617589498989, 196.91327031277248});
  const std::string fisheye = head + "fisheye_model: 1\n" + matrix + D(4, "0.01, -0.02, 0.003, -0.0004");
  expect_pixel("opencv", fisheye, 0, kAhead, {378.13842481427425, 198.90310263000802});
  expect_pixel("opencv", fisheye, 0, kBehind, {592.32757822833639, 381.95947856987661});
  expect_pixel("opencv", head + matrix + matrix_node("fisheye_dist_coeffs", 4, 1, "0.01, -0.02, 0.003, -0.0004"), 0, kAhead,
               {378.13842481427425, 198.90310263000802});
  EXPECT_FALSE(find_reader("opencv")->camera(head + matrix + matrix_node("my_distortion", 4, 1, "1., 1., 1., 1."), 0));
  const std::string omnidir = "%YAML:1.0\n---\n" +
                              matrix_node("camera_matrix", 3, 3, "200., 2.5, 320.5, 0., 210., 239.25, 0., 0., 1.") +
                              D(4, "-0.1, 0.05, 0.0005, -0.0003") + "xi: 0.9\n";
  expect_pixel("opencv", omnidir, 0, kAhead, {350.79874197456521, 217.86480979200943});
  expect_pixel("opencv", omnidir, 0, kBehind, {533.28632652902191, 350.47360581679891});
  // stereo_calib's names, as JSON and XML
  const std::string json = R"({"M1": {"type_id": "opencv-matrix", "rows": 3, "cols": 3, "dt": "d",
      "data": [1, 0, 0, 0, 1, 0, 0, 0, 1]}, "M2": {"type_id": "opencv-matrix", "rows": 3, "cols": 3, "dt": "d",
      "data": [200.0, 0, 320.5, 0, 210.0, 239.25, 0, 0, 1]}})";
  expect_pixel("opencv", json, 1, kAhead, {380.5, 197.25});
  const std::string xml =
      "<?xml version=\"1.0\"?>\n<opencv_storage>\n<K1 type_id=\"opencv-matrix\"><rows>3</rows><cols>3</cols><dt>d</dt><data>\n"
      "200. 0. 320.5 0. 210. 239.25 0. 0. 1.</data></K1>\n</opencv_storage>\n";
  expect_pixel("opencv", xml, 0, kAhead, {380.5, 197.25});
  EXPECT_FALSE(find_reader("opencv")->camera(xml, 1));
}

TEST(MatrixReaders, OCamCalib) {
  const std::string text =
      "#direct\n\n5 -200.0 0.0 0.002 -1e-6 3e-9\n\n#inverse\n\n5 310 190 12 20 8\n\n#centre\n\n239.25 320.5\n\n#affine\n\n"
      "1.001 0.002 -0.003\n\n#size\n\n480 640\n";
  const std::optional<PixelFormula> formula = find_reader("ocamcalib")->camera(text, 0);
  ASSERT_TRUE(formula);
  EXPECT_EQ(formula->size->width, 640);
  for (const auto& [ray, wanted] : {std::pair(kAhead, Pixel{384.32522261045966, 196.86971246491102}),
                                    std::pair(kBehind, Pixel{612.59185467336925, 386.24665195129499})}) {
    EXPECT_NEAR((*formula->stored_approximation(ray))[0], wanted[0], 1e-10);
    EXPECT_NEAR((*formula->stored_approximation(ray))[1], wanted[1], 1e-10);
  }
  for (const auto& [pixel, wanted] :
       {std::pair(Pixel{400.0, 300.0}, Ray{0.38580266101043115, 0.29307492668206294, 0.87479334365755995}),
        std::pair(Pixel{620.0, 30.0}, Ray{0.80355040319116608, -0.56363693617215867, -0.19136393002281376})}) {
    const Ray ray = *formula->ray(pixel);
    const double length = std::sqrt(ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2]);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(ray[i] / length, wanted[i], 1e-14);
    // The exact inverse of the direct polynomial
    EXPECT_NEAR((*formula->pixel(wanted))[0], pixel[0], 1e-10);
    EXPECT_NEAR((*formula->pixel(wanted))[1], pixel[1], 1e-10);
  }
}

std::string woodscape(const std::string& q, const std::string& t) {
  return R"({"extrinsic": {"quaternion": [)" + q + R"(], "translation": [)" + t +
         R"(]}, "intrinsic": {"aspect_ratio": 1.02, "cx_offset": 3.9, "cy_offset": -3.1, "height": 966.0, "k1": 339.0,
         "k2": -32.0, "k3": 48.0, "k4": -7.0, "model": "radial_poly", "poly_order": 4, "width": 1280.0}, "name": "FV"})";
}

TEST(MatrixReaders, WoodScape) {
  const std::string first = woodscape("0.5, -0.5, 0.5, -0.5", "3.7, 0.0, 0.66");
  expect_pixel("woodscape", first, 0, kAhead, {739.39084082881422, 414.12622823640633});
  expect_pixel("woodscape", first, 0, kBehind, {1216.7050449123479, 771.78557290529741});
  const std::vector<Pose> poses =
      find_reader("woodscape")->relative_poses({first, woodscape("0.1, 0.2, 0.3, 0.9", "2.0, 1.0, 0.9")});
  ASSERT_EQ(poses.size(), 1U);
  const Pose wanted = {{{-0.61052631578947368, 0.31578947368421053, 0.72631578947368421, 0.7},
                        {-0.78947368421052632, -0.31578947368421053, -0.52631578947368421, -1.76},
                        {0.063157894736842105, -0.89473684210526316, 0.44210526315789474, 0.6}}};
  for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(poses.front()[i / 4][i % 4], wanted[i / 4][i % 4], 1e-14);
}

// The same rig, a quarter turn about z and a step of (0.1, 0.2, 0.3) from camera 0 to camera 1, in every direction formats use.
TEST(MatrixReaders, RelativePoses) {
  const Pose wanted = {{{0.0, -1.0, 0.0, 0.1}, {1.0, 0.0, 0.0, 0.2}, {0.0, 0.0, 1.0, 0.3}}};
  const std::string rows = "[[0.0, -1.0, 0.0, 0.1], [1.0, 0.0, 0.0, 0.2], [0.0, 0.0, 1.0, 0.3], [0.0, 0.0, 0.0, 1.0]]";
  const std::string identity = "[[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]";
  const std::string inverted = "0., 1., 0., -0.2, -1., 0., 0., 0.1, 0., 0., 1., -0.3, 0., 0., 0., 1.";
  const std::string lens =
      ", camera_model: ds, distortion_model: none, distortion_coeffs: [], intrinsics: [0.1, 0.5, 1., 1., 0., 0.]}\n";
  const std::string R = "0., -1., 0., 1., 0., 0., 0., 0., 1.";
  const std::string head = "%YAML:1.0\n---\n";
  const std::vector<std::pair<std::string, std::string>> texts = {
      {"kalibr", "cam0: {a: 0" + lens + "cam1: {T_cn_cnm1: " + rows + lens},
      {"kalibr", "cam0: {T_cam_imu: " + identity + lens + "cam1: {T_cam_imu: " + rows + lens},
      {"tumvi", "cam0: {T_cam_imu: " + identity + lens + "cam1: {T_cam_imu: " + rows + lens},
      {"orbslam3", head + matrix_node("Stereo.T_c1_c2", 4, 4, inverted)},
      {"orbslam3", head + matrix_node("Tlr", 3, 4, "0., 1., 0., -0.2, -1., 0., 0., 0.1, 0., 0., 1., -0.3")},
      {"orbslam3", head + matrix_node("CAMERA.R", 3, 3, R) + matrix_node("CAMERA.T", 1, 3, "0.1, 0.2, 0.3")},
      {"opencv", head + matrix_node("R", 3, 3, R) + matrix_node("T", 3, 1, "0.1, 0.2, 0.3")},
      {"opencv", head + matrix_node("om", 3, 1, "0., 0., 1.5707963267948966") + "T: [0.1, 0.2, 0.3]\n"},
  };
  for (const auto& [format, text] : texts) {
    const std::vector<Pose> poses = find_reader(format)->relative_poses({text});
    ASSERT_EQ(poses.size(), 1U) << text;
    for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(poses.front()[i / 4][i % 4], wanted[i / 4][i % 4], 1e-15) << text;
  }
}

// The search must find rays beyond 90 deg, and none beyond a fold.
TEST(MatrixReaders, RaySearch) {
  const std::string ds = camchain("ds", "-0.2, 0.6, ", "none", "");
  const RayToPixel wide = find_reader("kalibr")->camera(ds, 0)->pixel;
  for (const Ray& ray : {kAhead, kBehind, Ray{-1.0, 2.0, -0.5}}) {
    const std::optional<Ray> found = search_ray(wide, *wide(ray));
    ASSERT_TRUE(found);
    const double length = std::sqrt(ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2]);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR((*found)[i], ray[i] / length, 1e-12);
    EXPECT_TRUE(reaches(wide, ray));
  }
  // 1 - 3 * 0.28 r^2 = 0: the radius grows up to r = 1.09, 145 px
  const std::string radtan = camchain("pinhole", "", "radtan", "-0.28, 0.0, 0.0, 0.0");
  const RayToPixel folded = find_reader("kalibr")->camera(radtan, 0)->pixel;
  EXPECT_TRUE(search_ray(folded, {320.5 + 145.0, 239.25}));
  EXPECT_FALSE(search_ray(folded, {320.5 + 146.0, 239.25}));
  EXPECT_TRUE(reaches(folded, {1.08, 0.0, 1.0}));
  EXPECT_FALSE(reaches(folded, {1.10, 0.0, 1.0}));
}

std::string read_bytes(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// One table that a real program printed: its rays, its pixels.
struct OracleTable {
  std::string corpus_file;
  std::size_t index = 0;
  std::vector<std::pair<Ray, Pixel>> rows;
};

OracleTable read_table(const fs::path& path) {
  OracleTable table;
  std::ifstream stream(path);
  std::string line;
  std::getline(stream, line);
  const std::string file = "# corpus file: ";
  const std::string index = "camera index: ";
  table.corpus_file = line.substr(file.size(), line.find('\t') - file.size());
  table.index = static_cast<std::size_t>(std::stoi(line.substr(line.find(index) + index.size())));
  while (std::getline(stream, line)) {
    std::istringstream words(line);
    std::string kind;
    Ray ray{};
    Pixel pixel{};
    // A row with nan ends the stream and is left out.
    if (words >> kind >> ray[0] >> ray[1] >> ray[2] >> pixel[0] >> pixel[1] && kind == "project")
      table.rows.emplace_back(ray, pixel);
  }
  return table;
}

/// The programs that compute with floats: 24 bits of some hundred pixels.
double tolerance(const fs::path& table) {
  const std::string program = table.stem().extension().string();
  return program == ".orbslam3" || program == ".openvins" || program == ".dso" ? 2e-4 : 1e-9;
}

/// What the program prints of a ray that its own formula does not mean (FORMATS.md 4 and shared/oracles/README.md).
bool beside_the_formula(const std::string& format, const Ray& ray) {
  const bool mirrors = format == "kalibr" || format == "opencv" || format == "tumvi";
  return mirrors && ray[2] <= 0.01;
}

/// ORB-SLAM3 prints pixels of the rescaled image, and its second camera has the first one's lens.
bool another_camera(const std::string& format, const std::string& bytes, std::size_t index) {
  return format == "orbslam3" && (index > 0 || bytes.find("newWidth") != std::string::npos);
}

TEST(MatrixReaders, AgreeWithWhatTheRealProgramsPrinted) {
  const fs::path shared = FCA_SHARED_DIR;
  if (!fs::exists(shared / "oracles")) GTEST_SKIP() << "no tables beside the repository: " << shared / "oracles";
  for (const test::SharedFolders& folders : test::kSharedFolders) {
    if (folders.tables.empty()) continue;
    const std::string format(folders.format);
    int tables = 0;
    double worst = 0.0;
    for (const fs::directory_entry& entry : fs::directory_iterator(shared / "oracles" / folders.tables)) {
      const OracleTable table = read_table(entry.path());
      if (format != "basalt" && entry.path().string().find(".basalt.") != std::string::npos) continue;  // another format
      const std::string bytes = read_bytes(shared / "corpus" / table.corpus_file);
      if (another_camera(format, bytes, table.index)) continue;
      const std::optional<PixelFormula> formula = find_reader(format)->camera(bytes, table.index);
      EXPECT_TRUE(formula) << table.corpus_file;
      if (!formula) continue;
      const RayToPixel& pixel_of = formula->stored_approximation ? formula->stored_approximation : formula->pixel;
      int compared = 0;
      for (const auto& [ray, wanted] : table.rows) {
        if (beside_the_formula(format, ray)) continue;
        const std::optional<Pixel> pixel = pixel_of(ray);
        if (!pixel) continue;
        ++compared;
        const double scale = std::max({1.0, std::abs(wanted[0]) / 1000.0, std::abs(wanted[1]) / 1000.0});
        const double off = std::hypot((*pixel)[0] - wanted[0], (*pixel)[1] - wanted[1]) / scale;
        EXPECT_LE(off, tolerance(entry.path())) << table.corpus_file << ": " << ray[0] << " " << ray[1] << " " << ray[2];
        worst = std::max(worst, off);
      }
      EXPECT_GT(compared, 10) << table.corpus_file;
      ++tables;
    }
    EXPECT_GT(tables, 0) << format;
    std::cout << format << ": " << tables << " tables, worst " << worst << " px\n";
  }
}

}  // namespace

}  // namespace fca::matrix
