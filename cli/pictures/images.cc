// SPDX-License-Identifier: BSD-3-Clause
#include "images.h"

#include "toolkit/remap/image_mat.h"

#include <opencv2/imgcodecs.hpp>

#include <cstring>
#include <exception>
#include <iostream>
#include <string_view>

namespace fca::cli::module {

namespace {

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

}  // namespace fca::cli::module
