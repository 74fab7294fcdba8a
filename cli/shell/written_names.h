// SPDX-License-Identifier: BSD-3-Clause
// Names of cameras as people find them in the files that were written.
#pragma once

#include <fca/toolkit/convert.h>

#include <span>

namespace fca::cli {

/// Losses, and those warnings and reasons that speak of the written file, name a camera by its name in the input: names it as
/// the file does, "cam0 (input's cam1)". What is to be given to a program as an option stays.
void name_as_written(ConvertResult& result);
void name_as_written(Verdict& verdict, std::span<const ConvertedCamera> cameras);

}  // namespace fca::cli
