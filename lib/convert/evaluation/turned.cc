// SPDX-License-Identifier: BSD-3-Clause
#include "turned.h"

#include "stages.h"

#include <fca/convert/evaluate.h>
#include <fca/rig/rotation.h>

namespace fca::internal {

ErrorStatistics evaluate_turned(const CameraModel& source, const CameraModel& target, const Transform& T_target_source,
                                const FieldOfView& field_of_view, double max_angle_rad, bool every_pixel) {
  const Projection image_of = [&](const Ray& ray) { return project(target, rotated(T_target_source, ray)); };
  const Scorer scorer{source, nullptr, &image_of, field_of_view, max_angle_rad};
  return evaluate_all(scorer, score_on_lattice(scorer), {every_pixel, false});
}

bool covers_as_much(const ErrorStatistics& before, const ErrorStatistics& after) {
  constexpr double kLargestLoss = 1e-3;
  return after.coverage.scored >= before.coverage.scored - kLargestLoss;
}

}  // namespace fca::internal
