// SPDX-License-Identifier: BSD-3-Clause
#include "commands/check/check_command.h"
#include "shell/option_hints.h"
#include "shell/words.h"
#include "stories.h"

#include <fca/code.h>
#include <fca/formats/sightings.h>
#include <fca/formats/text/message.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

namespace fca::cli {

namespace {

/// A sentence of the table with "..." for what it speaks of. What stands right after a word is a clause that may be absent.
std::string without_values(std::string_view sentence) {
  std::string text;
  bool behind_value = false;
  while (!sentence.empty()) {
    const bool is_brace = sentence.starts_with("{{") || sentence.starts_with("}}");
    if (sentence.front() != '{' || is_brace) {
      text += sentence.front();
      sentence.remove_prefix(is_brace ? 2 : 1);
      behind_value = false;
      continue;
    }
    const std::size_t end = std::min(sentence.find('}'), sentence.size() - 1);
    const std::string_view how = sentence.substr(1, end - 1);
    sentence.remove_prefix(end + 1);
    const char before = text.empty() ? ' ' : text.back();
    const bool behind_word = std::isalnum(static_cast<unsigned char>(before)) != 0 || before == ')' || before == '%';
    if (how.ends_with(":s")) {
      text += 's';
    } else if (!behind_word && !behind_value && !how.ends_with(":_")) {
      text += "...";
      behind_value = true;
    }
  }
  return text;
}

/// What a row says in general; nothing of one that is values alone.
std::string sentences_of(const CodeInfo& code) {
  const auto said = [&code](text::Part part) { return without_values(with_options(code.code, part)); };
  constexpr std::ptrdiff_t kOneWord = 3;
  const std::string what = said(text::Part::kText);
  if (std::ranges::count_if(what, [](unsigned char c) { return std::isalpha(c) != 0; }) < kOneWord) return "";
  std::string text = paragraph(std::string(code.id) + ": " + what, "");
  for (const auto& [title, part] :
       {std::pair("why: ", text::Part::kWhy), {"if used: ", text::Part::kConsequence}, {"fix: ", text::Part::kFix}}) {
    const std::string words = said(part);
    if (!words.empty()) text += paragraph(title + words, "  ");
  }
  return text;
}

/// How far to believe it.
std::string experience_with(std::string_view code) {
  const Sighting seen = sighting_of(code);
  const std::string all = " of " + std::to_string(kRealFiles) + " real calibration files";
  if (seen.files == 0) return "fca-io finds it in none" + all + ".";
  const std::string found = "fca-io finds it in " + std::to_string(seen.files) + all;
  if (seen.false_alarms == 0) return found + (seen.files == 1 ? ", rightly." : ", each time rightly.");
  return found + "; " + std::to_string(seen.false_alarms) + " of them are right as they are.";
}

}  // namespace

std::string explanation(const CodeInfo& code) {
  std::string text;
  if (find_check_code(code.id) != nullptr) {  // it has a row for what is wrong in general
    const Message facts{code.code};
    const std::string consequence = text::consequence_of(facts, with_options);
    const std::string fix = text::fix_of(facts, with_options);
    text = std::string(code.id) + ": " + text::text_of(facts, with_options) + "\n";
    if (!consequence.empty() || !fix.empty()) text += '\n';
    if (!consequence.empty()) text += paragraph("if used: " + consequence, "");
    if (!fix.empty()) text += paragraph("fix: " + fix, "");
    text += "\n" + paragraph(experience_with(code.id), "");
  } else {
    std::set<std::string> said;
    for (const CodeInfo& row : all_codes()) {
      if (row.id != code.id) continue;
      const std::string sentences = sentences_of(row);
      if (said.insert(sentences).second) text += sentences;
    }
    if (text.empty() && story_of(code.id).empty()) text = std::string(code.id) + ": what the message says\n";
  }
  const std::string_view story = story_of(code.id);
  if (text.empty()) return paragraph(std::string(code.id) + ": " + std::string(story), "");
  return story.empty() ? text : text + "\n" + std::string(story) + "\n";
}

}  // namespace fca::cli
