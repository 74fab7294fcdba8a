// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/convert/field_of_view.h>
#include <fca/convert/lens.h>
#include <fca/models/camera_model.h>

#include <vector>

namespace fca::internal {

/// Adds points on the field of view's edge, with weights near 0, to its samples. Without them, a pole or a radius that turns
/// back between the outermost sample and the edge would not change a fit's cost, but would spoil the pixels there.
void add_edge(const CameraModel& source, const FieldOfView& field_of_view, std::vector<Correspondence>& samples);

}  // namespace fca::internal
