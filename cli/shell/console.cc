// SPDX-License-Identifier: BSD-3-Clause
#include "console.h"

#include "compact_json.h"
#include "diagnostics_json.h"
#include "json.h"
#include "option_hints.h"
#include "verdict_text.h"

#include <fca/code.h>
#include <fca/formats/text/render.h>

#include <cstdlib>

namespace fca::cli {

namespace {

bool shows_colour(const Output& output) { return output.is_terminal() && std::getenv("NO_COLOR") == nullptr; }

}  // namespace

Console::Console(Streams& streams) : streams_(&streams), files_(streams), colour_(shows_colour(streams.err)) {}

void Console::say(std::string_view text, VerdictWord word) const {
  const std::string shown = text::printable(text, true);
  out(shows_colour(streams_->out) ? with_colour(shown, word) : shown);
}

void Console::print_stderr(std::string_view text, VerdictWord word) const {
  const std::string shown = text::printable(text, true);
  err(shows_colour(streams_->err) ? with_colour(shown, word) : shown);
}

void Console::out(std::string_view text) const { streams_->out.write(text); }
void Console::err(std::string_view text) const { streams_->err.write(text); }

bool Console::failed() const { return streams_->out.failed(); }

void Console::show(const Diagnostics& diagnostics) const {
  for (const Diagnostic& entry : diagnostics.entries()) err(text::render(entry, sources(), colour_, with_options));
}

std::string Console::errors_in_words(const Diagnostics& diagnostics, std::span<const text::Source> sources) const {
  std::string text;
  for (const Diagnostic& entry : diagnostics.entries()) {
    if (entry.severity == Severity::kError) text += text::render(entry, sources, colour_, with_options);
  }
  return text;
}

void Console::error(const std::string& message, const std::string& fix) const {
  err(text::render(text::Shown{Severity::kError, "", message, fix}, sources(), colour_));
}

ExitCode Console::refuse(ExitCode code, const std::string& message, const std::string& fix) const {
  Diagnostics diagnostics;
  diagnostics.add(code == ExitCode::kUsage ? Code::kUsage : Code::kRefused, {message, fix});
  error(message, fix);
  print_refusal(code, diagnostics);
  return code;
}

ExitCode Console::refuse(ExitCode code, const Diagnostics& diagnostics) const {
  show(diagnostics);
  print_refusal(code, diagnostics);
  return code;
}

void Console::print_refusal(ExitCode code, const Diagnostics& diagnostics) const {
  if (promised_ == JsonShape::kNone) return;
  Json json;
  json.object([&] {
    json.put("fca_io", FCA_VERSION);
    json.put("exit_code", static_cast<int>(code));
    put_diagnostics(json, diagnostics, *this);
  });
  out(promised_ == JsonShape::kLines ? compact(json.text()) + "\n" : json.document());
}

ExitCode Console::finish(ExitCode code) const {
  const std::optional<std::string> problem = streams_->out.flush();
  if (!problem) return code;
  error("writing to standard output failed: " + *problem);
  return worse(code, code == ExitCode::kGood && wrote_ ? ExitCode::kNotReported : ExitCode::kIo);
}

}  // namespace fca::cli
