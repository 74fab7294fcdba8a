// SPDX-License-Identifier: BSD-3-Clause
// Sampling by quadrature: a few hundred weighted points stand for every pixel of the field of view.
#pragma once

#include <fca/convert/field_of_view.h>
#include <fca/convert/lens.h>

#include <vector>

namespace fca {

/// About `count` places of the field of view with their rays (up to three times as many where the lens's edge crosses the
/// image's border); the weights are shares of the field of view's pixels and sum to 1.
///
/// Where the whole image is the field of view: a tensor of Gauss nodes of its rows' and columns' pixels. Where the lens ends
/// inside the image: polar around the principal point, Gauss-Legendre along the radius and around it along the image's sides or
/// the lens's edge, closer to each other towards that edge, where the angle may change without limit. A weighted sum over the
/// places is then the mean over all pixels to far below what a fit can notice (LIMITS.md: within 1.004 of the optimum over all
/// pixels at 200).
[[nodiscard]] std::vector<Correspondence> sample(const Lens& source, const FieldOfView& field_of_view, int count = 200);

}  // namespace fca
