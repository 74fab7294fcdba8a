// SPDX-License-Identifier: BSD-3-Clause
// ros-pixels FILE [RIGHT]: what ROS itself reads from a camera_info. camera_calibration_parsers reads the file, and
// image_geometry gives the pixel of each ray "x y z" of standard input, a line each: "u v" with all digits. Exits with 1 where
// ROS refuses.
//
// A ray's pixel is that of the point where it meets the rectified camera's plane z = 1 or, from behind, z = -1. The rectified
// pixel of that point is project3dToPixel's, and its pixel in the raw image is unrectifyPoint's. Where the camera sits in its
// pair (P(0, 3)) is left out: a ray has no place.
//
// With RIGHT, a file of the same pair, it prints StereoCameraModel's baseline, then for each point of standard input, in the
// rectified left camera, its pixels in both rectified images and where StereoCameraModel puts these: "u v u' v' x y z".
#include <camera_calibration_parsers/parse.h>
#include <image_geometry/pinhole_camera_model.h>
#include <image_geometry/stereo_camera_model.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <limits>
#include <string>

namespace {

sensor_msgs::CameraInfo read(const std::string& path) {
  sensor_msgs::CameraInfo info;
  std::string name;
  if (!camera_calibration_parsers::readCalibration(path, name, info))
    throw std::runtime_error("camera_calibration_parsers refuses it");
  return info;
}

void print_pixels(sensor_msgs::CameraInfo info) {
  info.P[3] = 0.0;
  info.P[7] = 0.0;
  image_geometry::PinholeCameraModel model;
  model.fromCameraInfo(info);
  std::printf("%u %u\n", info.width, info.height);
  const cv::Matx33d& R = model.rotationMatrix();
  for (const double value : R.val) std::printf("%.17g ", value);
  std::puts("");
  for (cv::Vec3d ray; std::cin >> ray[0] >> ray[1] >> ray[2];) {
    const cv::Vec3d there = R * ray;
    const cv::Point3d point(there[0] / std::abs(there[2]), there[1] / std::abs(there[2]), there[2] > 0.0 ? 1.0 : -1.0);
    const cv::Point2d pixel = model.unrectifyPoint(model.project3dToPixel(point));
    std::printf("%.17g %.17g\n", pixel.x, pixel.y);
  }
}

void print_pair(const sensor_msgs::CameraInfo& left, const sensor_msgs::CameraInfo& right) {
  image_geometry::StereoCameraModel model;
  model.fromCameraInfo(left, right);
  std::printf("%.17g\n", model.baseline());
  for (cv::Point3d point; std::cin >> point.x >> point.y >> point.z;) {
    const cv::Point2d in_left = model.left().project3dToPixel(point);
    const cv::Point2d in_right = model.right().project3dToPixel(point);
    cv::Point3d back;
    model.projectDisparityTo3d(in_left, static_cast<float>(in_left.x - in_right.x), back);
    std::printf("%.17g %.17g %.17g %.17g %.17g %.17g %.17g\n", in_left.x, in_left.y, in_right.x, in_right.y, back.x, back.y,
                back.z);
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc == 2) print_pixels(read(argv[1]));
    if (argc == 3) print_pair(read(argv[1]), read(argv[2]));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
