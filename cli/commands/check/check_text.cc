// SPDX-License-Identifier: BSD-3-Clause
#include "check_command.h"
#include "preview_text.h"
#include "shell/option_hints.h"
#include "shell/verdict_text.h"
#include "shell/words.h"

#include <fca/code.h>
#include <fca/formats/text/message.h>
#include <fca/formats/text/render.h>
#include <fca/formats/wording.h>
#include <fca/toolkit/format_name.h>

#include <algorithm>
#include <span>

namespace fca::cli {

namespace {

std::size_t count_of(const CheckReport& report, Severity severity) {
  return static_cast<std::size_t>(std::ranges::count(report.findings, severity, &Finding::severity));
}

std::string count_text(const CheckReport& report) {
  std::vector<std::string> parts;
  const std::size_t errors = count_of(report, Severity::kError);
  const std::size_t warnings = count_of(report, Severity::kWarning);
  const std::size_t notes = count_of(report, Severity::kNote);
  if (errors > 0) parts.push_back(counted(errors, "error"));
  if (warnings > 0) parts.push_back(counted(warnings, "warning"));
  if (notes > 0) parts.push_back(counted(notes, "note"));
  if (!parts.empty()) return enumerated(parts);
  return report.verdict.reasons.empty() ? "nothing wrong found" : "nothing wrong found in the file itself";
}

std::string finding_text(const Finding& finding, const text::Source& source) {
  std::string text =
      text::render(text::Shown{finding.severity, id_of(finding), message_of(finding, with_options), {}, finding.where},
                   std::span(&source, 1));
  const std::string consequence = consequence_of(finding, with_options);
  const std::string fix = fix_of(finding, with_options);
  if (!consequence.empty()) text += paragraph("if used: " + consequence, "    ");
  if (!fix.empty()) text += paragraph("fix: " + fix, "    ");
  return text;
}

/// The reasons of the verdict that findings do not tell: distances in pixels, and where it is worse than every finding all.
std::string reasons_text(const CheckReport& report) {
  const bool has_error = report.has(Severity::kError);
  const bool is_explained = has_error || (report.verdict.word != VerdictWord::kDoNotUse && report.has(Severity::kWarning));
  Verdict rest = report.verdict;
  std::erase_if(rest.reasons, [&](const Reason& reason) {
    const auto tells_it = [&reason](const Finding& finding) { return id_of(finding) == id_of(reason); };
    return !reason.distance && (is_explained || std::ranges::any_of(report.findings, tells_it));
  });
  std::vector<SummaryLine> lines = lines_of(rest);
  std::erase_if(lines, [](const SummaryLine& line) { return line.about == kAnyway; });  // nothing is written here
  return summary_text(lines);
}

std::string readers_line(const Readers& readers) {
  std::vector<std::string> names;
  for (const Readers::Program& program : readers.programs) {
    if (program.loads)
      names.push_back(program.program + (program.sensors.empty() ? "" : " (" + enumerated(program.sensors) + ")"));
  }
  return names.empty() ? "" : paragraph("read by " + enumerated(names), "  ");
}

}  // namespace

std::string check_text(const CheckResult& file, CheckDetail detail) {
  const CheckReport& report = file.report;
  std::string text = text::printable(file.source.name) + ": " + std::string(in_words(report.verdict.word)) + "; ";
  text += report.format == nullptr ? ""
                                   : std::string(name_of(*report.format, file.source).title) + " (" +
                                         (report.why.is_said() ? text::text_of(report.why, with_options) : "--from") + "); ";
  text += count_text(report) + "\n";
  text += reasons_text(report);
  for (const Finding& finding : report.findings) text += finding_text(finding, file.source);
  if (report.format == nullptr) return text;
  if (detail == CheckDetail::kFindings) return text;
  if (file.instead) text += preview_text(*file.instead);
  text += readers_line(report.readers);
  if (detail == CheckDetail::kUsual) {
    if (!report.undecided.empty()) text += "  " + counted(report.undecided.size(), "question") + " left open: -v\n";
    return text;
  }
  if (!report.checked.empty()) text += paragraph("checked: " + enumerated(text::texts_of(report.checked, with_options)), "  ");
  for (const Undecided& undecided : report.undecided)
    text += paragraph("not decidable: " + question_of(undecided, with_options) + "; " + why_of(undecided, with_options), "  ");
  return text;
}

std::string check_summary(const CheckedFiles& checked) {
  if (checked.files.size() < 2 && checked.skipped.empty()) return "";
  VerdictCounts words;
  for (const CheckResult& file : checked.files) words.add(file.report.verdict.word);
  const std::string text = counted(checked.files.size(), "file") + " checked: " + words.in_words();
  if (checked.skipped.empty()) return text + "\n";
  const std::string hold = checked.skipped.size() == 1 ? "holds" : "hold";
  return text + "; " + counted(checked.skipped.size(), "file") + " skipped that " + hold + " no calibration\n";
}

}  // namespace fca::cli
