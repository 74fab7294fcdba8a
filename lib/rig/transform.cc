// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/transform.h>

#include <cmath>

#include <Eigen/Core>
#include <Eigen/LU>

namespace fca {

namespace {

using Matrix4 = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
using ConstMap = Eigen::Map<const Matrix4>;  // unaligned by default, as std::array is

ConstMap as_eigen(const Transform& T) { return ConstMap(T.values.data()); }

}  // namespace

Transform operator*(const Transform& T_a_b, const Transform& T_b_c) {
  Transform T_a_c;
  Eigen::Map<Matrix4>(T_a_c.values.data()) = as_eigen(T_a_b) * as_eigen(T_b_c);
  return T_a_c;
}

std::optional<Transform> inverse(const Transform& T_a_b) {
  const Eigen::Matrix3d A = as_eigen(T_a_b).topLeftCorner<3, 3>();
  const Eigen::Vector3d t = as_eigen(T_a_b).topRightCorner<3, 1>();
  // The volume of the parallelepiped against that of the box of the same sides: 1 for a rotation, about 1e-16 for a singular
  // matrix with rounded entries.
  constexpr double kSingular = 1e-12;
  const Eigen::Vector3d sides = A.rowwise().norm();
  if (!(std::abs(A.determinant()) > kSingular * sides.prod())) return std::nullopt;
  Eigen::Matrix3d inverse_of_A = A.inverse();
  // Rotations carry the digits of a print: one Newton step takes the error of the closed formula to the last bit.
  inverse_of_A = inverse_of_A * (2.0 * Eigen::Matrix3d::Identity() - A * inverse_of_A);
  const Eigen::Vector3d back = -(inverse_of_A * t);
  if (!inverse_of_A.allFinite() || !back.allFinite()) return std::nullopt;
  Transform T_b_a;
  Eigen::Map<Matrix4> result(T_b_a.values.data());
  result.topLeftCorner<3, 3>() = inverse_of_A;
  result.topRightCorner<3, 1>() = back;
  return T_b_a;
}

double rotation_defect(const Transform& T_a_b) {
  const Eigen::Matrix3d R = as_eigen(T_a_b).topLeftCorner<3, 3>();
  return (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
}

double rotation_determinant(const Transform& T_a_b) {
  const Eigen::Matrix3d R = as_eigen(T_a_b).topLeftCorner<3, 3>();
  return R.determinant();
}

std::string name_of(const PoseEdge& edge) { return "T_" + edge.a + "_" + edge.b; }

}  // namespace fca
