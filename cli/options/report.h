// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"
#include "shell/output_name.h"

#include <fca/toolkit/report.h>

namespace fca::cli {

/// What `report` was asked for.
struct ReportArguments {
  ReportRequest request;
  OutputPlace output;  ///< One file.
  bool force = false;
};

void add_report_options(Options& options, ReportArguments& arguments);

}  // namespace fca::cli
