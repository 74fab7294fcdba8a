// SPDX-License-Identifier: BSD-3-Clause
// Single numbers of two rigs: IMU noise and rates, time offsets, baselines, frame rates.
#pragma once

#include "matching.h"

#include <fca/compare/report.h>
#include <fca/rig/rig.h>

namespace fca::internal {

/// Adds the numbers that both specify, the common mistakes that explain their differences, and what only one specifies.
void compare_facts(const Rig& reference, const Rig& other, const Matching& matching, RigComparison& result);

}  // namespace fca::internal
