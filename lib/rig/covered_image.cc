// SPDX-License-Identifier: BSD-3-Clause
#include <fca/rig/covered_image.h>

#include <array>
#include <variant>

namespace fca {

namespace {

bool is_round(const CameraModel& model) {
  return std::visit(
      []<class M>(const Intrinsics<M>& /*model*/) {
        if constexpr (requires { M::kRound; }) return M::kRound;
        return false;
      },
      model);
}

}  // namespace

bool is_surely_covered(const CameraModel& model, const ImageSize& size) {
  if (!is_round(model)) return false;
  const double right = size.width - 1.0;
  const double bottom = size.height - 1.0;
  const std::array<Pixel, 4> corners = {{{0.0, 0.0}, {right, 0.0}, {0.0, bottom}, {right, bottom}}};
  for (const Pixel& corner : corners) {
    if (!unproject(model, corner)) return false;
  }
  return true;
}

}  // namespace fca
