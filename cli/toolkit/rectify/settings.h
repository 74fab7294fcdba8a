// SPDX-License-Identifier: BSD-3-Clause
// Writes settings files for programs that rectify images, or that use images that are already rectified.
#pragma once

#include <fca/formats/calibration.h>
#include <fca/toolkit/rectify.h>

namespace fca {

/// Writes the files in the request's format, and proves what its programs read from them. Adds files and proofs to the result.
/// False, with errors, if the format cannot store the pair.
[[nodiscard]] bool write_settings(const RectifyRequest& request, const Calibration& input, RectifyResult& result);

}  // namespace fca
