// SPDX-License-Identifier: BSD-3-Clause
#include "complaints.h"
#include "layout_fix.h"
#include "tab_fix.h"

#include <fca/code.h>
#include <fca/formats/fix.h>
#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fca {

namespace {

using text::Node;

void collect_scalars(const Node& node, std::vector<const Node*>& scalars) {
  if (node.is_scalar()) scalars.push_back(&node);
  for (const Node& item : node.items) collect_scalars(item, scalars);
  for (const text::Entry& entry : node.entries) collect_scalars(entry.value, scalars);
}

Fix spelled(Code code, const text::Span& span, const std::string& text) { return {{code, {text}}, span, text}; }

/// Other spellings of the same value. A number in quotes is none for a program that wants a number and refuses nothing: it
/// would only stop looking at it.
std::vector<Fix> spellings(const Node& scalar, bool is_refused) {
  std::vector<Fix> fixes;
  const std::optional<double> number = text::parse_real(scalar.value);
  if (!scalar.quoted && number && std::isfinite(*number)) {
    const bool whole = text::parse_int(scalar.value).has_value();
    fixes.push_back(spelled(whole ? Code::kSpellReal : Code::kSpellNumber, scalar.span, text::format_real(*number)));
    constexpr double kLargest = 1e9;
    if (!whole && *number == std::floor(*number) && std::abs(*number) < kLargest)
      fixes.push_back(spelled(Code::kSpellWhole, scalar.span, std::to_string(static_cast<long long>(*number))));
  }
  if (scalar.quoted && number && std::isfinite(*number)) {
    fixes.push_back(spelled(Code::kSpellNumber, scalar.span, scalar.value));
    fixes.push_back(spelled(Code::kSpellNumber, scalar.span, text::format_real(*number)));
  }
  if (!scalar.quoted && (is_refused || !number))
    fixes.push_back(spelled(Code::kSpellQuoted, scalar.span, "\"" + scalar.value + "\""));
  return fixes;
}

/// A flat list of a pose's 16 numbers as four rows, each where it stands.
std::optional<Fix> in_rows(const text::Document& document, const Node& list) {
  constexpr std::size_t kSide = 4;
  if (list.items.size() != kSide * kSide || !std::ranges::all_of(list.items, &Node::is_scalar)) return std::nullopt;
  const text::Span span{list.items.front().span.offset, list.items.back().span.end() - list.items.front().span.offset};
  const std::string_view bytes = document.source().bytes;
  std::string rows(bytes.substr(span.offset, span.length));
  for (std::size_t i = list.items.size(); i-- > 0;) {  // from behind: what is before stays where it is
    const text::Span& number = list.items[i].span;
    if (i % kSide == kSide - 1) rows.insert(number.end() - span.offset, "]");
    if (i % kSide == 0) rows.insert(number.offset - span.offset, "[");
  }
  return Fix{{Code::kSpellRows}, span, rows};
}

std::optional<Fix> without_mark(const text::Document& document) {
  const std::size_t length = document.source().byte_order_mark();
  if (length == 0) return std::nullopt;
  return Fix{{Code::kMarkRemoved}, {0, length}, ""};
}

std::optional<Fix> blanks_for_tabs(const text::Document& document) {
  const bool yaml = document.syntax() == text::Syntax::kYaml || document.syntax() == text::Syntax::kOpenCvYaml;
  return yaml ? checks::tab_fix(document.source()) : std::nullopt;
}

/// Of the document's own bytes, not of its edits?
bool is_apart_from_edits(const Fix& fix, const text::Document& document) {
  const auto overlaps = [&fix](const text::Span& edit) {
    return fix.span.offset < edit.offset + edit.length && edit.offset < fix.span.offset + fix.span.length;
  };
  return std::ranges::none_of(document.edited_spans(), overlaps);
}

/// What a program says to the document with a fix in it.
consumers::ConsumerView view_after(text::Document document, const Fix& fix, const AskProgram& ask) {
  document.replace(fix.span, fix.text);
  return ask(document.bytes());
}

bool says(const std::vector<consumers::Complaint>& complaints, const Message& message) {
  return std::ranges::find(complaints, message, &consumers::Complaint::facts) != complaints.end();
}

bool is_alike(const Message& a, const Message& b);

/// A number is like any other, and the words of a parser may have numbers in them.
bool is_alike_in(const Argument& a, const Argument& b) {
  const auto clauses = [](const Argument& each) { return std::get_if<std::vector<Message>>(&each.value); };
  const auto words = [](const Argument& each) {
    const auto* const text = std::get_if<std::string>(&each.value);
    std::string result = text == nullptr ? "" : *text;
    std::erase_if(result, [](char c) { return c >= '0' && c <= '9'; });
    return result;
  };
  if (clauses(a) != nullptr && clauses(b) != nullptr) return std::ranges::equal(*clauses(a), *clauses(b), is_alike);
  return a.value.index() == b.value.index() && words(a) == words(b);
}

/// The same complaint, be it about another line?
bool is_alike(const Message& a, const Message& b) {
  return a.code == b.code && std::ranges::equal(a.arguments, b.arguments, is_alike_in);
}

}  // namespace

std::optional<Fix> find_fix(const text::Document& document, const consumers::ConsumerView& view,
                            const consumers::Complaint& complaint, const AskProgram& ask) {
  // Every try is a run of the program's parser; no real calibration is half as long.
  constexpr std::size_t kLongest = 512 * 1024;
  const bool binary = document.syntax() == text::Syntax::kBinary;  // no number in it has another spelling
  if (binary || document.source().bytes.size() > kLongest) return std::nullopt;
  const std::vector<consumers::Complaint>& before = view.refusals;
  const Message& said = complaint.facts;
  const auto is_like_it = [&said](const consumers::Complaint& each) { return is_alike(each.facts, said); };
  // After the header the program sees the file for the first time: it may go on to refuse something else.
  for (std::optional<Fix> (*layout)(const text::Document&) :
       {&without_mark, &checks::layout_fix, &checks::header_fix, &blanks_for_tabs}) {
    std::optional<Fix> fix = layout(document);
    if (fix && is_apart_from_edits(*fix, document) && says(before, said) &&
        std::ranges::none_of(view_after(document, *fix, ask).refusals, is_like_it))
      return fix;
  }
  // What is missing no other spelling of its owner brings: a camera whose name is put in quotes is only overlooked.
  if (!info(said.code).fix.empty()) return std::nullopt;
  const Node* named = checks::node_at(document, complaint.key);
  if (named == nullptr) return std::nullopt;
  std::vector<const Node*> scalars;
  collect_scalars(*named, scalars);
  // The same complaint with another value in it is no progress.
  const auto helps = [&](const Fix& fix) {
    const consumers::ConsumerView after = view_after(document, fix, ask);
    return !says(after.refusals, said) && !says(after.warnings, said) &&
           std::ranges::all_of(after.refusals, [&](const consumers::Complaint& each) { return says(before, each.facts); });
  };
  if (std::optional<Fix> fix = in_rows(document, *named); fix && is_apart_from_edits(*fix, document) && helps(*fix)) return fix;
  constexpr std::size_t kMostTried = 32;
  for (std::size_t i = 0; i < std::min(kMostTried, scalars.size()); ++i) {
    for (Fix& fix : spellings(*scalars[i], says(before, said))) {
      if (is_apart_from_edits(fix, document) && helps(fix)) return std::move(fix);
    }
  }
  return std::nullopt;
}

bool names_fix(const Message& complaint, const Fix& fix) {
  return checks::find_clause(complaint, [&fix](const Message& each) { return same_id(each.code, fix.remedy.code); }) != nullptr;
}

}  // namespace fca
