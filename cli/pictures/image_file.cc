// SPDX-License-Identifier: BSD-3-Clause
#include "image_file.h"

#include "image_formats.h"
#include "pictures.h"
#include "shell/words.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace fca::cli {

namespace fs = std::filesystem;

std::optional<Image> read_image(const std::string& path, Diagnostics& diagnostics) {
  constexpr std::uintmax_t kLargest = 1U << 30U;  // bytes; no camera makes more, and OpenCV counts in int
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  const auto refuse = [&](const char* code, const std::string& message) {
    diagnostics.error(code, message, {path, 0, 0});
    return std::nullopt;
  };
  if (!fs::exists(status)) return refuse("cannot-read", "there is no such file");
  if (!fs::is_regular_file(status)) return refuse("no-image", fs::is_directory(status) ? "it is a folder" : "it is no file");
  if (fs::file_size(path, error) > kLargest) return refuse("no-image", "it is larger than 1 GiB");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return refuse("cannot-read", std::strerror(errno));
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (bytes.empty()) return refuse("no-image", "the file is empty");
  std::optional<Image> image = decoded(bytes);
  if (!image) {
    diagnostics.error("no-image", "this is no image, or not a whole one, or of a kind that is not read", {path, 0, 0},
                      "up to 134 megapixels are read, as " + image_extensions());
  }
  return image;
}

bool has_size_of(const Camera& camera, bool changed, const Image& image, const std::string& path, Diagnostics& diagnostics) {
  const ImageSize& known = *camera.image_size;
  const ImageSize is = {image.width, image.height};
  if (is == known) return true;
  // Of a camera's pixels some may be left out on each side before they are scaled: the same proportions to a pixel.
  const bool scaled = std::abs(1.0 * known.width * is.height / known.height - is.width) <= 1.0;
  const bool part = is.width <= known.width && is.height <= known.height;
  const std::string size = std::to_string(is.width) + "x" + std::to_string(is.height);
  std::string fix = "give the images of the calibrated size";
  if (changed) {
    fix = "--crop, --binning and --resize say what was done to the images that are given; leave out what was not";
  } else if (scaled) {
    fix = "if it is the calibrated image, scaled: --resize " + size;
  } else if (part) {
    fix = "if it is a part of the calibrated image: --crop X,Y," + std::to_string(is.width) + "," + std::to_string(is.height);
  }
  diagnostics.error(
      "image-size",
      "the image is " + size_in_words(is) + " px, and " + camera.name + " is known for " + size_in_words(known) + " px",
      {path, 0, 0}, fix);
  return false;
}

}  // namespace fca::cli
