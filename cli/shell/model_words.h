// SPDX-License-Identifier: BSD-3-Clause
// What a camera would be as another model, for people.
#pragma once

#include <fca/toolkit/models.h>

#include <string>
#include <vector>

namespace fca::cli {

/// "OpenVINS pinhole-radtan (refitted: it has no k3)": who stores the candidate's model, and who demands other numbers.
[[nodiscard]] std::vector<std::string> stored_by_in_words(const Candidate& candidate);

}  // namespace fca::cli
