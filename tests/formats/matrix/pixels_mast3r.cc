// SPDX-License-Identifier: BSD-3-Clause
// MASt3R-SLAM's intrinsics.yaml as its dataloader.py computes it: cv::initUndistortRectifyMap's coefficients after fx fy cx
// cy.
#include "pixels_mast3r.h"

#include "opencv_lens.h"

#include <yaml-cpp/yaml.h>

namespace fca::matrix::mast3r {

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  if (index > 0) return std::nullopt;
  const YAML::Node root = YAML::Load(bytes);
  const auto list = root["calibration"].as<std::vector<double>>();
  PixelFormula formula;
  formula.pixel = in_image(pinhole({list.begin() + 4, list.end()}), list[0], list[1], list[2], list[3]);
  formula.size = Size{root["width"].as<int>(), root["height"].as<int>()};
  return formula;
}

std::vector<Pose> relative_poses(const std::vector<std::string>& /*files*/) { return {}; }

}  // namespace fca::matrix::mast3r
