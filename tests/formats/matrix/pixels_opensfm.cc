// SPDX-License-Identifier: BSD-3-Clause
// OpenSfM's cameras by its camera_projections_functions.h and camera_distortions_functions.h (mapillary/OpenSfM@238744cd):
// lengths in units of the longer side, from the middle of the image.
#include "pixels_opensfm.h"

#include "opencv_lens.h"

#include <rapidjson/document.h>

namespace fca::matrix::opensfm {

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
  const RayToPixel lens = is_fisheye ? fisheye({number("k1"), number("k2"), number("k3"), number("k4")})
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
