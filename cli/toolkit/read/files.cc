// SPDX-License-Identifier: BSD-3-Clause
#include <fca/code.h>
#include <fca/formats/calibration.h>
#include <fca/formats/text/read_document.h>
#include <fca/toolkit/files.h>

#include <algorithm>
#include <utility>

namespace fca {

std::optional<text::Source> Files::read(const std::string& path, Diagnostics& diagnostics) {
  const auto earlier =
      is_standard_input(path) ? std::ranges::find(sources_, text::kStandardInput, &text::Source::name) : sources_.end();
  std::optional<text::Source> source = earlier != sources_.end() ? std::optional(*earlier) : fetch(path, diagnostics);
  if (source) remember(*source);
  return source;
}

std::optional<text::Document> Files::parse(text::Source source, Diagnostics& diagnostics) {
  const auto known = std::ranges::find_if(parsed_, [&source](const std::shared_ptr<const Parsed>& each) {
    const text::Source& other = each->document.source();
    return other.name == source.name && other.bytes == source.bytes;
  });
  Diagnostics found;
  std::optional<text::Document> document;
  if (known != parsed_.end()) {
    found = (*known)->found;
    document = (*known)->document;
  } else {
    document = parse_calibration(source, found);
    if (document) parsed_.push_back(std::make_shared<const Parsed>(Parsed{*document, found}));
  }
  for (const Diagnostic& entry : found.entries()) diagnostics.add(entry);
  return document;
}

std::optional<Image> Files::read_image(const std::string& path, Diagnostics& diagnostics) {
  diagnostics.add(Code::kFilesWithoutImages, {}, {path, 0, 0});
  return std::nullopt;
}

std::optional<text::Source> Files::fetch(const std::string& path, Diagnostics& diagnostics) const {
  return text::read_source(path, diagnostics);
}

}  // namespace fca
