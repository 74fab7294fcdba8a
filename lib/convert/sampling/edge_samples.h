// SPDX-License-Identifier: BSD-3-Clause
// Samples on the edge of a field of view.
#pragma once

#include <fca/convert/field_of_view.h>
#include <fca/convert/lens.h>
#include <fca/models/camera_model.h>

#include <vector>

namespace fca::internal {

/// Adds points on the edge of the field of view to `samples`, with weights near 0. Without them, a fitted model could have a
/// pole or a shrinking image radius between the outermost sample and the edge: the cost of the fit would not change, but the
/// errors of the pixels there would be large.
void add_edge(const CameraModel& source, const FieldOfView& field_of_view, std::vector<Correspondence>& samples);

}  // namespace fca::internal
