// SPDX-License-Identifier: BSD-3-Clause
#include "command.h"
#include "shell/process_output.h"

#include <csignal>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  // A closed pipe is an error to report (exit 4), not a death without words.
  std::signal(SIGPIPE, SIG_IGN);
  fca::cli::ProcessOutput out(stdout);
  fca::cli::ProcessOutput err(stderr);
  fca::cli::Streams streams = {std::cin, out, err};
  const std::vector<std::string> words(argv + 1, argv + argc);
  return fca::cli::run(words, streams, fca::cli::origin_of_build());
}
