// SPDX-License-Identifier: BSD-3-Clause
#include "refusal.h"

namespace fca::text {

std::optional<Refusal> find_conflict_marker(const Source& source) {
  for (const std::string_view marker : {"<<<<<<< ", ">>>>>>> "}) {
    std::size_t at = source.bytes.find(marker);
    while (at != std::string::npos && at > 0 && source.bytes[at - 1] != '\n') at = source.bytes.find(marker, at + 1);
    if (at == std::string::npos) continue;
    return Refusal{"merge-conflict", "a git merge-conflict marker: the file holds two versions of these lines",
                   "keep one version and delete the marker lines", at};
  }
  return std::nullopt;
}

}  // namespace fca::text
