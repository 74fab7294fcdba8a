// SPDX-License-Identifier: BSD-3-Clause
#include "program.h"

#include "words.h"

#include <fca/formats/program_names.h>

namespace fca::cli {

void add_program_option(Options& options, const std::string& help, const consumers::Consumer*& target) {
  options.group(OptionGroup::kProof);
  options.value("--for", "PROGRAM", help, [&target](const std::string& word) {
    target = find_program(word);
    if (target != nullptr) return std::optional<std::string>();
    // A program that is known, and that nobody here can ask.
    if (find_program_name(word) != nullptr) return std::optional(unknown_target("--for", word));
    return std::optional(unknown_word("program", word, program_ids()));
  });
}

}  // namespace fca::cli
