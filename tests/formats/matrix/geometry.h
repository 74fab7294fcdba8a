// SPDX-License-Identifier: BSD-3-Clause
// What the matrix test speaks of: rays, pixels, poses, and a camera as its own program computes with it. Shares nothing with
// lib/ and formats/, on purpose.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace fca::matrix {

using Ray = std::array<double, 3>;    ///< x right, y down, z forward; any length.
using Pixel = std::array<double, 2>;  ///< The centre of the top-left pixel is (0, 0).
using RayToPixel = std::function<std::optional<Pixel>(const Ray&)>;
using PixelToRay = std::function<std::optional<Ray>(const Pixel&)>;

struct Size {
  int width = 0;
  int height = 0;
};

/// A camera of a file, by the formula of the program that reads the file.
struct PixelFormula {
  RayToPixel pixel;          ///< The mapping that defines the camera.
  PixelToRay ray = nullptr;  ///< Where the program's own formula goes this way (OCamCalib's cam2world).
  RayToPixel stored_approximation =
      nullptr;  ///< What the program computes where the file stores an approximation of its own inverse.
  std::optional<Size> size = std::nullopt;
};

/// Points of one frame in another: the first three rows of the 4 x 4 matrix.
using Pose = std::array<std::array<double, 4>, 3>;

inline Pose identity_pose() { return {{{1.0, 0.0, 0.0, 0.0}, {0.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 1.0, 0.0}}}; }

/// T_a_b * T_b_c
inline Pose operator*(const Pose& ab, const Pose& bc) {
  Pose ac{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      for (std::size_t k = 0; k < 3; ++k) ac[row][column] += ab[row][k] * bc[k][column];
    }
    ac[row][3] += ab[row][3];
  }
  return ac;
}

/// The affine inverse, by cofactors.
inline Pose inverse(const Pose& m) {
  Pose result{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      const std::size_t r1 = (column + 1) % 3;
      const std::size_t r2 = (column + 2) % 3;
      const std::size_t c1 = (row + 1) % 3;
      const std::size_t c2 = (row + 2) % 3;
      result[row][column] = m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
    }
  }
  const double determinant = m[0][0] * result[0][0] + m[0][1] * result[1][0] + m[0][2] * result[2][0];
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) result[row][column] /= determinant;
    for (std::size_t k = 0; k < 3; ++k) result[row][3] -= result[row][k] * m[k][3];
  }
  return result;
}

/// An independent reader of one format.
struct FormatReader {
  std::string id;
  /// The camera at `index` in the file; nothing if there is none or the file cannot be read.
  std::optional<PixelFormula> (*camera)(const std::string& bytes, std::size_t index);
  /// Every statement of the files (one camera per file: in the order of the cameras) that gives T_cam1_cam0. Empty: none.
  std::vector<Pose> (*relative_poses)(const std::vector<std::string>& files);
};

/// The reader for a format's id; null if nobody has written one.
const FormatReader* find_reader(const std::string& id);

}  // namespace fca::matrix
