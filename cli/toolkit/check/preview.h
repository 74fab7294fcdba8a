// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/formats/consumers/consumer.h>
#include <fca/toolkit/convert.h>

#include <string>

namespace fca {

/// What converting a file gives for a program, without the files themselves: one that does not read its format, or reads
/// another layout of it better (`rewrite`).
[[nodiscard]] ConvertResult preview_conversion(const std::string& file, const Inputs& inputs,
                                               const consumers::Consumer& program, Files& files, bool rewrite = false);

}  // namespace fca
