// SPDX-License-Identifier: BSD-3-Clause
// How a camera file is spelled.
#pragma once

#include "layout.h"

#include <fca/formats/format.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fca::vins {

[[nodiscard]] bool is_scaramuzza(const Camera& camera);

/// An inverse polynomial for the camera, told in `written`; empty for models that have none.
[[nodiscard]] std::vector<double> fitted_inverse(const Camera& camera, Written& written, Diagnostics& diagnostics);

/// A section's lines, or its one line where `flow`; without a last line break.
[[nodiscard]] std::string spelled(const Section& section, bool flow);

/// As cv::FileStorage writes it for camodocal. `name`: the camera's; `file`: the document's.
[[nodiscard]] std::optional<text::Document> fresh_camera_file(const Camera& camera, std::string_view name,
                                                              const std::string& file, Written& written,
                                                              Diagnostics& diagnostics);

}  // namespace fca::vins
