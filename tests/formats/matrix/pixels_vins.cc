// SPDX-License-Identifier: BSD-3-Clause
// camodocal's camera files as VINS-Fusion computes with them (MORE-FORMATS.md section 3): PINHOLE and PINHOLE_FULL after Brown
// with OpenCV's names, MEI after Mei and Rives 2007, KANNALA_BRANDT with k2 .. k5 behind theta, scaramuzza after Scaramuzza
// 2006 with x along the columns: pixel = [ac ad; ae 1] (x, y) + (cx, cy), z(rho) of poly_parameters to the back.
#include "pixels_vins.h"

#include "storage.h"

#include <map>

namespace fca::matrix::vins {

namespace {

using Values = std::map<std::string, double>;

/// The numbers of a section.
Values section(const cv::FileStorage& file, const std::string& name) {
  Values values;
  const cv::FileNode node = file[name];
  if (!node.isMap()) return values;
  for (const cv::FileNode& number : node) values[number.name()] = matrix::number(number);
  return values;
}

double at(const std::vector<double>& coefficients, double x) {
  double result = 0.0;
  for (std::size_t i = coefficients.size(); i-- > 0;) result = result * x + coefficients[i];
  return result;
}

std::vector<double> polynomial(Values values, std::size_t count) {
  std::vector<double> result;
  for (std::size_t i = 0; i < count; ++i) result.push_back(values["p" + std::to_string(i)]);
  return result;
}

/// On the plane of focal length 1; nothing behind a pinhole, or behind the pole of a mirror.
std::optional<Pixel> on_plane(const std::string& type, Values d, double xi, const Ray& p) {
  const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
  double depth = p[2];
  if (type == "MEI") {
    depth += xi * length;
    // The image ends where rays fold back (xi > 1), or at the pole.
    if (p[2] <= -length * (xi > 1.0 ? 1.0 / xi : xi)) return std::nullopt;
  } else if (p[2] <= 0.0) {
    return std::nullopt;
  }
  const double x = p[0] / depth;
  const double y = p[1] / depth;
  const double s = x * x + y * y;
  const double radial = (1.0 + d["k1"] * s + d["k2"] * s * s + (type == "PINHOLE_FULL" ? d["k3"] * s * s * s : 0.0)) /
                        (type == "PINHOLE_FULL" ? 1.0 + d["k4"] * s + d["k5"] * s * s + d["k6"] * s * s * s : 1.0);
  return Pixel{x * radial + 2.0 * d["p1"] * x * y + d["p2"] * (s + 2.0 * x * x),
               y * radial + d["p1"] * (s + 2.0 * y * y) + 2.0 * d["p2"] * x * y};
}

/// scaramuzza, by the direct polynomial; its inverse is what the program projects with.
struct Ocam {
  std::vector<double> direct;
  std::vector<double> inverse;
  Values affine;

  Pixel pixel_at(double x, double y) const {
    return {affine.at("ac") * x + affine.at("ad") * y + affine.at("cx"), affine.at("ae") * x + y + affine.at("cy")};
  }
  double angle_at(double rho) const { return std::atan2(rho, -at(direct, rho)); }
  std::optional<double> radius_of(double angle, double limit) const {
    const double step = limit / 512.0;
    for (double rho = 0.0; rho < limit; rho += step) {
      const double ahead = angle_at(rho + step);
      if (ahead < angle_at(rho)) return std::nullopt;
      if (ahead < angle) continue;
      double low = rho;
      double high = rho + step;
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (angle_at(middle) < angle ? low : high) = middle;
      }
      return 0.5 * (low + high);
    }
    return std::nullopt;
  }
};

void add_scaramuzza(const cv::FileStorage& file, PixelFormula& formula) {
  const Ocam lens = {polynomial(section(file, "poly_parameters"), 5), polynomial(section(file, "inv_poly_parameters"), 20),
                     section(file, "affine_parameters")};
  const Size size = formula.size.value_or(Size{1000, 1000});
  const double limit = 1.5 * std::hypot(size.width, size.height);
  formula.pixel = [lens, limit](const Ray& p) -> std::optional<Pixel> {
    const double r = std::hypot(p[0], p[1]);
    if (r == 0.0) return p[2] > 0.0 ? std::optional(lens.pixel_at(0.0, 0.0)) : std::nullopt;
    const std::optional<double> rho = lens.radius_of(std::atan2(r, p[2]), limit);
    if (!rho) return std::nullopt;
    return lens.pixel_at(*rho * p[0] / r, *rho * p[1] / r);
  };
  formula.stored_approximation = [lens](const Ray& p) -> std::optional<Pixel> {
    const double r = std::hypot(p[0], p[1]);
    if (r == 0.0) return std::nullopt;  // 0 / 0
    const double rho = at(lens.inverse, std::atan2(-p[2], r));
    return lens.pixel_at(rho * p[0] / r, rho * p[1] / r);
  };
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  const cv::FileStorage file = open_storage(bytes);
  if (!file.isOpened() || index > 0 || !file["model_type"].isString()) return std::nullopt;
  const std::string type = file["model_type"].string();
  PixelFormula formula;
  const int width = static_cast<int>(number(file["image_width"]));
  const int height = static_cast<int>(number(file["image_height"]));
  if (width > 0 && height > 0) formula.size = Size{width, height};
  if (type == "scaramuzza") {
    add_scaramuzza(file, formula);
    return formula;
  }
  Values linear = section(file, "projection_parameters");
  const auto with = [&](const std::string& fx, const std::string& fy, const std::string& cx, const std::string& cy) {
    return std::array{linear[fx], linear[fy], linear[cx], linear[cy]};
  };
  std::array<double, 4> k{};
  if (type == "KANNALA_BRANDT") {
    k = with("mu", "mv", "u0", "v0");
    formula.pixel = [k, linear](const Ray& p) -> std::optional<Pixel> {
      const double r = std::hypot(p[0], p[1]);
      if (r == 0.0) return p[2] > 0.0 ? std::optional(Pixel{k[2], k[3]}) : std::nullopt;
      const double t = std::atan2(r, p[2]);
      const double radius = t + linear.at("k2") * std::pow(t, 3) + linear.at("k3") * std::pow(t, 5) +
                            linear.at("k4") * std::pow(t, 7) + linear.at("k5") * std::pow(t, 9);
      return Pixel{k[0] * radius * p[0] / r + k[2], k[1] * radius * p[1] / r + k[3]};
    };
    return formula;
  }
  if (type != "PINHOLE" && type != "PINHOLE_FULL" && type != "MEI") return std::nullopt;
  k = type == "MEI" ? with("gamma1", "gamma2", "u0", "v0") : with("fx", "fy", "cx", "cy");
  const Values distortion = section(file, "distortion_parameters");
  const double xi = section(file, "mirror_parameters")["xi"];
  formula.pixel = [type, k, distortion, xi](const Ray& p) -> std::optional<Pixel> {
    const std::optional<Pixel> m = on_plane(type, distortion, xi, p);
    if (!m) return std::nullopt;
    return Pixel{k[0] * (*m)[0] + k[2], k[1] * (*m)[1] + k[3]};
  };
  return formula;
}

/// A camera file has no place for poses.
std::vector<Pose> relative_poses(const std::vector<std::string>&) { return {}; }

}  // namespace fca::matrix::vins
