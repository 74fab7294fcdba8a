// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/text/document.h>

#include <algorithm>

namespace fca::text {

void Document::replace(const Span& span, std::string text) { edits_.push_back({span, std::move(text)}); }

void Document::remove_entry(const Entry& entry) {
  const std::size_t start = source_.line_at(entry.key.span.offset).offset;
  const std::size_t last = std::max(entry.key.span.end(), entry.value.span.end());
  const std::size_t newline = source_.bytes.find('\n', last);
  const std::size_t end = newline == std::string::npos ? source_.bytes.size() : newline + 1;
  replace({start, end - start}, "");
}

void Document::insert_after(const Entry& entry, const std::string& lines) {
  const std::size_t column = entry.key.span.offset - source_.line_at(entry.key.span.offset).offset;
  const std::string indentation(column, ' ');
  const std::string line_break(source_.line_break());
  std::string text = indentation;
  for (const char c : lines) {
    if (c == '\n') {
      text += line_break + indentation;
    } else {
      text += c;
    }
  }
  const std::size_t last = std::max(entry.key.span.end(), entry.value.span.end());
  const std::size_t newline = source_.bytes.find('\n', last);
  if (newline == std::string::npos) {
    insert(source_.bytes.size(), line_break + text);
  } else {
    insert(newline + 1, text + line_break);
  }
}

std::string Document::bytes() const {
  std::vector<Edit> edits = edits_;
  std::ranges::stable_sort(edits, {}, [](const Edit& edit) { return edit.span.offset; });
  std::string result;
  std::size_t copied = 0;
  for (const Edit& edit : edits) {
    if (edit.span.offset < copied) continue;  // inside something removed
    result.append(source_.bytes, copied, edit.span.offset - copied);
    result += edit.text;
    copied = edit.span.end();
  }
  result.append(source_.bytes, copied, std::string::npos);
  return result;
}

}  // namespace fca::text
