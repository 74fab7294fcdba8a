// SPDX-License-Identifier: BSD-3-Clause
#include "convert/choose_model.h"

#include <fca/code.h>
#include <fca/convert/convert.h>
#include <fca/toolkit/report.h>

#include <algorithm>
#include <string>

namespace fca {

namespace {

/// Converts the cameras to the request's model, without writing a format.
ConvertResult converted_to_model(const ConvertRequest& request, const Reading& reading) {
  ConvertResult result;
  result.from = reading.calibration->format;
  result.diagnostics = reading.diagnostics;
  StoredModel of_no_format;
  of_no_format.model = request.model->id;
  ConvertOptions options = options_for(of_no_format, {.request = request});
  options.degree = request.degree;
  options.max_angle_table = true;
  for (const Camera& camera : reading.calibration->rig.cameras) {
    std::optional<Conversion> conversion = convert(camera, options, result.diagnostics);
    if (!conversion) {
      result.status = Status::kBadInput;
      continue;
    }
    result.cameras.push_back({camera, std::move(conversion->camera), std::move(conversion->report)});
  }
  return result;
}

/// Checks each file of the calibration.
std::vector<CheckResult> check_results(const Inputs& inputs, const Calibration& calibration, Files& files) {
  std::vector<CheckResult> results;
  for (std::size_t i = 0; i < calibration.documents.size(); ++i) {
    CheckRequest check_request;
    check_request.inputs.format = i < calibration.formats.size() ? calibration.formats[i] : nullptr;
    check_request.inputs.image_size = inputs.image_size;
    check_request.inputs.length_unit_m = inputs.length_unit_m;
    check_request.inputs.opencv_model = inputs.opencv_model;
    check_request.inputs.max_angle_rad = inputs.max_angle_rad;
    results.push_back(check(check_request, calibration.documents[i].source(), files));
  }
  return results;
}

/// Makes the conversion if the request has one. False if it failed, so that there is no report.
bool add_conversion(const ConvertRequest& request, Files& files, ReportResult& result) {
  if (request.to != nullptr || !request.into.empty()) {
    result.conversion = convert(request, files);
  } else if (request.model != nullptr) {
    result.conversion = converted_to_model(request, result.reading);
  }
  if (result.conversion) result.status = result.conversion->status;
  // A rejected conversion has results to report; a failed one has none.
  return result.status <= Status::kRejected;
}

/// The verdict on the converted files or, without a conversion to a format, the worst verdict on the input files.
Verdict verdict_of(const ReportResult& result) {
  if (result.conversion && result.conversion->to != nullptr) return result.conversion->verdict;
  const auto worst =
      std::ranges::max_element(result.checks, {}, [](const CheckResult& checked) { return checked.report.verdict.word; });
  return worst == result.checks.end() ? Verdict{} : worst->report.verdict;
}

}  // namespace

ReportResult report(const ReportRequest& request, Files& files) {
  ReportResult result;
  const ConvertRequest& conversion = request.conversion;
  const Inputs& inputs = conversion.inputs;
  result.reading = read({inputs, nullptr}, files);
  if (!result.reading.calibration) {
    result.status = worse(result.reading.status, Status::kBadInput);
    return result;
  }
  const std::vector<Camera>& cameras = result.reading.calibration->rig.cameras;
  for (const Camera& camera : cameras) {
    if (camera.rays.empty()) continue;
    result.reading.diagnostics.add(Code::kOnlyRaysKnown, {camera.name}, {inputs.files.front(), 0, 0});
    result.status = Status::kBadInput;
    return result;
  }
  if ((conversion.model != nullptr || request.every_model) && cameras.empty()) {
    result.reading.diagnostics.add(Code::kFileWithoutCamera, {inputs.files.front()});
    result.status = Status::kBadInput;
    return result;
  }
  if (!add_conversion(conversion, files, result)) return result;
  if (request.every_model) {
    auto models = compare_models(cameras, inputs.max_angle_rad, result.reading.diagnostics);
    if (!models) {
      result.conversion.reset();
      result.status = Status::kBadInput;
      return result;
    }
    result.models = *std::move(models);
  }
  result.checks = check_results(inputs, *result.reading.calibration, files);
  result.verdict = verdict_of(result);
  return result;
}

}  // namespace fca
