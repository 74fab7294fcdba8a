// SPDX-License-Identifier: BSD-3-Clause
#include "output.h"

#include "words.h"

namespace fca::cli {

namespace {

constexpr const char* kOutput = "-o,--output";
constexpr const char* kVerbose = "-v,--verbose";

}  // namespace

void add_output_option(Options& options, const std::string& help, std::string& path) {
  options.group(OptionGroup::kOutput);
  options.value(kOutput, "PATH", help, path);
}

void add_output_option(Options& options, const std::string& help, OutputPlace& place) {
  options.group(OptionGroup::kOutput);
  options.value(kOutput, "PATH", help, [&place](const std::string& word) { return take_place(word, place); });
}

void add_verbose_option(Options& options, const std::string& help, bool& is_verbose) {
  options.group(OptionGroup::kOutput);
  options.flag(kVerbose, help, is_verbose);
}

void add_verbose_option(Options& options, const std::string& help, int& verbosity) {
  options.group(OptionGroup::kOutput);
  options.count(kVerbose, help, verbosity);
}

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
