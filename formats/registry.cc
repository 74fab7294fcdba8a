// SPDX-License-Identifier: BSD-3-Clause
// The table of formats. One row each; the order is that of `fca-io formats` and of detection.
#include "kalibr.h"
#include "orbslam3/orbslam3.h"

#include <algorithm>
#include <array>

namespace fca {

namespace {

const std::array<Format, 2>& table() {
  static const std::array<Format, 2> kTable = {kalibr::kFormat, orbslam3::kFormat};
  return kTable;
}

/// Lower case without '-' and '_': "ORB_SLAM3", "orb-slam3" and "orbslam3" are one name.
std::string folded(std::string_view name) {
  std::string result;
  for (const char c : name) {
    if (c == '-' || c == '_') continue;
    result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return result;
}

}  // namespace

std::span<const Format> all_formats() { return table(); }

const Format* find_format(std::string_view name) {
  const auto& formats = table();
  const auto found = std::ranges::find_if(formats, [&](const Format& f) { return folded(f.id) == folded(name); });
  return found == formats.end() ? nullptr : &*found;
}

const StoredModel* find_stored_model(const Format& format, std::string_view model, bool stock_only) {
  const auto found = std::ranges::find_if(format.models, [&](const StoredModel& row) { return row.model == model && (row.stock || !stock_only); });
  return found == format.models.end() ? nullptr : &*found;
}

}  // namespace fca
