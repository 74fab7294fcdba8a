// SPDX-License-Identifier: BSD-3-Clause
#include "batch_table.h"

#include "shell/words.h"

#include <algorithm>
#include <array>

namespace fca::cli {

namespace {

constexpr std::size_t kGap = 2;
constexpr std::size_t kWidest = 60;  // longer names push their line to the right

/// The columns before the result.
constexpr std::array kColumns = {&TableRow::input, &TableRow::models, &TableRow::rms_px, &TableRow::max_px};

/// A longer text than its column is wide has its gap, too.
std::string cell(const std::string& said, std::size_t width) { return padded(said + std::string(kGap, ' '), width + kGap); }

std::string line(const TableRow& row, const std::vector<std::size_t>& widths) {
  std::string text;
  for (std::size_t i = 0; i < kColumns.size(); ++i) text += cell(row.*kColumns[i], widths[i]);
  return text + row.result + "\n";
}

}  // namespace

BatchTable::BatchTable(Spool& spool)
    : spool_(spool), title_({"input", "model", "rms px", "max px", "result"}), widths_(kColumns.size()) {
  for (std::size_t i = 0; i < kColumns.size(); ++i) widths_[i] = (title_.*kColumns[i]).size();
}

void BatchTable::add(const TableRow& row) {
  for (std::size_t i = 0; i < kColumns.size(); ++i) {
    const std::string& said = row.*kColumns[i];
    widths_[i] = std::max(widths_[i], std::min(said.size(), kWidest));
    rows_.put(said);
  }
  rows_.put(row.result);
  constexpr std::size_t kAtOnce = 64U << 10U;
  if (rows_.bytes().size() > kAtOnce) put_aside();
}

void BatchTable::put_aside() {
  pieces_.push_back(spool_.put(rows_.bytes()));
  rows_.clear();
}

void BatchTable::print(const std::function<void(std::string_view)>& out) {
  put_aside();
  out(line(title_, widths_));
  for (const Spool::Piece& piece : pieces_) {
    const std::string bytes = spool_.take(piece);
    PackedReader rows(bytes);
    while (!rows.is_at_end()) {
      TableRow row;
      for (const auto column : kColumns) rows.get(row.*column);
      rows.get(row.result);
      out(line(row, widths_));
    }
  }
}

}  // namespace fca::cli
