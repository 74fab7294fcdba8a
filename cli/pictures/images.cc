// SPDX-License-Identifier: BSD-3-Clause
#include "images.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <cstring>
#include <exception>
#include <iostream>
#include <string_view>

namespace fca::cli::module {

namespace {

int depth_of(Image::Sample sample) {
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

std::optional<Image::Sample> sample_of(int depth) {
  for (const Image::Sample sample : {Image::Sample::k8Bit, Image::Sample::k16Bit, Image::Sample::kFloat}) {
    if (depth_of(sample) == depth) return sample;
  }
  return std::nullopt;
}

/// The image's own memory, which OpenCV only reads where it is given a constant Mat.
cv::Mat as_mat(const Image& image) {
  return {image.height, image.width, CV_MAKETYPE(depth_of(image.sample), image.channels),
          const_cast<std::uint8_t*>(image.bytes.data())};
}

std::optional<Image> as_image(const cv::Mat& mat) {
  const std::optional<Image::Sample> sample = sample_of(mat.depth());
  const int channels = mat.channels();
  if (mat.empty() || !sample || !(channels == 1 || channels == 3 || channels == 4)) return std::nullopt;
  const cv::Mat whole = mat.isContinuous() ? mat : mat.clone();
  return Image{whole.cols, whole.rows, channels, *sample, {whole.data, whole.data + whole.total() * whole.elemSize()}};
}

/// OpenCV fills what a JPEG lacks with grey, and says so to nobody: its end marker must come after its last scan began.
bool is_cut_jpeg(std::string_view bytes) {
  if (!bytes.starts_with("\xFF\xD8")) return false;
  const std::size_t scan = bytes.rfind("\xFF\xDA");
  return scan == std::string_view::npos || bytes.find("\xFF\xD9", scan) == std::string_view::npos;
}

/// libpng complains of a cut file in words of its own: its last chunk must be there.
bool is_cut_png(std::string_view bytes) {
  return bytes.starts_with("\x89PNG") && bytes.rfind("IEND") == std::string_view::npos;
}

/// OpenCV tells std::cerr what is wrong with an image, and our own message (by stderr, not by std::cerr) says it too.
void hush_opencv() {
  static const std::streambuf* const kSpoken = std::cerr.rdbuf(nullptr);
  static_cast<void>(kSpoken);
}

}  // namespace

std::optional<Image> decoded_image(const std::string& bytes) {
  if (bytes.empty() || is_cut_jpeg(bytes) || is_cut_png(bytes)) return std::nullopt;
  hush_opencv();
  try {
    const cv::Mat file(1, static_cast<int>(bytes.size()), CV_8U, const_cast<char*>(bytes.data()));
    return as_image(cv::imdecode(file, cv::IMREAD_UNCHANGED));
  } catch (const std::exception&) {  // OpenCV's, or out of memory
    return std::nullopt;
  }
}

std::optional<std::string> encoded_image(const Image& image, const std::string& extension) {
  try {
    std::vector<std::uint8_t> bytes;
    if (!cv::imencode(extension, as_mat(image), bytes)) return std::nullopt;
    return std::string(bytes.begin(), bytes.end());
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

std::optional<Image> remapped_image(const Image& image, const ImageMap& map, Interpolation interpolation) {
  try {
    const cv::Mat places(map.size.height, map.size.width, CV_32FC2, const_cast<float*>(map.uv.data()));
    cv::Mat result;
    cv::remap(as_mat(image), result, places, cv::noArray(),
              interpolation == Interpolation::kLanczos ? cv::INTER_LANCZOS4 : cv::INTER_LINEAR);
    return as_image(result);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace fca::cli::module
