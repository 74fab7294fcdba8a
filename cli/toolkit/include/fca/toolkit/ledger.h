// SPDX-License-Identifier: BSD-3-Clause
// Lists, for each pair of formats, what a conversion keeps, fits, drops and fills with defaults. The lists follow from the
// table of formats; they are for the documentation.
#pragma once

#include <fca/formats/format.h>

#include <string_view>
#include <vector>

namespace fca {

/// A model of the source format, and how the target format stores it.
struct LedgerModel {
  std::string_view model;                   ///< Id of the source's model.
  std::string_view as = {};                 ///< Id of the target's model that contains it. Empty: the model is kept.
  std::vector<ParameterRange> limits = {};  ///< Ranges of parameters that only the target requires.
  bool operator==(const LedgerModel&) const = default;
};

/// A conversion between two formats. `dropped` and `defaulted` are clauses of sentences.
struct LedgerRow {
  const Format* from = nullptr;
  const Format* to = nullptr;
  /// Models that are converted without a fit: kept within `limits`, or as the target's model `as` that contains them.
  std::vector<LedgerModel> exact;
  std::vector<LedgerModel> fitted;  ///< Models that are fitted: the target lacks them, or cannot store them beyond `limits`.
  std::vector<Message> dropped;     ///< Facts that the target cannot store.
  std::vector<Message> defaulted;   ///< Values that the target requires and the source does not contain.
};

/// One row for each ordered pair of a format that is read and a different format that is written.
[[nodiscard]] std::vector<LedgerRow> ledger();

}  // namespace fca
