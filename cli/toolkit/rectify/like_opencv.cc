// SPDX-License-Identifier: BSD-3-Clause
#include "like_opencv.h"

#include "stereo_rectify.h"

#include <fca/code.h>
#include <fca/formats/opencv_coefficients.h>
#include <fca/rig/rotation.h>

#include <cmath>

namespace fca {

namespace {

/// The model's distortion coefficients in OpenCV's order. nullopt if neither cv::projectPoints nor cv::fisheye supports the
/// model.
std::optional<std::vector<double>> coefficients_of(const CameraModel& model) {
  const std::string_view id = model_info(model).id;
  const auto values = [&model](std::span<const ParameterId> names) {
    std::vector<double> result;
    for (const ParameterId name : names) result.push_back(parameter(model, name).value());
    return result;
  };
  if (id == "kb4") return values(kFisheyeCoefficients);
  if (id == "pinhole") return std::vector<double>(kRadtanCount, 0.0);
  const std::size_t count = opencv_count(id);
  return count > 0 ? std::optional(values(std::span(kOpenCvCoefficients).first(count))) : std::nullopt;
}

}  // namespace

std::optional<RectifiedPair> rectify_with_opencv(const OpenCvRectifier& opencv, const std::array<Camera, 2>& cameras,
                                                 const Transform& T_second_first, double alpha, const ImageSize& size,
                                                 Diagnostics& diagnostics) {
  OpenCvPair pair;
  pair.alpha = alpha;
  pair.size = *cameras[0].image_size;
  pair.new_size = size;
  const Transform& T = T_second_first;
  pair.R = {T(0, 0), T(0, 1), T(0, 2), T(1, 0), T(1, 1), T(1, 2), T(2, 0), T(2, 1), T(2, 2)};
  pair.T = translation_of(T);
  pair.is_fisheye = model_info(cameras[0].model).id == "kb4";
  for (std::size_t i = 0; i < 2; ++i) {
    const CameraModel& model = cameras.at(i).model;
    const std::string_view id = model_info(model).id;
    const std::optional<std::vector<double>> D = coefficients_of(model);
    if (!D || pair.is_fisheye != (id == "kb4")) {
      diagnostics.add(Code::kRectifyModelNotKnown, {pair.is_fisheye ? "cv::fisheye::stereoRectify" : "cv::stereoRectify", id});
      return std::nullopt;
    }
    pair.D.at(i) = *D;
    const auto value = [&model](const ParameterId& name) { return parameter(model, name).value(); };
    pair.K.at(i) = {value("fx"), 0.0, value("cx"), 0.0, value("fy"), value("cy"), 0.0, 0.0, 1.0};
  }
  const std::optional<OpenCvRectification> rectification = opencv(pair);
  const auto is_camera = [](const std::array<double, 12>& P) {
    return std::isfinite(P[0]) && P[0] > 0.0 && std::isfinite(P[2]);
  };
  if (!rectification || !is_camera(rectification->P[0]) || !is_camera(rectification->P[1])) {
    diagnostics.add(Code::kRectifyOpencvFailed, {cameras[0].name + " and " + cameras[1].name});
    return std::nullopt;
  }
  RectifiedPair result;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::array<double, 12>& P = rectification->P.at(i);
    RectifiedPair::View& view = result.views.at(i);
    view.camera = cameras.at(i).name;
    view.centre = {P[2], P[6]};
    for (int k = 0; k < 9; ++k) view.T_rectified_camera(k / 3, k % 3) = rectification->R.at(i).at(static_cast<std::size_t>(k));
  }
  const std::array<double, 12>& P2 = rectification->P[1];
  result.focal_lengths = {P2[0], P2[5]};
  result.is_vertical = P2[7] != 0.0;
  result.offset_m = result.is_vertical ? -P2[7] / P2[5] : -P2[3] / P2[0];
  result.size = size;
  return result;
}

}  // namespace fca
