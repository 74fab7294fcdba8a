// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/diagnostics.h>
#include <fca/formats/text/document.h>

#include <optional>

namespace fca::text {

/// Parses YAML, plain or OpenCV's dialect, with yaml-cpp. Spans are those of the source's bytes.
[[nodiscard]] std::optional<Node> parse_yaml(const Source& source, Syntax syntax, Diagnostics& diagnostics);

}  // namespace fca::text
