// SPDX-License-Identifier: BSD-3-Clause
#include <fca/code.h>
#include <fca/rig/first_camera.h>
#include <fca/toolkit/read.h>

#include <algorithm>
#include <utility>

namespace fca {

namespace {

bool asks_for_lens(const Diagnostic& entry) { return entry.facts.code == Code::kOpencvAmbiguousModel; }

/// The readings of a file as pinhole and as fisheye, if only its lens is ambiguous; otherwise empty. If neither reading is
/// possible, adds the other errors.
std::vector<ReadingAs> both_readings(const Inputs& inputs, Diagnostics& diagnostics, Files& files) {
  const auto is_other_error = [](const Diagnostic& entry) {
    return entry.severity == Severity::kError && !asks_for_lens(entry);
  };
  std::vector<ReadingAs> readings;
  Diagnostics other;  // further errors, if neither reading is possible
  if (std::ranges::none_of(diagnostics.entries(), asks_for_lens) || std::ranges::any_of(diagnostics.entries(), is_other_error))
    return readings;
  for (const OpenCvModel model : {OpenCvModel::kPinhole, OpenCvModel::kFisheye}) {
    Inputs as = inputs;
    as.opencv_model = model;
    Diagnostics found;
    std::optional<Calibration> calibration = read_calibration(as, files, found);
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

/// The readings of a file that has a lens for each image size, one per size; empty for other files.
std::vector<ReadingAs> readings_of_sizes(const Inputs& inputs, const Diagnostics& diagnostics, Files& files) {
  std::vector<ReadingAs> readings;
  for (const ImageSize& size : offered_sizes(diagnostics)) {
    Inputs as = inputs;
    as.image_size = size;
    Diagnostics found;
    if (std::optional<Calibration> calibration = read_calibration(as, files, found))
      readings.push_back({{}, size, *std::move(calibration)});
  }
  return readings;
}

Diagnostics as_warnings(const Diagnostics& diagnostics) {
  Diagnostics result;
  for (Diagnostic entry : diagnostics.entries()) {
    if (asks_for_lens(entry) || entry.facts.code == Code::kDeviceSizeNeeded) entry.severity = Severity::kWarning;
    result.add(std::move(entry));
  }
  return result;
}

/// The findings about the meaning of the file that contains the cameras.
std::vector<Finding> findings_in(const Calibration& calibration, const Inputs& inputs, const Diagnostics& diagnostics) {
  CheckOptions options;
  options.reading = read_options(inputs);
  options.from = calibration.format;
  options.max_angle_rad = inputs.max_angle_rad;
  std::vector<Finding> findings = findings_about_meaning(calibration.documents[calibration.with_cameras], calibration,
                                                         diagnostics, options, *calibration.format);
  // Reading does not need every part of the calibration, but the program does: a missing part is an error for it.
  for (Finding& finding : findings) {
    if (finding.facts.code != Code::kPartMissing) continue;
    finding.severity = Severity::kError;
    finding.facts.code = Code::kNamedPartMissing;
  }
  return findings;
}

}  // namespace

Inputs with_parts_recognised(const Inputs& inputs, Files& files) {
  constexpr std::size_t kMost = 4;
  if (inputs.join || inputs.files.size() < 2 || inputs.files.size() > kMost) return inputs;
  Inputs result = inputs;
  result.files.clear();
  for (const std::string& file : inputs.files) {
    Inputs one = inputs;
    one.files = {file};
    one.parts.clear();
    one.cameras.reset();
    Diagnostics discarded;
    const std::optional<Calibration> calibration = read_calibration(one, files, discarded);
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
    if (reading.readings.empty()) reading.readings = both_readings(request.inputs, reading.diagnostics, files);
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
    const std::vector<Finding> findings = findings_in(calibration, request.inputs, reading.diagnostics);
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
