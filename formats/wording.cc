// SPDX-License-Identifier: BSD-3-Clause
#include <fca/code.h>
#include <fca/formats/wording.h>

namespace fca {

Message facts_of(const Loss& loss) {
  Message message{loss.kind, {loss.owner, loss.key}};
  message.arguments.insert(message.arguments.end(), loss.values.begin(), loss.values.end());
  return message;
}

std::string id_of(const Loss& loss) { return std::string(info(loss.kind).id); }

std::string what_of(const Loss& loss, text::Wording wording) { return text::text_of(facts_of(loss), wording); }
std::string why_of(const Loss& loss, text::Wording wording) { return text::why_of(facts_of(loss), wording); }
std::string remedy_of(const Loss& loss, text::Wording wording) { return text::fix_of(facts_of(loss), wording); }

std::string value_of(const DefaultedValue& value, text::Wording wording) { return text::words_of(value.value, wording); }

std::string text_of(const DefaultedValue& value, text::Wording wording) { return value.key + " " + value_of(value, wording); }

std::string value_of(const ExtraField& extra, text::Wording wording) {
  return extra.said.is_said() ? text::text_of(extra.said, wording) : extra.value;
}

std::string id_of(const Finding& finding) { return std::string(info(code_of(finding)).id); }

std::string message_of(const Finding& finding, text::Wording wording) {
  std::string text = text::text_of(finding.facts, wording);
  for (const Message& detail : finding.details) text += text::text_of(detail, wording);
  return text;
}

std::string consequence_of(const Finding& finding, text::Wording wording) {
  if (finding.outcome.is_said()) return text::in_place(finding.outcome, text::Part::kConsequence, wording);
  return text::consequence_of(finding.facts, wording);
}

std::string fix_of(const Finding& finding, text::Wording wording) {
  return finding.remedy.is_said() ? text::in_place(finding.remedy, text::Part::kFix, wording)
                                  : text::fix_of(finding.facts, wording);
}

std::string id_of(const Undecided& undecided) {
  return std::string(info(undecided.kind != Code{} ? undecided.kind : undecided.facts.code).id);
}

std::string question_of(const Undecided& undecided, text::Wording wording) { return text::text_of(undecided.facts, wording); }
std::string why_of(const Undecided& undecided, text::Wording wording) { return text::why_of(undecided.facts, wording); }

std::string id_of(const Reason& reason) {
  return std::string(info(reason.kind != Code{} ? reason.kind : reason.facts.code).id);
}

std::string message_of(const Reason& reason, text::Wording wording) {
  return text::text_of(reason.facts, wording) + text::text_of(reason.addition, wording);
}

std::string fix_of(const Reason& reason, text::Wording wording) {
  return reason.remedy.is_said() ? text::in_place(reason.remedy, text::Part::kFix, wording)
                                 : text::fix_of(reason.facts, wording);
}

namespace consumers {

std::string sentence_of(const Complaint& complaint, text::Wording wording) { return text::text_of(complaint.facts, wording); }

std::vector<std::string> sentences_of(std::span<const Complaint> complaints, text::Wording wording) {
  std::vector<std::string> sentences;
  sentences.reserve(complaints.size());
  for (const Complaint& complaint : complaints) sentences.push_back(sentence_of(complaint, wording));
  return sentences;
}

}  // namespace consumers

}  // namespace fca
