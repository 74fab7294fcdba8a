// SPDX-License-Identifier: BSD-3-Clause
// Where results go and how they are told: options that several commands have.
#pragma once

#include "options.h"
#include "shell/output_name.h"

#include <cstddef>
#include <string>

namespace fca::cli {

/// -o
void add_output_option(Options& options, const std::string& help, OutputPlace& place);
/// -v
void add_verbose_option(Options& options, const std::string& help, bool& is_verbose);
/// -v and -vv
void add_verbose_option(Options& options, const std::string& help, int& verbosity);
/// -q
void add_quiet_option(Options& options, const std::string& help, bool& is_quiet);
/// --json
void add_json_option(Options& options, bool& json);
/// --json-lines, of commands whose inputs may be many; it goes before --json.
void add_json_lines_option(Options& options, bool& json_lines);
/// --force; `help` says what is overwritten.
void add_force_option(Options& options, const std::string& help, bool& force);
/// --jobs; `what` is worked on at the same time.
void add_jobs_option(Options& options, const std::string& what, std::size_t& jobs);

}  // namespace fca::cli
