// SPDX-License-Identifier: BSD-3-Clause
#include "stereo_order.h"

#include "camera_names.h"
#include "words.h"

#include <fca/rig/stereo_order.h>

#include <algorithm>

namespace fca {

namespace {

/// The first two cameras the other way round, as the request names them; the others after them.
std::vector<CameraChoice> swapped(const std::optional<std::vector<CameraChoice>>& cameras) {
  std::vector<CameraChoice> order = cameras.value_or(std::vector<CameraChoice>{{"0", 0}, {"1", 1}});
  std::swap(order[0], order[1]);
  return order;
}

}  // namespace

void warn_of_wrong_side(const Rig& rig, const ConvertRequest& request, const std::string& first_is_left,
                        ConvertResult& result) {
  if (first_is_left.empty()) return;
  const std::optional<double> left = second_left_of_first(rig);
  if (!left) return;
  Rig other = rig;
  std::swap(other.cameras[0], other.cameras[1]);
  const std::string what =
      rig.cameras[1].name + " sits " + fixed(100.0 * *left, 2) + " cm to the left of " + rig.cameras[0].name;
  if (second_left_of_first(other)) {
    result.diagnostics.warning(
        "stereo-order",
        with_names_of_file(what + ", and " + rig.cameras[0].name + " to the left of " + rig.cameras[1].name, result.cameras) +
            ": they do not look the same way, the same way up; " + first_is_left,
        {}, "is their pose right (show says it in words)? If so, they are no left and right camera");
    return;
  }
  result.diagnostics.warning("stereo-order", with_names_of_file(what, result.cameras) + "; " + first_is_left);
  result.better_order = swapped(request.inputs.cameras);
}

}  // namespace fca
