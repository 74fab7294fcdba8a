// SPDX-License-Identifier: BSD-3-Clause
// Files that hold a rectified pair, or are for its images.
#pragma once

#include <fca/formats/calibration.h>
#include <fca/toolkit/rectify.h>

namespace fca {

/// Adds to the result the files of the format that is asked for, and what its program makes of them. False with errors.
[[nodiscard]] bool write_settings(const RectifyRequest& request, const Calibration& input, RectifyResult& result);

}  // namespace fca
