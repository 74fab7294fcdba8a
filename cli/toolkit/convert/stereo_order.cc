// SPDX-License-Identifier: BSD-3-Clause
#include "stereo_order.h"

#include <fca/code.h>
#include <fca/rig/stereo_order.h>

#include <algorithm>

namespace fca {

namespace {

/// The choice of cameras with the first two exchanged. nullopt is the choice of cameras 0 and 1.
std::vector<CameraChoice> swapped(const std::optional<std::vector<CameraChoice>>& cameras) {
  std::vector<CameraChoice> order = cameras.value_or(std::vector<CameraChoice>{{"0", 0}, {"1", 1}});
  std::swap(order[0], order[1]);
  return order;
}

}  // namespace

void warn_of_wrong_side(const Rig& rig, const ConvertRequest& request, const Message& first_is_left, ConvertResult& result) {
  if (!first_is_left.is_said()) return;
  const std::optional<double> left_m = second_left_of_first(rig);
  if (!left_m) return;
  Rig exchanged = rig;
  std::swap(exchanged.cameras[0], exchanged.cameras[1]);
  const std::vector<Argument> facts = {rig.cameras[1].name, 100.0 * *left_m, rig.cameras[0].name, first_is_left};
  if (second_left_of_first(exchanged)) {  // the axes differ so much that each camera is to the left of the other
    result.diagnostics.add(Code::kEachIsLeft, facts);
    return;
  }
  result.diagnostics.add(Code::kSecondIsLeft, facts);
  result.better_order = swapped(request.inputs.cameras);
}

}  // namespace fca
