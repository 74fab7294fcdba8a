// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/formats/consumers/consumer.h>
#include <fca/toolkit/convert.h>

#include <string>

namespace fca {

/// Converts a file for `program` and returns the result without its files. `rewrite`: write a fresh file even if the text of
/// the input could be edited.
[[nodiscard]] ConvertResult preview_conversion(const std::string& file, const Inputs& inputs,
                                               const consumers::Consumer& program, Files& files, bool rewrite = false);

}  // namespace fca
