// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/application.h"
#include "options/show.h"
#include "shell/console.h"

#include <fca/toolkit/read.h>

#include <string>
#include <vector>

namespace fca::cli {

/// What one file means.
struct ShownFile : Reading {
  std::string file;
  double limit_deg = 180.0;  ///< What counts as lens, from the axis.
};

void add_show_command(Application& application);

/// One input, or several that are one rig.
[[nodiscard]] ShownFile read_shown(const ReadRequest& request, Files& files);
/// What was read, for the texts.
[[nodiscard]] ShownFile as_shown(Reading reading, const Inputs& inputs);

/// Of a file with a calibration or with readings.
[[nodiscard]] std::string show_text(const ShownFile& shown);
[[nodiscard]] std::string show_json(const std::vector<ShownFile>& files, const Console& console);

}  // namespace fca::cli
