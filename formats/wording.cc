// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/wording.h>

namespace fca {

namespace {

/// The words that a value brings with it, else the table's.
std::string said(const std::string& own, const Message& facts, text::Part part, text::Wording wording) {
  return own.empty() ? text::rendered(facts, part, wording) : own;
}

/// What stands in place of a column of another row: its own row's column, else its sentence.
std::string in_place(const Message& message, text::Part part, text::Wording wording) {
  const std::string words = text::rendered(message, part, wording);
  return words.empty() ? text::text_of(message, wording) : words;
}

std::string named(const std::string& own, const Message& facts) { return own.empty() ? id_of(facts) : own; }

}  // namespace

Message facts_of(const Loss& loss) {
  Message message{loss.kind, {loss.owner, loss.key}};
  message.arguments.insert(message.arguments.end(), loss.values.begin(), loss.values.end());
  return message;
}

std::string id_of(const Loss& loss) { return named(loss.code, {loss.kind, {}}); }

std::string what_of(const Loss& loss, text::Wording wording) {
  return said(loss.what, facts_of(loss), text::Part::kText, wording);
}

std::string why_of(const Loss& loss, text::Wording wording) {
  return said(loss.why, facts_of(loss), text::Part::kWhy, wording);
}

std::string remedy_of(const Loss& loss, text::Wording wording) {
  return said(loss.remedy, facts_of(loss), text::Part::kFix, wording);
}

Message facts_of(const Finding& finding) { return finding.message.empty() ? finding.facts : in_words(finding.message); }

std::string id_of(const Finding& finding) { return named(finding.code, finding.facts); }

std::string message_of(const Finding& finding, text::Wording wording) {
  std::string text = said(finding.message, finding.facts, text::Part::kText, wording);
  for (const Message& detail : finding.details) text += text::text_of(detail, wording);
  return text;
}

std::string consequence_of(const Finding& finding, text::Wording wording) {
  if (finding.consequence.empty() && finding.outcome.is_said())
    return in_place(finding.outcome, text::Part::kConsequence, wording);
  return said(finding.consequence, finding.facts, text::Part::kConsequence, wording);
}

std::string fix_of(const Finding& finding, text::Wording wording) {
  if (finding.fix.empty() && finding.remedy.is_said()) return in_place(finding.remedy, text::Part::kFix, wording);
  return said(finding.fix, finding.facts, text::Part::kFix, wording);
}

std::vector<std::string> checked_of(const CheckReport& report, text::Wording wording) {
  std::vector<std::string> checked;
  checked.reserve(report.checked.size());
  for (const Message& each : report.checked) checked.push_back(text::text_of(each, wording));
  return checked;
}

std::string id_of(const Undecided& undecided) { return named(undecided.code, undecided.facts); }

std::string question_of(const Undecided& undecided, text::Wording wording) {
  return said(undecided.question, undecided.facts, text::Part::kText, wording);
}

std::string why_of(const Undecided& undecided, text::Wording wording) {
  return said(undecided.why, undecided.facts, text::Part::kWhy, wording);
}

namespace consumers {

Message facts_of(const Complaint& complaint) {
  return complaint.sentence.empty() ? complaint.facts : in_words(complaint.sentence);
}

std::string sentence_of(const Complaint& complaint, text::Wording wording) {
  return said(complaint.sentence, complaint.facts, text::Part::kText, wording);
}

std::vector<std::string> sentences_of(std::span<const Complaint> complaints, text::Wording wording) {
  std::vector<std::string> sentences;
  sentences.reserve(complaints.size());
  for (const Complaint& complaint : complaints) sentences.push_back(sentence_of(complaint, wording));
  return sentences;
}

}  // namespace consumers

}  // namespace fca
