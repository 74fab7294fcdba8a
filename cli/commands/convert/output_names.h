// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace fca::cli {

/// The paths of a batch's outputs, of which it keeps no more than numbers.
class OutputNames {
 public:
  void add(std::size_t input, const std::string& path) { outputs_.emplace_back(std::hash<std::string>{}(path), input); }

  /// The inputs, in their order, of which an output may have the path of another one: all that have one, and hardly others.
  [[nodiscard]] std::vector<std::size_t> suspects();

 private:
  std::vector<std::pair<std::size_t, std::size_t>> outputs_;  ///< Hash of the path, and whose it is.
};

}  // namespace fca::cli
