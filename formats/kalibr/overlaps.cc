// SPDX-License-Identifier: BSD-3-Clause
#include "overlaps.h"

#include "layout.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>

namespace fca::kalibr {

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
    const auto now = std::ranges::find(after.cameras, other, &Camera::name);
    if (now != after.cameras.end()) field.tokens.push_back(std::to_string(now - after.cameras.begin()));
  }
  return field;
}

bool is_overlaps(const AsRead& extra) { return extra.key.ends_with(" " + std::string(kOverlaps)); }

}  // namespace fca::kalibr
