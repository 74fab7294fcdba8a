// SPDX-License-Identifier: BSD-3-Clause
// The camera through which remap looks at an image.
#pragma once

#include "commands/remap/remap_command.h"
#include "shell/console.h"

#include <fca/rig/rig.h>
#include <fca/rig/transform.h>

#include <optional>
#include <string>

namespace fca::cli {

struct RemapView {
  Camera camera;
  Transform T_source_view;  ///< A rotation.
};

/// Why the options do not say one view, in a sentence.
[[nodiscard]] std::optional<std::string> problem_with_view(const RemapArguments& arguments);

/// The view on the image of `source` that the options ask for; nothing with errors.
[[nodiscard]] std::optional<RemapView> view_of(const RemapArguments& arguments, const Camera& source, Console& console,
                                               Diagnostics& diagnostics);

}  // namespace fca::cli
