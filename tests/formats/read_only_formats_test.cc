// SPDX-License-Identifier: BSD-3-Clause
// Formats that are read only: their numbers against formulas that are written here, from the programs' sources and manuals.
#include "test_files.h"

#include <fca/code.h>
#include <fca/convert/ray_table.h>
#include <fca/formats/calibration.h>
#include <fca/formats/text/read_document.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace fca::test {
namespace {

using Formula = std::function<Pixel(const Ray& ray)>;

struct Outcome {
  std::optional<Calibration> calibration;
  Diagnostics diagnostics;

  [[nodiscard]] Code error() const {
    for (const Diagnostic& entry : diagnostics.entries()) {
      if (entry.severity == Severity::kError) return entry.facts.code;
    }
    return Code::kNone;
  }
  [[nodiscard]] const Camera& camera(const std::string& name) const {
    static const Camera kNone;
    const Camera* found = calibration ? calibration->rig.find_camera(name) : nullptr;
    EXPECT_NE(found, nullptr) << name;
    return found != nullptr ? *found : kNone;
  }
};

/// Detected and read.
Outcome read(const std::string& name, const std::string& bytes, const std::string& format) {
  Outcome outcome;
  std::optional<text::Document> document = text::parse_document({name, bytes}, outcome.diagnostics);
  if (!document) return outcome;
  const std::optional<DetectedFormat> detected = detect_format(*document, outcome.diagnostics);
  if (!detected) return outcome;
  EXPECT_EQ(detected->format->id, format);
  outcome.calibration = read_calibration({*std::move(document)}, detected->format, {}, outcome.diagnostics);
  return outcome;
}

/// Its model's pixels, or those of its table of rays, are the formula's.
void expect_pixels(const Camera& camera, const Formula& formula, double max_angle_deg) {
  int compared = 0;
  if (!camera.rays.empty()) {
    for (const Correspondence& entry : camera.rays) {
      const Pixel pixel = formula(entry.ray);
      EXPECT_NEAR(entry.pixel[0], pixel[0], 1e-9);
      EXPECT_NEAR(entry.pixel[1], pixel[1], 1e-9);
      ++compared;
    }
    EXPECT_GE(compared, 500);
    return;
  }
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < 6; ++j) {
      const double azimuth = 0.1 + 0.5 * i;
      const double angle = max_angle_deg * std::acos(-1.0) / 180.0 * j / 5.0;
      const Ray ray = {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)};
      const std::optional<Pixel> pixel = project(camera.model, ray);
      ASSERT_TRUE(pixel) << angle;
      EXPECT_NEAR((*pixel)[0], formula(ray)[0], 1e-9);
      EXPECT_NEAR((*pixel)[1], formula(ray)[1], 1e-9);
      ++compared;
    }
  }
}

// OpenSfM: lengths are shares of the longer side, from the middle of the image.
TEST(OpenSfm, PixelsAreThoseOfItsFormulas) {
  const std::string text = R"({
    "a camera": {"projection_type": "brown", "width": 1000, "height": 601, "focal_x": 0.8, "focal_y": 0.81,
                 "c_x": 0.01, "c_y": -0.02, "k1": -0.1, "k2": 0.02, "p1": 0.001, "p2": -0.002, "k3": 0.003},
    "plain": {"projection_type": "perspective", "width": 1000, "height": 601, "focal": 0.8, "k1": -1e-1, "k2": 0.02},
    "fish": {"projection_type": "fisheye_opencv", "width": 601, "height": 1000, "focal_x": 0.3, "focal_y": 0.31,
             "c_x": 0.0, "c_y": 0.0, "k1": 0.01, "k2": 0.002, "k3": 0.0, "k4": 0.0001},
    "fish62": {"projection_type": "fisheye62", "width": 1000, "height": 800, "focal_x": 0.3, "focal_y": 0.31,
             "k1": 0.01, "k2": 0.002, "k3": -0.001, "k5": 0.0002},
    "fish624": {"projection_type": "fisheye624", "width": 1000, "height": 800, "focal_x": 0.3, "focal_y": 0.31,
             "k1": 0.01, "k2": 0.002, "p1": 0.003, "p2": -0.002, "s0": 0.001, "s1": -0.0005, "s2": 0.002, "s3": 0.0001}})";
  const Outcome outcome = read("camera_models.json", text, "opensfm");
  ASSERT_TRUE(outcome.calibration);
  ASSERT_EQ(outcome.calibration->rig.cameras.size(), 5U);
  expect_pixels(
      outcome.camera("a camera"),
      [](const Ray& ray) {
        const double x = ray[0] / ray[2];
        const double y = ray[1] / ray[2];
        const double r2 = x * x + y * y;
        const double radial = 1.0 - 0.1 * r2 + 0.02 * r2 * r2 + 0.003 * r2 * r2 * r2;
        const double u = x * radial + 2.0 * 0.001 * x * y - 0.002 * (r2 + 2.0 * x * x);
        const double v = y * radial - 2.0 * 0.002 * x * y + 0.001 * (r2 + 2.0 * y * y);
        return Pixel{800.0 * u + 10.0 + 499.5, 810.0 * v - 20.0 + 300.0};
      },
      30.0);
  expect_pixels(
      outcome.camera("plain"),
      [](const Ray& ray) {
        const double x = ray[0] / ray[2];
        const double y = ray[1] / ray[2];
        const double r2 = x * x + y * y;
        const double radial = 1.0 - 0.1 * r2 + 0.02 * r2 * r2;
        return Pixel{800.0 * x * radial + 499.5, 800.0 * y * radial + 300.0};
      },
      30.0);
  const auto direction = [](const Ray& ray, std::size_t axis) {
    const double sine = std::hypot(ray[0], ray[1]);
    return sine > 0.0 ? ray[axis] / sine : 0.0;
  };
  const auto theta_of = [](const Ray& ray) { return std::atan2(std::hypot(ray[0], ray[1]), ray[2]); };
  expect_pixels(
      outcome.camera("fish"),
      [&](const Ray& ray) {
        const double t = theta_of(ray);
        const double r = t + 0.01 * std::pow(t, 3) + 0.002 * std::pow(t, 5) + 0.0001 * std::pow(t, 9);
        return Pixel{300.0 * r * direction(ray, 0) + 300.0, 310.0 * r * direction(ray, 1) + 499.5};
      },
      80.0);
  expect_pixels(
      outcome.camera("fish62"),
      [&](const Ray& ray) {
        const double t = theta_of(ray);
        const double r = t + 0.01 * std::pow(t, 3) + 0.002 * std::pow(t, 5) - 0.001 * std::pow(t, 7) + 0.0002 * std::pow(t, 11);
        return Pixel{300.0 * r * direction(ray, 0) + 499.5, 310.0 * r * direction(ray, 1) + 399.5};
      },
      80.0);
  EXPECT_TRUE(outcome.camera("fish62").rays.empty());
  EXPECT_FALSE(outcome.camera("fish624").rays.empty());
  expect_pixels(
      outcome.camera("fish624"),
      [&](const Ray& ray) {
        const double t = theta_of(ray);
        const double x = t * direction(ray, 0);
        const double y = t * direction(ray, 1);
        const double q = x * x + y * y;
        const double radial = 1.0 + 0.01 * q + 0.002 * q * q;
        const double u = x * radial + 2.0 * 0.003 * x * y - 0.002 * (q + 2.0 * x * x) + 0.001 * q - 0.0005 * q * q;
        const double v = y * radial - 2.0 * 0.002 * x * y + 0.003 * (q + 2.0 * y * y) + 0.002 * q + 0.0001 * q * q;
        return Pixel{300.0 * u + 499.5, 310.0 * v + 399.5};
      },
      0.0);
}

TEST(OpenSfm, ReadsAReconstructionAndRefusesPanoramas) {
  const std::string camera =
      R"("c": {"projection_type": "fisheye", "width": 100, "height": 80, "focal": 0.5, "k1": 0.0, "k2": 0.0})";
  const Outcome inside = read("reconstruction.json", "[{\"cameras\": {" + camera + "}, \"shots\": {}}]", "opensfm");
  ASSERT_TRUE(inside.calibration);
  EXPECT_EQ(parameter(inside.camera("c").model, "fx"), 50.0);
  const Outcome panorama =
      read("camera_models.json", R"({"p": {"projection_type": "spherical", "width": 100, "height": 50}})", "opensfm");
  EXPECT_FALSE(panorama.calibration);
  EXPECT_EQ(panorama.error(), Code::kTableUnknownWord);
}

/// Metashape's frame camera; k1 to k4, p1 to p4, b2.
Pixel metashape_frame(const Ray& ray, const std::array<double, 4>& k, const std::array<double, 4>& p, double b2) {
  const double x = ray[0] / ray[2];
  const double y = ray[1] / ray[2];
  const double r2 = x * x + y * y;
  const double radial = 1.0 + k[0] * r2 + k[1] * r2 * r2 + k[2] * std::pow(r2, 3) + k[3] * std::pow(r2, 4);
  const double growth = 1.0 + p[2] * r2 + p[3] * r2 * r2;
  const double u = x * radial + (p[0] * (r2 + 2.0 * x * x) + 2.0 * p[1] * x * y) * growth;
  const double v = y * radial + (p[1] * (r2 + 2.0 * y * y) + 2.0 * p[0] * x * y) * growth;
  return {500.0 + 3.0 + u * (700.0 + 2.0) + v * b2 - 0.5, 400.0 - 4.0 + v * 700.0 - 0.5};
}

TEST(Metashape, PixelsAreThoseOfItsFormulas) {
  const std::string head =
      "<?xml version=\"1.0\"?>\n<calibration>\n<projection>frame</projection>\n<width>1000</width>\n<height>800</height>\n"
      "<f>700</f><b1>2</b1><cx>3</cx><cy>-4</cy><k1>-0.1</k1><k2>0.02</k2><k3>-0.003</k3><p1>0.001</p1><p2>-0.002</p2>\n";
  const Outcome plain = read("lens.xml", head + "<date>2020</date></calibration>\n", "metashape");
  ASSERT_TRUE(plain.calibration);
  EXPECT_TRUE(plain.camera("cam0").rays.empty());
  expect_pixels(
      plain.camera("cam0"),
      [](const Ray& ray) {
        return metashape_frame(ray, {-0.1, 0.02, -0.003, 0.0}, {0.001, -0.002, 0.0, 0.0}, 0.0);
      },
      30.0);
  const Outcome more = read("lens.xml", head + "<k4>0.0004</k4><b2>0.5</b2><p3>0.1</p3></calibration>\n", "metashape");
  ASSERT_TRUE(more.calibration);
  EXPECT_FALSE(more.camera("cam0").rays.empty());
  expect_pixels(
      more.camera("cam0"),
      [](const Ray& ray) {
        return metashape_frame(ray, {-0.1, 0.02, -0.003, 0.0004}, {0.001, -0.002, 0.1, 0.0}, 0.5);
      },
      0.0);
}

TEST(Metashape, OfAProjectTheAdjustedCalibrationsCount) {
  const std::string sensor =
      "<sensor id=\"0\" label=\"left\" type=\"fisheye\"><resolution width=\"640\" height=\"480\"/>"
      "<calibration type=\"fisheye\" class=\"initial\"><f>200</f></calibration>"
      "<calibration type=\"fisheye\" class=\"adjusted\"><resolution width=\"640\" "
      "height=\"480\"/><f>210</f><k1>0.01</k1></calibration></sensor>"
      "<sensor id=\"1\" label=\"left\" type=\"frame\"><resolution width=\"640\" height=\"480\"/><calibration type=\"frame\" "
      "class=\"initial\"><f>300</f></calibration></sensor>"
      "<sensor id=\"2\" label=\"none\" type=\"frame\"><resolution width=\"640\" height=\"480\"/></sensor>";
  const Outcome outcome =
      read("cameras.xml",
           "<document version=\"1.5.0\"><chunk label=\"c\"><sensors next_id=\"3\">" + sensor + "</sensors></chunk></document>",
           "metashape");
  ASSERT_TRUE(outcome.calibration);
  ASSERT_EQ(outcome.calibration->rig.cameras.size(), 2U);
  const Camera& left = outcome.camera("left");
  EXPECT_EQ(model_info(left.model).id, "kb4");
  EXPECT_EQ(parameter(left.model, "fx"), 210.0);
  EXPECT_EQ(parameter(left.model, "cx"), 319.5);
  EXPECT_EQ(left.image_size, (ImageSize{640, 480}));
  EXPECT_EQ(parameter(outcome.camera("sensor1").model, "fx"), 300.0) << "a name that is taken";
}

TEST(Mast3r, TakesOpenCvsLengths) {
  const std::string head = "width: 640\nheight: 480\ncalibration: [500.0, 501.0, 320.0, 240.0";
  struct Row {
    std::string more;
    std::string model;
  };
  for (const Row& row :
       {Row{"", "pinhole"}, Row{", 0.1, -0.2, 0.001, 0.002", "radtan"}, Row{", 0.1, -0.2, 0.001, 0.002, 0.05", "radtan"},
        Row{", 0.1, -0.2, 0.001, 0.002, 0.05, 0.1, 0.2, 0.3", "rational"}}) {
    const Outcome outcome = read("intrinsics.yaml", head + row.more + "]\n", "mast3r");
    ASSERT_TRUE(outcome.calibration) << row.more;
    EXPECT_EQ(model_info(outcome.camera("cam0").model).id, row.model);
    EXPECT_EQ(parameter(outcome.camera("cam0").model, "fy"), 501.0);
  }
  const Outcome wrong = read("intrinsics.yaml", head + ", 0.1, 0.2]\n", "mast3r");
  EXPECT_EQ(wrong.error(), Code::kTableCoefficientCount);
}

TEST(Ncore, TwoConventionsOfPixelsAndPosesInTheVehicle) {
  const std::string tail = R"("resolution": [1000, 800], "shutter_type": "1",
      "T_sensor_rig": [[0.0, 0.0, 1.0, 2.0], [-1.0, 0.0, 0.0, 0.5], [0.0, -1.0, 0.0, 1.5], [0.0, 0.0, 0.0, 1.0]])";
  const std::string pinhole = R"("p": {"camera_model_type": "opencv-pinhole", )" + tail + R"(, "intrinsics": {
      "principal_point": [500.0, 400.0], "focal_length": [700.0, 701.0], "radial_coeffs": [0.1, 0.0, 0.0, 0.0, 0.0, 0.0],
      "tangential_coeffs": [0.001, 0.002], "thin_prism_coeffs": [0.0, 0.0, 0.0, 0.0]}})";
  const auto ftheta = [&tail](const std::string& id, const std::string& reference) {
    return "\"" + id + R"(": {"camera_model_type": "ftheta", )" + tail + R"(, "intrinsics": {
      "principal_point": [500.0, 400.0], "angle_to_pixeldist_poly": [0.0, 600.0, -10.0, 5.0, 0.0, 1.0],
      "pixeldist_to_angle_poly": [0.0, 0.0016, 1e-8, 0.0, 0.0, 0.0], "reference_poly": )" +
           reference + R"(, "max_angle_rad": 1.2, "linear_cde": [0.99, 0.001, 0.002]}})";
  };
  const Outcome outcome =
      read("rig.json", "{" + pinhole + ", " + ftheta("forwards", "2") + ", " + ftheta("backwards", "\"1\"") + "}", "ncore");
  ASSERT_TRUE(outcome.calibration);
  const Camera& plain = outcome.camera("p");
  EXPECT_EQ(model_info(plain.model).id, "radtan");
  EXPECT_EQ(parameter(plain.model, "cx"), 499.5);
  EXPECT_EQ(parameter(plain.model, "p2"), 0.002);
  // The camera looks ahead, along the vehicle's x, and is 2 m in front of its origin.
  const std::optional<Transform> T = outcome.calibration->rig.resolve("vehicle", "p");
  ASSERT_TRUE(T);
  EXPECT_EQ((*T)(0, 3), 2.0);
  EXPECT_EQ((*T)(0, 2), 1.0);

  const auto linear = [](const Ray& ray, double radius) {
    const double sine = std::hypot(ray[0], ray[1]);
    const double x = sine > 0.0 ? radius * ray[0] / sine : 0.0;
    const double y = sine > 0.0 ? radius * ray[1] / sine : 0.0;
    return Pixel{500.0 + 0.99 * x + 0.001 * y, 400.0 + 0.002 * x + y};
  };
  const auto angle_of = [](const Ray& ray) { return std::atan2(std::hypot(ray[0], ray[1]), ray[2]); };
  EXPECT_EQ(model_info(outcome.camera("forwards").model).id, "ftheta");
  expect_pixels(
      outcome.camera("forwards"),
      [&](const Ray& ray) {
        const double t = angle_of(ray);
        return linear(ray, 600.0 * t - 10.0 * t * t + 5.0 * std::pow(t, 3) + std::pow(t, 5));
      },
      68.0);
  // t = 0.0016 r + 1e-8 r^2, solved for r.
  expect_pixels(
      outcome.camera("backwards"),
      [&](const Ray& ray) {
        const double t = angle_of(ray);
        return linear(ray, 2.0 * t / (0.0016 + std::sqrt(0.0016 * 0.0016 + 4e-8 * t)));
      },
      0.0);
}

// As pyrealsense2's structures are saved: rotations column by column, points of the first stream to the second.
TEST(Realsense, StructuresOfPythonInJson) {
  const Outcome outcome = read("device.json", R"({
    "depth": {"width": 640, "height": 480, "fx": 380.5, "fy": 381.5, "ppx": 320.25, "ppy": 240.75,
              "model": "distortion.brown_conrady", "coeffs": [0.0, 0.0, 0.0, 0.0, 0.0]},
    "color": {"width": 640, "height": 480, "fx": 605.5, "fy": 604.5, "ppx": 325.25, "ppy": 241.75,
              "model": 4, "coeffs": [0.1, -0.2, 0.001, 0.002, 0.05]},
    "depth_to_color": {"rotation": [0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0], "translation": [0.015, 0.001, 0.002]}})",
                               "realsense");
  ASSERT_TRUE(outcome.calibration);
  EXPECT_EQ(model_info(outcome.camera("depth").model).id, "pinhole");
  EXPECT_EQ(parameter(outcome.camera("depth").model, "cx"), 320.25);
  EXPECT_EQ(model_info(outcome.camera("color").model).id, "radtan");
  EXPECT_EQ(parameter(outcome.camera("color").model, "p2"), 0.002);
  const std::optional<Transform> T = outcome.calibration->rig.resolve("color", "depth");
  ASSERT_TRUE(T);
  EXPECT_EQ((*T)(1, 0), 1.0);
  EXPECT_EQ((*T)(0, 1), -1.0);
  EXPECT_EQ((*T)(0, 3), 0.015);
}

/// Of an f-theta camera of 2000 x 1600 pixels whose polynomial from angle to distance is 500 angle.
Outcome equidistant_ncore(const std::string& to_angle, const std::string& reference) {
  return read("rig.json",
              R"({"cam": {"camera_model_type": "ftheta", "resolution": [2000, 1600], "intrinsics": {
      "principal_point": [999.5, 799.5], "angle_to_pixeldist_poly": [0.0, 500.0], "pixeldist_to_angle_poly": )" +
                  to_angle + R"(, "reference_poly": ")" + reference + R"(", "max_angle_rad": 2.0}}})",
              "ncore");
}

// 0.0020002 px of angle times 500 is 1.0001: after 1,000 px, or 2.0002 rad, 0.1 px.
TEST(Ncore, TheInverseIsBoundByWhatItIsOff) {
  const Outcome near = equidistant_ncore("[0.0, 0.0020002]", "2");
  ASSERT_TRUE(near.calibration);
  EXPECT_TRUE(near.diagnostics.entries().empty());
  const ExtraField* inverse = near.calibration->rig.find_extra_field("cam", "pixeldist_to_angle_poly");
  ASSERT_NE(inverse, nullptr);
  ASSERT_EQ(inverse->said.code, Code::kNcoreInverse);
  const double bound = std::get<double>(inverse->said.arguments.front().value);
  EXPECT_GE(bound, 0.1 * (1.0 - 1e-3));
  EXPECT_LE(bound, 0.12);

  const Outcome far = equidistant_ncore("[0.0, 0.0021]", "2");
  ASSERT_EQ(far.diagnostics.entries().size(), 1U);
  EXPECT_EQ(far.diagnostics.entries().front().facts.code, Code::kNcoreInverseFarOff);
}

// The polynomial from distance to angle says where every pixel looks, whatever ends the lens in the program.
TEST(Ncore, ATableReachesTheCorners) {
  const Outcome outcome = equidistant_ncore("[0.0, 0.0022]", "1");
  ASSERT_TRUE(outcome.calibration);
  const Camera& camera = outcome.camera("cam");
  ASSERT_FALSE(camera.rays.empty());
  const auto furthest = std::ranges::max_element(camera.rays, {}, [](const Correspondence& entry) {
    return std::abs(entry.pixel[0] - 999.5) + std::abs(entry.pixel[1] - 799.5);
  });
  EXPECT_GE(std::abs(furthest->pixel[0] - 999.5), 0.97 * 1000.0);
  EXPECT_GE(std::abs(furthest->pixel[1] - 799.5), 0.97 * 800.0);
  EXPECT_GE(angle_from_axis(furthest->ray), 2.2);
}

TEST(Kitti, RecordedCamerasAndTheirPoses) {
  const std::string text =
      "calib_time: 09-Jan-2012 13:57:47\ncorner_dist: 9.950000e-02\n"
      "S_00: 1.392000e+03 5.120000e+02\nK_00: 984.2 0 690.0 0 980.8 233.1 0 0 1\nD_00: -0.37 0.2 0.001 0.002 -0.07\n"
      "R_00: 1 0 0 0 1 0 0 0 1\nT_00: 0 0 0\nP_rect_00: 721.5 0 609.6 0 0 721.5 172.9 0 0 0 1 0\n"
      "S_01: 1392 512\nK_01: 989.5 0 702.0 0 987.9 245.6 0 0 1\nD_01: -0.36 0.19 0.0005 -0.0004 -0.06\n"
      "R_01: 1 0 0 0 1 0 0 0 1\nT_01: -0.54 0.005 -0.01\n";
  const Outcome outcome = read("calib_cam_to_cam.txt", text, "kitti");
  ASSERT_TRUE(outcome.calibration);
  const Camera& left = outcome.camera("image_00");
  EXPECT_EQ(left.image_size, (ImageSize{1392, 512}));
  EXPECT_EQ(parameter(left.model, "k3"), -0.07);
  EXPECT_EQ(parameter(left.model, "p1"), 0.001);
  // The right camera stands to the right of the left one: a point in front of it is further left in its frame.
  const std::optional<Transform> T = outcome.calibration->rig.resolve("image_01", "image_00");
  ASSERT_TRUE(T);
  EXPECT_EQ((*T)(0, 3), -0.54);
}

TEST(Kitti, RectifiedCamerasOfOdometry) {
  const std::string text =
      "P0: 718.856 0 607.1928 0 0 718.856 185.2157 0 0 0 1 0\n"
      "P1: 718.856 0 607.1928 -386.1448 0 718.856 185.2157 0 0 0 1 0\nTr: 0 -1 0 0 0 0 -1 0 1 0 0 0\n";
  const Outcome outcome = read("calib.txt", text, "kitti");
  ASSERT_TRUE(outcome.calibration);
  EXPECT_EQ(model_info(outcome.camera("P1").model).id, "pinhole");
  const std::optional<Transform> T = outcome.calibration->rig.resolve("P1", "P0");
  ASSERT_TRUE(T);
  EXPECT_NEAR((*T)(0, 3), -386.1448 / 718.856, 1e-12);
  EXPECT_EQ(read("calib.txt", "P0: 1 2 3\nP1: 718.856 0 607.1928 -386.1448 0 718.856 185.2157 0 0 0 1 0\n", "kitti").error(),
            Code::kNumbersWanted);
}

TEST(Kitti, RectifiedCamerasWithoutTheRecordedOnes) {
  const std::string text =
      "S_rect_00: 1.408000e+03 3.760000e+02\nR_rect_00: 1 0 0 0 1 0 0 0 1\n"
      "P_rect_00: 552.55 0 682.05 0 0 552.55 238.77 0 0 0 1 0\nP_rect_01: 552.55 0 682.05 -328.3 0 552.55 238.77 0 0 0 1 0\n";
  const Outcome outcome = read("perspective.txt", text, "kitti");
  ASSERT_TRUE(outcome.calibration);
  EXPECT_EQ(outcome.camera("image_00").image_size, (ImageSize{1408, 376}));
  EXPECT_EQ(outcome.camera("image_01").image_size, std::nullopt);
  const std::optional<Transform> T = outcome.calibration->rig.resolve("image_01", "image_00");
  ASSERT_TRUE(T);
  EXPECT_NEAR((*T)(0, 3), -328.3 / 552.55, 1e-12);
}

}  // namespace
}  // namespace fca::test
