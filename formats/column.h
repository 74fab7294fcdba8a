// SPDX-License-Identifier: BSD-3-Clause
// Private: a column of a table, for messages that list what a file may say.
#pragma once

#include <string>
#include <vector>

namespace fca {

/// One member of each row, in the order of the rows.
template <typename Rows, typename Row, typename Member>
[[nodiscard]] std::vector<std::string> column(const Rows& rows, Member Row::*member) {
  std::vector<std::string> texts;
  texts.reserve(rows.size());
  for (const Row& row : rows) texts.emplace_back(row.*member);
  return texts;
}

}  // namespace fca
