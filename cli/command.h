// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/origin.h"
#include "shell/streams.h"

#include <span>
#include <string>

namespace fca::cli {

/// The command: words after "fca-io" in, exit code out (shell/exit_code.h). Throws nothing; an error is written to
/// streams.err. Who calls it decides what a closed pipe does (SIGPIPE). `origin`: what `version` says of the build.
[[nodiscard]] int run(std::span<const std::string> words, Streams& streams, const Origin& origin = {});

}  // namespace fca::cli
