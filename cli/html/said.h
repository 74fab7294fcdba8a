// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "html.h"

#include <fca/diagnostics.h>

#include <string>

namespace fca::cli {

/// A finding or a diagnostic, as a page shows it; what is empty is left out.
struct Said {
  Severity severity = Severity::kNote;
  std::string code;
  std::string message;
  std::string place;
  std::string consequence;
  std::string fix;
};

void put_said(Html& html, const Said& said);

}  // namespace fca::cli
