// SPDX-License-Identifier: BSD-3-Clause
// PSNR and SSIM as the program of the paper computes them (S. Lee, "Fisheye-Calib-Adapter", 2024; program:
// eowjd0512/fisheye-calib-adapter b5b0e82, adapter.cpp: get_image, calculate_psnr, calculate_ssim). fca-io repeats them to
// compare with the paper's columns. They do not measure the quality of a conversion: see PaintedImage.
#pragma once

#include <fca/toolkit/evaluate.h>

#include <fca/rig/grey_image.h>

#include <functional>
#include <optional>
#include <vector>

namespace fca {

/// Returns the position [px] to which a conversion moves a pixel of the image; nullopt if no such position exists.
using Placement = std::function<std::optional<Pixel>(const Pixel& pixel)>;

/// Paints the image twice, once with every pixel at its own position and once with each pixel moved by `place`, and compares
/// the two paintings. `colours`: the planes blue, green and red, or one grey plane.
[[nodiscard]] PaintedImage painted_image(const std::vector<GreyImage>& colours, const Placement& place);

/// The statistics of painted_image() if `place` only adds noise of up to 1e-9 px in each direction.
[[nodiscard]] PaintedImage painted_with_noise(const std::vector<GreyImage>& colours);

}  // namespace fca
