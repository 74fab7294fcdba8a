// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/formats/format.h>

#include <span>

namespace fca {

/// Says what to do about each loss for which its writer knew nothing better than what holds for losses of that kind.
void add_remedies(std::span<Loss> losses);

}  // namespace fca
