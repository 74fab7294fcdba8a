// SPDX-License-Identifier: BSD-3-Clause
// Compares the inverse polynomials of files that describe a lens by two polynomials. The comparison of cameras uses the direct
// polynomial (pixel to ray), but programs that project use the inverse polynomial (ray to pixel).
#include "compare/inverses.h"

#include <fca/formats/consumers/consumer.h>

#include <algorithm>
#include <cmath>

namespace fca {

std::optional<double> inverse_distance_px(const Calibration& reference, const Calibration& other) {
  // The camera as a program that projects by the inverse polynomial loads it; empty if no program reads the format so.
  const auto view_of = [](const Calibration& calibration) {
    const auto programs = consumers::all_consumers();
    const auto program = std::ranges::find_if(programs, [&calibration](const consumers::Consumer& each) {
      return each.by_inverse && each.format == calibration.format->id;
    });
    if (program == programs.end() || calibration.rig.cameras.size() != 1) return consumers::ConsumerView();
    return program->load(calibration.documents[calibration.with_cameras].source().bytes, {});
  };
  const consumers::ConsumerView reference_view = view_of(reference);
  const consumers::ConsumerView other_view = view_of(other);
  if (reference_view.cameras.empty() || other_view.cameras.empty()) return std::nullopt;
  const consumers::ConsumerCamera& reference_camera = reference_view.cameras.front();
  const consumers::ConsumerCamera& other_camera = other_view.cameras.front();
  if (reference_camera.width != other_camera.width || reference_camera.height != other_camera.height) return std::nullopt;
  const CameraModel& reference_model = reference.rig.cameras.front().model;
  constexpr int kSteps = 100;  // of a lattice along each side of the image
  double worst = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const std::optional<Ray> ray = unproject(
          reference_model, {(reference_camera.width - 1.0) * i / kSteps, (reference_camera.height - 1.0) * j / kSteps});
      if (!ray) continue;
      const auto a = reference_camera.project(*ray);
      const auto b = other_camera.project(*ray);
      if (a && b) worst = std::max(worst, std::hypot((*a)[0] - (*b)[0], (*a)[1] - (*b)[1]));
      // A pixel that one of them lacks counts as the image's diagonal.
      if (a.has_value() != b.has_value()) worst = std::max(worst, std::hypot(reference_camera.width, reference_camera.height));
    }
  }
  return worst;
}

}  // namespace fca
