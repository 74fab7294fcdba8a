// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "commands/remap/remap_images.h"
#include "options/application.h"
#include "options/rectify.h"

#include <array>
#include <string>
#include <vector>

namespace fca::cli {

void add_rectify_command(Application& application);

/// What was done.
struct Rectifying {
  RectifyResult result;
  std::vector<std::string> settings;  ///< Paths of its files; empty: standard output.
  std::vector<std::string> maps;      ///< Paths of the left and the right one; empty: none.
  std::array<std::vector<RemappedImage>, 2> images;
};

[[nodiscard]] std::string rectify_text(const RectifyArguments& arguments, const Rectifying& done);
[[nodiscard]] std::string rectify_json(const RectifyArguments& arguments, const Rectifying& done, ExitCode code,
                                       const Console& console);

}  // namespace fca::cli
