// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/console.h"
#include "toolkit/program_reading.h"
#include "toolkit/reading.h"

#include <fca/formats/proof.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace fca::cli {

struct ShowArguments {
  std::vector<std::string> files;
  ReadingOptions reading;
  std::string program;  ///< --for
  bool json = false;
};

/// What one file means.
struct ShownFile {
  std::string file;
  std::optional<Calibration> calibration;
  Readers readers;
  std::optional<ProgramReading> asked;  ///< --for
  double limit_deg = 180.0;             ///< --max-angle
  Diagnostics diagnostics;
};

void add_show_command(CLI::App& app, ShowArguments& arguments, std::function<ExitCode(Console&)>& run);

/// One input, or several that are one rig (--join).
[[nodiscard]] ShownFile read_shown(const std::vector<std::string>& files, const ShowArguments& arguments, Console& console);

/// "Kalibr pinhole-equidistant"
[[nodiscard]] std::string name_in(const Format& format, const StoredModel& row);
/// What all formats call a model, from the registry.
[[nodiscard]] std::vector<std::string> names_elsewhere(std::string_view model);

[[nodiscard]] std::string show_text(const ShownFile& shown);
[[nodiscard]] std::string show_json(const std::vector<ShownFile>& files, const Console& console);

}  // namespace fca::cli
