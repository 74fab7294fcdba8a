// SPDX-License-Identifier: BSD-3-Clause
// YAML's readers want blanks: PyYAML and cv::FileStorage refuse a TAB nearly everywhere outside of quotes and comments.
#pragma once

#include <fca/formats/fix.h>

#include <fca/formats/text/source.h>

namespace fca::checks {

/// Blanks for all TABs of a YAML file that stand outside of quotes and comments. Nothing where there is none, and where it is
/// not certain how many blanks are meant: a line begins as deep as the lines before allow, and that must be one depth only. The
/// result need not be read by everyone: ask.
[[nodiscard]] std::optional<Fix> tab_fix(const text::Source& source);

}  // namespace fca::checks
