// SPDX-License-Identifier: BSD-3-Clause
#include "comments.h"

#include "markup.h"

#include <algorithm>

namespace fca::text {

namespace {

void collect_scalars(const Node& node, std::vector<Span>& spans) {
  if (node.is_scalar()) spans.push_back(node.span);
  for (const Node& item : node.items) collect_scalars(item, spans);
  for (const Entry& entry : node.entries) {
    spans.push_back(entry.key.span);
    collect_scalars(entry.value, spans);
  }
}

/// A '#' after a blank (in Python after anything), outside of all scalars.
std::vector<Span> hash_comments(const Document& document) {
  const std::string& bytes = document.source().bytes;
  std::vector<Span> scalars;
  collect_scalars(document.root(), scalars);
  std::ranges::sort(scalars, {}, &Span::offset);
  const auto in_scalar = [&scalars](std::size_t offset) {
    const auto behind = std::ranges::upper_bound(scalars, offset, {}, &Span::offset);
    return behind != scalars.begin() && offset < std::prev(behind)->end();
  };
  std::vector<Span> comments;
  for (std::size_t hash = bytes.find('#'); hash != std::string::npos; hash = bytes.find('#', hash + 1)) {
    const bool begins = hash == 0 || document.syntax() == Syntax::kPython ||
                        std::string_view(" \t\n").find(bytes[hash - 1]) != std::string_view::npos;
    if (!begins || in_scalar(hash)) continue;
    std::size_t end = std::min(bytes.find('\n', hash), bytes.size());
    if (end > hash && bytes[end - 1] == '\r') --end;
    comments.push_back({hash, end - hash});
    hash = end - 1;
  }
  return comments;
}

std::vector<Span> markup_comments(const std::string& bytes) {
  std::vector<Span> comments;
  for (std::optional<Markup> markup = next_markup(bytes, 0); markup; markup = next_markup(bytes, markup->span.end())) {
    if (markup->kind == Markup::Kind::kComment) comments.push_back(markup->span);
    if (markup->kind == Markup::Kind::kUnfinished) break;
  }
  return comments;
}

}  // namespace

std::vector<Span> comments_of(const Document& document) {
  switch (document.syntax()) {
    case Syntax::kYaml:
    case Syntax::kOpenCvYaml:
    case Syntax::kPython:
      return hash_comments(document);
    case Syntax::kXml:
      return markup_comments(document.source().bytes);
    case Syntax::kJson:
    case Syntax::kWords:
    case Syntax::kBinary:
      return {};
  }
  return {};
}

}  // namespace fca::text
