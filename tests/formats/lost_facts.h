// SPDX-License-Identifier: BSD-3-Clause
// Losses asked by code and values.
#pragma once

#include "id_and_arguments.h"

#include <fca/code.h>
#include <fca/formats/format.h>
#include <fca/formats/wording.h>

#include <algorithm>
#include <vector>

namespace fca::test {

/// `values`: of its owner, its key and its values, those that a test is about.
inline bool loses(const Written& written, Code code, const std::vector<Argument>& values = {}) {
  return std::ranges::any_of(written.losses, [&](const Loss& loss) { return is_said_of(facts_of(loss), code, values); });
}

/// Is there any loss of that name?
inline bool loses_anything_of(const Written& written, const char* name) {
  return std::ranges::any_of(written.losses, [name](const Loss& loss) { return speaks_of(facts_of(loss), name); });
}

}  // namespace fca::test
