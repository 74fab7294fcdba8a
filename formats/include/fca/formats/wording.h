// SPDX-License-Identifier: BSD-3-Clause
// What losses, findings and programs say, in words. A remedy or an outcome that stands in a value is said in place of the
// table's: who says it knows better.
#pragma once

#include <fca/formats/check.h>
#include <fca/formats/consumers/consumer.h>
#include <fca/formats/format.h>
#include <fca/formats/text/message.h>
#include <fca/formats/verdict_value.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fca {

/// A loss's message: {0} its owner, {1} its key, {2} ... its values.
[[nodiscard]] Message facts_of(const Loss& loss);
[[nodiscard]] std::string id_of(const Loss& loss);
[[nodiscard]] std::string what_of(const Loss& loss, text::Wording wording = text::table_wording);
[[nodiscard]] std::string why_of(const Loss& loss, text::Wording wording = text::table_wording);
[[nodiscard]] std::string remedy_of(const Loss& loss, text::Wording wording = text::table_wording);

[[nodiscard]] std::string value_of(const DefaultedValue& value, text::Wording wording = text::table_wording);
/// All of it: "Camera.fps 30.0".
[[nodiscard]] std::string text_of(const DefaultedValue& value, text::Wording wording = text::table_wording);
[[nodiscard]] std::string value_of(const ExtraField& extra, text::Wording wording = text::table_wording);

[[nodiscard]] std::string id_of(const Finding& finding);
[[nodiscard]] std::string message_of(const Finding& finding, text::Wording wording = text::table_wording);
[[nodiscard]] std::string consequence_of(const Finding& finding, text::Wording wording = text::table_wording);
[[nodiscard]] std::string fix_of(const Finding& finding, text::Wording wording = text::table_wording);

[[nodiscard]] std::string id_of(const Undecided& undecided);
[[nodiscard]] std::string question_of(const Undecided& undecided, text::Wording wording = text::table_wording);
[[nodiscard]] std::string why_of(const Undecided& undecided, text::Wording wording = text::table_wording);

[[nodiscard]] std::string id_of(const Reason& reason);
[[nodiscard]] std::string message_of(const Reason& reason, text::Wording wording = text::table_wording);
[[nodiscard]] std::string fix_of(const Reason& reason, text::Wording wording = text::table_wording);

namespace consumers {

[[nodiscard]] std::string sentence_of(const Complaint& complaint, text::Wording wording = text::table_wording);
[[nodiscard]] std::vector<std::string> sentences_of(std::span<const Complaint> complaints,
                                                    text::Wording wording = text::table_wording);

}  // namespace consumers

}  // namespace fca
