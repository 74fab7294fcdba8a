// SPDX-License-Identifier: BSD-3-Clause
#include "preview_text.h"

#include "commands/convert/convert_command.h"
#include "shell/option_hints.h"
#include "shell/words.h"

#include <fca/formats/wording.h>

#include <algorithm>

namespace fca::cli {

namespace {

std::string camera_text(const ConvertedCamera& camera) {
  const std::string text = camera.source.name + ": " + camera_line(camera);
  if (!camera.report || camera.report->exact) return text;
  const ErrorSummary& error = camera.report->judgement.error;
  return text + ": rms " + pixels(error.rms) + " px, max " + pixels(error.max) + " px";
}

/// "a; b; c" in lines behind `indent`, or nothing.
std::string list_text(const std::string& heading, const std::vector<std::string>& parts, const std::string& indent) {
  if (parts.empty()) return "";
  std::string text = heading;
  for (const std::string& part : parts) text += (&part == &parts.front() ? "" : "; ") + part;
  return paragraph(text, indent);
}

/// "a, b and c (no place for it)", a reason once.
std::vector<std::string> losses_by_reason(const std::vector<Loss>& losses) {
  std::vector<std::string> reasons;
  for (const Loss& loss : losses) {
    std::string why = why_of(loss, with_options);
    if (std::ranges::find(reasons, why) == reasons.end()) reasons.push_back(std::move(why));
  }
  std::vector<std::string> texts;
  for (const std::string& reason : reasons) {
    std::vector<std::string> lost;
    for (const Loss& loss : losses) {
      if (why_of(loss, with_options) == reason) lost.push_back(what_of(loss, with_options));
    }
    texts.push_back(enumerated(lost, "and") + " (" + reason + ")");
  }
  return texts;
}

}  // namespace

std::string preview_text(const ConvertResult& outcome, const std::string& indent) {
  const auto& entries = outcome.diagnostics.entries();
  const auto error = std::ranges::find(entries, Severity::kError, &Diagnostic::severity);
  if (error != entries.end()) {
    const std::string fix = fix_of(*error, with_options);
    return paragraph("convert would not write it: " + message_of(*error, with_options) + (fix.empty() ? "" : " (" + fix + ")"),
                     indent);
  }
  std::string text = paragraph("convert would write " + text::text_of(outcome.headline, with_options), indent);
  for (const ConvertedCamera& camera : outcome.cameras) text += indent + "  " + camera_text(camera) + "\n";
  const std::vector<std::string> losses = losses_by_reason(outcome.losses);
  std::vector<std::string> made_up;
  for (const bool look_at_it : {true, false}) {  // those first
    for (const DefaultedValue& value : outcome.defaults) {
      if (value.look_at_it == look_at_it) made_up.push_back(text_of(value, with_options));
    }
  }
  text += list_text("lost: ", losses, indent + "  ") + list_text("made up: ", made_up, indent + "  ");
  for (const ProofResult& proof : outcome.proofs) {
    if (proof.misread_px > 0.0)
      text += paragraph(proof.program + " misreads it by up to " + pixels(proof.misread_px) + " px", indent + "  ");
  }
  return text;
}

}  // namespace fca::cli
