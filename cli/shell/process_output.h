// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "streams.h"

#include <cstdio>

namespace fca::cli {

/// stdout or stderr of the process.
class ProcessOutput : public Output {
 public:
  explicit ProcessOutput(std::FILE* file) : file_(file) {}

  void write(std::string_view bytes) override;
  std::optional<std::string> flush() override;
  [[nodiscard]] bool failed() const override;
  [[nodiscard]] bool is_terminal() const override;

 private:
  std::FILE* file_;
};

}  // namespace fca::cli
