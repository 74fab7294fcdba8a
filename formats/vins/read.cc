// SPDX-License-Identifier: BSD-3-Clause
#include "camera_file.h"
#include "config.h"
#include "vins.h"

#include <fca/code.h>

#include <algorithm>

namespace fca::vins {

std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options, Diagnostics& diagnostics) {
  Rig rig;
  for (std::size_t i = 0; i < documents.size(); ++i) {
    const text::Document& document = documents[i];
    if (!is_yaml(document)) {
      diagnostics.add(Code::kVinsWrongSyntax, {}, document.source().range({0, 1}));
      return std::nullopt;
    }
    Diagnostics found;
    if (is_config(document)) {
      const std::span<const text::Document> files = documents.subspan(i + 1);
      read_config(document, files.first(std::min(files.size(), camera_files_of(document).size())), options, rig, found);
      i = documents.size();
    } else {
      read_camera_file(document, options, rig, found);
    }
    for (const Diagnostic& entry : found.entries()) diagnostics.add(entry);
    if (found.has_errors()) return std::nullopt;
  }
  return rig;
}

}  // namespace fca::vins
