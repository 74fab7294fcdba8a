// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/text/document.h>

#include <algorithm>

namespace fca::text {

void Document::replace(const Span& span, std::string text) { edits_.push_back({span, std::move(text)}); }

namespace {

std::size_t end_of(const Entry& entry) { return std::max(entry.key.span.end(), entry.value.span.end()); }

}  // namespace

void Document::remove_entry(const Node& mapping, const Entry& entry) {
  if (mapping.flow) {
    const auto index = static_cast<std::size_t>(&entry - mapping.entries.data());
    const bool first = index == 0;
    const bool only = mapping.entries.size() == 1;
    const std::size_t start = first ? entry.key.span.offset : end_of(mapping.entries[index - 1]);
    const std::size_t end = first && !only ? mapping.entries[1].key.span.offset : end_of(entry);
    replace({start, end - start}, "");
    return;
  }
  const std::size_t start = source_.line_at(entry.key.span.offset).offset;
  const std::size_t newline = source_.bytes.find('\n', end_of(entry));
  const std::size_t end = newline == std::string::npos ? source_.bytes.size() : newline + 1;
  replace({start, end - start}, "");
}

void Document::insert_after(const Node& mapping, const Entry& entry, const std::string& lines) {
  if (mapping.flow) {
    insert(end_of(entry), ", " + lines);
    return;
  }
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
  const std::size_t newline = source_.bytes.find('\n', end_of(entry));
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
