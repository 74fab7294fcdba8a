// SPDX-License-Identifier: BSD-3-Clause
// Files that hold a rectified pair, or are for its images.
#pragma once

#include <fca/formats/calibration.h>
#include <fca/toolkit/rectify.h>

namespace fca {

/// Adds to the result the files in the request's format, and how its program reads them. False with errors.
[[nodiscard]] bool write_settings(const RectifyRequest& request, const Calibration& input, RectifyResult& result);

}  // namespace fca
