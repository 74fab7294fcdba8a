// SPDX-License-Identifier: BSD-3-Clause
// Files for a rectified pair, or for its rectified images.
#pragma once

#include <fca/formats/calibration.h>
#include <fca/toolkit/rectify.h>

namespace fca {

/// Adds the files in the request's format, and the proofs that its programs read them, to the result. False with errors.
[[nodiscard]] bool write_settings(const RectifyRequest& request, const Calibration& input, RectifyResult& result);

}  // namespace fca
