// SPDX-License-Identifier: BSD-3-Clause
#include "lists.h"

#include "inputs.h"
#include "output.h"

namespace fca::cli {

void add_formats_options(Options& options, ListArguments& arguments) {
  add_json_option(options, arguments.json);
  add_verbose_option(options, "Also the models of each format, and who reads them", arguments.verbose);
  options.flag("--markdown", "The table of the README", arguments.markdown);
  options.flag("--ledger", "For every pair of formats: what is exact, fitted, dropped and defaulted", arguments.ledger);
  options.footer("Example:\n  fca-io formats\n  fca-io formats --ledger\n");
}

void add_models_options(Options& options, ListArguments& arguments) {
  options.one_positional("FILE", "Calibration file", arguments.inputs.files, false);
  add_input_options(options, arguments.inputs);
  options.group(OptionGroup::kOutput);
  add_json_option(options, arguments.json);
  options.footer("Example:\n  fca-io models camchain.yaml --max-angle 97.5\n");
}

void add_programs_options(Options& options, ListArguments& arguments) {
  add_json_option(options, arguments.json);
  options.footer("Example:\n  fca-io programs\n");
}

void add_version_options(Options& options, ListArguments& arguments) {
  add_json_option(options, arguments.json);
  options.footer("Example:\n  fca-io version\n");
}

}  // namespace fca::cli
