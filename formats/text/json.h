// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/diagnostics.h>
#include <fca/formats/text/document.h>

#include <optional>

namespace fca::text {

/// Parses strict JSON with RapidJSON. Numbers keep their spelling; true and false are scalars without quotes; null is a null
/// node that spans its word. "type_id": "opencv-matrix" in an object is the tag that YAML spells !!opencv-matrix.
[[nodiscard]] std::optional<Node> parse_json(const Source& source, Diagnostics& diagnostics);

}  // namespace fca::text
