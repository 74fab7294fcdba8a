// SPDX-License-Identifier: BSD-3-Clause
#include "image_file.h"

#include "image_formats.h"
#include "pictures.h"

#include <fca/code.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace fca::cli {

namespace fs = std::filesystem;

std::optional<Image> read_image_file(const std::string& path, Diagnostics& diagnostics) {
  constexpr std::uintmax_t kLargest = 1U << 30U;  // bytes; no camera makes more, and OpenCV counts in int
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  const auto refuse = [&](Code why, std::vector<Argument> arguments = {}) {
    diagnostics.add(why, std::move(arguments), {path, 0, 0});
    return std::nullopt;
  };
  if (!fs::exists(status)) return refuse(Code::kImageMissing);
  if (!fs::is_regular_file(status)) return refuse(fs::is_directory(status) ? Code::kImageIsFolder : Code::kImageIsNoFile);
  if (fs::file_size(path, error) > kLargest) return refuse(Code::kImageFileTooLarge);
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return refuse(Code::kImageUnreadable, {std::strerror(errno)});
  std::string bytes(fs::file_size(path, error), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  if (bytes.empty()) return refuse(Code::kImageFileEmpty);
  std::optional<Image> image = decoded(bytes);
  if (!image) diagnostics.add(Code::kNotAnImage, {image_extensions()}, {path, 0, 0});
  return image;
}

}  // namespace fca::cli
