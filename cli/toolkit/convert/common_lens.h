// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/convert.h>

namespace fca {

/// Some programs use the lens parameters of the first fisheye camera for both cameras of a pair. If the request's layout is for
/// such programs (Format::common_lens_layout), fits common lens parameters to the first two cameras and adds a note with the
/// errors before and after. Otherwise does nothing. `cameras_in_file`: the number of cameras that the file will contain.
/// Returns false, with an error, if this number is below 2, if the first two cameras are not fisheyes of one model, or if the
/// fit fails.
[[nodiscard]] bool share_lens(const ConvertRequest& request, const Format& to, std::size_t cameras_in_file,
                              std::vector<ConvertedCamera>& cameras, Diagnostics& diagnostics);

}  // namespace fca
