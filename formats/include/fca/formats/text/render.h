// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/diagnostics.h>
#include <fca/formats/text/message.h>
#include <fca/formats/text/source.h>

#include <span>
#include <string>

namespace fca::text {

/// `file:line:column: error: message [code]`, the line with a caret, and the fix. Without a place: `error: message [code]`.
/// `sources`: the files the diagnostic may point into. `colour`: with terminal escapes.
/// `wording`: where the sentences of codes come from.
[[nodiscard]] std::string render(const Diagnostic& diagnostic, std::span<const Source> sources, bool colour = false,
                                 Wording wording = table_wording);

}  // namespace fca::text
