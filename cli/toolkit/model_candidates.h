// SPDX-License-Identifier: BSD-3-Clause
// Every model that a camera could be written as, what that costs, and who reads it.
#pragma once

#include <fca/convert/convert.h>
#include <fca/formats/format.h>

#include <optional>
#include <string>
#include <vector>

namespace fca::cli {

/// One model as a camera's target. No conversion: it cannot describe the camera, `diagnostics` say why.
struct Candidate {
  const ModelInfo* model = nullptr;
  std::optional<Conversion> conversion;
  std::vector<std::string> stored_by;
  Diagnostics diagnostics;
};

[[nodiscard]] std::vector<Candidate> candidates(const Camera& camera, std::optional<double> max_angle_rad);

/// The candidate to take: the camera's own model if it is exact, else the one that covers most and errs least. Of those that
/// the stock program of `format` reads, if one is given. Null where there is none.
[[nodiscard]] const Candidate* recommended(const std::vector<Candidate>& candidates, const Format* format);

/// The same among all but `other`.
[[nodiscard]] const Candidate* recommended_beside(const std::vector<Candidate>& candidates, const Candidate& other);

}  // namespace fca::cli
