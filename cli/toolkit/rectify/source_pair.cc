// SPDX-License-Identifier: BSD-3-Clause
#include "source_pair.h"

#include <fca/code.h>
#include <fca/rectify/rectify.h>
#include <fca/rig/stereo_pair.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace fca {

namespace {

/// The pair of a file that contains one camera without distortion for both rectified images.
SourcePair of_rectified_images(const Rig& rig) {
  SourcePair result;
  const Camera& camera = rig.cameras.front();
  result.cameras = {camera, camera};
  result.cameras[0].name = "left";
  result.cameras[1].name = "right";
  result.is_rectified = true;
  RectifiedPair pair;
  const auto value = [&camera](ParameterId id) { return parameter(camera.model, id).value(); };
  pair.focal_lengths = {value("fx"), value("fy")};
  for (std::size_t i = 0; i < 2; ++i) pair.views.at(i) = {result.cameras.at(i).name, {}, {value("cx"), value("cy")}};
  pair.offset_m = *rig.baseline_m;
  result.T_second_first = pose_of(pair);
  result.stated = pair;
  return result;
}

/// True if the rig only has a baseline and one camera without distortion.
bool is_of_rectified_images(const Rig& rig) {
  if (rig.cameras.size() != 1 || !rig.baseline_m) return false;
  const CameraModel& model = rig.cameras.front().model;
  if (model_info(model).id == "pinhole") return true;
  const std::span<const double> lens = parameter_values(model).subspan(4);
  return model_info(model).id == "radtan" && std::ranges::all_of(lens, [](double value) { return value == 0.0; });
}

/// The indices of the pair's cameras in the rig: those of its rectification if it has one, else its only two cameras, else its
/// stereo pair. nullopt if there is none.
std::optional<std::pair<std::size_t, std::size_t>> indices_of_pair(const Rig& rig) {
  if (rig.rectified) {
    const auto index_of = [&rig](std::size_t view) {
      const auto found = std::ranges::find(rig.cameras, rig.rectified->views.at(view).camera, &Camera::name);
      return static_cast<std::size_t>(found - rig.cameras.begin());
    };
    if (index_of(0) < rig.cameras.size() && index_of(1) < rig.cameras.size()) return std::pair{index_of(0), index_of(1)};
  }
  if (rig.cameras.size() == 2) return std::pair<std::size_t, std::size_t>{0, 1};
  return stereo_pair(rig);
}

}  // namespace

std::optional<SourcePair> source_pair(const Rig& rig, const std::string& file, Diagnostics& diagnostics) {
  const auto refuse = [&](Code code, std::vector<Argument> facts) {
    diagnostics.add(code, std::move(facts), {file, 0, 0});
    return std::nullopt;
  };
  if (rig.rectified && rig.rectified->sources.size() == 2) {
    const std::vector<Camera>& sources = rig.rectified->sources;
    return SourcePair{{sources[0], sources[1]}, pose_of(*rig.rectified), rig.rectified, false};
  }
  if (is_of_rectified_images(rig)) return of_rectified_images(rig);
  if (rig.cameras.size() < 2) return refuse(Code::kRectifyNeedsPair, {rig.cameras.size()});
  const auto indices = indices_of_pair(rig);
  if (!indices) return refuse(Code::kRectifyWhichPair, {rig.cameras.size()});
  SourcePair result;
  result.cameras = {rig.cameras[indices->first], rig.cameras[indices->second]};
  const auto& [first, second] = result.cameras;
  const std::optional<Transform> T = rig.resolve(second.name, first.name);
  if (!T) return refuse(Code::kRectifyNoPose, {first.name, second.name});
  result.T_second_first = *T;
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  if (common_view(rig, first, second) == 0.0) {
    const double cosine = std::clamp((*T)(2, 2), -1.0, 1.0);
    return refuse(Code::kRectifyNothingShared, {first.name, second.name, std::acos(cosine) * kDegrees});
  }
  const bool is_stated =
      rig.rectified && rig.rectified->views[0].camera == first.name && rig.rectified->views[1].camera == second.name;
  if (is_stated) result.stated = rig.rectified;
  return result;
}

}  // namespace fca
