// SPDX-License-Identifier: BSD-3-Clause
// OpenVINS' kalibr_imucam_chain.yaml as ov_core's CamEqui.h and CamRadtan.h compute with it (MORE-FORMATS.md section 4), in
// double, and past 90 deg, where the program itself has no features. camera_model is not read: any four intrinsics are fx fy cx
// cy, any distortion_model but equidistant is radtan.
#include "pixels_openvins.h"

#include "storage.h"

namespace fca::matrix::openvins {

namespace {

cv::FileNode camera_node(const cv::FileStorage& storage, std::size_t index) {
  return storage.isOpened() ? storage["cam" + std::to_string(index)] : cv::FileNode();
}

/// T_imu_cam
std::optional<Pose> pose_in_imu(const cv::FileStorage& storage, std::size_t index) {
  const cv::FileNode camera = camera_node(storage, index);
  if (!camera.isMap()) return std::nullopt;
  if (const std::optional<Pose> stated = pose_of(numbers(camera["T_imu_cam"]))) return stated;
  const std::optional<Pose> other = pose_of(numbers(camera["T_cam_imu"]));
  return other ? std::optional(inverse(*other)) : std::nullopt;
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  const cv::FileStorage storage = open_storage(bytes);
  const cv::FileNode node = camera_node(storage, index);
  if (!node.isMap()) return std::nullopt;
  const std::vector<double> k = numbers(node["intrinsics"]);
  const std::vector<double> d = numbers(node["distortion_coeffs"]);
  const std::vector<double> size = numbers(node["resolution"]);
  if (k.size() < 4 || d.size() < 4 || size.size() != 2 || !node["distortion_model"].isString()) return std::nullopt;
  const bool equidistant = node["distortion_model"].string() == "equidistant";
  PixelFormula formula;
  formula.size = Size{static_cast<int>(size[0]), static_cast<int>(size[1])};
  formula.pixel = [k, d, equidistant](const Ray& ray) -> std::optional<Pixel> {
    const auto to_pixel = [&k](double x, double y) { return Pixel{k[0] * x + k[2], k[1] * y + k[3]}; };
    if (equidistant) {
      const double r = std::hypot(ray[0], ray[1]);
      if (r == 0.0) return ray[2] > 0.0 ? std::optional(Pixel{k[2], k[3]}) : std::nullopt;
      const double t = std::atan2(r, ray[2]);
      const double bent = t + d[0] * std::pow(t, 3) + d[1] * std::pow(t, 5) + d[2] * std::pow(t, 7) + d[3] * std::pow(t, 9);
      return to_pixel(bent * ray[0] / r, bent * ray[1] / r);
    }
    if (!(ray[2] > 0.0)) return std::nullopt;
    const double x = ray[0] / ray[2];
    const double y = ray[1] / ray[2];
    const double s = x * x + y * y;
    const double radial = 1.0 + d[0] * s + d[1] * s * s;
    return to_pixel(x * radial + 2.0 * d[2] * x * y + d[3] * (s + 2.0 * x * x),
                    y * radial + d[2] * (s + 2.0 * y * y) + 2.0 * d[3] * x * y);
  };
  return formula;
}

std::vector<Pose> relative_poses(const std::vector<std::string>& files) {
  if (files.empty()) return {};
  const cv::FileStorage storage = open_storage(files.front());
  const std::optional<Pose> first = pose_in_imu(storage, 0);
  const std::optional<Pose> second = pose_in_imu(storage, 1);
  if (!first || !second) return {};
  return {inverse(*second) * *first};
}

}  // namespace fca::matrix::openvins
