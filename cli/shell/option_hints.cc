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
    // Conversion.
    OptionHint{Code::kImageSizeNotKnown, text::Part::kFix, "give it: --size WIDTHxHEIGHT"},
    OptionHint{Code::kNoPixelInTheLens, text::Part::kFix, "a larger --max-angle"},
    OptionHint{Code::kTargetCannotReach, text::Part::kFix,
               "another model may reach further: fca-io models FILE compares all models"},
    OptionHint{Code::kDomainGiven, text::Part::kText, "given (--max-angle)"},
    OptionHint{Code::kDomainInsideGiven, text::Part::kText, "the whole image (it ends inside --max-angle)"},
    // Comparison.
    OptionHint{Code::kResolutionDiffers, text::Part::kFix,
               "say how the reference's images become the other's: --crop X,Y,W,H, --binning N, --resize {3}x{4}"},
    // Fields.
    OptionHint{Code::kPoseMirrors, text::Part::kFix,
               "mend the sign or the order of its rows first; fca-io check shows the place"},
};

}  // namespace

std::string_view with_options(Code code, text::Part part) {
  const auto* const hint =
      std::ranges::find_if(kHints, [&](const OptionHint& each) { return each.code == code && each.part == part; });
  return hint != kHints.end() ? hint->words : text::table_wording(code, part);
}

}  // namespace fca::cli
