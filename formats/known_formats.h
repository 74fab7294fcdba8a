// SPDX-License-Identifier: BSD-3-Clause
// Files that are calibrations, but of formats fca-io does not read: people are told what they have.
#pragma once

#include <fca/formats/text/document.h>

#include <string>

namespace fca {

/// "py-OCamCalib's JSON (taylor_coefficient and distortion_center)"; empty if the document looks like none that is known.
[[nodiscard]] std::string looks_like(const text::Document& document);

}  // namespace fca
