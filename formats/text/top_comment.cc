// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/text/top_comment.h>

#include <string_view>

namespace fca::text {

namespace {

/// The offset behind the leading lines of YAML that are directives ("%YAML:1.0"), "---" or comments.
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

}  // namespace

bool add_top_comment(Document& document, std::span<const std::string> lines) {
  const Source& source = document.source();
  const std::string line_break(source.line_break());
  std::string text;
  if (document.syntax() == Syntax::kYaml || document.syntax() == Syntax::kOpenCvYaml) {
    for (const std::string& line : lines) text += "# " + printable(line) + line_break;
    document.insert(behind_head(source), text);
    return true;
  }
  constexpr std::string_view kRoot = "<opencv_storage>";
  const std::size_t root = source.bytes.find(kRoot);
  if (document.syntax() != Syntax::kXml || root == std::string::npos) return false;
  for (const std::string& line : lines) text += line_break + "<!-- " + without_double_hyphens(printable(line)) + " -->";
  document.insert(root + kRoot.size(), text);
  return true;
}

}  // namespace fca::text
