// SPDX-License-Identifier: BSD-3-Clause
#include "output.h"

namespace fca::cli {

void add_json_option(Options& options, bool& json) {
  options.group(OptionGroup::kOutput);
  options.flag("--json", "One JSON document on standard output", json);
}

void add_force_option(Options& options, const std::string& help, bool& force) {
  options.group(OptionGroup::kOutput);
  options.flag("--force", help, force);
}

void add_jobs_option(Options& options, const std::string& what, std::size_t& jobs) {
  constexpr int kMost = 1024;
  options.group(OptionGroup::kOutput);
  options.count("--jobs", "N", what + " (default: as many as there are processors)", jobs, 1, kMost);
}

}  // namespace fca::cli
