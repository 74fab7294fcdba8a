// SPDX-License-Identifier: BSD-3-Clause
// The paper's Figure 2: how the number of samples affects a conversion and its duration.
#pragma once

#include <fca/toolkit/evaluate.h>

namespace fca {

/// One sweep for each row of a table that contains a calibration in the target's model.
[[nodiscard]] std::vector<SampleSweep> sample_sweeps(const EvaluatedTable& table);

}  // namespace fca
