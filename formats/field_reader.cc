// SPDX-License-Identifier: BSD-3-Clause
#include "fields.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/prose.h>
#include <fca/rig/limits.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

namespace fca::fields {

using text::Node;

namespace {

std::string shown(const Node& node) { return node.value.substr(0, 40); }

/// What stands there: a clause.
Message content_of(const Node& node) {
  switch (node.kind) {
    case text::NodeKind::kNull:
      return {Code::kValueEmpty};
    case text::NodeKind::kScalar:
      return {Code::kValueText, {shown(node)}};
    case text::NodeKind::kSequence:
      return {Code::kValueList};
    case text::NodeKind::kMapping:
      return {Code::kValueMapping};
  }
  return {};
}

/// "017": the programs that read it as a number at all take it for octal, fifteen. Not scanf, by which words are read, and
/// Python has 0 only.
std::optional<int> octal(const Node& node, text::Syntax syntax) {
  if (syntax == text::Syntax::kWords || syntax == text::Syntax::kBinary || syntax == text::Syntax::kPython) return std::nullopt;
  std::string_view text = node.value;
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  if (node.quoted || text.size() < 2 || text[0] != '0' || text.find_first_not_of("01234567") != std::string_view::npos)
    return std::nullopt;
  constexpr int kOctal = 8;
  int value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value, kOctal);
  if (failure != std::errc()) return std::nullopt;
  return negative ? -value : value;
}

}  // namespace

void Reader::say(const Node& node, Code code, std::vector<Argument> arguments) {
  diagnostics_.add(code, std::move(arguments), document_.range(node));
}

void Reader::say(Severity severity, const Node& node, Code code, std::vector<Argument> arguments) {
  diagnostics_.add(severity, code, std::move(arguments), document_.range(node));
}

void Reader::warn_of_duplicates(const Node& mapping) {
  constexpr std::size_t kMostNamed = 10;
  const std::vector<const text::Entry*> shadowed = text::shadowed_entries(mapping, dialect_);
  for (std::size_t i = 0; i < std::min(kMostNamed, shadowed.size()); ++i) {
    const Node& key = shadowed[i]->key;
    const Node& read = text::find_entry(mapping, key.value, dialect_)->value;
    const Node& here = shadowed[i]->value;
    if (!read.is_scalar() || !here.is_scalar()) {
      say(key, Code::kKeyTwice, {key.value});
    } else if (read.value == here.value) {
      say(key, Code::kKeyTwiceAlike, {key.value});
    } else {
      say(key, Code::kKeyTwiceUnlike, {key.value, read.value, here.value});
    }
  }
  if (shadowed.size() > kMostNamed) say(shadowed[kMostNamed]->key, Code::kMoreKeysTwice, {shadowed.size() - kMostNamed});
}

const Node* Reader::find(const Node& mapping, std::string_view key) const {
  const Node* node = text::find(mapping, key, dialect_);
  if (mapping.is_mapping()) asked_.push_back({&mapping, std::string(key), node != nullptr});
  return node;
}

std::vector<Node> words_in(const Node& scalar, std::string_view separators) {
  std::vector<Node> words;
  const std::string& text = scalar.value;
  for (std::size_t at = text.find_first_not_of(separators); at != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
    Node word;
    word.kind = text::NodeKind::kScalar;
    word.value = text.substr(at, end - at);
    word.span = {scalar.span.offset + at, end - at};
    words.push_back(std::move(word));
    at = text.find_first_not_of(separators, end);
  }
  return words;
}

bool Reader::has_read(const Node& mapping, std::string_view key) const {
  return std::ranges::any_of(asked_,
                             [&](const Asked& each) { return each.mapping == &mapping && each.found && each.key == key; });
}

void Reader::keep_unasked(const Node& mapping, const std::string& owner, std::vector<ExtraField>& kept) const {
  for (const text::Entry& entry : mapping.entries) {
    if (entry.value.kind != text::NodeKind::kNull && !has_read(mapping, entry.key.value))
      kept.push_back({owner, entry.key.value, value_text(entry.value)});
  }
}

void Reader::warn_of_misspelt() const {
  std::set<const Node*> told;
  for (const Asked& missing : asked_) {
    if (missing.found) continue;
    for (const text::Entry& entry : missing.mapping->entries) {
      const std::string& key = entry.key.value;
      if (!text::is_misspelling(key, missing.key)) continue;
      if (has_read(*missing.mapping, key) || !told.insert(&entry.key).second) continue;
      diagnostics_.add(Code::kKeyMisspelt, {key, missing.key}, document_.range(entry.key));
    }
  }
}

const Node* Reader::require(const Node& mapping, std::string_view key, std::string_view owner) {
  const Node* node = find(mapping, key);
  if (node == nullptr) {
    SourceRange where = document_.range(mapping);
    where.length = 1;
    diagnostics_.add(Code::kKeyMissing, {owner, key}, where);
  }
  return node;
}

std::optional<double> Reader::real(const Node& node, std::string_view what) {
  if (const std::optional<int> value = node.is_scalar() ? octal(node, document_.syntax()) : std::nullopt) {
    say(node, Code::kValueOctal, {what, shown(node), *value});
    return *value;
  }
  const std::optional<double> value = node.is_scalar() ? text::parse_real(node.value) : std::nullopt;
  if (!value) {
    say(node, Code::kValueNoNumber, {what, content_of(node)});
    return std::nullopt;
  }
  if (!std::isfinite(*value)) {
    say(node, Code::kValueNotFinite, {what, shown(node)});
    return std::nullopt;
  }
  return value;
}

std::optional<double> Reader::positive(const Node& node, std::string_view what) {
  const std::optional<double> value = real(node, what);
  constexpr double kLargest = 1e9;
  if (!value || (*value > 0.0 && *value <= kLargest)) return value;
  std::vector<Message> too_large;
  if (*value > 0.0) too_large = {{Code::kAndTooLarge}};
  say(node, Code::kValueNotPositive, {what, shown(node), too_large});
  return std::nullopt;
}

std::optional<double> Reader::baseline(const Node& node, std::string_view what, std::optional<double> focal_length) {
  const std::optional<double> value = real(node, what);
  if (!value) return std::nullopt;
  const double metres = *value / focal_length.value_or(1.0);
  const Message problem = problem_with_baseline(metres);
  if (!problem.is_said()) return metres;
  say(node, focal_length ? Code::kBaselineTimesFocalLength : Code::kBaselineOutOfRange, {what, problem});
  return std::nullopt;
}

std::optional<double> Reader::time_offset(const Node& node, std::string_view what) {
  const std::optional<double> value = real(node, what);
  const Message problem = value ? problem_with_time_offset(*value) : Message();
  if (!problem.is_said()) return value;
  say(node, Code::kTimeOffsetOutOfRange, {what, problem});
  return std::nullopt;
}

std::optional<int> Reader::integer(const Node& node, std::string_view what) {
  if (!node.is_scalar()) {
    say(node, Code::kValueNoInteger, {what, content_of(node), std::vector<Message>()});
    return std::nullopt;
  }
  if (const std::optional<int> value = text::parse_int(node.value); value && !octal(node, document_.syntax())) return value;
  const std::optional<double> real_value = real(node, what);
  if (!real_value) return std::nullopt;
  constexpr double kLargestInt = 2147483647.0;
  const bool whole = *real_value == std::floor(*real_value);
  if (!whole || std::abs(*real_value) > kLargestInt) {
    std::vector<Message> of_32_bits;
    if (whole) of_32_bits = {{Code::kOf32Bits}};
    say(node, Code::kValueNoInteger, {what, content_of(node), of_32_bits});
    return std::nullopt;
  }
  return static_cast<int>(*real_value);
}

std::optional<std::string> Reader::string(const Node& node, std::string_view what) {
  if (!node.is_scalar()) {
    say(node, Code::kValueNoName, {what, content_of(node)});
    return std::nullopt;
  }
  return node.value;
}

std::string Reader::name(const Node& node, std::string_view what) {
  if (!node.is_scalar()) {
    if (node.kind != text::NodeKind::kNull) say(node, Code::kValueNoNameUnread, {what, content_of(node)});
    return "";
  }
  std::string name = text::printable(node.value);
  if (name != node.value) say(node, Code::kNameReadAs, {what, name});
  return name;
}

std::optional<std::vector<double>> Reader::reals(const Node& node, std::size_t count, std::string_view what) {
  // XML says a list of one number as it says a number.
  const bool list_of_one = node.is_scalar() && document_.syntax() == text::Syntax::kXml;
  if (!node.is_sequence() && !list_of_one) {
    say(node, Code::kValueNoList, {what, content_of(node)});
    return std::nullopt;
  }
  const std::span<const Node> items = list_of_one ? std::span(&node, 1) : std::span(node.items);
  if (count != 0 && items.size() != count) {
    say(node, Code::kNumbersWanted, {what, items.size(), count});
    return std::nullopt;
  }
  std::vector<double> values;
  for (const Node& item : items) {
    const std::optional<double> value = real(item, what);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

bool Reader::parameter(const Node& node, std::string_view what, ParameterId id, CameraModel& model) {
  const std::string_view name = id.name();
  const std::string label = what.ends_with(name) ? std::string(what) : std::string(what) + " (" + std::string(name) + ")";
  const std::optional<double> value = real(node, label);
  return value && parameter(node, what, id, *value, model);
}

bool Reader::parameter(const Node& node, std::string_view what, ParameterId id, double value, CameraModel& model) {
  const auto& parameters = model_info(model).parameters;
  const auto parameter = std::ranges::find(parameters, id.name(), &Parameter::name);
  if (const Message problem = problem_with(*parameter, value); problem.is_said()) {
    say(node, Code::kNotACamera, {what, problem});
    return false;
  }
  return set_parameter(model, id, value);
}

std::optional<ImageSize> Reader::image_size(const Node& width, const Node& height, std::string_view owner) {
  const std::optional<int> w = integer(width, std::string(owner) + "width");
  const std::optional<int> h = integer(height, std::string(owner) + "height");
  if (!w || !h) return std::nullopt;
  if (const Message problem = problem_with_image_size({*w, *h}); problem.is_said()) {
    const bool wide = *w < 1 || *w > kLargestImageSide;
    say(wide ? width : height, problem.code, problem.arguments);
    return std::nullopt;
  }
  return ImageSize{*w, *h};
}

std::optional<Transform> Reader::transform(const Node& node, std::string_view what) {
  std::vector<double> values;
  const bool nested = node.is_sequence() && !node.items.empty() && node.items.front().is_sequence();
  if (nested) {
    constexpr std::size_t kRows = 4;
    if (node.items.size() != kRows) {
      say(node, Code::kRowsWanted, {what, node.items.size(), kRows});
      return std::nullopt;
    }
    for (const Node& row : node.items) {
      const std::optional<std::vector<double>> numbers = reals(row, 4, what);
      if (!numbers) return std::nullopt;
      values.insert(values.end(), numbers->begin(), numbers->end());
    }
  } else {
    const std::optional<std::vector<double>> numbers = reals(node, 16, what);
    if (!numbers) return std::nullopt;
    values = *numbers;
  }
  Transform T;
  std::ranges::copy(values, T.values.begin());
  return checked(T, node, what);
}

namespace {

enum class Part { kRotation, kTranslation };

void collect_numbers(const Node& node, std::vector<const Node*>& numbers) {
  if (node.is_scalar()) numbers.push_back(&node);
  for (const Node& item : node.items) collect_numbers(item, numbers);
}

/// The numbers of a pose or of a part of it, row by row: those of a list, of rows, or of an opencv-matrix.
std::vector<const Node*> numbers_of(const Node& pose, text::Dialect dialect) {
  const Node* data = pose.is_mapping() ? text::find(pose, "data", dialect) : &pose;
  std::vector<const Node*> numbers;
  if (data != nullptr) collect_numbers(*data, numbers);
  return numbers;
}

double value_of(const Node& number) { return text::parse_real(number.value).value_or(0.0); }

/// The first number of a part of a pose that is larger than `limit`; the whole node where none is. Of a pose of 12 or 16
/// numbers every fourth is of the translation; else the node holds the part alone.
const Node& first_beyond(double limit, Part part, const Node& node, text::Dialect dialect) {
  const std::vector<const Node*> numbers = numbers_of(node, dialect);
  const bool whole = numbers.size() == 12 || numbers.size() == 16;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (whole && (i % 4 == 3) != (part == Part::kTranslation)) continue;
    if (std::abs(value_of(*numbers[i])) > limit) return *numbers[i];
  }
  return node;
}

constexpr std::array kLastRow = {0.0, 0.0, 0.0, 1.0};

bool is_off(double value, double wanted) { return !(std::abs(value - wanted) <= 1e-9); }

/// The first number of the last row that does not belong there; the whole node where none of 16 is.
const Node& first_off_last_row(const Node& node, text::Dialect dialect) {
  const std::vector<const Node*> numbers = numbers_of(node, dialect);
  if (numbers.size() != 16) return node;
  for (std::size_t i = 0; i < kLastRow.size(); ++i) {
    if (is_off(value_of(*numbers[12 + i]), kLastRow[i])) return *numbers[12 + i];
  }
  return node;
}

}  // namespace

std::optional<Transform> Reader::checked(const Transform& T, const Place& rotation, const Place& translation) {
  for (int column = 0; column < 4; ++column) {
    if (!is_off(T(3, column), kLastRow[static_cast<std::size_t>(column)])) continue;
    say(first_off_last_row(rotation.node, dialect_), Code::kLastRowWrong, {rotation.what});
    return std::nullopt;
  }
  for (int row = 0; row < 3; ++row) {
    const Message problem = problem_with_translation(T(row, 3));
    if (!problem.is_said()) continue;
    say(first_beyond(kLongestDistance, Part::kTranslation, translation.node, dialect_), Code::kTranslationOutOfRange,
        {translation.what, problem});
    return std::nullopt;
  }
  if (const Message problem = problem_with_rotation(T); problem.is_said()) {
    say(first_beyond(kLargestRotationElement, Part::kRotation, rotation.node, dialect_), Code::kRotationImpossible,
        {rotation.what, problem});
    return std::nullopt;
  }
  constexpr double kPrintedWithThreeDigits = 2e-3;
  const double defect = rotation_defect(T);
  if (defect > kPrintedWithThreeDigits) {
    say(rotation.node, Code::kRotationRough, {rotation.what, Message{Code::kNotOrthonormal, {defect}}});
  } else if (rotation_determinant(T) < 0.0) {
    say(rotation.node, Code::kRotationMirrors, {rotation.what});
  }
  return T;
}

std::optional<Reader::Matrix> Reader::opencv_matrix(const Node& node, std::string_view what) {
  if (!node.is_mapping()) {
    say(node, Code::kValueNoMatrix, {what, content_of(node)});
    return std::nullopt;
  }
  const Node* rows = require(node, "rows", what);
  const Node* cols = require(node, "cols", what);
  const Node* data = require(node, "data", what);
  if (rows == nullptr || cols == nullptr || data == nullptr) return std::nullopt;
  const std::optional<int> row_count = integer(*rows, "rows");
  const std::optional<int> column_count = integer(*cols, "cols");
  if (!row_count || !column_count) return std::nullopt;
  constexpr int kLargestSide = 100'000;
  if (*row_count < 1 || *column_count < 1 || *row_count > kLargestSide || *column_count > kLargestSide) {
    say(*rows, Code::kMatrixOfSize, {what, *row_count, *column_count});
    return std::nullopt;
  }
  const auto count = static_cast<std::size_t>(*row_count) * static_cast<std::size_t>(*column_count);
  std::optional<std::vector<double>> values = reals(*data, count, what);
  if (!values) return std::nullopt;
  return Matrix{*row_count, *column_count, *std::move(values)};
}

}  // namespace fca::fields
