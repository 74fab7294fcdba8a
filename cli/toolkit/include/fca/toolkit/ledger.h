// SPDX-License-Identifier: BSD-3-Clause
// What converting between two formats keeps, fits, drops and makes up: from the registry, for the README.
#pragma once

#include <fca/formats/format.h>

#include <string_view>
#include <vector>

namespace fca {

/// A model of the source in the target.
struct LedgerModel {
  std::string_view model;                   ///< Its id.
  std::string_view as = {};                 ///< The target's model that contains it and that it becomes; empty: it stays.
  std::vector<ParameterRange> limits = {};  ///< Where the target demands more of its parameters than the source.
  bool operator==(const LedgerModel&) const = default;
};

/// A pair of formats. Facts and values are clauses.
struct LedgerRow {
  const Format* from = nullptr;
  const Format* to = nullptr;
  std::vector<LedgerModel> exact;   ///< Models whose numbers stay: within the limits or, as another model, beyond them.
  std::vector<LedgerModel> fitted;  ///< Models that the target does not have, or not beyond the limits.
  std::vector<Message> dropped;     ///< Facts that it has no place for.
  std::vector<Message> defaulted;   ///< Values that it demands and the source does not state.
};

/// All ordered pairs of different formats, by the stock programs' models.
[[nodiscard]] std::vector<LedgerRow> ledger();

}  // namespace fca
