// SPDX-License-Identifier: BSD-3-Clause
// What the command itself says: of its words, which the command brings, its images, its outputs.
#include "rows.h"
#include "topics.h"

#include <array>

namespace fca::diagnostics {

namespace {

constexpr std::string_view kNoImage = "no-image";

}  // namespace

std::span<const CodeInfo> command_codes() {
  static constexpr std::array kRows = {
      bad_request(Code::kUsage, "usage", "{0}", "{1}"),
      bad_request(Code::kRefused, "refused", "{0}", "{1}"),
      bad_request(Code::kOverwritesInput, "overwrites-input", "{0} is an input; name another place"),
      clause(Code::kCommandInstead, "{0}"),
      error(Code::kImageMissing, "cannot-read", "there is no such file"),
      error(Code::kImageIsFolder, kNoImage, "it is a folder"),
      error(Code::kImageIsNoFile, kNoImage, "it is not a file"),
      error(Code::kImageFileTooLarge, kNoImage, "it is larger than 1 GiB"),
      error(Code::kImageUnreadable, "cannot-read", "{0}"),
      error(Code::kImageFileEmpty, kNoImage, "the file is empty"),
      error(Code::kNotAnImage, kNoImage, "this is not an image, or it is incomplete, or fca-io does not read its kind",
            "fca-io reads images of up to 134 megapixels, as {0}"),
      error(Code::kImageNotMapped, kNoImage, "OpenCV could not map it or write it as {0}"),
      bad_request(Code::kImageFormatUnfit, "image-format", "{0}"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
