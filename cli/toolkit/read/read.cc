// SPDX-License-Identifier: BSD-3-Clause
#include <fca/code.h>
#include <fca/rig/first_camera.h>
#include <fca/toolkit/read.h>

#include <algorithm>
#include <utility>

namespace fca {

namespace {

/// True for the error that the lens model of an OpenCV file is ambiguous.
bool is_ambiguous_lens(const Diagnostic& entry) { return entry.facts.code == Code::kOpencvAmbiguousModel; }

/// Reads a file with the pinhole and with the fisheye model, if an ambiguous lens is its only error. Otherwise returns nothing.
/// If neither reading is possible, returns nothing and adds the errors of the fisheye reading.
std::vector<ReadingAs> readings_of_lenses(const Inputs& inputs, Diagnostics& diagnostics, Files& files) {
  const auto is_other_error = [](const Diagnostic& entry) {
    return entry.severity == Severity::kError && !is_ambiguous_lens(entry);
  };
  std::vector<ReadingAs> readings;
  Diagnostics other;  // further errors, if neither reading is possible
  if (std::ranges::none_of(diagnostics.entries(), is_ambiguous_lens) ||
      std::ranges::any_of(diagnostics.entries(), is_other_error))
    return readings;
  for (const OpenCvModel model : {OpenCvModel::kPinhole, OpenCvModel::kFisheye}) {
    Inputs assumed = inputs;
    assumed.opencv_model = model;
    Diagnostics found;
    std::optional<Calibration> calibration = read_calibration(assumed, files, found);
    if (calibration) {
      readings.push_back({model, {}, *std::move(calibration)});
    } else {
      other = std::move(found);
    }
  }
  if (!readings.empty()) return readings;
  for (const Diagnostic& entry : other.entries()) diagnostics.add(entry);
  return readings;
}

/// Reads a file that contains a lens for each of several image sizes once for each size. Empty for other files.
std::vector<ReadingAs> readings_of_sizes(const Inputs& inputs, const Diagnostics& diagnostics, Files& files) {
  std::vector<ReadingAs> readings;
  for (const ImageSize& size : offered_sizes(diagnostics)) {
    Inputs assumed = inputs;
    assumed.image_size = size;
    Diagnostics found;
    if (std::optional<Calibration> calibration = read_calibration(assumed, files, found))
      readings.push_back({{}, size, *std::move(calibration)});
  }
  return readings;
}

/// Replaces the errors about an ambiguous lens or image size by warnings.
Diagnostics as_warnings(const Diagnostics& diagnostics) {
  Diagnostics result;
  for (Diagnostic entry : diagnostics.entries()) {
    if (is_ambiguous_lens(entry) || entry.facts.code == Code::kDeviceSizeNeeded) entry.severity = Severity::kWarning;
    result.add(std::move(entry));
  }
  return result;
}

/// Checks the meaning of the file that contains the cameras.
std::vector<Finding> findings_of_check(const Calibration& calibration, const Inputs& inputs, const Diagnostics& diagnostics) {
  CheckOptions options;
  options.reading = read_options(inputs);
  options.from = calibration.format;
  options.max_angle_rad = inputs.max_angle_rad;
  std::vector<Finding> findings = findings_about_meaning(calibration.documents[calibration.with_cameras], calibration,
                                                         diagnostics, options, *calibration.format);
  // We can read a calibration without all of its parts, but the program cannot: for the program, a missing part is an error.
  for (Finding& finding : findings) {
    if (finding.facts.code != Code::kPartMissing) continue;
    finding.severity = Severity::kError;
    finding.facts.code = Code::kNamedPartMissing;
  }
  return findings;
}

}  // namespace

Inputs with_parts_recognised(const Inputs& inputs, Files& files) {
  constexpr std::size_t kMaxFiles = 4;
  if (inputs.join || inputs.files.size() < 2 || inputs.files.size() > kMaxFiles) return inputs;
  Inputs result = inputs;
  result.files.clear();
  for (const std::string& file : inputs.files) {
    Inputs single = inputs;
    single.files = {file};
    single.parts.clear();
    single.cameras.reset();
    Diagnostics discarded;
    const std::optional<Calibration> calibration = read_calibration(single, files, discarded);
    const bool is_part = calibration && calibration->rig.cameras.empty();
    (is_part ? result.parts : result.files).push_back(file);
  }
  return result.files.size() == 1 ? result : inputs;
}

Reading read(const ReadRequest& request, Files& files) {
  Reading reading;
  reading.calibration = read_calibration(request.inputs, files, reading.diagnostics);
  reading.status = status_of(reading.diagnostics);
  if (!reading.calibration) {
    reading.readings = readings_of_sizes(request.inputs, reading.diagnostics, files);
    if (reading.readings.empty()) reading.readings = readings_of_lenses(request.inputs, reading.diagnostics, files);
    if (reading.readings.empty()) return reading;
    reading.diagnostics = as_warnings(reading.diagnostics);
    reading.status = Status::kDone;
    return reading;
  }
  Calibration& calibration = *reading.calibration;
  if (request.inputs.cameras) {
    calibration.rig.poses = poses_of_first(calibration.rig);
    if (!calibration.poses_without_unit.empty()) calibration.poses_without_unit = calibration.rig.poses;
  }
  const Rig& rig = calibration.rig;
  const bool is_for_no_program =
      rig.cameras.empty() && rig.imus.empty() && rig.poses.empty() && !rig.uncertainties.empty();  // a report of uncertainty
  if (!is_for_no_program) {
    reading.readers = ask_readers(calibration.format->id, calibration.documents.front().source().bytes, !rig.cameras.empty(),
                                  load_options(read_options(request.inputs)));
  }
  if (request.program != nullptr) {
    const std::vector<Finding> findings = findings_of_check(calibration, request.inputs, reading.diagnostics);
    reading.asked = ask_program(*request.program, calibration, request.inputs, findings);
  }
  return reading;
}

std::string name_in(const Format& format, const StoredModel& row) {
  return std::string(format.program) + " " + std::string(row.file_name) + (row.stock ? "" : " (forks)");
}

std::vector<std::string> names_elsewhere(std::string_view model) {
  std::vector<std::string> names;
  for (const Format& format : written_formats()) {
    for (const StoredModel& row : format.models) {
      const std::string name = name_in(format, row);
      if (row.model == model && std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
  }
  return names;
}

bool has_assumed_unit(const PoseEdge& edge, const Calibration& calibration) {
  return std::ranges::find(calibration.poses_without_unit, edge.T_a_b, &PoseEdge::T_a_b) !=
         calibration.poses_without_unit.end();
}

CameraReading read_camera(const Inputs& inputs, Files& files) {
  CameraReading result;
  const std::optional<Calibration> calibration = read_models(inputs, files, result.diagnostics);
  if (calibration) {
    const std::vector<Camera>& cameras = calibration->rig.cameras;
    std::vector<std::string> names;
    names.reserve(cameras.size());
    for (const Camera& camera : cameras) names.push_back(camera.name);
    if (cameras.empty()) result.diagnostics.add(Code::kNoCameraInFile);
    if (cameras.size() > 1) result.diagnostics.add(Code::kWhichCamera, {cameras.size(), names});
    if (cameras.size() == 1) {
      for (const Message& problem : validate(cameras.front().model))
        result.diagnostics.add(Code::kNotACamera, {cameras.front().name, problem});
      if (!result.diagnostics.has_errors()) result.camera = cameras.front();
    }
  }
  if (!result.camera) result.status = worse(status_of(result.diagnostics), Status::kBadInput);
  return result;
}

}  // namespace fca
