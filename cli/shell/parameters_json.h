// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json.h"

#include <fca/rig/rig.h>

namespace fca::cli {

/// The object "parameters" of an open object: by name, in the model's order.
inline void put_parameters(Json& json, const CameraModel& model) {
  json.object("parameters", [&] {
    const std::span<const Parameter> parameters = model_info(model).parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) json.put(parameters[i].name, parameter_values(model)[i]);
  });
}

/// Of a camera: a table of rays has none.
inline void put_parameters(Json& json, const Camera& camera) {
  if (camera.rays.empty()) {
    put_parameters(json, camera.model);
  } else {
    json.object("parameters", [] {});
  }
}

}  // namespace fca::cli
