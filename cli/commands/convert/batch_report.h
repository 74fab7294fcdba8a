// SPDX-License-Identifier: BSD-3-Clause
// The reports of a batch: text or JSON input by input, one line for each at the end.
#pragma once

#include "batch.h"
#include "batch_table.h"
#include "conversion_json.h"
#include "shell/verdict_text.h"

#include <cstddef>

namespace fca::cli {

class BatchReport {
 public:
  /// Of what `batch` holds.
  BatchReport(Batch& batch, const ConvertArguments& arguments, const Console& console);

  /// The next one. `is_reached`: its files are in their places, as far as there are any; false: Ctrl-C.
  void add(const Finished& finished, bool is_reached);
  /// After the last one.
  void end();

  /// The worst of those that were reached.
  [[nodiscard]] ExitCode code() const { return code_; }

 private:
  void print(const Finished& finished) const;
  void warn_of_unused() const;
  [[nodiscard]] std::string last_line() const;

  const Batch& batch_;
  const ConvertArguments& arguments_;
  const Console& console_;
  ExitCode code_ = ExitCode::kGood;
  ConversionsJson json_;
  BatchTable table_;
  VerdictCounts words_;
  std::size_t good_ = 0;
  std::size_t files_ = 0;
  std::size_t not_reached_ = 0;
  bool has_result_ = false;
};

}  // namespace fca::cli
