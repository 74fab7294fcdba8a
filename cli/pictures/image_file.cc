// SPDX-License-Identifier: BSD-3-Clause
#include "image_file.h"

#include "image_formats.h"
#include "pictures.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace fca::cli {

namespace fs = std::filesystem;

std::optional<Image> read_image_file(const std::string& path, Diagnostics& diagnostics) {
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

}  // namespace fca::cli
