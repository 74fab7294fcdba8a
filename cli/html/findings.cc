// SPDX-License-Identifier: BSD-3-Clause
#include "sections.h"

#include "said.h"
#include "shell/diagnostics_json.h"
#include "shell/option_hints.h"
#include "shell/words.h"

#include <fca/formats/text/source.h>
#include <fca/formats/wording.h>

#include <algorithm>

namespace fca::cli {

namespace {

/// "camchain.yaml, line 7"; nothing where it is about no place.
std::string place_of(const SourceRange& where, const text::Source& source) {
  if (where.file.empty()) return "";
  if (where.file != source.name || where.length == 0) return where.file;
  if (source.is_binary()) return where.file + ", byte " + std::to_string(where.offset);
  return where.file + ", line " + std::to_string(source.position(where.offset).line);
}

void put_checked(Html& html, const CheckResult& file) {
  const CheckReport& report = file.report;
  html.element("h3", {}, file.source.name);
  if (report.findings.empty()) html.element("p", {{"class", "good"}}, "Nothing wrong found.");
  for (const Finding& finding : report.findings) {
    put_said(html, {finding.severity, id_of(finding), message_of(finding, with_options), place_of(finding.where, file.source),
                    consequence_of(finding, with_options), fix_of(finding, with_options)});
  }
  html.element("details", {}, [&] {
    html.element("summary", {}, "What was checked, and what could not be decided");
    if (!report.checked.empty())
      html.element("p", {}, "Checked: " + enumerated(text::texts_of(report.checked, with_options)) + ".");
    html.element("ul", {}, [&] {
      for (const Undecided& undecided : report.undecided) {
        html.element("li", {},
                     "Not decidable: " + question_of(undecided, with_options) + "; " + why_of(undecided, with_options));
      }
    });
  });
}

}  // namespace

void put_said(Html& html, const Said& said) {
  const std::string severity(name_of(said.severity));
  html.element("div", {{"class", "finding " + severity}}, [&] {
    html.element("p", {}, [&] {
      html.element("span", {{"class", "strong " + severity}}, severity + ": ");
      html.text(said.message + " ");
      html.element("code", {}, said.code);
      if (!said.place.empty()) html.element("span", {{"class", "soft"}}, " " + said.place);
    });
    if (!said.consequence.empty()) html.element("p", {{"class", "soft"}}, "If used: " + said.consequence);
    if (!said.fix.empty()) html.element("p", {{"class", "soft"}}, "Fix: " + said.fix);
  });
}

void put_findings(Html& html, const ReportContents& contents) {
  html.element("h2", {}, "What check finds");
  for (const CheckResult& file : contents.checks) put_checked(html, file);
  const Diagnostics& said = contents.conversion ? contents.conversion->diagnostics : contents.shown.diagnostics;
  if (said.entries().empty()) return;
  html.element("h3", {}, contents.conversion ? "Messages while reading and converting" : "Messages while reading");
  const text::Source& first = contents.shown.calibration->documents.front().source();
  for (const Diagnostic& entry : said.entries()) {
    put_said(html, {entry.severity, id_of(entry), message_of(entry, with_options), place_of(entry.where, first), "",
                    fix_of(entry, with_options)});
  }
}

}  // namespace fca::cli
