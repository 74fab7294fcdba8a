// SPDX-License-Identifier: BSD-3-Clause
// evaluate --image: an image that the source camera took, shown as the converted one would have taken it.
#pragma once

#include "toolkit/evaluation.h"

#include <string>

namespace fca::cli {

/// Adds to each row of the tables how alike an image and the one recovered from it by that row's conversion are: each pixel of
/// the recovered one is the original's where the source camera sees the converted one's ray (Lanczos, at exactly that place,
/// not rounded to grey levels). Places near the border, whose window reaches beyond the image, are left out. With models that
/// agree the two are the same. False with an error where there is no such image, or none of that size among the tables.
[[nodiscard]] bool add_recovered_images(const std::string& path, Evaluation& evaluation, Diagnostics& diagnostics);

}  // namespace fca::cli
