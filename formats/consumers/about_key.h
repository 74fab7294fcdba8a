// SPDX-License-Identifier: BSD-3-Clause
// Complaints about a key.
#pragma once

#include <fca/formats/consumers/consumer.h>

#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace fca::consumers {

/// A complaint at `key` whose sentence names it: argument 0, `more` follow.
[[nodiscard]] inline Complaint about_key(Code code, const std::string& key, std::vector<Argument> more = {}) {
  std::vector<Argument> arguments = {key};
  arguments.insert(arguments.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  return {code, key, std::move(arguments)};
}

}  // namespace fca::consumers
