// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/application.h"
#include "shell/origin.h"

namespace fca::cli {

/// `version`: what was built from what, and after which programs its readers are written.
void add_version_command(Application& application, const Origin& origin);

}  // namespace fca::cli
