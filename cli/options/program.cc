// SPDX-License-Identifier: BSD-3-Clause
#include "program.h"

#include "words.h"

namespace fca::cli {

void add_program_option(Options& options, const std::string& help, const consumers::Consumer*& target) {
  options.group(OptionGroup::kProof);
  options.value("--for", "PROGRAM", help, [&target](const std::string& word) {
    target = find_program(word);
    if (target != nullptr) return std::optional<std::string>();
    return std::optional(unknown_program(word));
  });
}

}  // namespace fca::cli
