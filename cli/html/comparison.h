// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "commands/compare/compare_command.h"

#include <optional>
#include <string>

namespace fca::cli {

/// The page of two calibrations next to each other, made as report_page() is. `compared` has a comparison.
[[nodiscard]] std::string comparison_page(const ReferenceFile& reference, const ComparedFile& compared,
                                          std::optional<double> max_angle_rad, const std::string& command);

}  // namespace fca::cli
