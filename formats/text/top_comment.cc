// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/text/top_comment.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace fca::text {

namespace {

/// The offset after the leading lines that are directives ("%YAML:1.0"), "---" or comments.
std::size_t behind_head(const Source& source) {
  const std::string_view bytes = source.bytes;
  std::size_t at = source.byte_order_mark();
  while (at < bytes.size() && (bytes[at] == '%' || bytes[at] == '#' || bytes.substr(at).starts_with("---"))) {
    const std::size_t end = bytes.find('\n', at);
    if (end == std::string_view::npos) return at;
    at = end + 1;
  }
  return at;
}

/// "--" may not stand in an XML comment.
std::string without_double_hyphens(std::string text) {
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at + 1)) text.insert(at + 1, " ");
  return text;
}

/// Where XML's comments at the top begin.
constexpr std::string_view kRoot = "<opencv_storage>";

/// The parts of the one line of comment in lines of words; the first is the owner's.
constexpr std::string_view kPart = "; ";
/// CMV_MAX_BUF of ocam_functions.h, with the terminating zero and the line's end.
constexpr std::size_t kLongestLine = 1022;

/// The first line without its break, where it is a comment; empty elsewhere.
Span comment_of_words(const Document& document) {
  const std::string_view bytes = document.source().bytes;
  if (document.syntax() != Syntax::kWords || !bytes.starts_with('#')) return {};
  return {0, std::min(bytes.find_first_of("\r\n"), bytes.size())};
}

/// Of lines of words only where two comments stand at the top (COLMAP's): OCamCalib's reader skips exactly one line.
bool has_lines_of_comment(const Document& document) {
  if (document.syntax() != Syntax::kWords) {
    return document.syntax() == Syntax::kYaml || document.syntax() == Syntax::kOpenCvYaml ||
           document.syntax() == Syntax::kPython;
  }
  const std::string_view bytes = document.source().bytes;
  const std::size_t end = bytes.find('\n');
  return bytes.starts_with('#') && end != std::string_view::npos && bytes.substr(end + 1).starts_with('#');
}

/// A line of comment: its bytes with their line break, and what it says.
struct CommentLine {
  Span span;
  std::string_view text;
};

std::vector<CommentLine> lines_of_comment(const Source& source) {
  constexpr std::string_view kMark = "# ";
  const std::string_view bytes = source.bytes;
  std::vector<CommentLine> lines;
  const std::size_t end = behind_head(source);
  for (std::size_t at = source.byte_order_mark(); at < end;) {
    const std::size_t next = std::min(bytes.find('\n', at), end - 1) + 1;
    std::string_view text = bytes.substr(at, next - at);
    while (text.ends_with('\n') || text.ends_with('\r')) text.remove_suffix(1);
    if (text.starts_with(kMark)) lines.push_back({{at, next - at}, text.substr(kMark.size())});
    at = next;
  }
  return lines;
}

std::vector<CommentLine> xml_comments(const Source& source) {
  constexpr std::string_view kBegin = "<!-- ";
  constexpr std::string_view kEnd = " -->";
  const std::string_view bytes = source.bytes;
  std::vector<CommentLine> lines;
  std::size_t at = bytes.find(kRoot);
  if (at == std::string_view::npos) return lines;
  at += kRoot.size();
  while (true) {
    const std::size_t begin = bytes.find_first_not_of("\r\n", at);
    if (begin == std::string_view::npos || !bytes.substr(begin).starts_with(kBegin)) return lines;
    const std::size_t end = bytes.find(kEnd, begin);
    if (end == std::string_view::npos) return lines;
    const std::size_t text = begin + kBegin.size();
    lines.push_back({{at, end + kEnd.size() - at}, bytes.substr(text, end - text)});
    at = end + kEnd.size();
  }
}

/// Each part with the separator before it.
std::vector<CommentLine> words_comments(const Document& document) {
  const Span line = comment_of_words(document);
  const std::string_view text = document.source().text(line);
  std::vector<CommentLine> parts;
  for (std::size_t at = text.find(kPart); at < text.size();) {
    const std::size_t next = std::min(text.find(kPart, at + kPart.size()), text.size());
    parts.push_back({{line.offset + at, next - at}, text.substr(at + kPart.size(), next - at - kPart.size())});
    at = next;
  }
  return parts;
}

std::vector<CommentLine> comments_at_top(const Document& document) {
  if (has_lines_of_comment(document)) return lines_of_comment(document.source());
  return document.syntax() == Syntax::kXml ? xml_comments(document.source()) : words_comments(document);
}

/// False if the reader does not skip so long a line whole.
bool add_to_words(Document& document, std::span<const std::string> lines) {
  const Span line = comment_of_words(document);
  if (line.length == 0) return false;
  std::string text;
  for (const std::string& each : lines) {
    std::string part = printable(each);
    part.erase(0, part.find_first_not_of(' '));
    for (std::size_t at = part.find(kPart); at != std::string::npos; at = part.find(kPart)) part.erase(at + 1, 1);
    text += std::string(kPart) + part;
  }
  // What is taken out of the line goes before this comes.
  std::size_t length = line.length + text.size();
  for (const Span& removed : document.edited_spans()) length -= removed.end() <= line.end() ? removed.length : 0;
  if (length > kLongestLine) return false;
  document.insert(line.end(), text);
  return true;
}

}  // namespace

bool remove_top_comment(Document& document, const std::function<bool(std::string_view)>& is_ours) {
  const std::vector<CommentLine> lines = comments_at_top(document);
  bool removed = false;
  for (const CommentLine& line : lines) {
    if (!is_ours(line.text)) continue;
    document.replace(line.span, "");
    removed = true;
  }
  return removed;
}

bool add_top_comment(Document& document, std::span<const std::string> lines) {
  const Source& source = document.source();
  const std::string line_break(source.line_break());
  std::string text;
  if (has_lines_of_comment(document)) {
    for (const std::string& line : lines) text += "# " + printable(line) + line_break;
    document.insert(behind_head(source), text);
    return true;
  }
  if (document.syntax() == Syntax::kWords) return add_to_words(document, lines);
  const std::size_t root = source.bytes.find(kRoot);
  if (document.syntax() != Syntax::kXml || root == std::string::npos) return false;
  for (const std::string& line : lines) text += line_break + "<!-- " + without_double_hyphens(printable(line)) + " -->";
  document.insert(root + kRoot.size(), text);
  return true;
}

}  // namespace fca::text
