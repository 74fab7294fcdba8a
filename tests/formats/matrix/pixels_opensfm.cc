// SPDX-License-Identifier: BSD-3-Clause
// OpenSfM's cameras by its camera_projections_functions.h and camera_distortions_functions.h (mapillary/OpenSfM@238744cd):
// lengths in units of the longer side, from the middle of the image.
#include "pixels_opensfm.h"

#include "opencv_lens.h"

#include <rapidjson/document.h>

#include <cmath>

namespace fca::matrix::opensfm {

namespace {

/// theta (1 + k1 theta^2 + ... + k6 theta^12)
RayToPixel equidistant(const std::vector<double>& k) {
  return [k](const Ray& ray) -> std::optional<Pixel> {
    const double r = std::hypot(ray[0], ray[1]);
    if (r == 0.0) return ray[2] > 0.0 ? std::optional(Pixel{0.0, 0.0}) : std::nullopt;
    const double theta = std::atan2(r, ray[2]);
    double bent = 1.0;
    for (std::size_t i = 0; i < k.size(); ++i) bent += k[i] * std::pow(theta, 2.0 * static_cast<double>(i) + 2.0);
    return Pixel{theta * bent * ray[0] / r, theta * bent * ray[1] / r};
  };
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  rapidjson::Document document;
  document.Parse<rapidjson::kParseFullPrecisionFlag>(bytes.c_str(), bytes.size());
  if (document.HasParseError() || index >= document.MemberCount()) return std::nullopt;
  const rapidjson::Value& in = (document.MemberBegin() + static_cast<std::ptrdiff_t>(index))->value;
  const std::string type = in["projection_type"].GetString();
  const auto number = [&in](const char* key) { return in.HasMember(key) ? in[key].GetDouble() : 0.0; };
  const Size size = {in["width"].GetInt(), in["height"].GetInt()};
  const double side = std::max(size.width, size.height);
  const bool is_fisheye = type.starts_with("fisheye");
  const RayToPixel lens =
      is_fisheye ? equidistant({number("k1"), number("k2"), number("k3"), number("k4"), number("k5"), number("k6")})
                 : pinhole({number("k1"), number("k2"), number("p1"), number("p2"), number("k3")});
  const double fx = in.HasMember("focal") ? number("focal") : number("focal_x");
  const double fy = in.HasMember("focal") ? number("focal") : number("focal_y");
  PixelFormula formula;
  formula.pixel = in_image(lens, fx * side, fy * side, number("c_x") * side + (size.width - 1) / 2.0,
                           number("c_y") * side + (size.height - 1) / 2.0);
  formula.size = size;
  return formula;
}

std::vector<Pose> relative_poses(const std::vector<std::string>& /*files*/) { return {}; }

}  // namespace fca::matrix::opensfm
