// SPDX-License-Identifier: BSD-3-Clause
#include <fca/code.h>
#include <fca/toolkit/status.h>

#include <algorithm>
#include <array>

namespace fca {

Status status_of(const Diagnostics& diagnostics) {
  if (!diagnostics.has_errors()) return Status::kDone;
  const auto has = [&diagnostics](Code code) {
    return std::ranges::any_of(diagnostics.entries(),
                               [code](const Diagnostic& entry) { return same_id(code_of(entry), code); });
  };
  if (has(Code::kAnyCannotRead)) return Status::kUnreadable;
  // Errors of the request itself, whatever the files contain.
  constexpr std::array kRequestErrors = {Code::kNoInput,          Code::kNoTarget,           Code::kUnknownCamera,
                                         Code::kUnitWithoutUse,   Code::kRectifyViewTooWide, Code::kCommonLensNeedsPair,
                                         Code::kPairFitNeedsPair, Code::kPairFitWithOthers};
  return std::ranges::any_of(kRequestErrors, has) ? Status::kBadRequest : Status::kBadInput;
}

}  // namespace fca
