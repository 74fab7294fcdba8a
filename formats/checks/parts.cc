// SPDX-License-Identifier: BSD-3-Clause
#include "parts.h"

#include "subject.h"

#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <string>
#include <vector>

namespace fca::checks {

namespace {

/// The document and the parts of it, as far as all are there and can be read.
std::optional<std::vector<text::Document>> with_parts(const text::Document& document, const Format& format,
                                                      CheckReport& report) {
  Findings findings(report);
  std::vector<text::Document> documents = {document};
  bool all = true;
  std::vector<std::string> missing;
  for (const NamedFile& named : named_parts(format, document)) {
    std::optional<text::Source> source = read_part(named);
    if (!source) {
      if (std::ranges::find(missing, named.path) == missing.end())
        findings.add(Code::kNamedPartMissing, {named.path}, named.where);
      missing.push_back(named.path);
      all = false;
      continue;
    }
    report.parts.push_back(named.path);
    Diagnostics said_in_its_own_report;
    std::optional<text::Document> part = text::parse_document(*std::move(source), said_in_its_own_report);
    all = all && part;
    if (part) documents.push_back(*std::move(part));
  }
  return all ? std::optional(std::move(documents)) : std::nullopt;
}

}  // namespace

void check_parts(const text::Document& document, const Format& format, const CheckOptions& options, CheckReport& report) {
  if (format.parts == nullptr) return;
  std::optional<std::vector<text::Document>> documents = with_parts(document, format, report);
  if (!documents || documents->size() < 2) return;
  Diagnostics diagnostics;
  const std::optional<Calibration> ignored = read_calibration(*std::move(documents), &format, options.reading, diagnostics);
  Findings findings(report);
  for (const Diagnostic& entry : diagnostics.entries()) {
    if (entry.where.file != document.source().name || findings.has(code_of(entry), entry.where)) continue;
    findings.add(
        {.severity = entry.severity, .facts = entry.facts, .where = entry.where, .kind = entry.kind, .remedy = entry.remedy});
  }
}

}  // namespace fca::checks
