// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/application.h"

namespace fca::cli {

/// `formats`, `models` and `programs`: what is supported, from the registries.
void add_list_commands(Application& application);

}  // namespace fca::cli
