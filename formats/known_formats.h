// SPDX-License-Identifier: BSD-3-Clause
// Files that are calibrations, but of formats fca-io does not read: people are told what they have.
#pragma once

#include <fca/formats/text/document.h>
#include <fca/message.h>

namespace fca {

/// That it looks like py-OCamCalib's JSON (taylor_coefficient and distortion_center); nothing if the document looks like none
/// that is known.
[[nodiscard]] Message looks_like(const text::Document& document);

}  // namespace fca
