// SPDX-License-Identifier: BSD-3-Clause
#include "refusal.h"

#include <fca/formats/text/limits.h>

namespace fca::text {

Refusal too_long(std::size_t offset) {
  return {"too-long", "more than " + std::to_string(kLongestList) + " values in one list; no calibration has so many", "",
          offset};
}

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
