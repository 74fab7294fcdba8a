// SPDX-License-Identifier: BSD-3-Clause
// Everything the command says: results on stdout, diagnostics on stderr; and what it reads from standard input.
#pragma once

#include "command_files.h"
#include "exit_code.h"
#include "streams.h"

#include <fca/diagnostics.h>
#include <fca/formats/text/source.h>
#include <fca/formats/verdict_value.h>

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fca::cli {

/// What scripts are to find on standard output.
enum class JsonShape : std::uint8_t { kNone, kDocument, kLines };

class Console {
 public:
  explicit Console(Streams& streams);

  /// What the command reads, into which diagnostics point.
  [[nodiscard]] Files& files() { return files_; }
  /// Renders to stderr, with colour on a terminal unless NO_COLOR is set.
  void show(const Diagnostics& diagnostics) const;
  /// The errors alone as they are printed. `sources`: what they point into.
  [[nodiscard]] std::string errors_in_words(const Diagnostics& diagnostics, std::span<const text::Source> sources) const;
  void error(const std::string& message, const std::string& fix = {}) const;
  /// An error that ends the command before it has a document of its own to print: as text, and under --json as a document, too.
  [[nodiscard]] ExitCode refuse(ExitCode code, const std::string& message, const std::string& fix = {}) const;
  /// The same with what was found on the way.
  [[nodiscard]] ExitCode refuse(ExitCode code, const Diagnostics& diagnostics) const;
  /// Was --json given, or --json-lines?
  void promise_json(JsonShape shape) { promised_ = shape; }
  /// Text for people, without control characters that a file may have brought in; to stdout, or next to it to stderr.
  void say(std::string_view text) const { out(text::printable(text, true)); }
  void print_stderr(std::string_view text) const { err(text::printable(text, true)); }
  /// The same of text that tells a verdict, which has its colour on a terminal unless NO_COLOR is set.
  void say(std::string_view text, VerdictWord word) const;
  void print_stderr(std::string_view text, VerdictWord word) const;
  /// Bytes as they are.
  void out(std::string_view text) const;
  void err(std::string_view text) const;
  /// Standard input.
  [[nodiscard]] std::istream& in() const { return streams_->in; }
  [[nodiscard]] Streams& streams() const { return *streams_; }
  /// Brings what was printed on its way.
  void flush() const { static_cast<void>(streams_->out.flush()); }
  /// Did writing to stdout fail (its reader is gone, the disk is full)? Then an endless input need not be read to its end.
  [[nodiscard]] bool failed() const;

  /// A file was put in its place.
  void note_written() const { wrote_ = true; }
  /// Flushes stdout; kIo (and a message) if what was printed did not arrive, kNotReported if all else is well and files are
  /// written.
  [[nodiscard]] ExitCode finish(ExitCode code) const;

  [[nodiscard]] const std::vector<text::Source>& sources() const { return files_.sources(); }

 private:
  void print_refusal(ExitCode code, const Diagnostics& diagnostics) const;

  Streams* streams_;
  CommandFiles files_;
  mutable std::atomic<bool> wrote_ = false;  ///< Images are written at the same time.
  bool colour_ = false;
  JsonShape promised_ = JsonShape::kNone;
};

}  // namespace fca::cli
