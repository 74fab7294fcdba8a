// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options/application.h"

namespace fca::cli {

void add_report_command(Application& application);

}  // namespace fca::cli
