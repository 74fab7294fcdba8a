// SPDX-License-Identifier: BSD-3-Clause
#include "settings.h"

#include <fca/code.h>
#include <fca/formats/set_value.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>

namespace fca {

namespace {

/// The frame rate that a document states with its edits; nothing where it states none.
std::optional<double> frame_rate(const Format& format, const text::Document& document, const ReadOptions& options) {
  Diagnostics ignored;
  const std::optional<text::Document> now = text::as_edited(document);
  const std::optional<Rig> rig = now ? format.read(std::span(&*now, 1), options, ignored) : std::nullopt;
  return rig && !rig->cameras.empty() ? rig->cameras.front().frame_rate_hz : std::nullopt;
}

bool apply(const KeyValue& setting, const Format& format, const ReadOptions& options, std::optional<double> fps,
           Written& written, Diagnostics& diagnostics) {
  const auto has_key = [&setting](const Written::File& file) {
    const std::optional<text::Document> now = text::as_edited(file.document);
    return now && has_value(*now, setting.key);
  };
  const auto may_come = [&](const Written::File& file) {
    const std::optional<text::Document> now = text::as_edited(file.document);
    return now && may_add_value(format, *now, setting.key);
  };
  const bool nowhere = std::ranges::none_of(written.files, has_key);
  const bool comes = nowhere && std::ranges::any_of(written.files, may_come);
  for (Written::File& file : written.files) {
    if (comes ? !may_come(file) : !nowhere && !has_key(file)) continue;
    std::optional<text::Document> document = set_value(format, file.document, setting, options, diagnostics);
    if (!document) return false;
    if (fps && frame_rate(format, *document, options) != frame_rate(format, file.document, options)) {
      diagnostics.add(Code::kSettingContradictsRate, {setting.key, setting.value, *fps});
      return false;
    }
    file.document = *std::move(document);
  }
  std::erase_if(written.defaults, [&setting](const DefaultedValue& value) { return value.key == setting.key; });
  return true;
}

}  // namespace

bool apply_settings(const ConvertRequest& request, const Format& format, Written& written, Diagnostics& diagnostics) {
  ReadOptions options = read_options(request.inputs);
  options.join = false;           // each file by itself
  options.length_unit_m.reset();  // it is written in metres
  return std::ranges::all_of(request.settings, [&](const KeyValue& setting) {
    return apply(setting, format, options, request.frame_rate_hz, written, diagnostics);
  });
}

}  // namespace fca
