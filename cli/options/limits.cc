// SPDX-License-Identifier: BSD-3-Clause
#include "limits.h"

#include <fca/formats/text/numbers.h>

namespace fca::cli {

void add_max_error_option(Options& options, const std::string& help, std::optional<double>& limit_px) {
  options.group(OptionGroup::kProof);
  options.number("--max-error", "PX", help, [&limit_px](double limit) -> std::optional<std::string> {
    if (!(limit >= 0.0)) return "--max-error wants a number of pixels";
    limit_px = limit;
    return std::nullopt;
  });
}

void add_max_error_option(Options& options, const std::string& help, std::optional<double>& limit_px,
                          std::optional<double>& limit_sigmas) {
  options.group(OptionGroup::kProof);
  options.value("--max-error", "PX", help, [&limit_px, &limit_sigmas](const std::string& word) -> std::optional<std::string> {
    constexpr std::string_view kSigma = "sigma";
    const bool in_sigmas = word.ends_with(kSigma);
    const std::optional<double> limit = text::parse_real(word.substr(0, word.size() - (in_sigmas ? kSigma.size() : 0)));
    if (!limit || !(*limit >= 0.0)) return "--max-error wants a number of pixels, or of standard deviations (0.2sigma)";
    (in_sigmas ? limit_sigmas : limit_px) = limit;
    return std::nullopt;
  });
}

void add_strict_option(Options& options, const std::string& help, bool& strict) {
  options.group(OptionGroup::kProof);
  options.flag("--strict", help, strict);
}

void add_every_pixel_option(Options& options, bool& every_pixel) {
  options.group(OptionGroup::kProof);
  options.flag("--every-pixel", "Evaluate every pixel, not a lattice of about 5,000 points", every_pixel);
}

}  // namespace fca::cli
