// SPDX-License-Identifier: BSD-3-Clause
// Messages in words. A sentence of the table (fca/code.h) names its arguments as {0}, {1} ...; after a colon stands how:
//   text     {0} as it is      {0:short} a beginning of a long one
//            {0:_} and a blank after it; nothing of an empty one    {0:shell} as a shell takes it
//   number   {0} 6 digits      {0:.3} 3 significant digits     {0:.1f} 1 decimal      {0:real} all digits, always with a point
//            {0:all} all digits ("1.5", "-1", "1e+308")
//            {0:px} an error in pixels ("0", "0.113", "4e-14")  {0:%} a share ("12.5 %")
//            {0:rms}{1:worst} "0.113 px rms off, worst 0.4"; "exact" of less than 1e-9 px
//   count    {0} in digits     {0:s} nothing of 1, else the "s" of a plural
//   names    {0} "a, b and c"  {0:or} "a, b or c"  {0:,} "a, b, c"  {0:s} as of their number
//   clauses  {0} one after the other; nothing of none         {0:and} "a, b and c", with any last word
//            {0:short} a beginning of long ones
// A brace that is one is written twice.
#pragma once

#include <fca/diagnostics.h>
#include <fca/message.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fca {

namespace text {

/// A column of the table.
enum class Part { kText, kWhy, kConsequence, kFix };

/// Where the sentences come from: the table, or a caller's own words for some codes (the command names its options).
using Wording = std::string_view (*)(Code code, Part part);
[[nodiscard]] std::string_view table_wording(Code code, Part part);

/// Empty where the code says nothing there. A sentence that asks for an argument that is not there, a bug, is shown as it
/// stands: a calibration is not refused for a word.
[[nodiscard]] std::string rendered(const Message& message, Part part, Wording wording = table_wording);

/// In place of a column of another row: this row's column, else its sentence.
[[nodiscard]] std::string in_place(const Message& message, Part part, Wording wording = table_wording);

[[nodiscard]] std::string text_of(const Message& message, Wording wording = table_wording);
[[nodiscard]] std::vector<std::string> texts_of(std::span<const Message> messages, Wording wording = table_wording);
[[nodiscard]] std::string why_of(const Message& message, Wording wording = table_wording);
[[nodiscard]] std::string consequence_of(const Message& message, Wording wording = table_wording);
[[nodiscard]] std::string fix_of(const Message& message, Wording wording = table_wording);

/// An argument by itself, as {0} says it.
[[nodiscard]] std::string words_of(const Argument& argument, Wording wording = table_wording);

/// A pattern with the arguments in their places; throws fmt::format_error of one that is none.
[[nodiscard]] std::string filled(std::string_view pattern, std::span<const Argument> arguments,
                                 Wording wording = table_wording);

}  // namespace text

/// What is wrong, one sentence.
[[nodiscard]] std::string message_of(const Diagnostic& diagnostic, text::Wording wording = text::table_wording);
/// How to fix it; may be empty.
[[nodiscard]] std::string fix_of(const Diagnostic& diagnostic, text::Wording wording = text::table_wording);

}  // namespace fca
