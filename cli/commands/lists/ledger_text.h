// SPDX-License-Identifier: BSD-3-Clause
// What converting between two formats keeps and costs, for people and for scripts.
#pragma once

#include <fca/toolkit/ledger.h>

#include <span>
#include <string>

namespace fca::cli {

/// The table of the README.
[[nodiscard]] std::string ledger_text(std::span<const LedgerRow> rows);
[[nodiscard]] std::string ledger_json(std::span<const LedgerRow> rows);

}  // namespace fca::cli
