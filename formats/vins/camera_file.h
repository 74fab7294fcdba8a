// SPDX-License-Identifier: BSD-3-Clause
// One camera as camodocal's files say it.
#pragma once

#include "layout.h"

#include <fca/formats/format.h>

#include <vector>

namespace fca::vins {

/// YAML with keys at its top.
[[nodiscard]] bool is_yaml(const text::Document& document);

/// Adds the camera of the document to the rig, or errors.
void read_camera_file(const text::Document& document, const ReadOptions& options, Rig& rig, Diagnostics& diagnostics);

/// OCamCalib's inverse polynomial as the document specifies it; empty where it has none.
[[nodiscard]] std::vector<double> stated_inverse(const text::Document& document);

}  // namespace fca::vins
