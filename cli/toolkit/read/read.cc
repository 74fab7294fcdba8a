// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/first_camera.h>
#include <fca/toolkit/read.h>

#include <algorithm>

namespace fca {

Reading read(const ReadRequest& request, Files& files) {
  Reading reading;
  reading.calibration = read_calibration(request.inputs, files, reading.diagnostics);
  reading.status = status_of(reading.diagnostics);
  if (!reading.calibration) return reading;
  Calibration& calibration = *reading.calibration;
  if (request.inputs.cameras) {
    calibration.rig.poses = poses_of_first(calibration.rig);
    if (!calibration.poses_without_unit.empty()) calibration.poses_without_unit = calibration.rig.poses;
  }
  reading.readers = ask_readers(calibration.format->id, calibration.documents.front().source().bytes,
                                !calibration.rig.cameras.empty(), {{}, std::string(name_of(request.inputs.opencv_model))});
  if (request.program != nullptr) reading.asked = ask_program(*request.program, calibration, request.inputs);
  return reading;
}

std::string name_in(const Format& format, const StoredModel& row) {
  return std::string(format.program) + " " + std::string(row.file_name) + (row.stock ? "" : " (forks)");
}

std::vector<std::string> names_elsewhere(std::string_view model) {
  std::vector<std::string> names;
  for (const Format& format : all_formats()) {
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

}  // namespace fca
