// SPDX-License-Identifier: BSD-3-Clause
// For the script that runs the entries: their names, and what each starts from.
#include "entries.h"

#include <cstdio>
#include <span>
#include <string_view>

int main(int count, char** words) {
  const std::span<char*> arguments(words, static_cast<std::size_t>(count));
  if (arguments.size() == 2 && std::string_view(arguments[1]) == "entries") {
    for (const fca::fuzz::Entry& entry : fca::fuzz::all_entries()) std::printf("%s\n", entry.name.c_str());
    return 0;
  }
  const fca::fuzz::Entry* entry = arguments.size() == 3 ? fca::fuzz::find_entry(arguments[2]) : nullptr;
  const std::string_view question = entry == nullptr ? "" : arguments[1];
  if (question == "seeds") {
    for (const std::filesystem::path& path : fca::fuzz::seeds_of(*entry)) std::printf("%s\n", path.c_str());
  } else if (question == "dictionary") {
    std::printf("%s", fca::fuzz::dictionary_of(*entry).c_str());
  } else {
    std::fprintf(stderr, "usage: fuzz-inputs entries | seeds ENTRY | dictionary ENTRY\n");
    return 2;
  }
  return 0;
}
