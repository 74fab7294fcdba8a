// SPDX-License-Identifier: BSD-3-Clause
#include <fca/toolkit/status.h>

#include <string_view>

namespace fca {

Status status_of(const Diagnostics& diagnostics) {
  if (!diagnostics.has_errors()) return Status::kDone;
  const auto has = [&diagnostics](std::string_view code) {
    return std::ranges::any_of(diagnostics.entries(), [code](const Diagnostic& entry) { return id_of(entry) == code; });
  };
  if (has("cannot-read")) return Status::kUnreadable;
  return has("unknown-camera") ? Status::kBadRequest : Status::kBadInput;
}

}  // namespace fca
