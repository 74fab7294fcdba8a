// SPDX-License-Identifier: BSD-3-Clause
// The paper's Figure 2: what the number of samples does to a conversion and its duration.
#pragma once

#include <fca/toolkit/evaluate.h>

namespace fca {

/// Of every row of a table that is evaluated.
[[nodiscard]] std::vector<SampleSweep> sample_sweeps(const EvaluatedTable& table);

}  // namespace fca
