// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/read_back.h>
#include <fca/formats/text/read_document.h>

#include <span>

namespace fca {

std::optional<Rig> read_back(const Format& format, const Written::File& file, const ReadOptions& options) {
  Diagnostics told_when_written;
  if (!file.document.edited()) return format.read(std::span(&file.document, 1), options, told_when_written);
  const std::optional<text::Document> document = text::as_edited(file.document);
  return document ? format.read(std::span(&*document, 1), options, told_when_written) : std::nullopt;
}

std::optional<Rig> read_back(const Format& format, const Written::File& file, const Rig& rig, const Written& written) {
  const Camera* camera = file.cameras.empty() ? nullptr : rig.find_camera(file.cameras.front());
  return read_back(format, file, camera == nullptr ? ReadOptions{} : ReadOptions{camera->image_size, written.opencv_model});
}

}  // namespace fca
