// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/application.h"

namespace fca::cli {

/// `project` and `unproject`.
void add_project_commands(Application& application);

}  // namespace fca::cli
