// SPDX-License-Identifier: BSD-3-Clause
#include "topics.h"

#include <algorithm>
#include <array>
#include <vector>

namespace fca {

namespace {

/// The rows of all topics, sorted by their codes.
std::vector<CodeInfo> joined_topics() {
  std::vector<CodeInfo> rows;
  for (const std::span<const CodeInfo> topic :
       {diagnostics::rig_codes(), diagnostics::loss_codes(), diagnostics::dso_codes(), diagnostics::imu_codes()})
    rows.insert(rows.end(), topic.begin(), topic.end());
  std::ranges::stable_sort(rows, {}, &CodeInfo::code);
  return rows;
}

}  // namespace

std::span<const CodeInfo> all_codes() {
  static const std::vector<CodeInfo> rows = joined_topics();
  return rows;
}

const CodeInfo& info(Code code) {
  static constexpr CodeInfo kNothing = {.code = Code::kNone, .id = "", .text = ""};
  const std::span<const CodeInfo> rows = all_codes();
  const auto row = std::ranges::lower_bound(rows, code, {}, &CodeInfo::code);
  return row != rows.end() && row->code == code ? *row : kNothing;
}

}  // namespace fca
