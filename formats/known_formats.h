// SPDX-License-Identifier: BSD-3-Clause
// Files that are calibrations, but of formats fca-io does not read: people are told what they have.
#pragma once

#include <fca/formats/text/document.h>

#include <string>

namespace fca {

/// "Basalt's calibration JSON (value0 with intrinsics)"; empty if the document looks like none that is known.
[[nodiscard]] std::string looks_like(const text::Document& document);

}  // namespace fca
