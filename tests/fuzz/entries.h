// SPDX-License-Identifier: BSD-3-Clause
// What is fuzzed: an entry per syntax and, from the registry, one per format.
#pragma once

#include "promises.h"

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace fca::fuzz {

struct Entry {
  std::string name;  ///< "syntax-yaml", "kalibr"
  std::function<Complaints(std::string_view bytes)> run;
  /// Ids of the formats whose files it starts from.
  std::vector<std::string> seeds_of;
};

[[nodiscard]] const std::vector<Entry>& all_entries();
/// Null if there is none of that name.
[[nodiscard]] const Entry* find_entry(std::string_view name);

/// Files to start from: testdata's (good and bad), and the corpus' where it is there.
[[nodiscard]] std::vector<std::filesystem::path> seeds_of(const Entry& entry);

/// Words of those files, as a dictionary of libFuzzer: a line "\"word\"" each.
[[nodiscard]] std::string dictionary_of(const Entry& entry);

}  // namespace fca::fuzz
