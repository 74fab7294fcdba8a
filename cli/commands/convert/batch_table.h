// SPDX-License-Identifier: BSD-3-Clause
// One line for each of several inputs.
#pragma once

#include "shell/packed.h"
#include "shell/spool.h"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace fca::cli {

struct TableRow {
  std::string input;
  std::string models;
  std::string rms_px;
  std::string max_px;
  std::string result;
};

/// Its lines wait in a spool until all of them are known: columns are as wide as they need to be.
class BatchTable {
 public:
  explicit BatchTable(Spool& spool);

  void add(const TableRow& row);
  /// Ends the table: its lines, one at a time.
  void print(const std::function<void(std::string_view)>& out);

 private:
  void put_aside();

  Spool& spool_;
  PackedWriter rows_;  ///< The last of them.
  std::vector<Spool::Piece> pieces_;
  TableRow title_;
  std::vector<std::size_t> widths_;
};

}  // namespace fca::cli
