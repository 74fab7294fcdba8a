// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/formats/calibration.h>

#include <optional>

namespace fca {

/// ComparedFile::inverse_px
[[nodiscard]] std::optional<double> inverses_apart_px(const Calibration& reference, const Calibration& other);

}  // namespace fca
