// SPDX-License-Identifier: BSD-3-Clause
#include <fca/code.h>
#include <fca/formats/text/read_document.h>
#include <fca/toolkit/files.h>

#include <algorithm>

namespace fca {

std::optional<text::Source> Files::read(const std::string& path, Diagnostics& diagnostics) {
  const auto before =
      is_standard_input(path) ? std::ranges::find(sources_, text::kStandardInput, &text::Source::name) : sources_.end();
  std::optional<text::Source> source = before != sources_.end() ? std::optional(*before) : fetch(path, diagnostics);
  if (source) remember(*source);
  return source;
}

std::optional<Image> Files::read_image(const std::string& path, Diagnostics& diagnostics) {
  diagnostics.add(Code::kFilesWithoutImages, {}, {path, 0, 0});
  return std::nullopt;
}

std::optional<text::Source> Files::fetch(const std::string& path, Diagnostics& diagnostics) const {
  return text::read_source(path, diagnostics);
}

}  // namespace fca
