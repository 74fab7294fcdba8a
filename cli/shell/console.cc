// SPDX-License-Identifier: BSD-3-Clause
#include "console.h"

#include "diagnostics_json.h"
#include "json.h"

#include <fca/formats/text/render.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <unistd.h>

namespace fca::cli {

Console::Console() : colour_(isatty(STDERR_FILENO) == 1 && std::getenv("NO_COLOR") == nullptr) {}

void Console::out(std::string_view text) const { std::fwrite(text.data(), 1, text.size(), stdout); }
void Console::err(std::string_view text) const { std::fwrite(text.data(), 1, text.size(), stderr); }

bool Console::failed() const { return std::ferror(stdout) != 0; }

void Console::show(const Diagnostics& diagnostics) const {
  for (const Diagnostic& entry : diagnostics.entries()) err(text::render(entry, sources_, colour_));
}

void Console::show_errors(const Diagnostics& diagnostics) const {
  for (const Diagnostic& entry : diagnostics.entries()) {
    if (entry.severity == Severity::kError) err(text::render(entry, sources_, colour_));
  }
}

void Console::error(const std::string& message, const std::string& fix) const {
  err(text::render({Severity::kError, "", message, fix, {}}, sources_, colour_));
}

ExitCode Console::refuse(ExitCode code, const std::string& message, const std::string& fix) const {
  Diagnostics diagnostics;
  diagnostics.error(code == ExitCode::kUsage ? "usage" : "refused", message, {}, fix);
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
  if (!json_promised_) return;
  Json json;
  json.object([&] {
    json.put("fca_io", FCA_VERSION);
    json.put("exit_code", static_cast<int>(code));
    put_diagnostics(json, diagnostics, *this);
  });
  out(json.document());
}

ExitCode Console::finish(ExitCode code) const {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  error(std::string("writing to standard output failed: ") + std::strerror(errno));
  return worse(code, ExitCode::kIo);
}

ExitCode code_of(const Diagnostics& diagnostics) {
  if (!diagnostics.has_errors()) return ExitCode::kGood;
  const auto has = [&diagnostics](std::string_view code) {
    return std::ranges::find(diagnostics.entries(), code, &Diagnostic::code) != diagnostics.entries().end();
  };
  if (has("cannot-read")) return ExitCode::kIo;
  return has("unknown-camera") ? ExitCode::kUsage : ExitCode::kBadInput;
}

}  // namespace fca::cli
