// SPDX-License-Identifier: BSD-3-Clause
#include "command_files.h"

#include "pictures/image_file.h"

#include <fca/formats/text/read_document.h>
#include <fca/formats/text/read_stream.h>

namespace fca::cli {

std::optional<Image> CommandFiles::read_image(const std::string& path, Diagnostics& diagnostics) {
  return read_image_file(path, diagnostics);
}

std::optional<text::Source> CommandFiles::fetch(const std::string& path, Diagnostics& diagnostics) const {
  if (is_standard_input(path)) return text::read_stream(text::kStandardInput, streams_->in);
  return text::read_source(path, diagnostics);
}

}  // namespace fca::cli
