// SPDX-License-Identifier: BSD-3-Clause
// `fca-io evaluate --image`: the image as each converted camera would have taken it, compared with the image itself (PSNR,
// SSIM).
#pragma once

#include <fca/toolkit/evaluate.h>

namespace fca {

/// Fills the image statistics of the rows in those tables of `evaluation` whose published images have the size of the request's
/// image. False, with an error, if the image cannot be read or no table has that size.
[[nodiscard]] bool add_recovered_images(const EvaluateRequest& request, Files& files, EvaluateResult& evaluation);

}  // namespace fca
