// SPDX-License-Identifier: BSD-3-Clause
#include "pair.h"

#include "columns.h"

#include <fca/code.h>
#include <fca/rig/limits.h>
#include <fca/rig/stereo_order.h>
#include <fca/rig/stereo_pair.h>

#include <algorithm>
#include <cmath>

namespace fca::orbslam3 {

namespace {

/// Does one set of intrinsics and a baseline say all of the pair? What differs less, a file in floats cannot say.
bool is_posed_as_rectified(const Rig& rig) {
  constexpr double kFloatPrecision = 1e-6;
  const std::optional<Transform> T_c1_c2 = rig.resolve(rig.cameras[0].name, rig.cameras[1].name);
  if (!T_c1_c2 || rig.cameras[0].model != rig.cameras[1].model) return false;
  Transform beside;
  beside(0, 3) = std::hypot((*T_c1_c2)(0, 3), (*T_c1_c2)(1, 3), (*T_c1_c2)(2, 3));
  return std::ranges::equal(T_c1_c2->values, beside.values,
                            [](double a, double b) { return std::abs(a - b) <= kFloatPrecision; });
}

/// Frame::ComputeStereoMatches searches the images as they are, along their rows; a lens with distortion bends those.
void warn_of_unrectified_camera(const Rig& rig, const Target& target, Diagnostics& diagnostics) {
  if (!target.sensor.two_cameras || rig.cameras.size() != 1 || is_rectified_pair(rig)) return;
  diagnostics.add(Code::kOrbslam3PairNotRectified, {rig.cameras.front().name});
}

/// One time stamp stands for both images of a pair.
void warn_of_unlike_times(const Rig& rig, Diagnostics& diagnostics) {
  const std::optional<double>& first = rig.cameras[0].time_offset_s;
  const std::optional<double>& second = rig.cameras[1].time_offset_s;
  if (!first || !second || std::abs(*first - *second) <= kSameClock) return;
  constexpr double kMsPerS = 1e3;
  diagnostics.add(Code::kOrbslam3PairNotSynchronous,
                  {rig.cameras[0].name, rig.cameras[1].name, kMsPerS * std::abs(*first - *second)});
}

}  // namespace

bool holds_pair(const Rig& rig, Style style) {
  const bool before_v1 = style == Style::kOld || style == Style::kOrbSlam2;
  if (!before_v1 || rig.cameras.size() < 2) return true;
  const Layout* layout = find_layout(style, model_info(rig.cameras[1].model).id);
  return (layout != nullptr && is_fisheye(*layout)) || is_posed_as_rectified(rig);
}

// Frame::ComputeStereoMatches searches along the rows of rectified images.
bool matches_along_rows(std::string_view model) {
  return std::ranges::none_of(layouts(), [model](const Layout& each) { return each.model == model && is_fisheye(each); });
}

bool check_pair(const Rig& rig, const Target& target, Diagnostics& diagnostics) {
  if (!target.sensor.two_cameras || holds_pair(rig, target.style)) return true;
  diagnostics.add(Code::kOrbslam3PairNotStorable);
  return false;
}

void warn_of_pair(const Rig& rig, const Target& target, Diagnostics& diagnostics) {
  warn_of_unrectified_camera(rig, target, diagnostics);
  if (!target.sensor.two_cameras || rig.cameras.size() < 2) return;
  const Layout* layout = find_layout(target.style, model_info(rig.cameras[0].model).id);
  const bool is_plane = layout != nullptr && !is_fisheye(*layout);
  if ((is_plane && common_view(rig, rig.cameras[0], rig.cameras[1]) == 0.0) || shares_no_columns(rig, target))
    diagnostics.add(Code::kOrbslam3NothingShared, {rig.cameras[0].name, rig.cameras[1].name});
  warn_of_unlike_times(rig, diagnostics);
}

}  // namespace fca::orbslam3
