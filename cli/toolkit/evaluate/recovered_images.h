// SPDX-License-Identifier: BSD-3-Clause
// `fca-io evaluate --image`: computes the image that each converted camera would have taken, and compares it with the image
// itself (PSNR, SSIM).
#pragma once

#include <fca/toolkit/evaluate.h>

namespace fca {

/// Adds image statistics to the rows of each table in `evaluation` whose published image size is the size of the request's
/// image. False, with an error, if the image cannot be read or no table has its size.
[[nodiscard]] bool add_recovered_images(const EvaluateRequest& request, Files& files, EvaluateResult& evaluation);

}  // namespace fca
