// SPDX-License-Identifier: BSD-3-Clause
#include "stereo_order.h"

#include <fca/code.h>
#include <fca/rig/stereo_order.h>

#include <algorithm>

namespace fca {

namespace {

/// The choice of cameras with the first two exchanged.
std::vector<CameraChoice> swapped(const std::optional<std::vector<CameraChoice>>& cameras) {
  std::vector<CameraChoice> order = cameras.value_or(std::vector<CameraChoice>{{"0", 0}, {"1", 1}});
  std::swap(order[0], order[1]);
  return order;
}

}  // namespace

void warn_of_wrong_side(const Rig& rig, const ConvertRequest& request, const Message& first_is_left, ConvertResult& result) {
  if (!first_is_left.is_said()) return;
  const std::optional<double> left = second_left_of_first(rig);
  if (!left) return;
  Rig other = rig;
  std::swap(other.cameras[0], other.cameras[1]);
  const std::vector<Argument> facts = {rig.cameras[1].name, 100.0 * *left, rig.cameras[0].name, first_is_left};
  if (second_left_of_first(other)) {
    result.diagnostics.add(Code::kEachIsLeft, facts);
    return;
  }
  result.diagnostics.add(Code::kSecondIsLeft, facts);
  result.better_order = swapped(request.inputs.cameras);
}

}  // namespace fca
