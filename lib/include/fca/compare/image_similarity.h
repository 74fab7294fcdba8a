// SPDX-License-Identifier: BSD-3-Clause
// How alike two images are, by the two measures that papers print.
#pragma once

#include <fca/rig/grey_image.h>

#include <cstdint>
#include <span>

namespace fca {

struct ImageSimilarity {
  double mean_square = 0.0;  ///< Of the differences, in squares of samples.
  double ssim = 1.0;         ///< In [-1, 1]; 1: the same.
  double compared = 0.0;     ///< Share of the pixels that the mean square is over.
  double windows = 0.0;      ///< Share of the pixels that SSIM is the mean over; 0: there is none, and it says nothing.
};

/// Of two images of one size and full scale, over the pixels where `mask` is not 0 (one byte per pixel; empty: all).
///
/// SSIM is Wang, Bovik, Sheikh & Simoncelli, "Image Quality Assessment: From Error Visibility to Structural Similarity" (2004),
/// eq. 13: windows of 11 x 11 pixels with Gaussian weights of standard deviation 1.5 that sum to 1, C1 = (0.01 L)^2,
/// C2 = (0.03 L)^2, L the full scale. The mean is over the pixels whose whole window lies inside the image and the mask;
/// nothing is made up beyond them.
[[nodiscard]] ImageSimilarity similarity(const GreyImage& a, const GreyImage& b, std::span<const std::uint8_t> mask = {});

/// 10 log10(L^2 / mean square) [dB]; infinite for the same images.
[[nodiscard]] double psnr_db(double mean_square, double full_scale);

}  // namespace fca
