// SPDX-License-Identifier: BSD-3-Clause
// The camera of a table of oracles/: as our reader gives it, and as the program that printed the table holds it.
#pragma once

#include "formats/oracle_table.h"

#include <fca/formats/consumers/consumer.h>

#include <algorithm>
#include <cmath>

namespace fca::test {

struct OracleCamera {
  CameraModel ours;
  consumers::ConsumerCamera theirs;
  /// The camera that the program computes with: ours, or where it misreads its second camera, that with the first one's lens
  /// coefficients (FORMATS.md 3.2). In pixels of the file.
  CameraModel in_program;
  [[nodiscard]] bool is_rescaled() const { return theirs.scale[0] != 1.0 || theirs.scale[1] != 1.0; }
};

/// `camera` with the lens coefficients of `other`.
inline CameraModel with_lens_of(CameraModel camera, const CameraModel& other) {
  for (const Parameter& each : model_info(camera).parameters) {
    const ParameterId id(each);
    const bool is_of_matrix =
        id == ParameterId("fx") || id == ParameterId("fy") || id == ParameterId("cx") || id == ParameterId("cy");
    if (is_of_matrix) continue;
    EXPECT_TRUE(set_parameter(camera, id, parameter(other, id).value_or(0.0)));
  }
  return camera;
}

/// Nothing, with a failure, where one of the two has no such camera.
inline std::optional<OracleCamera> oracle_camera(const consumers::Consumer& consumer, const OracleTable& table) {
  const std::string bytes = read_file(shared_dir() / "corpus" / table.file);
  const Calibration calibration = calibration_of(bytes);
  if (calibration.rig.cameras.size() <= table.camera) {
    ADD_FAILURE() << "our reader finds " << calibration.rig.cameras.size() << " cameras";
    return std::nullopt;
  }
  consumers::ConsumerView view = consumer.load(bytes, {"mono"});
  if (view.cameras.size() <= table.camera) view = consumer.load(bytes, {"stereo"});
  if (view.cameras.size() <= table.camera) {
    // A chain Kalibr's own reader stops at, whose cameras the oracle loaded one by one: MANIFEST.tsv.
    EXPECT_NE(table.file.find("4seasons"), std::string::npos);
    view = consumer.load(bytes.substr(0, bytes.find("T_cam1_cam0")), {"mono"});
  }
  if (view.cameras.size() <= table.camera) {
    ADD_FAILURE() << "the program finds " << view.cameras.size() << " cameras";
    return std::nullopt;
  }
  const CameraModel& ours = calibration.rig.cameras[table.camera].model;
  const consumers::ConsumerCamera& theirs = view.cameras[table.camera];
  return OracleCamera{ours, theirs, theirs.misread ? with_lens_of(ours, calibration.rig.cameras.front().model) : ours};
}

/// What separates two right implementations of one formula in the program's precision (oracles/README.md), in pixels.
inline double oracle_tolerance(const consumers::Consumer& consumer, const Pixel& pixel) {
  if (consumer.id == "kalibr") return 1e-9;
  return 2e-4 * std::max({1.0, std::abs(pixel[0]) / 1000.0, std::abs(pixel[1]) / 1000.0});
}

/// Whether the program's image radius falls anywhere between the axis and the ray, on the ray's azimuth.
inline bool folds_before(const consumers::ConsumerCamera& camera, const Ray& ray) {
  const double r = std::hypot(ray[0], ray[1]);
  const double end = std::atan2(r, ray[2]);
  const auto centre = camera.project({0.0, 0.0, 1.0});
  if (!centre || r == 0.0) return false;
  constexpr int kSteps = 4000;
  double last = 0.0;
  for (int i = 1; i <= kSteps; ++i) {
    const double angle = end * i / kSteps;
    const auto pixel = camera.project({std::sin(angle) * ray[0] / r, std::sin(angle) * ray[1] / r, std::cos(angle)});
    if (!pixel) return true;
    const double radius = std::hypot((*pixel)[0] - (*centre)[0], (*pixel)[1] - (*centre)[1]);
    if (radius < last) return true;
    last = radius;
  }
  return false;
}

}  // namespace fca::test
