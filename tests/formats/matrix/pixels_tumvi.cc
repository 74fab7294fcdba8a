// SPDX-License-Identifier: BSD-3-Clause
// TUM-VI's files: its camchains are Kalibr's (FORMATS.md section 2: "there is no separate schema"), its camera.txt is DSO's.
// Source for the latter: FORMATS.md section 2 and JakobEngel/dso, src/util/Undistort.cpp (readFromFile: relative values are
// scaled by the size and the centre shifted by half a pixel; distortCoordinates of UndistortFOV, UndistortRadTan,
// UndistortEquidistant, UndistortKB).
#include "pixels_tumvi.h"

#include "pixels_kalibr.h"

#include <map>
#include <sstream>

namespace fca::matrix::tumvi {

namespace {

using Lens = std::function<std::optional<Pixel>(const Ray&)>;

std::optional<Lens> lens_of(const std::string& kind, const std::vector<double>& d) {
  if (kind == "EquiDistant" || kind == "KannalaBrandt") {
    return [d](const Ray& p) -> std::optional<Pixel> {
      const double r = std::hypot(p[0], p[1]);
      if (r == 0.0) return p[2] > 0.0 ? std::optional(Pixel{0.0, 0.0}) : std::nullopt;
      const double theta = std::atan2(r, p[2]);
      const double t2 = theta * theta;
      const double t4 = t2 * t2;
      const double thetad = theta * (1.0 + d[0] * t2 + d[1] * t4 + d[2] * t4 * t2 + d[3] * t4 * t4);
      return Pixel{thetad / r * p[0], thetad / r * p[1]};
    };
  }
  if (kind == "RadTan") {
    return [d](const Ray& p) -> std::optional<Pixel> {
      if (p[2] <= 0.0) return std::nullopt;
      const double ix = p[0] / p[2];
      const double iy = p[1] / p[2];
      const double rho2 = ix * ix + iy * iy;
      const double radial = d[0] * rho2 + d[1] * rho2 * rho2;
      return Pixel{ix + ix * radial + 2.0 * d[2] * ix * iy + d[3] * (rho2 + 2.0 * ix * ix),
                   iy + iy * radial + 2.0 * d[3] * ix * iy + d[2] * (rho2 + 2.0 * iy * iy)};
    };
  }
  const double omega = kind == "FOV" ? d[0] : 0.0;
  return [omega](const Ray& p) -> std::optional<Pixel> {
    const double r = std::hypot(p[0], p[1]);
    if (omega == 0.0) {
      if (p[2] <= 0.0) return std::nullopt;
      return Pixel{p[0] / p[2], p[1] / p[2]};
    }
    if (r == 0.0) return p[2] > 0.0 ? std::optional(Pixel{0.0, 0.0}) : std::nullopt;
    const double distorted = std::atan2(2.0 * std::tan(omega / 2.0) * r, p[2]) / omega;
    return Pixel{distorted / r * p[0], distorted / r * p[1]};
  };
}

std::optional<PixelFormula> camera_txt(const std::string& bytes) {
  std::istringstream lines(bytes);
  std::string first;
  std::getline(lines, first);
  std::istringstream words(first);
  std::string kind;
  if (!first.empty() && std::isalpha(static_cast<unsigned char>(first.front())) != 0) words >> kind;
  std::vector<double> values;
  for (double value = 0.0; words >> value;) values.push_back(value);
  if (kind.empty()) kind = values.size() == 8 ? "RadTan" : "FOV";
  if (kind == "ATAN") kind = "FOV";
  const std::map<std::string, std::size_t> lengths = {
      {"EquiDistant", 8}, {"KannalaBrandt", 8}, {"RadTan", 8}, {"FOV", 5}, {"Pinhole", 4}};
  const auto length = lengths.find(kind);
  if (length == lengths.end() || values.size() < length->second) return std::nullopt;
  Size size;
  if (!(lines >> size.width >> size.height)) return std::nullopt;
  double fx = values[0];
  double fy = values[1];
  double cx = values[2];
  double cy = values[3];
  if (cx < 1.0 && cy < 1.0) {
    fx *= size.width;
    fy *= size.height;
    cx = cx * size.width - 0.5;
    cy = cy * size.height - 0.5;
  }
  const std::optional<Lens> lens = lens_of(kind, {values.begin() + 4, values.end()});
  if (!lens) return std::nullopt;
  PixelFormula formula;
  formula.size = size;
  formula.pixel = [lens = *lens, fx, fy, cx, cy](const Ray& p) -> std::optional<Pixel> {
    const std::optional<Pixel> m = lens(p);
    if (!m) return std::nullopt;
    return Pixel{fx * (*m)[0] + cx, fy * (*m)[1] + cy};
  };
  return formula;
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  if (std::optional<PixelFormula> chain = kalibr::camera(bytes, index)) return chain;
  return index == 0 ? camera_txt(bytes) : std::nullopt;
}

std::vector<Pose> relative_poses(const std::vector<std::string>& files) { return kalibr::relative_poses(files); }

}  // namespace fca::matrix::tumvi
