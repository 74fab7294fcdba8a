// SPDX-License-Identifier: BSD-3-Clause
#include "option_hints.h"

#include <fca/code.h>

#include <algorithm>
#include <array>

namespace fca::cli {

namespace {

/// The words of one column of the table where the command's differ.
struct OptionHint {
  Code code;
  text::Part part;
  std::string_view words;
};

constexpr std::array kHints = {
    OptionHint{Code::kImageSizeNotStated, text::Part::kFix, "give it: --size WIDTHxHEIGHT"},
};

}  // namespace

std::string_view with_options(Code code, text::Part part) {
  const auto* const hint =
      std::ranges::find_if(kHints, [&](const OptionHint& each) { return each.code == code && each.part == part; });
  return hint != kHints.end() ? hint->words : text::table_wording(code, part);
}

}  // namespace fca::cli
