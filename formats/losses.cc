// SPDX-License-Identifier: BSD-3-Clause
#include "losses.h"

#include <algorithm>
#include <string>

namespace fca {

namespace {

/// "Viewer." of "Viewer.PointSize"; nothing of a key without a point.
std::string_view group_of(const AsRead& extra) {
  const std::size_t point = extra.key.find('.');
  return point == std::string::npos ? std::string_view() : std::string_view(extra.key).substr(0, point + 1);
}

}  // namespace

void add_not_carried(std::span<const AsRead> extras, std::string_view why, std::vector<Loss>& losses) {
  constexpr std::ptrdiff_t kFewest = 3;  // fewer keys are named one by one
  std::vector<std::string_view> told;
  for (const AsRead& extra : extras) {
    const std::string_view group = group_of(extra);
    const auto members = std::ranges::count(extras, group, group_of);
    if (group.empty() || members < kFewest) {
      losses.push_back({"not-carried", extra.key + (extra.value.empty() ? "" : " " + extra.value), std::string(why), ""});
    } else if (std::ranges::find(told, group) == told.end()) {
      told.push_back(group);
      losses.push_back({"not-carried", std::string(group) + "* (" + std::to_string(members) + " keys)", std::string(why), ""});
    }
  }
}

}  // namespace fca
