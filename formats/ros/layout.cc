// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>

namespace fca::ros {

namespace {

struct Names {
  std::string_view distortion_model;
  std::string_view model;
};
/// In the order in which a model of ours looks for its name.
constexpr std::array kNames = {Names{"plumb_bob", "radtan"}, Names{"plumb_bob", "pinhole"},
                               Names{"rational_polynomial", "rational"}, Names{"rational_polynomial", "opencv14"},
                               Names{"equidistant", "kb4"}};

constexpr std::string_view kFrame = "rectified";

}  // namespace

std::string_view model_of(std::string_view distortion_model) {
  const auto* const found = std::ranges::find(kNames, distortion_model, &Names::distortion_model);
  return found == kNames.end() ? std::string_view() : found->model;
}

std::string_view name_of(const CameraModel& model) {
  const auto* const found = std::ranges::find(kNames, straight_id(model), &Names::model);
  return found == kNames.end() ? std::string_view() : found->distortion_model;
}

std::vector<double> coefficients_of(const CameraModel& model) {
  std::vector<double> values;
  const auto add = [&](std::span<const ParameterId> coefficients) {
    for (const ParameterId coefficient : coefficients) values.push_back(parameter(model, coefficient).value());
  };
  const std::string_view id = straight_id(model);
  std::vector<double> zeros(kRadtanCount, 0.0);
  if (id == "pinhole") return zeros;
  if (id == "kb4") {
    add(kFisheyeCoefficients);
  } else {
    add(std::span(kOpenCvCoefficients).first(opencv_count(id)));
    const bool is_level = values.size() > kPrismCount && values[kPrismCount] == 0.0 && values[kPrismCount + 1] == 0.0;
    if (is_level) values.resize(kPrismCount);
  }
  return values;
}

Matrix3 camera_matrix_of(const CameraModel& model) {
  const auto value = [&model](ParameterId id) { return parameter(model, id).value(); };
  return {value("fx"), without_skew(model).skew_px, value("cx"), 0.0, value("fy"), value("cy"), 0.0, 0.0, 1.0};
}

PixelMap Reduction::map() const {
  return {{1.0 / binning_x, 1.0 / binning_y}, {-static_cast<double>(x) / binning_x, -static_cast<double>(y) / binning_y}};
}

CameraModel unreduced(const CameraModel& model, const Reduction& reduction) {
  if (!reduction.changes_pixels()) return model;
  return with_pixels(model, {{static_cast<double>(reduction.binning_x), static_cast<double>(reduction.binning_y)},
                             {static_cast<double>(reduction.x), static_cast<double>(reduction.y)}});
}

std::string frame_of(const Projection& P) {
  return std::string(kFrame) + "(" + text::format_short(P[0]) + " " + text::format_short(P[6]) + ")";
}

bool is_rectified_frame(std::string_view frame) { return frame.starts_with(kFrame) && frame.ends_with(")"); }

Transform pose_of(const Matrix3& R, const Projection& P) {
  Transform T;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) T(row, column) = R[static_cast<std::size_t>(3 * row + column)];
  }
  // 0 rather than -0: poses are compared and printed.
  T(0, 3) = P[3] == 0.0 ? 0.0 : -P[3] / P[0];
  T(1, 3) = P[7] == 0.0 ? 0.0 : -P[7] / P[5];
  return T;
}

Projection projection_of(const Matrix3& K) { return {K[0], 0.0, K[2], 0.0, 0.0, K[4], K[5], 0.0, 0.0, 0.0, 1.0, 0.0}; }

}  // namespace fca::ros
