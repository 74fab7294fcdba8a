// SPDX-License-Identifier: BSD-3-Clause
// For a program that takes one camera's distortion for all: cameras of one model that share it.
#pragma once

#include <fca/convert/convert.h>
#include <fca/rig/rig.h>

#include <optional>
#include <span>
#include <vector>

namespace fca {

/// Those models with the lens parameters (ParameterGroup::kLens: k1 ... k4 of kb4) of the first: what such a program uses.
[[nodiscard]] std::vector<CameraModel> with_lens_of_first(std::span<const CameraModel> models);

/// The least-squares fit, in pixels over the cameras' fields of view, of models with common lens parameters to the sources,
/// each with its own focal lengths and principal point. The cameras count alike, their pixels by `weight`. `start`: one model
/// for each source, all of one kind, to begin with. Nothing, with an error, where a source has no field of view or a step leads
/// nowhere.
[[nodiscard]] std::optional<std::vector<CameraModel>> fit_common_lens(std::span<const Camera> sources,
                                                                      std::span<const CameraModel> start,
                                                                      std::optional<double> max_angle_rad,
                                                                      Diagnostics& diagnostics, const FitWeight& weight = {});

}  // namespace fca
