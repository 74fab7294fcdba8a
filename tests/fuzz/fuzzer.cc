// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer's side. FCA_FUZZ_ENTRY names the entry: libFuzzer starts itself again for some of its modes, and a variable goes
// with it.
#include "entries.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace {

const fca::fuzz::Entry& chosen_entry() {
  const char* name = std::getenv("FCA_FUZZ_ENTRY");
  const fca::fuzz::Entry* entry = name == nullptr ? nullptr : fca::fuzz::find_entry(name);
  if (entry != nullptr) return *entry;
  std::fprintf(stderr, "FCA_FUZZ_ENTRY is to name an entry:");
  for (const fca::fuzz::Entry& each : fca::fuzz::all_entries()) std::fprintf(stderr, " %s", each.name.c_str());
  std::fprintf(stderr, "\n");
  std::exit(2);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fca::fuzz::Entry& entry = chosen_entry();
  const fca::fuzz::Complaints complaints = entry.run({reinterpret_cast<const char*>(data), size});
  for (const std::string& complaint : complaints) std::fprintf(stderr, "%s: %s\n", entry.name.c_str(), complaint.c_str());
  if (!complaints.empty()) std::abort();
  return 0;
}
