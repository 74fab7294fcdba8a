// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/toolkit/convert.h>

namespace fca {

/// Where the request asks for the format's layout for programs that take the first fisheye's lens for both
/// (Format::common_lens_layout), fits one lens to the first two cameras, with a note of what each gains; false with an error
/// where they are no pair of fisheyes of one model, or the file holds fewer than two: `held`.
[[nodiscard]] bool share_lens(const ConvertRequest& request, const Format& to, std::size_t held,
                              std::vector<ConvertedCamera>& cameras, Diagnostics& diagnostics);

}  // namespace fca
