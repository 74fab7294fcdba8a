// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json.h"

#include <fca/formats/verdict_value.h>

namespace fca::cli {

/// The member "verdict": its word and its reasons.
void put_verdict(Json& json, const Verdict& verdict);

}  // namespace fca::cli
