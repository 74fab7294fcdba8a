// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/text/message.h>
#include <fca/formats/text/render.h>

#include <algorithm>

namespace fca::text {

namespace {

constexpr std::size_t kLongestLine = 160;

std::string_view severity_word(Severity severity) {
  switch (severity) {
    case Severity::kError:
      return "error";
    case Severity::kWarning:
      return "warning";
    case Severity::kNote:
      return "note";
  }
  return "";
}

std::string_view severity_colour(Severity severity) {
  switch (severity) {
    case Severity::kError:
      return "\x1b[1;31m";
    case Severity::kWarning:
      return "\x1b[1;33m";
    case Severity::kNote:
      return "\x1b[1;36m";
  }
  return "";
}

/// Characters, not bytes.
std::size_t count_characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }));
}

/// The line and a caret under the range; long lines are cut around it.
std::string excerpt(const Source& source, const SourceRange& where) {
  const Span line = source.line_at(where.offset);
  std::size_t start = line.offset;
  const std::size_t offset = std::clamp(where.offset, line.offset, line.end());
  if (offset - start > kLongestLine / 2) start = offset - kLongestLine / 2;
  const std::size_t end = std::min(line.end(), start + kLongestLine);
  const std::string caret(count_characters(source.text({start, offset - start})), ' ');
  const std::size_t marked_end = std::clamp(where.offset + where.length, std::min(offset, end), end);
  const std::size_t length = std::max<std::size_t>(1, count_characters(source.text({offset, marked_end - offset})));
  return "    " + printable(source.text({start, end - start})) + "\n    " + caret + "^" + std::string(length - 1, '~') + "\n";
}

}  // namespace

std::string render(const Diagnostic& diagnostic, std::span<const Source> sources, bool colour, Wording wording) {
  std::string text;
  const auto source = std::ranges::find(sources, diagnostic.where.file, &Source::name);
  const bool placed =
      !diagnostic.where.file.empty() && source != sources.end() && (diagnostic.where.offset > 0 || diagnostic.where.length > 0);
  if (placed) {
    const Position position = source->position(diagnostic.where.offset);
    text += printable(source->name) + ":" + std::to_string(position.line) + ":" + std::to_string(position.column) + ": ";
  } else if (!diagnostic.where.file.empty()) {
    text += printable(diagnostic.where.file) + ": ";
  }
  if (colour) text += severity_colour(diagnostic.severity);
  text += severity_word(diagnostic.severity);
  if (colour) text += "\x1b[0m";
  text += ": " + printable(message_of(diagnostic, wording));
  if (const std::string id = id_of(diagnostic); !id.empty()) text += " [" + id + "]";
  text += "\n";
  if (placed) text += excerpt(*source, diagnostic.where);
  if (const std::string fix = fca::fix_of(diagnostic, wording); !fix.empty()) text += "    fix: " + printable(fix) + "\n";
  return text;
}

}  // namespace fca::text
