// SPDX-License-Identifier: BSD-3-Clause
// The only user of libfmt.
#include <fca/code.h>
#include <fca/formats/text/message.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/prose.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <numeric>
#include <optional>

#include <fmt/args.h>
#include <fmt/format.h>

namespace fca::text {

namespace {

constexpr std::string_view kShort = "short";

/// An argument in a sentence.
struct Slot {
  const Argument* argument;
  Wording wording;
};

[[noreturn]] void refuse(std::string_view how) { throw fmt::format_error("no way to write an argument: " + std::string(how)); }

std::string fixed(double value, int decimals) {
  std::array<char, 400> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
  return {buffer.data(), result.ptr};
}

std::string shortest(double value) {
  std::array<char, 40> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// "0.113", "4e-14", "2614"
std::string pixels(double value) {
  constexpr double kTiny = 1e-4;
  constexpr double kWhole = 1e3;
  constexpr double kHuge = 1e6;
  if (value == 0.0) return "0";
  if (value >= kWhole && value < kHuge) return fixed(value, 0);
  return format_short(value, value < kTiny ? 2 : 3);
}

/// An rms, or the worst pixel after it: nothing where both are rounding.
constexpr double kExactPx = 1e-9;
std::string rms_off(double rms_px) { return rms_px < kExactPx ? "exact" : pixels(rms_px) + " px rms off"; }
std::string worst_off(double worst_px) { return worst_px < kExactPx ? "" : ", worst " + pixels(worst_px); }

std::string plural(std::size_t count) { return count == 1 ? "" : "s"; }

/// The words of one argument, by its type; `how` is what stands after the colon.
struct InWords {
  std::string_view how;
  Wording wording;

  std::string operator()(const std::string& text) const {
    if (how.empty()) return text;
    if (how == kShort) return shortened(text);
    if (how == "shell") return shell_word(text);
    if (how == "_") return text.empty() ? text : text + " ";
    refuse(how);
  }

  std::string operator()(double value) const {
    if (how.empty()) return format_short(value);
    if (how == "real") return format_real(value);
    if (how == "all") return shortest(value);
    if (how == "px") return pixels(value);
    if (how == "rms") return rms_off(value);
    if (how == "worst") return worst_off(value);
    if (how == "%") return fixed(100.0 * value, 1) + " %";
    if (!how.starts_with('.')) refuse(how);
    const bool decimals = how.ends_with('f');
    const std::optional<int> digits = parse_int(how.substr(1, how.size() - (decimals ? 2 : 1)));
    constexpr int kMostDigits = 17;
    if (!digits || *digits < 0 || *digits > kMostDigits) refuse(how);
    return decimals ? fixed(value, *digits) : format_short(value, *digits);
  }

  std::string operator()(std::int64_t count) const {
    if (how.empty()) return std::to_string(count);
    if (how == "s") return plural(count < 0 ? 0 : static_cast<std::size_t>(count));
    refuse(how);
  }

  std::string operator()(const std::vector<std::string>& names) const {
    if (how == "s") return plural(names.size());
    if (how == ",") return joined(names);
    return enumerated(names, how.empty() ? "and" : how);
  }

  std::string operator()(const std::vector<Message>& clauses) const {
    std::vector<std::string> texts;
    texts.reserve(clauses.size());
    for (const Message& clause : clauses) texts.push_back(text_of(clause, wording));
    if (!how.empty() && how != kShort) return enumerated(texts, how);
    const std::string all = std::accumulate(texts.begin(), texts.end(), std::string());
    return how == kShort ? shortened(all) : all;
  }
};

}  // namespace

}  // namespace fca::text

template <>
struct fmt::formatter<fca::text::Slot> {
  constexpr auto parse(fmt::format_parse_context& context) {
    const auto* end = std::find(context.begin(), context.end(), '}');
    how = {context.begin(), static_cast<std::size_t>(end - context.begin())};
    return end;
  }

  auto format(const fca::text::Slot& slot, fmt::format_context& context) const {
    const std::string words = std::visit(fca::text::InWords{how, slot.wording}, slot.argument->value);
    return std::copy(words.begin(), words.end(), context.out());
  }

  std::string_view how;
};

namespace fca::text {

std::string_view table_wording(Code code, Part part) {
  const CodeInfo& row = info(code);
  switch (part) {
    case Part::kText:
      return row.text;
    case Part::kWhy:
      return row.why;
    case Part::kConsequence:
      return row.consequence;
    case Part::kFix:
      return row.fix;
  }
  return {};
}

std::string words_of(const Argument& argument, Wording wording) {
  return std::visit(InWords{.how = {}, .wording = wording}, argument.value);
}

std::string filled(std::string_view pattern, std::span<const Argument> arguments, Wording wording) {
  fmt::dynamic_format_arg_store<fmt::format_context> store;
  for (const Argument& argument : arguments) store.push_back(Slot{&argument, wording});
  return fmt::vformat(fmt::string_view(pattern.data(), pattern.size()), store);
}

std::string rendered(const Message& message, Part part, Wording wording) {
  const std::string_view pattern = wording(message.code, part);
  if (pattern.empty()) return {};
  try {
    return filled(pattern, message.arguments, wording);
  } catch (const fmt::format_error&) {
    // Only of arguments other than the row's: every row is filled in a test of all, with arguments as it names them.
    return std::string(pattern);
  }
}

std::string in_place(const Message& message, Part part, Wording wording) {
  const std::string words = rendered(message, part, wording);
  return words.empty() ? text_of(message, wording) : words;
}

std::string text_of(const Message& message, Wording wording) { return rendered(message, Part::kText, wording); }
std::vector<std::string> texts_of(std::span<const Message> messages, Wording wording) {
  std::vector<std::string> texts;
  texts.reserve(messages.size());
  for (const Message& message : messages) texts.push_back(text_of(message, wording));
  return texts;
}
std::string why_of(const Message& message, Wording wording) { return rendered(message, Part::kWhy, wording); }
std::string consequence_of(const Message& message, Wording wording) { return rendered(message, Part::kConsequence, wording); }
std::string fix_of(const Message& message, Wording wording) { return rendered(message, Part::kFix, wording); }

}  // namespace fca::text

namespace fca {

std::string message_of(const Diagnostic& diagnostic, text::Wording wording) { return text::text_of(diagnostic.facts, wording); }

std::string fix_of(const Diagnostic& diagnostic, text::Wording wording) {
  return diagnostic.remedy.is_said() ? text::in_place(diagnostic.remedy, text::Part::kFix, wording)
                                     : text::fix_of(diagnostic.facts, wording);
}

}  // namespace fca
