// SPDX-License-Identifier: BSD-3-Clause
// Where the command reads and writes: the streams of the process, or memory where it is called by a test.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

namespace fca::cli {

class Output {
 public:
  Output() = default;
  virtual ~Output() = default;
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  virtual void write(std::string_view bytes) = 0;
  /// Why something of what was written did not arrive; nothing if all of it did.
  virtual std::optional<std::string> flush() = 0;
  /// Did writing fail so far?
  [[nodiscard]] virtual bool failed() const = 0;
  [[nodiscard]] virtual bool is_terminal() const = 0;
};

struct Streams {
  std::istream& in;
  Output& out;
  Output& err;
};

}  // namespace fca::cli
