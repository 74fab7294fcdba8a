// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/convert.h>

namespace fca {

/// If the request's layout is for programs that use the first fisheye's lens parameters for both (Format::common_lens_layout),
/// fits one lens to the first two cameras and adds a note with the errors before and after. `held`: the number of cameras in
/// the file. False, with an error, if it is below 2, or the first two cameras are not fisheyes of one model.
[[nodiscard]] bool share_lens(const ConvertRequest& request, const Format& to, std::size_t held,
                              std::vector<ConvertedCamera>& cameras, Diagnostics& diagnostics);

}  // namespace fca
