// SPDX-License-Identifier: BSD-3-Clause
#include "markup.h"

#include <fca/formats/text/node.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace fca::text {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";

/// After the first `mark` at or after `from`; npos if there is none.
std::size_t behind(std::string_view bytes, std::string_view mark, std::size_t from) {
  const std::size_t at = bytes.find(mark, from);
  return at == std::string_view::npos ? at : at + mark.size();
}

/// After the '>' of a tag; one inside an attribute's quotes does not count. npos if another '<' or the end comes first.
std::size_t end_of_tag(std::string_view bytes, std::size_t from) {
  char quote = '\0';
  for (std::size_t i = from; i < bytes.size(); ++i) {
    const char c = bytes[i];
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return i + 1;
    } else if (c == '<') {
      break;
    }
  }
  return std::string_view::npos;
}

Markup tag_at(std::string_view bytes, std::size_t at) {
  Markup markup;
  const bool closes = bytes.substr(at).starts_with("</");
  const std::size_t name = at + (closes ? 2 : 1);
  const std::size_t name_end = std::min(bytes.find_first_of(" \t\r\n/<>\"'=", name), bytes.size());
  const std::size_t end = end_of_tag(bytes, name_end);
  markup.name = {name, name_end - name};
  if (end == std::string_view::npos) {
    markup.kind = Markup::Kind::kUnfinished;
    markup.span = {at, bytes.size() - at};
  } else {
    const bool empty = bytes[end - 2] == '/' && end - 2 >= name_end;
    markup.kind = closes ? Markup::Kind::kClose : empty ? Markup::Kind::kEmpty : Markup::Kind::kOpen;
    markup.span = {at, end - at};
  }
  return markup;
}

}  // namespace

std::optional<Markup> next_markup(std::string_view bytes, std::size_t from) {
  const std::size_t at = bytes.find('<', from);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view rest = bytes.substr(at);
  std::size_t end = std::string_view::npos;
  Markup markup;
  if (rest.starts_with("<!--")) {
    markup.kind = Markup::Kind::kComment;
    end = behind(bytes, "-->", at + 4);
  } else if (rest.starts_with("<?")) {
    markup.kind = Markup::Kind::kInstruction;
    end = behind(bytes, "?>", at + 2);
  } else if (rest.starts_with("<!")) {
    markup.kind = Markup::Kind::kOther;
    end = behind(bytes, ">", at + 2);
  } else {
    return tag_at(bytes, at);
  }
  if (end == std::string_view::npos) {
    if (markup.kind != Markup::Kind::kOther) markup.kind = Markup::Kind::kUnfinished;
    end = bytes.size();
  }
  markup.span = {at, end - at};
  return markup;
}

Span element_span(std::string_view bytes, const Span& name) {
  const std::size_t start = name.offset - 1;
  int depth = 0;
  std::size_t at = start;
  while (const std::optional<Markup> markup = next_markup(bytes, at)) {
    at = markup->span.end();
    if (markup->kind == Markup::Kind::kOpen) ++depth;
    if (markup->kind == Markup::Kind::kClose) --depth;
    const bool tag = markup->kind == Markup::Kind::kClose || markup->kind == Markup::Kind::kEmpty;
    if (tag && depth <= 0) return {start, at - start};
  }
  return {start, bytes.size() - start};
}

namespace {

/// Walks the tags with the open elements on a stack.
class Checker {
 public:
  explicit Checker(const Source& source) : source_(source), bytes_(source.bytes) {}

  void check() {
    std::size_t at = source_.byte_order_mark();
    while (const std::optional<Markup> markup = next_markup(bytes_, at)) {
      check_text(at, markup->span.offset);
      check_one(*markup);
      at = markup->span.end();
    }
    check_text(at, bytes_.size());
    if (!open_.empty()) refuse({Code::kXmlElementOpen, {name(open_.back())}}, open_.back().span.offset);
    if (!has_root_) refuse({Code::kXmlNoElement}, at == bytes_.size() && at > 0 ? at - 1 : at);
  }

 private:
  [[nodiscard]] std::string name(const Markup& markup) const {
    constexpr std::size_t kLongest = 40;
    return std::string(source_.text(markup.name).substr(0, kLongest));
  }

  [[noreturn]] static void refuse(Message message, std::size_t offset) { throw Refusal{std::move(message), offset}; }

  void check_text(std::size_t from, std::size_t to) const {
    if (!open_.empty()) return;
    const std::size_t text = bytes_.find_first_not_of(kBlanks, from);
    if (text < to) refuse({Code::kXmlTextOutside}, text);
  }

  void check_one(const Markup& markup) {
    switch (markup.kind) {
      case Markup::Kind::kUnfinished:
        refuse({Code::kXmlTagOpen}, markup.span.offset);
      case Markup::Kind::kComment:
        return;
      case Markup::Kind::kInstruction:
        if (bytes_.find_first_not_of(kBlanks, source_.byte_order_mark()) == markup.span.offset) return;
        refuse({Code::kXmlInstruction}, markup.span.offset);
      case Markup::Kind::kOther:
        refuse({Code::kXmlDeclaration}, markup.span.offset);
      case Markup::Kind::kClose:
        return close(markup);
      case Markup::Kind::kOpen:
      case Markup::Kind::kEmpty:
        return open(markup);
    }
  }

  void open(const Markup& markup) {
    if (markup.name.length == 0) refuse({Code::kXmlTagWithoutName}, markup.span.offset);
    if (open_.empty() && has_root_) refuse({Code::kXmlSecondRoot}, markup.span.offset);
    has_root_ = true;
    if (open_.size() >= static_cast<std::size_t>(kMaxDepth)) throw too_deep(markup.span.offset);
    if (markup.kind == Markup::Kind::kOpen) open_.push_back(markup);
  }

  void close(const Markup& markup) {
    if (open_.empty()) refuse({Code::kXmlClosesNothing, {name(markup)}}, markup.span.offset);
    const Markup& opened = open_.back();
    if (source_.text(opened.name) != source_.text(markup.name)) {
      const int line = source_.position(opened.span.offset).line;
      refuse({Code::kXmlClosesAnother, {name(markup), name(opened), line}}, markup.span.offset);
    }
    open_.pop_back();
  }

  const Source& source_;
  std::string_view bytes_;
  std::vector<Markup> open_;
  bool has_root_ = false;
};

}  // namespace

std::optional<Refusal> check_markup(const Source& source) {
  try {
    Checker(source).check();
    return std::nullopt;
  } catch (const Refusal& refusal) {
    return refusal;
  }
}

}  // namespace fca::text
