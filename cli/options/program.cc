// SPDX-License-Identifier: BSD-3-Clause
#include "program.h"

#include "words.h"

namespace fca::cli {

void add_program_option(Options& options, const std::string& help, const consumers::Consumer*& target) {
  options.group(OptionGroup::kProof);
  options.value("--for", "PROGRAM", help, [&target](const std::string& word) {
    target = find_program(word);
    return target != nullptr ? std::nullopt : std::optional(unknown_word("program", word, program_ids()));
  });
}

}  // namespace fca::cli
