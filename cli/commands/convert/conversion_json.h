// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/json.h"
#include "toolkit/conversion.h"

namespace fca::cli {

/// The members of one conversion's object, as CLI.md names them.
void put_conversion(Json& json, const ConvertOutcome& outcome, const Console& console);

}  // namespace fca::cli
