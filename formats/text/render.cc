// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/text/message.h>
#include <fca/formats/text/render.h>

#include <algorithm>

namespace fca::text {

namespace {

constexpr std::size_t kLongestLine = 160;

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

/// "3:11", line and column; in a binary file "byte 24", from 0.
std::string place_in(const Source& source, std::size_t offset) {
  if (source.is_binary()) return "byte " + std::to_string(offset);
  const Position position = source.position(offset);
  return std::to_string(position.line) + ":" + std::to_string(position.column);
}

}  // namespace

std::string render(const Shown& shown, std::span<const Source> sources, bool colour) {
  std::string text;
  const auto source = std::ranges::find(sources, shown.where.file, &Source::name);
  const bool placed =
      !shown.where.file.empty() && source != sources.end() && (shown.where.offset > 0 || shown.where.length > 0);
  if (placed) {
    text += printable(source->name) + ":" + place_in(*source, shown.where.offset) + ": ";
  } else if (!shown.where.file.empty()) {
    text += printable(shown.where.file) + ": ";
  }
  if (colour) text += severity_colour(shown.severity);
  text += name_of(shown.severity);
  if (colour) text += "\x1b[0m";
  text += ": " + printable(shown.message);
  if (!shown.id.empty()) text += " [" + shown.id + "]";
  text += "\n";
  if (placed && !source->is_binary()) text += excerpt(*source, shown.where);
  if (!shown.fix.empty()) text += "    fix: " + printable(shown.fix) + "\n";
  return text;
}

std::string render(const Diagnostic& diagnostic, std::span<const Source> sources, bool colour, Wording wording) {
  return render({diagnostic.severity, id_of(diagnostic), message_of(diagnostic, wording), fca::fix_of(diagnostic, wording),
                 diagnostic.where},
                sources, colour);
}

}  // namespace fca::text
