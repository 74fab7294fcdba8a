// SPDX-License-Identifier: BSD-3-Clause
// PSNR and SSIM as the authors' program computes them (eowjd0512/fisheye-calib-adapter b5b0e82, adapter.cpp: get_image,
// calculate_psnr, calculate_ssim), for a comparison with the paper's columns. They do not measure the quality of a conversion:
// see PaintedImage.
#pragma once

#include <fca/toolkit/evaluate.h>

#include <fca/rig/grey_image.h>

#include <functional>
#include <optional>
#include <vector>

namespace fca {

/// The position to which a program moves a pixel of the image; nullopt if it has none.
using Placement = std::function<std::optional<Pixel>(const Pixel& pixel)>;

/// `colours`: blue, green and red, or grey.
[[nodiscard]] PaintedImage painted_image(const std::vector<GreyImage>& colours, const Placement& place);

/// The statistics if every pixel stays at its position, except for noise of up to 1e-9 px.
[[nodiscard]] PaintedImage painted_with_noise(const std::vector<GreyImage>& colours);

}  // namespace fca
