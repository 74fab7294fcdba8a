// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "outcome.h"
#include "shell/console.h"
#include "shell/json.h"

namespace fca::cli {

/// The members of one conversion's object, as CLI.md names them.
void put_conversion(Json& json, const ConvertOutcome& outcome, const Console& console);

}  // namespace fca::cli
