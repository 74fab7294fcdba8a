// SPDX-License-Identifier: BSD-3-Clause
#include "output.h"

#include <filesystem>
#include <system_error>

namespace fca::cli {

namespace {

constexpr const char* kVerbose = "-v,--verbose";

/// A folder ends with a slash or is there.
OutputPlace output_place(const std::string& word) {
  if (word == "-") return {OutputPlace::Kind::kStandardOutput, ""};
  if (word.find('{') != std::string::npos) return {OutputPlace::Kind::kPattern, word};
  std::error_code error;  // what cannot be asked is no folder; writing will tell
  const bool is_folder = word.ends_with('/') || std::filesystem::is_directory(word, error);
  return {is_folder ? OutputPlace::Kind::kFolder : OutputPlace::Kind::kFile, word};
}

}  // namespace

void add_output_option(Options& options, const std::string& help, OutputPlace& place) {
  options.group(OptionGroup::kOutput);
  options.value("-o,--output", "PATH", help, [&place](const std::string& word) {
    place = output_place(word);
    return std::nullopt;
  });
}

void add_verbose_option(Options& options, const std::string& help, bool& is_verbose) {
  options.group(OptionGroup::kOutput);
  options.flag(kVerbose, help, is_verbose);
}

void add_verbose_option(Options& options, const std::string& help, int& verbosity) {
  options.group(OptionGroup::kOutput);
  options.count(kVerbose, help, verbosity);
}

void add_quiet_option(Options& options, const std::string& help, bool& is_quiet) {
  options.group(OptionGroup::kOutput);
  options.flag("-q,--quiet", help, is_quiet);
}

void add_json_option(Options& options, bool& json) {
  options.group(OptionGroup::kOutput);
  options.flag("--json", "One JSON document on standard output", json, OptionKey::kJson);
}

void add_json_lines_option(Options& options, bool& json_lines) {
  options.group(OptionGroup::kOutput);
  options.flag("--json-lines", "One line of JSON for each input, with the content of --json", json_lines,
               OptionKey::kJsonLines);
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
