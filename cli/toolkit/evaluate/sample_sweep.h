// SPDX-License-Identifier: BSD-3-Clause
// How the number of samples affects the error and the duration of a conversion: Figure 2 of S. Lee, "Fisheye-Calib-Adapter",
// 2024.
#pragma once

#include <fca/toolkit/evaluate.h>

namespace fca {

/// Returns one sweep for each row of the table, except rows whose target model has no published calibration in the table.
[[nodiscard]] std::vector<SampleSweep> sample_sweeps(const EvaluatedTable& table);

}  // namespace fca
