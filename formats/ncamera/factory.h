// SPDX-License-Identifier: BSD-3-Clause
// vikit's older files, which SVO's tests still have (vikit_cameras, camera_factory.cpp): a mapping of plain keys for each
// camera, under its name. They are only read.
#pragma once

#include <fca/formats/format.h>

namespace fca::ncamera {

[[nodiscard]] bool is_factory_file(const text::Document& document);
[[nodiscard]] std::optional<Rig> read_factory_file(const text::Document& document, const ReadOptions& options,
                                                   Diagnostics& diagnostics);

}  // namespace fca::ncamera
