// SPDX-License-Identifier: BSD-3-Clause
#include "image_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

namespace fca {

namespace {

/// Copies one channel of an image whose samples have the type T.
template <class T>
void put_samples(const Image& image, std::size_t channel, std::span<float> samples) {
  const std::uint8_t* from = image.bytes.data() + channel * sizeof(T);
  const std::size_t stride = static_cast<std::size_t>(image.channels) * sizeof(T);
  for (float& sample : samples) {
    T value{};
    std::memcpy(&value, from, sizeof(T));
    from += stride;
    sample = static_cast<float>(value);
    if constexpr (std::is_floating_point_v<T>) sample = std::isfinite(sample) ? sample : 0.0F;
  }
}

void put_samples(const Image& image, std::size_t channel, std::span<float> samples) {
  switch (image.sample) {
    case Image::Sample::k8Bit:
      return put_samples<std::uint8_t>(image, channel, samples);
    case Image::Sample::k16Bit:
      return put_samples<std::uint16_t>(image, channel, samples);
    case Image::Sample::kFloat:
      return put_samples<float>(image, channel, samples);
  }
}

/// The level that white has. For floating-point samples, it is the largest sample of the image, but at least 1. For 16-bit
/// samples, it is the largest level of 10, 12, 14 or 16 bits: sensors with fewer than 16 bits leave the high bits 0.
float full_scale_of(const Image& image, const std::vector<GreyImage>& planes) {
  if (image.sample == Image::Sample::k8Bit) return 255.0F;
  float largest = 1.0F;
  for (const GreyImage& plane : planes) largest = std::max(largest, *std::ranges::max_element(plane.samples));
  if (image.sample == Image::Sample::kFloat) return largest;
  constexpr std::array<float, 4> kLargestLevels = {1023.0F, 4095.0F, 16383.0F, 65535.0F};
  return *std::ranges::lower_bound(kLargestLevels, largest);
}

}  // namespace

std::vector<GreyImage> planes(const Image& image) {
  constexpr int kChannelsWithOpacity = 4;
  const int colours = image.channels == kChannelsWithOpacity ? kChannelsWithOpacity - 1 : image.channels;
  const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  std::vector<GreyImage> result;
  for (int colour = 0; colour < colours; ++colour) {
    GreyImage& plane = result.emplace_back(GreyImage{image.width, image.height, 0.0F, {}});
    plane.samples.resize(pixels);
    put_samples(image, static_cast<std::size_t>(colour), plane.samples);
  }
  const float full_scale = full_scale_of(image, result);
  for (GreyImage& plane : result) plane.full_scale = full_scale;
  return result;
}

}  // namespace fca
