// SPDX-License-Identifier: BSD-3-Clause
#include "process_output.h"

#include <cerrno>
#include <cstring>

#include <unistd.h>

namespace fca::cli {

void ProcessOutput::write(std::string_view bytes) { std::fwrite(bytes.data(), 1, bytes.size(), file_); }

std::optional<std::string> ProcessOutput::flush() {
  if (std::fflush(file_) == 0 && std::ferror(file_) == 0) return std::nullopt;
  return std::strerror(errno);
}

bool ProcessOutput::failed() const { return std::ferror(file_) != 0; }

bool ProcessOutput::is_terminal() const { return isatty(fileno(file_)) == 1; }

}  // namespace fca::cli
