// SPDX-License-Identifier: BSD-3-Clause
#include "command.h"

#include "commands/check/check_command.h"
#include "commands/compare/compare_command.h"
#include "commands/convert/convert_command.h"
#include "commands/evaluate/evaluate_command.h"
#include "commands/lists/list_commands.h"
#include "commands/points/project_command.h"
#include "commands/rectify/rectify_command.h"
#include "commands/remap/remap_command.h"
#include "commands/report/report_command.h"
#include "commands/show/show_command.h"
#include "commands/version/version_command.h"
#include "options/application.h"
#include "shell/option_hints.h"
#include "shell/spool.h"

#include <fca/formats/consumers/missing_module.h>

#include <exception>
#include <new>
#include <string>

namespace fca::cli {

namespace {

ExitCode run_words(std::span<const std::string> words, Streams& streams, const Origin& origin) {
  Console console(streams);
  Application application;
  add_convert_command(application);
  add_show_command(application);
  add_check_command(application);
  add_compare_command(application);
  add_report_command(application);
  add_remap_command(application);
  add_rectify_command(application);
  add_project_commands(application);
  add_list_commands(application);
  add_evaluate_command(application);
  add_version_command(application, origin);
  return console.finish(application.run(words, console));
}

}  // namespace

int run(std::span<const std::string> words, Streams& streams, const Origin& origin) {
  const auto fail = [&streams](ExitCode code, const std::string& message) {
    streams.err.write("fca-io: " + message + "\n");
    return static_cast<int>(code);
  };
  try {
    return static_cast<int>(run_words(words, streams, origin));
  } catch (const consumers::MissingModule& error) {
    return fail(ExitCode::kIo,
                text::text_of(error.facts, with_options) +
                    "; install fca-io, for images also fca-io-images (the tarball has no images), or allow more memory "
                    "(ulimit -v)");
  } catch (const SpoolFailure& error) {
    return fail(ExitCode::kIo, std::string("what was converted cannot be read again: ") + error.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::kIo, "not enough memory; allow it more (ulimit -v)");
  } catch (const std::exception& error) {
    return fail(ExitCode::kBug, std::string("a bug, please report it: ") + error.what());
  } catch (...) {
    return fail(ExitCode::kBug, "a bug, please report it: an exception of no known kind");
  }
}

}  // namespace fca::cli
