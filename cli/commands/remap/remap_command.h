// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/application.h"
#include "options/remap.h"

namespace fca::cli {

void add_remap_command(Application& application);

}  // namespace fca::cli
