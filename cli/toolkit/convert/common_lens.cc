// SPDX-License-Identifier: BSD-3-Clause
#include "common_lens.h"

#include <fca/code.h>
#include <fca/convert/common_lens.h>
#include <fca/convert/evaluate.h>
#include <fca/convert/max_angle_table.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <span>
#include <utility>

namespace fca {

namespace {

constexpr std::size_t kPair = 2;  // the number of cameras that share a lens
constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

/// A report with the errors of `model` compared with the camera `source`. nullopt, with an error, if the source has no field of
/// view.
std::optional<ConversionReport> report_of(const Camera& source, const CameraModel& model, const ConvertRequest& request,
                                          Diagnostics& diagnostics) {
  const std::optional<FieldOfView> field_of_view = field_of_view_of(source, request.inputs.max_angle_rad, diagnostics);
  if (!field_of_view) return std::nullopt;
  ConversionReport report;
  report.from_model = source.lens_id();
  report.to_model = model_info(model).id;
  report.statistics = evaluate(source.model, model, *field_of_view, {.every_pixel = request.every_pixel});
  report.scored_to_deg = std::min(field_of_view->max_angle_rad, max_angle(model)) * kDegreesPerRadian;
  return report;
}

}  // namespace

bool share_lens(const ConvertRequest& request, const Format& to, std::size_t cameras_in_file,
                std::vector<ConvertedCamera>& cameras, Diagnostics& diagnostics) {
  if (!request.layout || to.common_lens_layout.empty() || request.layout->name() != to.common_lens_layout) return true;
  const auto is_fisheye = [](const ConvertedCamera& camera) {
    return camera.source.rays.empty() && !is_perspective(model_info(camera.target.model).id);
  };
  const bool is_pair = std::min(cameras_in_file, cameras.size()) >= kPair &&
                       std::all_of(cameras.begin(), cameras.begin() + kPair, is_fisheye) &&
                       cameras[0].target.lens_id() == cameras[1].target.lens_id();
  if (!is_pair) {
    std::vector<std::string> models;
    models.reserve(cameras.size());
    for (const ConvertedCamera& camera : cameras)
      models.push_back(camera.source.name + " " + std::string(camera.target.lens_id()));
    diagnostics.add(Code::kCommonLensNeedsPair, {to.common_lens_layout, models});
    return false;
  }
  const std::array<Camera, kPair> sources = {cameras[0].source, cameras[1].source};
  const std::array<CameraModel, kPair> own = {cameras[0].target.model, cameras[1].target.model};
  const std::vector<CameraModel> before = with_lens_of_first(own);  // as the programs would use the separate fits
  const std::optional<std::vector<CameraModel>> after =
      fit_common_lens(sources, own, request.inputs.max_angle_rad, diagnostics, {request.weight, request.density});
  if (!after) {
    if (!diagnostics.has_errors()) diagnostics.add(Code::kFitFailed, {sources[1].name, model_info(own[1]).id});
    return false;
  }
  std::array<double, kPair> rms_before{};
  std::array<double, kPair> rms_after{};
  for (std::size_t i = 0; i < kPair; ++i) {
    const std::optional<ConversionReport> report_before = report_of(sources.at(i), before[i], request, diagnostics);
    std::optional<ConversionReport> report = report_of(sources.at(i), (*after)[i], request, diagnostics);
    if (!report_before || !report) return false;
    rms_before.at(i) = report_before->statistics.error.rms;
    rms_after.at(i) = report->statistics.error.rms;
    cameras[i].target.model = (*after)[i];
    cameras[i].report = std::move(report);
  }
  constexpr double kRoundingPx = 1e-9;  // smaller errors are reported as 0
  for (double& rms : rms_before) rms = rms < kRoundingPx ? 0.0 : rms;
  diagnostics.add(Code::kCommonLensFitted,
                  {sources[0].name, sources[1].name, rms_after[0], rms_after[1], rms_before[0], rms_before[1]});
  return true;
}

}  // namespace fca
