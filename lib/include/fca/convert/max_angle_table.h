// SPDX-License-Identifier: BSD-3-Clause
// The angle at which the lens ends decides how good a conversion is, and a file rarely contains it.
#pragma once

#include <fca/convert/convert.h>
#include <fca/convert/report.h>
#include <fca/diagnostics.h>
#include <fca/rig/rig.h>

#include <string_view>
#include <vector>

namespace fca {

/// Has no camera of that model a pixel for rays at 90 degrees from the axis and beyond? True of what projects to a plane.
[[nodiscard]] bool is_perspective(std::string_view model_id);

/// The errors of the same conversion inside 90, 95, 100, ... degrees from the axis, up to and including the field of view's
/// angle: one fit per row, evaluated inside its own angle. Empty where there is no such choice: options.max_angle_rad is given,
/// the camera's lens circle is known, or the field of view ends within 90 degrees. Black corners of an image are not lens, but
/// no file tells them apart (TUM-VI kb4 -> eucm: 2.91 px at most over the whole image, 0.20 px inside the lens).
///
/// A row whose conversion fails is left out; its diagnostics are not repeated. Errors of the camera itself are.
[[nodiscard]] std::vector<MaxAngleRow> max_angle_table(const Camera& camera, const ConvertOptions& options,
                                                       Diagnostics& diagnostics);

/// The same where that conversion has been made: `report` is what convert() says of that camera with these options. Saves the
/// fits that it made already.
[[nodiscard]] std::vector<MaxAngleRow> max_angle_table(const Camera& camera, const ConvertOptions& options,
                                                       const ConversionReport& report, Diagnostics& diagnostics);

}  // namespace fca
