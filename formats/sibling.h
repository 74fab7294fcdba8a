// SPDX-License-Identifier: BSD-3-Clause
// New entries in the style of those that stand next to them.
#pragma once

#include "fields.h"

#include <span>
#include <string>
#include <string_view>

namespace fca::fields {

/// A new entry of `mapping`, ready for Document::insert_after: the sibling's text under another key, taken from saying `before`
/// to saying `after`. Indentation, order of keys, blanks and lists are the sibling's; its comments and its other keys speak of
/// it alone and are left out. `base` must be unedited.
[[nodiscard]] std::string like_sibling(const text::Document& base, const text::Node& mapping, const text::Entry& sibling,
                                       text::Dialect dialect, std::string_view key, std::span<const Field> before,
                                       std::span<const Field> after);

}  // namespace fca::fields
