// SPDX-License-Identifier: BSD-3-Clause
// DSO's camera.txt: see camera_txt.h. TUM-VI's folder has such files next to its chains, and that format reads and writes them,
// too, where it is told to.
#pragma once

#include <fca/formats/format.h>

namespace fca::dso {

extern const Format kFormat;

/// Is it lines of words?
[[nodiscard]] bool is_camera_txt(const text::Document& document);

/// A camera.txt for each camera of the rig: the base, which says `old`, with the numbers of its own camera, and fresh ones.
/// Nothing, and `why` says why, a clause, if one of them cannot be.
[[nodiscard]] std::optional<Written> written(const text::Document* base, const std::optional<Rig>& old, const Rig& rig,
                                             Message& why, Diagnostics& diagnostics);

}  // namespace fca::dso
