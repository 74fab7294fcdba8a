// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/diagnostics.h>
#include <fca/formats/text/document.h>

#include <optional>

namespace fca::text {

/// The tag of bytes (b'..'), whose escapes stay as they are.
inline constexpr std::string_view kBytesTag = "tag:yaml.org,2002:binary";

/// Parses a literal of Python as ast.literal_eval takes it: dicts, lists, tuples, strings with any prefix but f, decimal
/// numbers, True, False and None, with comments and commas after the last value. Adjacent strings are one scalar. Numbers keep
/// their spelling; True and False are the scalars true and false without quotes; None is a null node that spans its word.
/// Sets, complex numbers, 0x10 and 1_000 are refused.
[[nodiscard]] std::optional<Node> parse_python(const Source& source, Diagnostics& diagnostics);

}  // namespace fca::text
