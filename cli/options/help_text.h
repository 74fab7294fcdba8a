// SPDX-License-Identifier: BSD-3-Clause
// What --help prints: 80 columns, options by what they are about.
#pragma once

#include "options.h"

#include <array>
#include <memory>
#include <string_view>

namespace CLI {
class FormatterBase;
}

namespace fca::cli {

/// In the order in which they are shown.
inline constexpr std::array kOptionGroups = {OptionGroup::kTarget, OptionGroup::kReading, OptionGroup::kLens,
                                             OptionGroup::kProof, OptionGroup::kOutput};

/// "How to read the input"
[[nodiscard]] std::string_view title_of(OptionGroup group);

/// Shows the positional words, the groups in their order, then commands and the footer. In a footer lines that begin with a
/// blank stay as they are; others are paragraphs.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> help_formatter();

}  // namespace fca::cli
