// SPDX-License-Identifier: BSD-3-Clause
// Kimera-VIO's CameraParams.yaml as its CameraParams.cpp reads it (MORE-FORMATS-2.md section 19), in OpenCV's formulas.
#include "pixels_kimera.h"

#include "sensor_lens.h"
#include "storage.h"

#include <algorithm>

namespace fca::matrix::kimera {

namespace {

/// T_body_camera
std::optional<Pose> pose_in_body(const std::string& bytes) {
  const cv::FileStorage storage = open_storage(bytes);
  if (!storage.isOpened() || !storage["camera_id"].isString() || !storage["T_BS"].isMap()) return std::nullopt;
  return pose_of(numbers(storage["T_BS"]["data"]));
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  const cv::FileStorage storage = open_storage(bytes);
  if (index > 0 || !storage.isOpened() || !storage["distortion_model"].isString()) return std::nullopt;
  const std::vector<double> k = numbers(storage["intrinsics"]);
  std::vector<double> d = numbers(storage["distortion_coefficients"]);
  const std::vector<double> size = numbers(storage["resolution"]);
  if (k.size() != 4 || d.size() < 4 || size.size() != 2) return std::nullopt;
  std::string model = storage["distortion_model"].string();
  std::ranges::transform(model, model.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (model == "none") d.clear();
  PixelFormula formula;
  formula.size = Size{static_cast<int>(size[0]), static_cast<int>(size[1])};
  formula.pixel = sensor_lens(k, d, model == "equidistant");
  return formula;
}

std::vector<Pose> relative_poses(const std::vector<std::string>& files) { return second_in_first(files, &pose_in_body); }

}  // namespace fca::matrix::kimera
