// SPDX-License-Identifier: BSD-3-Clause
// OpenCV's files, read by cv::FileStorage, with the formulas of OpenCV's documentation. Source of the key families: FORMATS.md
// section
// 4. Formulas: docs.opencv.org, modules calib3d ("Detailed Description": rational, thin prism and tilted model), calib3d
// fisheye (theta_d = theta (1 + k1 theta^2 + ...), u = fx (x' + alpha y') + cx) and ccalib omnidir (Mei: the unit sphere, xi,
// then k1 k2 p1 p2, skew in K(0,1)). The pinhole functions do not look at K(0,1). The fisheye angle is taken by atan2: that
// OpenCV's own functions end at 90 deg is its affair.
#include "pixels_opencv.h"

#include "opencv_lens.h"
#include "storage.h"

namespace fca::matrix::opencv {

namespace {

using Lens = RayToPixel;

Lens omnidir(double xi, std::vector<double> d) {
  d.resize(4, 0.0);
  return [xi, d](const Ray& p) -> std::optional<Pixel> {
    const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    const double below = p[2] / length + xi;
    if (below <= 0.0 || (xi > 1.0 && p[2] * xi <= -length)) return std::nullopt;
    const double x = p[0] / length / below;
    const double y = p[1] / length / below;
    const double r2 = x * x + y * y;
    const double radial = 1.0 + d[0] * r2 + d[1] * r2 * r2;
    return Pixel{x * radial + 2.0 * d[2] * x * y + d[3] * (r2 + 2.0 * x * x),
                 y * radial + d[2] * (r2 + 2.0 * y * y) + 2.0 * d[3] * x * y};
  };
}

/// What a file says of one camera, whatever the family calls it.
struct Found {
  std::vector<double> K;
  std::vector<double> D;
  std::optional<double> xi;
  bool fisheye = false;
  std::optional<Size> size;
};

std::vector<double> first_matrix(const cv::FileNode& owner, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const std::vector<double> values = numbers(owner[name]);
    if (!values.empty()) return values;
  }
  return {};
}

std::optional<double> first_number(const cv::FileNode& owner, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const cv::FileNode node = owner[name];
    if (is_number(node)) return static_cast<double>(node);
    const std::vector<double> values = numbers(node);
    if (values.size() == 1) return values.front();
  }
  return std::nullopt;
}

std::optional<Size> size_of(const cv::FileNode& owner) {
  const std::optional<double> width = first_number(owner, {"image_width", "image_Width", "img_width", "width"});
  const std::optional<double> height = first_number(owner, {"image_height", "image_Height", "img_height", "height"});
  if (width && height) return Size{static_cast<int>(*width), static_cast<int>(*height)};
  for (const char* name : {"imageSize", "image_size", "resolution", "img_size"}) {
    const std::vector<double> both = numbers(owner[name]);
    if (both.size() == 2) return Size{static_cast<int>(both[0]), static_cast<int>(both[1])};
  }
  return std::nullopt;
}

/// Metadata decides between the two meanings of four numbers.
bool says_fisheye(const cv::FileNode& owner) {
  if (first_number(owner, {"fisheye_model", "distortion_type"}).value_or(0.0) == 1.0) return true;
  for (const char* name : {"distortion_model", "camera_model", "model"}) {
    const cv::FileNode node = owner[name];
    if (!node.isString()) continue;
    const std::string word = static_cast<std::string>(node);
    if (word == "fisheye" || word == "equidistant") return true;
  }
  return false;
}

/// A key that speaks of distortion under none of the usual names: "fisheye_dist_coeffs".
std::optional<std::string> other_distortion(const cv::FileNode& owner) {
  for (const cv::FileNode& node : owner) {
    if (node.name().find("dist") != std::string::npos && (node.isMap() || node.isSeq())) return node.name();
  }
  return std::nullopt;
}

std::optional<Found> with_suffix(const cv::FileNode& root, const std::vector<std::string>& matrices,
                                 const std::vector<std::string>& distortions, const std::vector<std::string>& xis) {
  Found found;
  found.K = first_matrix(root, matrices);
  if (found.K.size() != 9) return std::nullopt;
  found.D = first_matrix(root, distortions);
  const std::optional<std::string> other = found.D.empty() ? other_distortion(root) : std::nullopt;
  if (other) found.D = numbers(root[*other]);
  if (other && other->find("fisheye") == std::string::npos) return std::nullopt;  // a name whose meaning is not known
  found.xi = first_number(root, xis);
  found.fisheye = says_fisheye(root) || other;
  found.size = size_of(root);
  return found;
}

std::optional<Found> find_camera(const cv::FileNode& root, std::size_t index) {
  const cv::FileNode block = root["camera_" + std::to_string(index)];
  if (block.isMap()) {
    return with_suffix(block, {"camera_matrix"}, {"distortion_vector", "distortion_coefficients"}, {"xi"});
  }
  if (index == 0) {
    if (std::optional<Found> one = with_suffix(root, {"camera_matrix", "Camera_Matrix"},
                                               {"distortion_coefficients", "Distortion_Coefficients", "dist_coeffs"}, {"xi"})) {
      return one;
    }
  }
  const std::string n = std::to_string(index + 1);
  const std::string side = index == 0 ? "left" : "right";
  if (index > 1) return std::nullopt;
  return with_suffix(root, {"M" + n, "K" + n, "camera_matrix_" + n, "camera_matrix_" + side, "cameraMatrix" + n},
                     {"D" + n, "distortion_coefficients_" + n, "distortion_coefficients_" + side, "dist_coeffs_" + side,
                      "dist_coeffs_" + n, "distCoeffs" + n},
                     {"xi" + n, "xi_" + n, "xi_" + side});
}

/// cv::Rodrigues: a rotation vector as a matrix.
std::vector<double> rotation(const std::vector<double>& om) {
  const double angle = std::sqrt(om[0] * om[0] + om[1] * om[1] + om[2] * om[2]);
  if (angle == 0.0) return {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  const double x = om[0] / angle;
  const double y = om[1] / angle;
  const double z = om[2] / angle;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double v = 1.0 - c;
  return {c + v * x * x,     v * x * y - s * z, v * x * z + s * y, v * x * y + s * z, c + v * y * y,
          v * y * z - s * x, v * x * z - s * y, v * y * z + s * x, c + v * z * z};
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  const cv::FileStorage storage = open_storage(bytes);
  if (!storage.isOpened()) return std::nullopt;
  const std::optional<Found> found = find_camera(storage.root(), index);
  if (!found) return std::nullopt;
  const double fx = found->K[0];
  const double fy = found->K[4];
  const double cx = found->K[2];
  const double cy = found->K[5];
  double skew = found->K[1];
  Lens lens;
  if (found->xi) {
    lens = omnidir(*found->xi, found->D);
  } else if (found->fisheye) {
    lens = fisheye(found->D);
  } else {
    lens = pinhole(found->D);
    skew = 0.0;
  }
  PixelFormula formula;
  formula.size = found->size;
  formula.pixel = [lens, fx, fy, cx, cy, skew](const Ray& p) -> std::optional<Pixel> {
    const std::optional<Pixel> m = lens(p);
    if (!m) return std::nullopt;
    return Pixel{fx * (*m)[0] + skew * (*m)[1] + cx, fy * (*m)[1] + cy};
  };
  return formula;
}

std::vector<Pose> relative_poses(const std::vector<std::string>& files) {
  std::vector<Pose> result;
  for (const std::string& bytes : files) {
    const cv::FileStorage storage = open_storage(bytes);
    if (!storage.isOpened()) continue;
    // stereo_calib.cpp: p_2 = R p_1 + T; omnidir: the same with a rotation vector
    std::vector<double> R = numbers(storage["R"]);
    if (R.empty()) R = numbers(storage["om"]);
    if (R.size() == 3) R = rotation(R);
    const std::vector<double> T = numbers(storage["T"]);
    if (R.size() == 9 && T.size() == 3) {
      result.push_back({{{R[0], R[1], R[2], T[0]}, {R[3], R[4], R[5], T[1]}, {R[6], R[7], R[8], T[2]}}});
    }
    // MC-Calib: camera -> reference camera
    const std::optional<Pose> first = pose_of(numbers(storage["camera_0"]["camera_pose_matrix"]));
    const std::optional<Pose> second = pose_of(numbers(storage["camera_1"]["camera_pose_matrix"]));
    if (first && second) result.push_back(inverse(*second) * *first);
  }
  return result;
}

}  // namespace fca::matrix::opencv
