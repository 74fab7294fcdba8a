// SPDX-License-Identifier: BSD-3-Clause
#include "known_formats.h"

#include <fca/formats/text/dialect.h>

#include <array>
#include <string_view>

namespace fca {

namespace {

/// A format and two keys that its files have. The second stands in the first one's mapping if that is one, else beside it.
struct Known {
  std::string_view what;
  std::string_view key;
  std::string_view second_key;
};

constexpr std::array kKnown = {
    Known{"MultiCol-SLAM's OCam settings", "Camera.nrpol", "Camera.nrinvpol"},
    Known{"OpenCV's numbers in plain lists, of which cv::FileStorage makes no matrix", "camera_matrix",
          "distortion_coefficients"},
    Known{"OpenCV's numbers in plain lists, of which cv::FileStorage makes no matrix", "camera_matrix", "dist_coeff"},
    Known{"OpenCV's numbers in plain lists, of which cv::FileStorage makes no matrix", "camera_matrix", "dist_coeffs"},
    Known{"py-OCamCalib's JSON", "taylor_coefficient", "distortion_center"},
};

}  // namespace

std::string looks_like(const text::Document& document) {
  constexpr text::Dialect kDialect = text::Dialect::kOpenCv;
  const text::Node& root = document.root();
  for (const Known& known : kKnown) {
    const text::Node* first = text::find(root, known.key, kDialect);
    if (first == nullptr) continue;
    const bool inside = first->is_mapping();
    if (text::find(inside ? *first : root, known.second_key, kDialect) == nullptr) continue;
    return std::string(known.what) + " (" + std::string(known.key) + (inside ? " with " : " and ") +
           std::string(known.second_key) + ")";
  }
  return "";
}

}  // namespace fca
