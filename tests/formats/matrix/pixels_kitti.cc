// SPDX-License-Identifier: BSD-3-Clause
// KITTI's calib_cam_to_cam.txt by the dataset's paper (Geiger et al., IJRR 2013): K and D are OpenCV's, p_nn = R p_00 + T.
#include "pixels_kitti.h"

#include "opencv_lens.h"

#include <map>
#include <sstream>

namespace fca::matrix::kitti {

namespace {

std::map<std::string, std::vector<double>> lines_of(const std::string& bytes) {
  std::map<std::string, std::vector<double>> lines;
  std::istringstream stream(bytes);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos) continue;
    std::istringstream numbers(line.substr(colon + 1));
    for (double number = 0.0; numbers >> number;) lines[line.substr(0, colon)].push_back(number);
  }
  return lines;
}

}  // namespace

std::optional<PixelFormula> camera(const std::string& bytes, std::size_t index) {
  std::map<std::string, std::vector<double>> lines = lines_of(bytes);
  const std::string number = "0" + std::to_string(index);
  if (const std::string P = "P_rect_" + number; !lines.contains("K_" + number) && lines.contains(P)) {
    const std::vector<double>& size = lines["S_rect_" + number];
    PixelFormula rectified;
    rectified.pixel = in_image(pinhole({}), lines[P][0], lines[P][5], lines[P][2], lines[P][6]);
    rectified.size = Size{static_cast<int>(size[0]), static_cast<int>(size[1])};
    return rectified;
  }
  if (!lines.contains("K_" + number)) return std::nullopt;
  const std::vector<double>& K = lines["K_" + number];
  const std::vector<double>& size = lines["S_" + number];
  PixelFormula formula;
  formula.pixel = in_image(pinhole(lines["D_" + number]), K[0], K[4], K[2], K[5]);
  formula.size = Size{static_cast<int>(size[0]), static_cast<int>(size[1])};
  return formula;
}

std::vector<Pose> relative_poses(const std::vector<std::string>& files) {
  std::map<std::string, std::vector<double>> lines = lines_of(files.front());
  if (!lines.contains("R_01")) return {};
  Pose pose{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) pose[row][column] = lines["R_01"][3 * row + column];
    pose[row][3] = lines["T_01"][row];
  }
  return {pose};
}

}  // namespace fca::matrix::kitti
