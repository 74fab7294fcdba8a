// SPDX-License-Identifier: BSD-3-Clause
#include "refusal.h"

#include <fca/formats/text/limits.h>
#include <fca/formats/text/node.h>

namespace fca::text {

Refusal too_deep(std::size_t offset) { return {{Code::kTooDeep, {kMaxDepth}}, offset}; }

Refusal too_long(std::size_t offset) { return {{Code::kListTooLong, {kLongestList}}, offset}; }

std::optional<Refusal> find_conflict_marker(const Source& source) {
  for (const std::string_view marker : {"<<<<<<< ", ">>>>>>> "}) {
    std::size_t at = source.bytes.find(marker);
    while (at != std::string::npos && at > 0 && source.bytes[at - 1] != '\n') at = source.bytes.find(marker, at + 1);
    if (at == std::string::npos) continue;
    return Refusal{{Code::kMergeConflict}, at};
  }
  return std::nullopt;
}

}  // namespace fca::text
