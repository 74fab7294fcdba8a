// SPDX-License-Identifier: BSD-3-Clause
#include "image_formats.h"

#include "shell/words.h"

#include <algorithm>
#include <array>
#include <vector>

namespace fca::cli {

namespace {

/// What OpenCV's encoders write as it is.
struct ImageFormat {
  std::string_view extension;
  bool grey;
  bool colour;
  bool alpha;
  bool deep;  ///< 16 bits
  bool real;  ///< 32-bit floats
};

constexpr std::array kFormats = {
    ImageFormat{".png", true, true, true, true, false},    ImageFormat{".tif", true, true, true, true, true},
    ImageFormat{".tiff", true, true, true, true, true},    ImageFormat{".jpg", true, true, false, false, false},
    ImageFormat{".jpeg", true, true, false, false, false}, ImageFormat{".bmp", true, true, true, false, false},
    ImageFormat{".pgm", true, false, false, true, false},  ImageFormat{".ppm", false, true, false, true, false}};

const ImageFormat* find_image_format(std::string_view extension) {
  std::string lower(extension);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const auto* const found = std::ranges::find(kFormats, lower, &ImageFormat::extension);
  return found == kFormats.end() ? nullptr : found;
}

}  // namespace

bool is_image_extension(std::string_view extension) { return find_image_format(extension) != nullptr; }

std::optional<std::string> problem_with_format(const Image& image, std::string_view extension) {
  const ImageFormat* format = find_image_format(extension);
  if (format == nullptr)
    return "'" + std::string(extension) + "' is no image format that is written; there are " + image_extensions();
  const auto lacks = [&](std::string_view what) { return std::string(extension) + " files hold no " + std::string(what); };
  if (image.channels == 1 && !format->grey) return lacks("grey images");
  if (image.channels == 3 && !format->colour) return lacks("colours");
  if (image.channels == 4 && !format->alpha) return lacks("opacity, and this image has it");
  if (image.sample == Image::Sample::k16Bit && !format->deep) return lacks("16 bits, and this image has them");
  if (image.sample == Image::Sample::kFloat && !format->real) return lacks("floating-point numbers, and this image has them");
  return std::nullopt;
}

std::string image_extensions() {
  std::vector<std::string> names;
  names.reserve(kFormats.size());
  for (const ImageFormat& format : kFormats) names.emplace_back(format.extension);
  return enumerated(names);
}

}  // namespace fca::cli
