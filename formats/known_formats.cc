// SPDX-License-Identifier: BSD-3-Clause
#include "known_formats.h"

#include <fca/code.h>
#include <fca/formats/text/dialect.h>

#include <array>
#include <string_view>

namespace fca {

namespace {

/// A format and two keys that its files have. The second stands in the first one's mapping if that is one, else beside it.
struct Known {
  Code what;
  std::string_view key;
  std::string_view second_key;
};

constexpr std::array kKnown = {
    Known{Code::kLooksLikeMultiCol, "Camera.nrpol", "Camera.nrinvpol"},
    Known{Code::kLooksLikeOv2Slam, "Camera.fxl", "Camera.model_left"},
    Known{Code::kLooksLikeD2Slam, "estimation_mode", "self_id"},
    Known{Code::kLooksLikePlainLists, "camera_matrix", "distortion_coefficients"},
    Known{Code::kLooksLikePlainLists, "camera_matrix", "dist_coeff"},
    Known{Code::kLooksLikePlainLists, "camera_matrix", "dist_coeffs"},
    Known{Code::kLooksLikePyOcamCalib, "taylor_coefficient", "distortion_center"},
};

}  // namespace

Message looks_like(const text::Document& document) {
  constexpr text::Dialect kDialect = text::Dialect::kOpenCv;
  const text::Node& root = document.root();
  for (const Known& known : kKnown) {
    const text::Node* first = text::find(root, known.key, kDialect);
    if (first == nullptr) continue;
    const bool inside = first->is_mapping();
    if (text::find(inside ? *first : root, known.second_key, kDialect) == nullptr) continue;
    return {inside ? Code::kFormatLooksLikeKeysInside : Code::kFormatLooksLikeKeysBeside,
            {Message{known.what}, known.key, known.second_key}};
  }
  return {};
}

}  // namespace fca
