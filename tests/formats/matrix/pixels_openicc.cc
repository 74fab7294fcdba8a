// SPDX-License-Identifier: BSD-3-Clause
// OpenImuCameraCalibrator's lens as its read_camera_calibration.cc and Theia's camera models compute it (MORE-FORMATS-2.md
// section 21): fy is focal_length * aspect_ratio; the division model counts the radius in pixels.
#include "pixels_openicc.h"

#include "opencv_lens.h"

#include <rapidjson/document.h>

namespace fca::matrix::openicc {

namespace {

/// Solved for the distorted radius: r_u = r_d / (1 + k r_d^2).
std::optional<Pixel> divided(double u, double v, double k) {
  const double r = std::hypot(u, v);
  if (r == 0.0 || k == 0.0) return Pixel{u, v};
  const double root = 1.0 - 4.0 * k * r * r;
  if (root < 0.0) return std::nullopt;
  const double distorted = (1.0 - std::sqrt(root)) / (2.0 * k * r);
  return Pixel{u / r * distorted, v / r * distorted};
}

std::optional<Pixel> on_sphere(double alpha, double xi, const Ray& p) {
  const double r2 = p[0] * p[0] + p[1] * p[1];
  const double d1 = std::sqrt(r2 + p[2] * p[2]);
  const double shifted = xi * d1 + p[2];
  const double below = alpha * std::sqrt(r2 + shifted * shifted) + (1.0 - alpha) * shifted;
  const double w1 = alpha > 0.5 ? (1.0 - alpha) / alpha : alpha / (1.0 - alpha);
  if (p[2] <= -(w1 + xi) / std::sqrt(2.0 * w1 * xi + xi * xi + 1.0) * d1) return std::nullopt;
  return Pixel{p[0] / below, p[1] / below};
}

std::optional<Pixel> on_ellipsoid(double alpha, double beta, const Ray& p) {
  const double rho = std::sqrt(beta * (p[0] * p[0] + p[1] * p[1]) + p[2] * p[2]);
  const double w = alpha > 0.5 ? (1.0 - alpha) / alpha : alpha / (1.0 - alpha);
  if (p[2] <= -w * rho) return std::nullopt;
  const double below = alpha * rho + (1.0 - alpha) * p[2];
  return Pixel{p[0] / below, p[1] / below};
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  rapidjson::Document document;
  document.Parse<rapidjson::kParseFullPrecisionFlag>(bytes.c_str(), bytes.size());
  if (index > 0 || document.HasParseError() || !document.HasMember("intrinsics")) return std::nullopt;
  const rapidjson::Value& in = document["intrinsics"];
  const std::string type = document["intrinsic_type"].GetString();
  const auto number = [&in](const char* key, const char* otherwise = "") {
    return in.HasMember(key) ? in[key].GetDouble() : in.HasMember(otherwise) ? in[otherwise].GetDouble() : 0.0;
  };
  const double fx = number("focal_length", "fx");
  const double fy = in.HasMember("fy") ? number("fy") : fx * number("aspect_ratio");
  const double cx = number("principal_pt_x", "cx");
  const double cy = number("principal_pt_y", "cy");
  RayToPixel lens = pinhole({number("radial_distortion_1", "k1"), number("radial_distortion_2", "k2"),
                             number("tangential_distortion_1", "p1"), number("tangential_distortion_2", "p2"),
                             number("radial_distortion_3", "k3")});
  if (type == "FISHEYE") {
    lens = fisheye({number("radial_distortion_1"), number("radial_distortion_2"), number("radial_distortion_3"),
                    number("radial_distortion_4")});
  } else if (type == "DOUBLE_SPHERE") {
    lens = [alpha = number("alpha"), xi = number("xi")](const Ray& ray) { return on_sphere(alpha, xi, ray); };
  } else if (type == "EXTENDED_UNIFIED") {
    lens = [alpha = number("alpha"), beta = number("beta")](const Ray& ray) { return on_ellipsoid(alpha, beta, ray); };
  }
  PixelFormula formula;
  formula.pixel = [lens = in_image(lens, fx, fy, cx, cy), cy, fy, skew = number("skew")](const Ray& ray) {
    std::optional<Pixel> pixel = lens(ray);
    if (pixel) (*pixel)[0] += skew * ((*pixel)[1] - cy) / fy;
    return pixel;
  };
  if (type == "DIVISION_UNDISTORTION") {
    formula.pixel = [fx, fy, cx, cy, k = number("div_undist_distortion")](const Ray& ray) -> std::optional<Pixel> {
      if (!(ray[2] > 0.0)) return std::nullopt;
      const std::optional<Pixel> m = divided(fx * ray[0] / ray[2], fy * ray[1] / ray[2], k);
      return m ? std::optional(Pixel{(*m)[0] + cx, (*m)[1] + cy}) : std::nullopt;
    };
  }
  formula.size = Size{document["image_width"].GetInt(), document["image_height"].GetInt()};
  return formula;
}

std::vector<Pose> relative_poses(const std::vector<std::string>& /*files*/) { return {}; }

}  // namespace fca::matrix::openicc
