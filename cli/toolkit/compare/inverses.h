// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/formats/calibration.h>

#include <optional>

namespace fca {

/// The value of ComparedFile::inverse_px: the largest distance [px] between the pixels of two files' inverse polynomials.
/// nullopt if a file has none.
[[nodiscard]] std::optional<double> inverses_apart_px(const Calibration& reference, const Calibration& other);

}  // namespace fca
