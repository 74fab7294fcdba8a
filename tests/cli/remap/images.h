// SPDX-License-Identifier: BSD-3-Clause
// Cameras and their images for remap, made here: no file of somebody else's.
#pragma once

#include "cli/run_program.h"
#include "lib/convert/known_cameras.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include <cmath>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

namespace fca::test {

/// TUM-VI's cam0 and a camera with radtan, as Kalibr's files.
inline const std::string kFisheye = R"(cam0:
  camera_model: pinhole
  intrinsics: [190.97847715128717, 190.9733070521226, 254.93170605935475, 256.8974428996504]
  distortion_model: equidistant
  distortion_coeffs: [0.0034823894022493434, 0.0007150348452162257, -0.0020532361418706202, 0.00020293673591811182]
  resolution: [512, 512]
)";
inline const std::string kRadtan = R"(cam0:
  camera_model: pinhole
  intrinsics: [458.654, 457.296, 367.215, 248.375]
  distortion_model: radtan
  distortion_coeffs: [-0.28340811, 0.07395907, 0.00019359, 1.76187114e-05]
  resolution: [752, 480]
)";

/// What a camera sees of a scene: `shade` of each pixel's ray, black without one.
inline cv::Mat1b rendered(const Camera& camera, const std::function<double(const Ray&)>& shade) {
  cv::Mat1b image(camera.image_size->height, camera.image_size->width, uchar{0});
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const std::optional<Ray> ray = unproject(camera.model, {static_cast<double>(u), static_cast<double>(v)});
      if (ray) image(v, u) = cv::saturate_cast<uchar>(shade(*ray));
    }
  }
  return image;
}

/// Noise: an image in which no place looks like another.
inline cv::Mat noise(int width, int height, int type) {
  cv::Mat image(height, width, type);
  cv::RNG random(7);
  random.fill(image, cv::RNG::UNIFORM, 0, CV_MAT_DEPTH(type) == CV_8U ? 256 : 65536);
  return image;
}

inline std::string bytes_of(const cv::Mat& image, const std::string& extension) {
  std::vector<uchar> bytes;
  cv::imencode(extension, image, bytes);
  return {bytes.begin(), bytes.end()};
}

inline cv::Mat read_picture(const std::string& path) { return cv::imread(path, cv::IMREAD_UNCHANGED); }

/// Two images are the same in kind, size and every sample.
inline bool same(const cv::Mat& a, const cv::Mat& b) {
  return a.type() == b.type() && a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

/// The array of a NumPy file of float32, shape (height, width, 2).
inline cv::Mat2f read_npy(const std::string& path, int width, int height) {
  const std::string bytes = read_file(path);
  const std::string shape = "(" + std::to_string(height) + ", " + std::to_string(width) + ", 2)";
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t header = static_cast<unsigned char>(bytes[8]) + 256UL * static_cast<unsigned char>(bytes[9]);
  EXPECT_EQ((10 + header) % 64, 0U);
  EXPECT_TRUE(contains(bytes.substr(10, header), "'descr': '<f4', 'fortran_order': False, 'shape': " + shape));
  cv::Mat2f map(height, width);
  const std::size_t size = map.total() * map.elemSize();
  EXPECT_EQ(bytes.size(), 10 + header + size);
  if (bytes.size() == 10 + header + size) std::memcpy(map.data, bytes.data() + 10 + header, size);
  return map;
}

}  // namespace fca::test
