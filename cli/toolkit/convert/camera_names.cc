// SPDX-License-Identifier: BSD-3-Clause
#include "camera_names.h"

#include <fca/formats/text/dialect.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>

namespace fca {

namespace {

/// True if the name is a top-level key of the file; false if the reader of the file made it up.
bool contains_name(const Written::File& file, const std::string& name) {
  const std::optional<text::Document> document = text::as_edited(file.document);
  return document && text::find_entry(document->root(), name, text::Dialect::kPyYaml) != nullptr;
}

}  // namespace

void name_as_written(const Format& format, const Written& written, std::vector<ConvertedCamera>& cameras) {
  if (!format.many_cameras) return;
  for (const Written::File& file : written.files) {
    if (!file.says || file.says->cameras.size() != file.cameras.size()) continue;
    for (std::size_t i = 0; i < file.cameras.size(); ++i) {
      const std::string& name = file.says->cameras[i].name;
      const auto camera =
          std::ranges::find_if(cameras, [&](const ConvertedCamera& each) { return each.source.name == file.cameras[i]; });
      // A single camera whose name is not in the file keeps the name of the input.
      if (camera != cameras.end() && (file.cameras.size() > 1 || contains_name(file, name))) camera->name_in_file = name;
    }
  }
}

}  // namespace fca
