// SPDX-License-Identifier: BSD-3-Clause
// `fca-io evaluate --image`: the image as each converted camera would have taken it, compared with the image itself (PSNR,
// SSIM).
#pragma once

#include <fca/toolkit/evaluate.h>

namespace fca {

/// Fills what rows have of an image in those tables of `evaluation` whose published images have the size of the request's.
/// False, with an error, where the image cannot be read, or where no table has that size.
[[nodiscard]] bool add_recovered_images(const EvaluateRequest& request, Files& files, EvaluateResult& evaluation);

}  // namespace fca
