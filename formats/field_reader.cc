// SPDX-License-Identifier: BSD-3-Clause
#include "fields.h"

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

std::string quoted_text(const Node& node) { return "'" + node.value.substr(0, 40) + "'"; }

std::string kind_in_words(const Node& node) {
  switch (node.kind) {
    case text::NodeKind::kNull:
      return "empty";
    case text::NodeKind::kScalar:
      return quoted_text(node);
    case text::NodeKind::kSequence:
      return "a list";
    case text::NodeKind::kMapping:
      return "a mapping";
  }
  return "";
}

/// "017": the programs that read it as a number at all take it for octal, fifteen. Not scanf, by which words are read.
std::optional<int> octal(const Node& node, text::Syntax syntax) {
  if (syntax == text::Syntax::kWords) return std::nullopt;
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

void Reader::error(const Node& node, std::string code, std::string message, std::string fix) {
  diagnostics_.error(std::move(code), std::move(message), document_.range(node), std::move(fix));
}

void Reader::warning(const Node& node, std::string code, std::string message, std::string fix) {
  diagnostics_.warning(std::move(code), std::move(message), document_.range(node), std::move(fix));
}

void Reader::warn_of_duplicates(const Node& mapping) {
  constexpr std::size_t kMostNamed = 10;
  const std::vector<const text::Entry*> shadowed = text::shadowed_entries(mapping, dialect_);
  for (std::size_t i = 0; i < std::min(kMostNamed, shadowed.size()); ++i) {
    const Node& key = shadowed[i]->key;
    const Node& read = text::find_entry(mapping, key.value, dialect_)->value;
    const Node& here = shadowed[i]->value;
    const std::string twice = "the key " + key.value + " stands twice";
    if (read.is_scalar() && here.is_scalar() && read.value == here.value) {
      diagnostics_.note("duplicate-key", twice + ", with the same value", document_.range(key));
    } else if (read.is_scalar() && here.is_scalar()) {
      warning(key, "duplicate-key", twice + ", with " + read.value + " and here with " + here.value + ", which is not read");
    } else {
      warning(key, "duplicate-key", twice + "; this one is not read");
    }
  }
  if (shadowed.size() > kMostNamed) {
    warning(shadowed[kMostNamed]->key, "duplicate-key",
            std::to_string(shadowed.size() - kMostNamed) + " more keys stand twice and are not read");
  }
}

const Node* Reader::find(const Node& mapping, std::string_view key) const {
  const Node* node = text::find(mapping, key, dialect_);
  if (mapping.is_mapping()) asked_.push_back({&mapping, std::string(key), node != nullptr});
  return node;
}

void Reader::warn_of_misspelt() const {
  std::set<const Node*> told;
  for (const Asked& missing : asked_) {
    if (missing.found) continue;
    for (const text::Entry& entry : missing.mapping->entries) {
      const std::string& key = entry.key.value;
      if (!text::is_misspelling(key, missing.key)) continue;
      const bool read = std::ranges::any_of(
          asked_, [&](const Asked& each) { return each.mapping == missing.mapping && each.found && each.key == key; });
      if (read || !told.insert(&entry.key).second) continue;
      diagnostics_.warning("key-misspelt", "'" + key + "' is not read, and there is no " + missing.key,
                           document_.range(entry.key), "did you mean " + missing.key + "?");
    }
  }
}

const Node* Reader::require(const Node& mapping, std::string_view key, std::string_view owner) {
  const Node* node = find(mapping, key);
  if (node == nullptr) {
    SourceRange where = document_.range(mapping);
    where.length = 1;
    diagnostics_.error("missing-key", std::string(owner) + " has no " + std::string(key), where);
  }
  return node;
}

std::optional<double> Reader::real(const Node& node, std::string_view what) {
  if (const std::optional<int> value = node.is_scalar() ? octal(node, document_.syntax()) : std::nullopt) {
    warning(node, "octal",
            std::string(what) + " is written " + quoted_text(node) + ", which the programs read as octal " +
                std::to_string(*value));
    return *value;
  }
  const std::optional<double> value = node.is_scalar() ? text::parse_real(node.value) : std::nullopt;
  if (!value) {
    error(node, "not-a-number", std::string(what) + " is " + kind_in_words(node) + "; a number is wanted");
    return std::nullopt;
  }
  if (!std::isfinite(*value)) {
    error(node, "not-finite", std::string(what) + " is " + quoted_text(node) + ", not a finite number");
    return std::nullopt;
  }
  return value;
}

std::optional<double> Reader::positive(const Node& node, std::string_view what) {
  const std::optional<double> value = real(node, what);
  constexpr double kLargest = 1e9;
  if (!value || (*value > 0.0 && *value <= kLargest)) return value;
  error(node, "not-positive",
        std::string(what) + " is " + quoted_text(node) + "; it must be greater than 0" +
            (*value > 0.0 ? " and is too large" : ""));
  return std::nullopt;
}

std::optional<double> Reader::baseline(const Node& node, std::string_view what, std::optional<double> focal_length) {
  const std::optional<double> value = real(node, what);
  if (!value) return std::nullopt;
  const double metres = *value / focal_length.value_or(1.0);
  const std::optional<std::string> problem = problem_with_baseline(metres);
  if (!problem) return metres;
  error(node, "out-of-range", std::string(what) + ": " + *problem,
        focal_length ? "it is the distance of the two cameras in metres, times the focal length in pixels"
                     : "it is the distance of the two cameras in metres");
  return std::nullopt;
}

std::optional<double> Reader::time_offset(const Node& node, std::string_view what) {
  const std::optional<double> value = real(node, what);
  const std::optional<std::string> problem = value ? problem_with_time_offset(*value) : std::nullopt;
  if (!problem) return value;
  error(node, "out-of-range", std::string(what) + ": " + *problem, "it is in seconds: t_imu = t_cam + offset");
  return std::nullopt;
}

std::optional<int> Reader::integer(const Node& node, std::string_view what) {
  if (!node.is_scalar()) {
    error(node, "not-an-integer", std::string(what) + " is " + kind_in_words(node) + "; a whole number is wanted");
    return std::nullopt;
  }
  if (const std::optional<int> value = text::parse_int(node.value); value && !octal(node, document_.syntax())) return value;
  const std::optional<double> real_value = real(node, what);
  if (!real_value) return std::nullopt;
  constexpr double kLargestInt = 2147483647.0;
  const bool whole = *real_value == std::floor(*real_value);
  if (!whole || std::abs(*real_value) > kLargestInt) {
    error(node, "not-an-integer",
          std::string(what) + " is " + quoted_text(node) + "; a whole number" + (whole ? " of 32 bits" : "") + " is wanted");
    return std::nullopt;
  }
  return static_cast<int>(*real_value);
}

std::optional<std::string> Reader::string(const Node& node, std::string_view what) {
  if (!node.is_scalar()) {
    error(node, "not-a-string", std::string(what) + " is " + kind_in_words(node) + "; a name is wanted");
    return std::nullopt;
  }
  return node.value;
}

std::string Reader::name(const Node& node, std::string_view what) {
  if (!node.is_scalar()) {
    if (node.kind != text::NodeKind::kNull)
      warning(node, "not-a-string", std::string(what) + " is " + kind_in_words(node) + "; a name is wanted, and none is read");
    return "";
  }
  std::string name = text::printable(node.value);
  if (name != node.value) {
    warning(
        node, "name-unprintable",
        std::string(what) + " holds line breaks, control characters or bytes that are not UTF-8; it is read as '" + name + "'",
        "give it a name of printable characters");
  }
  return name;
}

std::optional<std::vector<double>> Reader::reals(const Node& node, std::size_t count, std::string_view what) {
  // XML says a list of one number as it says a number.
  const bool list_of_one = node.is_scalar() && document_.syntax() == text::Syntax::kXml;
  if (!node.is_sequence() && !list_of_one) {
    error(node, "not-a-list", std::string(what) + " is " + kind_in_words(node) + "; a list of numbers is wanted");
    return std::nullopt;
  }
  const std::span<const Node> items = list_of_one ? std::span(&node, 1) : std::span(node.items);
  if (count != 0 && items.size() != count) {
    error(node, "wrong-length",
          std::string(what) + " has " + std::to_string(items.size()) + " numbers; " + std::to_string(count) + " are wanted");
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
  if (const std::optional<std::string> problem = problem_with(*parameter, value)) {
    error(node, "not-a-camera", std::string(what) + ": " + *problem);
    return false;
  }
  return set_parameter(model, id, value);
}

std::optional<ImageSize> Reader::image_size(const Node& width, const Node& height, std::string_view owner) {
  const std::optional<int> w = integer(width, std::string(owner) + "width");
  const std::optional<int> h = integer(height, std::string(owner) + "height");
  if (!w || !h) return std::nullopt;
  if (const std::optional<std::string> problem = problem_with_image_size({*w, *h})) {
    const bool wide = *w < 1 || *w > kLargestImageSide;
    error(wide ? width : height, "image-size-invalid", *problem);
    return std::nullopt;
  }
  return ImageSize{*w, *h};
}

std::optional<Transform> Reader::transform(const Node& node, std::string_view what) {
  std::vector<double> values;
  const bool nested = node.is_sequence() && !node.items.empty() && node.items.front().is_sequence();
  if (nested) {
    if (node.items.size() != 4) {
      error(node, "wrong-length", std::string(what) + " has " + std::to_string(node.items.size()) + " rows; 4 are wanted");
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
    error(first_off_last_row(rotation.node, dialect_), "not-a-transform",
          std::string(rotation.what) + ": the last row of a transform is 0 0 0 1");
    return std::nullopt;
  }
  for (int row = 0; row < 3; ++row) {
    const std::optional<std::string> problem = problem_with_translation(T(row, 3));
    if (!problem) continue;
    error(first_beyond(kLongestDistance, Part::kTranslation, translation.node, dialect_), "out-of-range",
          std::string(translation.what) + ": " + *problem, "translations are in metres");
    return std::nullopt;
  }
  if (const std::optional<std::string> problem = problem_with_rotation(T)) {
    error(first_beyond(kLargestRotationElement, Part::kRotation, rotation.node, dialect_), "not-a-rotation",
          std::string(rotation.what) + ": " + *problem,
          "the columns of a rotation are unit vectors at right angles to each other");
    return std::nullopt;
  }
  constexpr double kPrintedWithThreeDigits = 2e-3;
  const double defect = rotation_defect(T);
  if (defect > kPrintedWithThreeDigits) {
    warning(rotation.node, "not-a-rotation",
            std::string(rotation.what) + ": its 3 x 3 part is not a rotation, R^T R differs from the identity by " +
                text::format_short(defect, 3));
  } else if (rotation_determinant(T) < 0.0) {
    warning(rotation.node, "not-a-rotation", std::string(rotation.what) + ": its 3 x 3 part is a mirror image, not a rotation");
  }
  return T;
}

std::optional<Reader::Matrix> Reader::opencv_matrix(const Node& node, std::string_view what) {
  if (!node.is_mapping()) {
    error(node, "not-a-matrix", std::string(what) + " is " + kind_in_words(node) + "; an opencv-matrix is wanted");
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
    error(*rows, "wrong-length",
          std::string(what) + ": a matrix of " + std::to_string(*row_count) + " x " + std::to_string(*column_count));
    return std::nullopt;
  }
  const auto count = static_cast<std::size_t>(*row_count) * static_cast<std::size_t>(*column_count);
  std::optional<std::vector<double>> values = reals(*data, count, what);
  if (!values) return std::nullopt;
  return Matrix{*row_count, *column_count, *std::move(values)};
}

}  // namespace fca::fields
