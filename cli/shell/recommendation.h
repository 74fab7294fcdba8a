// SPDX-License-Identifier: BSD-3-Clause
// Which camera model to take, for people.
#pragma once

#include <fca/toolkit/models.h>

#include <string>
#include <vector>

namespace fca::cli {

/// In a sentence or two: for a reader of that format; null: for any, and what to take next to it.
[[nodiscard]] std::string recommendation(const std::vector<Candidate>& candidates, const Format* to);

}  // namespace fca::cli
