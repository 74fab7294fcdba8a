// SPDX-License-Identifier: BSD-3-Clause
#include "layout.h"
#include "opencv.h"

#include <fca/code.h>

#include <array>

namespace fca::opencv {

namespace {

constexpr std::array kOwnFacts = {OwnFact{"keys of its own (calibration_time, flags, reprojection errors)"}};
constexpr std::array kModels = {
    StoredModel{"radtan", "5 coefficients", true, "cv::projectPoints", {}},
    StoredModel{"rational", "8 coefficients", true, "cv::projectPoints", {}},
    StoredModel{"opencv14", "12 or 14 coefficients", true, "cv::projectPoints", {}},
    StoredModel{"pinhole", "5 zeros", true, "cv::projectPoints", {}},
    StoredModel{"kb4", "fisheye", true, "cv::fisheye (rays inside 90 deg)", {}},
    StoredModel{"mei", "omnidir", true, "cv::omnidir", {}, {}, true},
    StoredModel{"mei-skew", "omnidir with K(0, 1)", true, "cv::omnidir", {}, {}, true},
    StoredModel{"radtan-skew", "5 coefficients with K(0, 1)", false, "cv::projectPoints without the skew", {}},
    StoredModel{"rational-skew", "8 coefficients with K(0, 1)", false, "cv::projectPoints without the skew", {}},
    StoredModel{"opencv14-skew", "12 or 14 coefficients with K(0, 1)", false, "cv::projectPoints without the skew", {}},
    StoredModel{"kb4-skew", "fisheye with K(0, 1)", false, "cv::fisheye without the skew", {}},
};

ProbeResult probe(const text::Document& document) {
  const std::optional<Layout> layout = find_layout(document);
  if (!layout) return {};
  return {layout->cameras.empty() ? evidence::kHint : evidence::kCamera, layout->why};
}

}  // namespace

const Format kFormat = {
    .id = "opencv",
    .title = "OpenCV calibration (cv::FileStorage)",
    .group = FormatGroup::kCalibration,
    .syntaxes = "YAML, XML, JSON",
    .extension = ".yml",
    .program = "OpenCV",
    .main_file = "intrinsics.yml",
    .many_cameras = true,
    .undistorts_points = true,
    .extrinsics = true,
    .any_length_unit = true,
    .imu = false,
    .image_size = true,
    .frame = "reference",
    .own_facts = kOwnFacts,
    .layouts = kLayoutNames,
    .about_layouts = Code::kOpencvLayouts,
    .rectified = RectifiedFiles::kCameras,
    .leaves_model_open = true,
    .models = kModels,
    .probe = probe,
    .read = read,
    .write = write,
};

}  // namespace fca::opencv
