// SPDX-License-Identifier: BSD-3-Clause
// The camera near a least-squares fit whose largest error over the domain is smallest.
#pragma once

#include "../evaluation/scorer.h"

#include <fca/convert/convert.h>

#include <span>
#include <string>
#include <vector>

namespace fca::internal {

/// A camera after the search, and the number of steps that led there.
struct MinimaxFit {
  CameraModel model;
  int iterations = 0;
  std::vector<std::string> at_bound;
};

/// Minimises the largest error of `start` over the rays that it reaches, within the ranges. The points are a few of the judge's
/// lattice and of the lens's edge, and then, again and again, all where the error turns out to be larger than on the others
/// (Remez' exchange, but no point is given up). Every one of them stays in the target's domain, so that no coverage is traded
/// for a smaller error. A minimum near `start`: no other basin is looked for. What the judge says of it is the caller's to ask:
/// the largest error of the result may even be the larger one where nothing was to be gained.
[[nodiscard]] MinimaxFit fit_largest_error(const CameraModel& source, const CameraModel& start, const Domain& domain,
                                           double target_reach_rad, std::span<const ParameterRange> ranges);

}  // namespace fca::internal
