// SPDX-License-Identifier: BSD-3-Clause
#include "output_names.h"

#include <algorithm>

namespace fca::cli {

std::vector<std::size_t> OutputNames::suspects() const {
  std::vector<std::pair<std::size_t, std::size_t>> sorted = outputs_;
  std::ranges::sort(sorted);
  std::vector<std::size_t> inputs;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first == sorted[i - 1].first) inputs.insert(inputs.end(), {sorted[i - 1].second, sorted[i].second});
  }
  std::ranges::sort(inputs);
  inputs.erase(std::unique(inputs.begin(), inputs.end()), inputs.end());
  return inputs;
}

}  // namespace fca::cli
