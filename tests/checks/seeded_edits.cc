// SPDX-License-Identifier: BSD-3-Clause
#include "seeded_edits.h"

#include "places.h"

#include <fca/formats/text/numbers.h>

#include <regex>

namespace fca::test {

std::optional<text::Span> number_of(const Good& good, ParameterId name) {
  if (good.calibration.rig.cameras.empty()) return std::nullopt;
  const Places places(document_of(good), good.calibration);
  const Camera& camera = good.calibration.rig.cameras.front();
  if (!parameter(camera.model, name)) return std::nullopt;
  const SourceRange where = places.parameter(camera, name);
  if (where.length == 0) return std::nullopt;
  return text::Span{where.offset, where.length};
}

Edit spelled(ParameterId name, std::function<std::string(const std::string&)> change) {
  return [name, change = std::move(change)](const Good& good) -> std::optional<SpanEdit> {
    const std::optional<text::Span> span = number_of(good, name);
    if (!span) return std::nullopt;
    return SpanEdit{*span, change(std::string(document_of(good).source().text(*span)))};
  };
}

Edit line_starting(std::string_view start, std::function<std::optional<std::string>(const std::string&)> change) {
  return [start, change = std::move(change)](const Good& good) -> std::optional<SpanEdit> {
    const std::string& bytes = bytes_of(good);
    for (std::size_t at = 0; at < bytes.size();) {
      const text::Span line = document_of(good).source().line_at(at);
      const std::string text(document_of(good).source().text(line));
      const std::size_t first = text.find_first_not_of(' ');
      if (first != std::string::npos && std::string_view(text).substr(first).starts_with(start)) {
        const std::optional<std::string> changed = change(text);
        if (!changed || *changed == text) return std::nullopt;
        return SpanEdit{line, *changed};
      }
      at = std::min(bytes.find('\n', line.end()), bytes.size() - 1) + 1;
    }
    return std::nullopt;
  };
}

std::optional<std::string> with_number(const std::string& line, const std::function<std::string(double)>& spell) {
  const std::size_t colon = line.find(':');
  const std::size_t first = line.find_first_not_of(" \t", colon + 1);
  if (colon == std::string::npos || first == std::string::npos) return std::nullopt;
  const std::size_t end = std::min(line.find_first_of(" \t\r#", first), line.size());
  const std::optional<double> number = text::parse_real(line.substr(first, end - first));
  if (!number) return std::nullopt;
  return line.substr(0, first) + spell(*number) + line.substr(end);
}

Edit without_line(std::string_view start) {
  return [find = line_starting(start, [](const std::string&) { return std::string(); })](const Good& good) {
    std::optional<SpanEdit> edit = find(good);
    if (edit && edit->span.end() < bytes_of(good).size()) ++edit->span.length;  // and its end
    return edit;
  };
}

Edit replaced(const char* pattern, const char* replacement) {
  return [=](const Good& good) -> std::optional<SpanEdit> {
    const std::string& bytes = bytes_of(good);
    std::smatch match;
    if (!std::regex_search(bytes, match, std::regex(pattern, std::regex::multiline))) return std::nullopt;
    return SpanEdit{{static_cast<std::size_t>(match.position()), static_cast<std::size_t>(match.length())},
                    match.format(replacement)};
  };
}

Edit appended(std::string_view text) {
  return [text](const Good& good) {
    const std::string& bytes = bytes_of(good);
    return SpanEdit{{bytes.size(), 0}, (bytes.ends_with('\n') ? "" : "\n") + std::string(text)};
  };
}

Edit where(text::Syntax syntax, Edit edit) {
  return [syntax, edit = std::move(edit)](const Good& good) {
    return document_of(good).syntax() == syntax ? edit(good) : std::nullopt;
  };
}

Edit of_cameras(Edit edit) {
  return
      [edit = std::move(edit)](const Good& good) { return good.calibration.rig.cameras.empty() ? std::nullopt : edit(good); };
}

bool is_read_by(const Good& good, std::string_view program) {
  return std::ranges::any_of(good.report.readers.programs,
                             [program](const Readers::Program& reader) { return reader.loads && reader.program == program; });
}

SeededDefect seeded(const TextDefect& defect) {
  const auto plant = [formats = defect.formats, edit = defect.edit](const Good& good) -> std::optional<std::string> {
    if (!formats.empty() && std::ranges::find(formats, good.calibration.format->id) == formats.end()) return std::nullopt;
    if (good.report.has(Severity::kError)) return std::nullopt;
    const std::optional<SpanEdit> planted = edit(good);
    if (!planted) return std::nullopt;
    std::string bytes = bytes_of(good);
    return bytes.replace(planted->span.offset, planted->span.length, planted->text);
  };
  SeededDefect result{defect.name, defect.codes, plant, {}, defect.at_least, defect.program};
  if (!defect.line_is_known) return result;
  result.is_placed = [edit = defect.edit](const Good& good, const text::Source& damaged, const Finding& finding) {
    const SpanEdit planted = edit(good).value_or(SpanEdit{});
    const int line = damaged.position(finding.where.offset).line;
    return line >= damaged.position(planted.span.offset).line &&
           line <= damaged.position(planted.span.offset + planted.text.size()).line;
  };
  return result;
}

}  // namespace fca::test
