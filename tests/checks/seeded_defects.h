// SPDX-License-Identifier: BSD-3-Clause
// Defects to plant in good files, in three lists: facts, spellings, structure.
#pragma once

#include "seeded_files.h"

#include <functional>

namespace fca::test {

/// A defect, and what must be reported of it.
struct SeededDefect {
  std::string name;
  std::vector<std::string> codes;  ///< One of them must be reported.
  /// The file's bytes with the defect; nothing where it has no such place, or where that is no defect to its program.
  std::function<std::optional<std::string>(const Good&)> plant;
  /// Does the finding in the damaged file stand where the defect does? Null: the defect is of the file as a whole.
  std::function<bool(const Good&, const text::Source&, const Finding&)> is_placed;
  int at_least = 20;              ///< In how many files of testdata and corpus it must have been planted.
  const char* program = nullptr;  ///< Whose reading is checked, if not that of the format's own (--for).
};

/// Facts made wrong by the format's own writer: the text stays as the program wants it.
std::vector<SeededDefect> seeded_facts();
/// Numbers and words spelled as the program does not read them, or too large or small for what they are.
std::vector<SeededDefect> seeded_spellings();
/// Keys, lists, matrices and blocks that are missing, too many, or not what they should be.
std::vector<SeededDefect> seeded_structure();

/// Is the place a number that was not there before?
bool is_new_number(const Good& good, const text::Source& damaged, const Finding& finding);

}  // namespace fca::test
