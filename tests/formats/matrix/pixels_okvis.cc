// SPDX-License-Identifier: BSD-3-Clause
// OKVIS2's configuration as its ViParametersReader.cpp reads it (MORE-FORMATS.md section 8), in OpenCV's formulas; EUCM after
// Khomutenko, Garcia, Martinet 2016.
#include "pixels_okvis.h"

#include "sensor_lens.h"
#include "storage.h"

namespace fca::matrix::okvis {

namespace {

cv::FileNode entry(const cv::FileStorage& storage, std::size_t index) {
  if (!storage.isOpened() || !storage["cameras"].isSeq() || index >= storage["cameras"].size()) return {};
  return storage["cameras"][static_cast<int>(index)];
}

RayToPixel eucm(const std::vector<double>& k, double alpha, double beta) {
  return [=](const Ray& ray) -> std::optional<Pixel> {
    const double rho = std::sqrt(beta * (ray[0] * ray[0] + ray[1] * ray[1]) + ray[2] * ray[2]);
    const double w = alpha <= 0.5 ? alpha / (1.0 - alpha) : (1.0 - alpha) / alpha;
    if (ray[2] <= -w * rho) return std::nullopt;
    const double down = alpha * rho + (1.0 - alpha) * ray[2];
    return Pixel{k[0] * ray[0] / down + k[2], k[1] * ray[1] / down + k[3]};
  };
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  const cv::FileStorage storage = open_storage(bytes);
  const cv::FileNode node = entry(storage, index);
  if (!node.isMap()) return std::nullopt;
  const std::vector<double> focal = numbers(node["focal_length"]);
  const std::vector<double> centre = numbers(node["principal_point"]);
  const std::vector<double> size = numbers(node["image_dimension"]);
  if (focal.size() != 2 || centre.size() != 2 || size.size() != 2) return std::nullopt;
  const std::vector<double> k = {focal[0], focal[1], centre[0], centre[1]};
  PixelFormula formula;
  formula.size = Size{static_cast<int>(size[0]), static_cast<int>(size[1])};
  if (node["cam_model"].isString() && node["cam_model"].string() == "eucm") {
    const std::vector<double> shape = numbers(node["eucm_parameters"]);
    if (shape.size() != 2) return std::nullopt;
    formula.pixel = eucm(k, shape[0], shape[1]);
  } else {
    formula.pixel = sensor_lens(k, numbers(node["distortion_coefficients"]), node["distortion_type"].string() == "equidistant");
  }
  return formula;
}

std::vector<Pose> relative_poses(const std::vector<std::string>& files) {
  for (const std::string& bytes : files) {
    const cv::FileStorage storage = open_storage(bytes);
    std::vector<Pose> in_imu;
    for (std::size_t i = 0; i < 2; ++i) {
      const cv::FileNode node = entry(storage, i);
      if (!node.isMap()) continue;
      if (const std::optional<Pose> pose = pose_of(numbers(node["T_SC"]))) in_imu.push_back(*pose);
    }
    if (in_imu.size() == 2) return {inverse(in_imu[1]) * in_imu[0]};
  }
  return {};
}

}  // namespace fca::matrix::okvis
