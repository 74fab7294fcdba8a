// SPDX-License-Identifier: BSD-3-Clause
#include "overlaps.h"

#include "layout.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <vector>

namespace fca::kalibr {

namespace {

/// The numbers of "[0, 2]"; nothing if it is another text.
std::optional<std::vector<int>> numbers_of(std::string_view list) {
  if (!list.starts_with('[') || !list.ends_with(']')) return std::nullopt;
  std::vector<int> numbers;
  for (std::size_t at = 1; at + 1 < list.size();) {
    const std::size_t end = std::min(list.find(',', at), list.size() - 1);
    const std::size_t begin = std::min(list.find_first_not_of(' ', at), end);
    const std::optional<int> number = text::parse_int(list.substr(begin, end - begin));
    if (!number || *number < 0) return std::nullopt;
    numbers.push_back(*number);
    at = end + 1;
  }
  return numbers;
}

/// Adds the number that the camera has among those of `after`, if it is one of them.
void add_number(const Rig& after, std::string_view camera, fields::Field& field) {
  const auto now = std::ranges::find(after.cameras, camera, &Camera::name);
  if (now != after.cameras.end()) field.tokens.push_back(std::to_string(now - after.cameras.begin()));
}

}  // namespace

std::optional<fields::Field> overlaps_among(const text::Document& base, const std::string& name, const Rig& after) {
  const text::Dialect dialect = dialect_of(base);
  const text::Node* camera = text::find(base.root(), name, dialect);
  const text::Node* list = camera != nullptr ? text::find(*camera, kOverlaps, dialect) : nullptr;
  if (list == nullptr || !list->is_sequence()) return std::nullopt;
  fields::Field field{std::string(kOverlaps), fields::Shape::kList, {}, 0, {}};
  for (const text::Node& item : list->items) {
    const std::optional<int> number = text::parse_int(item.value);
    if (!number || *number < 0) return std::nullopt;
    const std::string other = indexed("cam", static_cast<std::size_t>(*number));
    if (text::find(base.root(), other, dialect) == nullptr) return std::nullopt;
    add_number(after, other, field);
  }
  return field;
}

std::optional<fields::Field> overlaps_read(const Rig& read, const std::string& name, const Rig& after) {
  const ExtraField* extra = read.find_extra_field(name, kOverlaps);
  const std::optional<std::vector<int>> numbers = extra == nullptr ? std::nullopt : numbers_of(extra->value);
  if (!numbers) return std::nullopt;
  fields::Field field{std::string(kOverlaps), fields::Shape::kList, {}, 0, {}};
  for (const int number : *numbers) add_number(after, indexed("cam", static_cast<std::size_t>(number)), field);
  return field;
}

bool is_whole(const std::optional<fields::Field>& field, const ExtraField& extra) {
  const std::optional<std::vector<int>> numbers = numbers_of(extra.value);
  return field && numbers && field->tokens.size() == numbers->size();
}

bool is_overlaps(const ExtraField& extra) { return !extra.owner.empty() && extra.key == kOverlaps; }

}  // namespace fca::kalibr
