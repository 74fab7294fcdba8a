// SPDX-License-Identifier: BSD-3-Clause
#include "output_names.h"

#include <algorithm>

namespace fca::cli {

std::vector<std::size_t> OutputNames::suspects() {
  std::ranges::sort(outputs_);
  std::vector<std::size_t> inputs;
  for (std::size_t i = 1; i < outputs_.size(); ++i) {
    if (outputs_[i].first == outputs_[i - 1].first) inputs.insert(inputs.end(), {outputs_[i - 1].second, outputs_[i].second});
  }
  std::ranges::sort(inputs);
  inputs.erase(std::unique(inputs.begin(), inputs.end()), inputs.end());
  return inputs;
}

}  // namespace fca::cli
