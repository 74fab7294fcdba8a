// SPDX-License-Identifier: BSD-3-Clause
// What the files written call the cameras, where that is not what the input calls them.
#pragma once

#include <fca/formats/format.h>
#include <fca/toolkit/convert.h>

#include <span>
#include <string>
#include <vector>

namespace fca {

/// Gives the cameras the names that the files written have for them, where those state or count cameras: a chain begins with
/// cam0, whichever camera was chosen for it.
void name_as_written(const Format& format, const Written& written, std::vector<ConvertedCamera>& cameras);

/// A camera by its name in the input: "cam0 (input's cam1)" if the files call it otherwise. Any other name as it is.
[[nodiscard]] std::string name_in_words(const std::string& name, std::span<const ConvertedCamera> cameras);

/// Names the owner of a loss so, and the cameras of its lists. What else it has (a name that is to be given to the program)
/// stays.
void name_as_in_file(Loss& loss, std::span<const ConvertedCamera> cameras);

}  // namespace fca
