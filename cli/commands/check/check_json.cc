// SPDX-License-Identifier: BSD-3-Clause
#include "check_command.h"
#include "commands/convert/conversion_json.h"
#include "explain/stories.h"
#include "shell/diagnostics_json.h"
#include "shell/json.h"
#include "shell/option_hints.h"
#include "shell/verdict_json.h"

#include <fca/formats/wording.h>
#include <fca/toolkit/format_name.h>

#include <set>

namespace fca::cli {

namespace {

bool placed(const Finding& finding) { return finding.where.offset > 0 || finding.where.length > 0; }

void put_finding(Json& json, const Finding& finding, const text::Source& source) {
  json.put("severity", name_of(finding.severity));
  json.put("code", id_of(finding));
  if (placed(finding)) put_place(json, source, finding.where.offset);
  json.put("message", message_of(finding, with_options));
  json.put("consequence", consequence_of(finding, with_options));
  json.put("fix", fix_of(finding, with_options));
}

void put_file(Json& json, const CheckResult& file, const Console& console) {
  const CheckReport& report = file.report;
  json.put("file", file.source.name);
  report.format != nullptr ? json.put("format", name_of(*report.format, file.source).id) : json.null("format");
  put_verdict(json, report.verdict);
  json.array("findings", report.findings,
             [&](const Finding& finding) { json.object([&] { put_finding(json, finding, file.source); }); });
  json.put("checked", text::texts_of(report.checked, with_options));
  json.array("undecided", report.undecided, [&](const Undecided& undecided) {
    json.object([&] {
      json.put("code", id_of(undecided));
      json.put("question", question_of(undecided, with_options));
      json.put("why", why_of(undecided, with_options));
    });
  });
  if (!file.instead) return;
  ConvertOutcome outcome;
  static_cast<ConvertResult&>(outcome) = *file.instead;
  outcome.input = file.source.name;
  outcome.code = exit_code(outcome.status);
  json.object("conversion", [&] { put_conversion(json, outcome, console.sources()); });
}

/// A path as SARIF wants it (RFC 3986): absolute ones as file://, everything but plain letters encoded.
std::string uri_of(std::string_view path) {
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string uri = path.starts_with("/") ? "file://" : "";
  for (const char c : path) {
    if (kPlain.find(c) != std::string_view::npos) {
      uri += c;
    } else {
      const auto byte = static_cast<unsigned char>(c);
      uri += {'%', kDigits[byte / 16U], kDigits[byte % 16U]};
    }
  }
  return uri;
}

/// SARIF's word for a severity.
std::string_view level(Severity severity) { return name_of(severity); }

void put_result(Json& json, const Finding& finding, const text::Source& source) {
  json.put("ruleId", id_of(finding));
  json.put("level", level(finding.severity));
  const std::string consequence = consequence_of(finding, with_options);
  const std::string fix = fix_of(finding, with_options);
  const std::string text = message_of(finding, with_options) + (consequence.empty() ? "" : "\nIf used: " + consequence) +
                           (fix.empty() ? "" : "\nFix: " + fix);
  json.object("message", [&] { json.put("text", text); });
  json.array("locations", std::initializer_list<int>{0}, [&](int) {
    json.object([&] {
      json.object("physicalLocation", [&] {
        json.object("artifactLocation", [&] { json.put("uri", uri_of(source.name)); });
        if (!placed(finding)) return;
        const text::Position first = source.position(finding.where.offset);
        const text::Position last = source.position(finding.where.offset + finding.where.length);
        json.object("region", [&] {
          if (source.is_binary()) {
            json.put("byteOffset", static_cast<long long>(finding.where.offset));
            json.put("byteLength", static_cast<long long>(finding.where.length));
            return;
          }
          json.put("startLine", first.line);
          json.put("startColumn", first.column);
          json.put("endLine", last.line);
          json.put("endColumn", last.column);
        });
      });
    });
  });
}

void put_rule(Json& json, const CodeInfo& code) {
  json.put("id", code.id);
  json.object("shortDescription", [&] { json.put("text", text::text_of({code.code}, with_options)); });
  const std::string_view story = story_of(code.id);
  if (!story.empty()) json.object("help", [&] { json.put("text", story); });
}

}  // namespace

std::string check_json(const CheckedFiles& checked, const Console& console) {
  Json json;
  json.object([&] {
    json.put("fca_io", FCA_VERSION);
    json.array("files", checked.files, [&](const CheckResult& file) { json.object([&] { put_file(json, file, console); }); });
    json.put("skipped", std::span<const std::string>(checked.skipped));
  });
  return json.document();
}

std::string check_sarif(const CheckedFiles& checked) {
  std::set<std::string> codes;
  for (const CheckResult& file : checked.files) {
    for (const Finding& finding : file.report.findings) codes.insert(id_of(finding));
  }
  Json json;
  json.object([&] {
    json.put("$schema", "https://json.schemastore.org/sarif-2.1.0.json");
    json.put("version", "2.1.0");
    json.array("runs", std::initializer_list<int>{0}, [&](int) {
      json.object([&] {
        json.object("tool", [&] {
          json.object("driver", [&] {
            json.put("name", "fca-io");
            json.put("version", FCA_VERSION);
            json.array("rules", codes, [&](std::string_view code) {
              if (const CodeInfo* known = find_check_code(code)) json.object([&] { put_rule(json, *known); });
            });
          });
        });
        json.put("columnKind", "unicodeCodePoints");
        std::vector<std::pair<const Finding*, const text::Source*>> results;
        for (const CheckResult& file : checked.files) {
          for (const Finding& finding : file.report.findings) results.emplace_back(&finding, &file.source);
        }
        json.array("results", results,
                   [&](const auto& result) { json.object([&] { put_result(json, *result.first, *result.second); }); });
      });
    });
  });
  return json.document();
}

}  // namespace fca::cli
