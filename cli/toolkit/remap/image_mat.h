// SPDX-License-Identifier: BSD-3-Clause
// Conversions between Image and cv::Mat.
#pragma once

#include <fca/toolkit/image.h>

#include <optional>

#include <opencv2/core.hpp>

namespace fca {

/// OpenCV's depth for a sample type.
inline int depth_of(Image::Sample sample) {
  switch (sample) {
    case Image::Sample::k8Bit:
      return CV_8U;
    case Image::Sample::k16Bit:
      return CV_16U;
    case Image::Sample::kFloat:
      break;
  }
  return CV_32F;
}

/// The sample type for a depth of OpenCV. nullopt if Image has no such type.
inline std::optional<Image::Sample> sample_of(int depth) {
  for (const Image::Sample sample : {Image::Sample::k8Bit, Image::Sample::k16Bit, Image::Sample::kFloat}) {
    if (depth_of(sample) == depth) return sample;
  }
  return std::nullopt;
}

/// A Mat that shares the memory of the image. It must only be passed to OpenCV as a constant, so that the image is not changed.
inline cv::Mat as_mat(const Image& image) {
  return {image.height, image.width, CV_MAKETYPE(depth_of(image.sample), image.channels),
          const_cast<std::uint8_t*>(image.bytes.data())};
}

/// Copies a Mat to an image. nullopt if the Mat is empty, or if its depth or number of channels is not one that Image has.
inline std::optional<Image> as_image(const cv::Mat& mat) {
  const std::optional<Image::Sample> sample = sample_of(mat.depth());
  const int channels = mat.channels();
  if (mat.empty() || !sample || !(channels == 1 || channels == 3 || channels == 4)) return std::nullopt;
  const cv::Mat whole = mat.isContinuous() ? mat : mat.clone();
  return Image{whole.cols, whole.rows, channels, *sample, {whole.data, whole.data + whole.total() * whole.elemSize()}};
}

}  // namespace fca
