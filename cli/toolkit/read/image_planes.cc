// SPDX-License-Identifier: BSD-3-Clause
#include "image_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace fca {

namespace {

template <class T>
float sample_as(const Image& image, std::size_t index) {
  T value{};
  std::memcpy(&value, &image.bytes[index * sizeof(T)], sizeof(T));
  return static_cast<float>(value);
}

float sample_at(const Image& image, std::size_t index) {
  switch (image.sample) {
    case Image::Sample::k8Bit:
      return sample_as<std::uint8_t>(image, index);
    case Image::Sample::k16Bit:
      return sample_as<std::uint16_t>(image, index);
    case Image::Sample::kFloat:
      break;
  }
  const auto value = sample_as<float>(image, index);
  return std::isfinite(value) ? value : 0.0F;
}

/// The level of white. Floating-point samples have no largest value: the image's own is taken, at least 1. Sensors of 10, 12 or
/// 14 bits deliver 16-bit samples whose high bits are mostly 0.
float full_scale_of(const Image& image, const std::vector<GreyImage>& planes) {
  if (image.sample == Image::Sample::k8Bit) return 255.0F;
  float largest = 1.0F;
  for (const GreyImage& plane : planes) largest = std::max(largest, *std::ranges::max_element(plane.samples));
  if (image.sample == Image::Sample::kFloat) return largest;
  constexpr std::array<float, 4> kDepths = {1023.0F, 4095.0F, 16383.0F, 65535.0F};
  return *std::ranges::lower_bound(kDepths, largest);
}

}  // namespace

std::vector<GreyImage> planes(const Image& image) {
  constexpr int kWithOpacity = 4;
  const int colours = image.channels == kWithOpacity ? kWithOpacity - 1 : image.channels;
  const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  std::vector<GreyImage> result;
  for (int colour = 0; colour < colours; ++colour) {
    GreyImage& plane = result.emplace_back(GreyImage{image.width, image.height, 0.0F, {}});
    plane.samples.reserve(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
      plane.samples.push_back(
          sample_at(image, i * static_cast<std::size_t>(image.channels) + static_cast<std::size_t>(colour)));
    }
  }
  const float full_scale = full_scale_of(image, result);
  for (GreyImage& plane : result) plane.full_scale = full_scale;
  return result;
}

}  // namespace fca
