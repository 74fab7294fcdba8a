// SPDX-License-Identifier: BSD-3-Clause
// What converting between two formats keeps, fits, drops and makes up: from the registry, for the README.
#pragma once

#include <fca/formats/format.h>

#include <string>
#include <vector>

namespace fca {

/// A pair of formats; ids of models, names of facts.
struct LedgerRow {
  const Format* from = nullptr;
  const Format* to = nullptr;
  std::vector<std::string> exact;      ///< Models that stay as they are.
  std::vector<std::string> fitted;     ///< Models that the target does not have.
  std::vector<std::string> dropped;    ///< Facts that it has no place for.
  std::vector<std::string> defaulted;  ///< Values that it demands and the source does not state.
};

/// All ordered pairs of different formats, by the stock programs' models.
[[nodiscard]] std::vector<LedgerRow> ledger();

}  // namespace fca
