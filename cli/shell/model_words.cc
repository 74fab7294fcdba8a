// SPDX-License-Identifier: BSD-3-Clause
#include "model_words.h"

#include "option_hints.h"

#include <fca/code.h>

namespace fca::cli {

std::vector<std::string> stored_by_in_words(const Candidate& candidate) {
  std::vector<std::string> names;
  for (const StoringFormat& format : candidate.stored_by) {
    const bool refitted = format.demands != Code::kNone;
    names.push_back(format.name + (refitted ? " (refitted: " + text::text_of({format.demands}, with_options) + ")" : ""));
  }
  return names;
}

}  // namespace fca::cli
