// SPDX-License-Identifier: BSD-3-Clause
#include "ids.h"

#include <fca/code.h>
#include <fca/formats/text/numbers.h>

#include <charconv>
#include <limits>
#include <set>

namespace fca::colmap {

std::optional<Id> parse_id(std::string_view word) {
  Id id = 0;
  const char* const end = word.data() + word.size();
  const auto [rest, failure] = std::from_chars(word.data(), end, id);
  if (failure == std::errc() && rest == end && id <= kLargestId) return id;
  const std::optional<int> other_spelling = text::parse_int(word);
  return other_spelling && *other_spelling >= 0 ? std::optional(static_cast<Id>(*other_spelling)) : std::nullopt;
}

std::optional<Id> read_id(const text::Node& word, std::string_view what, fields::Reader& reader) {
  constexpr auto kLargestInt = static_cast<Id>(std::numeric_limits<int>::max());
  const std::optional<Id> id = parse_id(word.value);
  if (id && *id > kLargestInt) return id;
  const std::optional<double> number = text::parse_real(word.value);
  if (text::parse_int(word.value).value_or(0) < 0 || (number && !id && *number == static_cast<double>(kLargestId) + 1.0)) {
    reader.say(word, Code::kColmapIdRange, {what, word.value});
    return std::nullopt;
  }
  const std::optional<int> value = reader.integer(word, what);
  return value ? std::optional(static_cast<Id>(*value)) : std::nullopt;
}

std::vector<Id> camera_ids(const Rig& rig) {
  std::vector<std::optional<Id>> had;
  std::set<Id> taken;
  for (const Camera& camera : rig.cameras) {
    const ExtraField* field = rig.find_extra_field(camera.name, kId);
    const std::optional<Id> id = field != nullptr ? parse_id(field->value) : std::nullopt;
    had.push_back(id && taken.insert(*id).second ? id : std::nullopt);
  }
  std::vector<Id> ids;
  for (const std::optional<Id>& id : had) {
    Id next = static_cast<Id>(ids.size()) + 1;
    while (!id && !taken.insert(next).second) ++next;
    ids.push_back(id.value_or(next));
  }
  return ids;
}

}  // namespace fca::colmap
