// SPDX-License-Identifier: BSD-3-Clause
// What a result is measured by, and when it is not good enough: options that several commands have.
#pragma once

#include "options.h"

#include <optional>
#include <string>

namespace fca::cli {

/// --max-error; `help` says of what.
void add_max_error_option(Options& options, const std::string& help, std::optional<double>& limit_px);
/// The same with a number of standard deviations of the calibration's own pixels ("0.2sigma") in place of pixels, if asked for.
void add_max_error_option(Options& options, const std::string& help, std::optional<double>& limit_px,
                          std::optional<double>& limit_sigmas);
/// --strict
void add_strict_option(Options& options, const std::string& help, bool& strict);
/// --every-pixel
void add_every_pixel_option(Options& options, bool& every_pixel);

}  // namespace fca::cli
