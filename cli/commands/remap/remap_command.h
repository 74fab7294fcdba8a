// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/console.h"
#include "toolkit/reading.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace fca::cli {

struct RemapArguments {
  std::string file;
  std::vector<std::string> images;
  ReadingOptions reading;
  std::string model;
  std::string like;
  std::optional<double> pinhole_deg;  ///< The full field of view, from the left border to the right one.
  std::string out_size;               ///< "640x480"
  std::string rotate;                 ///< "yaw,pitch,roll", degrees
  std::string interpolation = "bilinear";
  std::string output;
  std::string mask;
  std::string map;
  std::size_t jobs = 0;  ///< 0: as many as there are processors
  bool force = false;
  bool json = false;
};

void add_remap_command(CLI::App& app, RemapArguments& arguments, std::function<ExitCode(Console&)>& run);

}  // namespace fca::cli
