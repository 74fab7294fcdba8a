// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/formats/consumers/consumer.h>
#include <fca/toolkit/convert.h>

#include <string>

namespace fca {

/// The result of converting a file for `program`, without the files themselves: for a program that does not read the file's
/// format or, with `rewrite`, reads another layout of it better.
[[nodiscard]] ConvertResult preview_conversion(const std::string& file, const Inputs& inputs,
                                               const consumers::Consumer& program, Files& files, bool rewrite = false);

}  // namespace fca
