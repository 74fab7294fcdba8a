// SPDX-License-Identifier: BSD-3-Clause
// cv::FileStorage over bytes, as the programs that read with OpenCV use it.
#pragma once

#include "geometry.h"

#include <opencv2/core.hpp>
#include <opencv2/core/persistence.hpp>

namespace fca::matrix {

/// Not opened where OpenCV refuses the text.
inline cv::FileStorage open_storage(const std::string& bytes) {
  cv::FileStorage storage;
  try {
    storage.open(bytes, cv::FileStorage::READ | cv::FileStorage::MEMORY);
  } catch (const cv::Exception&) {
    storage.release();
  }
  return storage;
}

inline bool is_number(const cv::FileNode& node) { return node.isReal() || node.isInt(); }

inline double number(const cv::FileNode& node, double otherwise = 0.0) {
  return is_number(node) ? static_cast<double>(node) : otherwise;
}

/// The matrix, or the plain sequence, as doubles in row-major order; empty if it is neither.
inline std::vector<double> numbers(const cv::FileNode& node) {
  std::vector<double> result;
  if (node.isSeq()) {
    for (const cv::FileNode& item : node) {
      if (item.isSeq()) {
        for (const double inner : numbers(item)) result.push_back(inner);
      } else {
        result.push_back(number(item));
      }
    }
    return result;
  }
  if (!node.isMap()) return result;
  cv::Mat matrix;
  try {
    matrix = node.mat();
  } catch (const cv::Exception&) {
    return result;
  }
  if (matrix.empty()) return result;
  cv::Mat reals;
  matrix.convertTo(reals, CV_64F);
  for (int row = 0; row < reals.rows; ++row) {
    for (int column = 0; column < reals.cols; ++column) result.push_back(reals.at<double>(row, column));
  }
  return result;
}

/// 12 or 16 numbers as a pose.
inline std::optional<Pose> pose_of(const std::vector<double>& values) {
  if (values.size() != 12 && values.size() != 16) return std::nullopt;
  Pose pose{};
  for (std::size_t i = 0; i < 12; ++i) pose[i / 4][i % 4] = values[i];
  return pose;
}

}  // namespace fca::matrix
