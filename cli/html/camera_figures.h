// SPDX-License-Identifier: BSD-3-Clause
// What is drawn of one camera, and of another next to it: a map over the image, bands, and curves over the angle.
#pragma once

#include "html.h"

#include <fca/convert/report.h>
#include <fca/rig/rig.h>

#include <optional>
#include <string>

namespace fca::cli {

struct DrawnCamera {
  const Camera& source;
  std::string source_label;  ///< For legends: "kb4", "reference (kb4)".

  /// The one next to it, in the same pixels; null: none, or the same.
  const CameraModel* target = nullptr;
  std::string target_label = {};
  const ErrorStatistics* statistics = nullptr;  ///< Of the two; null where there is none.
  double scored_to_deg = 0.0;                   ///< Nothing further from the axis was scored.
  std::string distance = "Error";               ///< What the statistics are about: "Error", "Difference".
  const Transform* turn = nullptr;              ///< Takes the source's rays to the target's; null: they have the same frame.

  const PixelUncertainty* uncertainty = nullptr;  ///< The source's own; null: not known.

  /// The rotation that brings the two nearest to each other (takes the source's rays to the target's); null: none is drawn.
  const Transform* rotation = nullptr;
  const ErrorStatistics* rotated = nullptr;  ///< With it undone.

  std::optional<double> limit_rad = {};  ///< What counts as lens, as it was given (--max-angle).

  /// Is there anything to see of the error?
  [[nodiscard]] bool errs() const;
};

void put_figures(Html& html, const DrawnCamera& camera);

}  // namespace fca::cli
