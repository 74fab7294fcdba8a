// SPDX-License-Identifier: BSD-3-Clause
// Compares the inverse polynomials of files that contain a lens as two polynomials. The comparison of cameras uses the direct
// one, but programs that project use the inverse.
#include "compare/inverses.h"

#include <fca/formats/consumers/consumer.h>

#include <algorithm>
#include <cmath>

namespace fca {

std::optional<double> inverses_apart_px(const Calibration& reference, const Calibration& other) {
  const auto view_of = [](const Calibration& calibration) {
    const auto programs = consumers::all_consumers();
    const auto program = std::ranges::find_if(programs, [&calibration](const consumers::Consumer& each) {
      return each.by_inverse && each.format == calibration.format->id;
    });
    if (program == programs.end() || calibration.rig.cameras.size() != 1) return consumers::ConsumerView();
    return program->load(calibration.documents[calibration.with_cameras].source().bytes, {});
  };
  const consumers::ConsumerView here = view_of(reference);
  const consumers::ConsumerView there = view_of(other);
  if (here.cameras.empty() || there.cameras.empty()) return std::nullopt;
  const consumers::ConsumerCamera& right = here.cameras.front();
  const consumers::ConsumerCamera& left = there.cameras.front();
  if (right.width != left.width || right.height != left.height) return std::nullopt;
  const CameraModel& directions = reference.rig.cameras.front().model;
  constexpr int kSteps = 100;
  double worst = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const std::optional<Ray> ray =
          unproject(directions, {(right.width - 1.0) * i / kSteps, (right.height - 1.0) * j / kSteps});
      if (!ray) continue;
      const auto a = right.project(*ray);
      const auto b = left.project(*ray);
      if (a && b) worst = std::max(worst, std::hypot((*a)[0] - (*b)[0], (*a)[1] - (*b)[1]));
      if (a.has_value() != b.has_value()) worst = std::hypot(right.width, right.height);
    }
  }
  return worst;
}

}  // namespace fca
