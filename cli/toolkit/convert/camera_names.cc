// SPDX-License-Identifier: BSD-3-Clause
#include "camera_names.h"

#include <fca/formats/read_back.h>
#include <fca/formats/text/dialect.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <variant>

namespace fca {

namespace {

/// Does the file say the name, or does its reader make it up?
bool is_stated(const Written::File& file, const std::string& name) {
  const std::optional<text::Document> document = text::as_edited(file.document);
  return document && text::find_entry(document->root(), name, text::Dialect::kPyYaml) != nullptr;
}

}  // namespace

void name_as_written(const Format& format, const Written& written, std::vector<ConvertedCamera>& cameras) {
  if (!format.many_cameras) return;
  for (const Written::File& file : written.files) {
    const std::optional<Rig> rig = read_back(format, file, {std::nullopt, written.opencv_model, false});
    if (!rig || rig->cameras.size() != file.cameras.size()) continue;
    for (std::size_t i = 0; i < file.cameras.size(); ++i) {
      const std::string& name = rig->cameras[i].name;
      const auto camera =
          std::ranges::find_if(cameras, [&](const ConvertedCamera& each) { return each.source.name == file.cameras[i]; });
      if (camera != cameras.end() && (file.cameras.size() > 1 || is_stated(file, name))) camera->name_in_file = name;
    }
  }
}

std::string name_in_words(const std::string& name, std::span<const ConvertedCamera> cameras) {
  const auto camera = std::ranges::find_if(cameras, [&name](const ConvertedCamera& each) { return each.source.name == name; });
  return camera != cameras.end() ? camera->name_in_words() : name;
}

void name_as_in_file(Loss& loss, std::span<const ConvertedCamera> cameras) {
  loss.owner = name_in_words(loss.owner, cameras);
  for (Argument& value : loss.values) {
    auto* const names = std::get_if<std::vector<std::string>>(&value.value);
    if (names == nullptr) continue;
    for (std::string& name : *names) name = name_in_words(name, cameras);
  }
}

}  // namespace fca
