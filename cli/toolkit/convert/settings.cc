// SPDX-License-Identifier: BSD-3-Clause
#include "settings.h"

#include <fca/code.h>
#include <fca/formats/set_value.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fca {

namespace {

/// The frame rate of a rig's first camera [Hz]; nullopt if it has none.
std::optional<double> frame_rate(const std::optional<Rig>& rig) {
  return rig && !rig->cameras.empty() ? rig->cameras.front().frame_rate_hz : std::nullopt;
}

/// A written file that settings may change.
class SetFile {
 public:
  SetFile(const Format& format, const ReadOptions& options, Written::File& file)
      : format_(format), options_(options), file_(file) {
    text::keep_edited(file_.document);
  }

  [[nodiscard]] bool has_key(const std::string& key) const {
    const text::Document* document = now();
    return document != nullptr && has_value(*document, key);
  }

  [[nodiscard]] bool may_add_key(const std::string& key) const {
    const text::Document* document = now();
    return document != nullptr && may_add_value(format_, *document, key);
  }

  /// Sets a key's value; false, with an error, if that fails. `fps`: the frame rate [Hz] that the request gives, which the
  /// setting must not change.
  [[nodiscard]] bool set(const KeyValue& setting, std::optional<double> fps, Diagnostics& diagnostics) {
    if (!stated_) stated_ = as_stated(format_, file_.document, options_, diagnostics);
    if (!stated_) return false;
    std::optional<StatedRig> after = set_value(format_, *stated_, setting, options_, diagnostics);
    if (!after) return false;
    if (fps && frame_rate(after->rig) != frame_rate(stated_->rig)) {
      diagnostics.add(Code::kSettingContradictsRate, {setting.key, setting.value, *fps});
      return false;
    }
    stated_ = *std::move(after);
    file_.document = stated_->document;
    return true;
  }

 private:
  /// The document as edited; null if the edits did not leave a valid document.
  [[nodiscard]] const text::Document* now() const {
    return file_.document.edited() ? file_.document.kept_edited() : &file_.document;
  }

  const Format& format_;
  const ReadOptions& options_;
  Written::File& file_;
  std::optional<StatedRig> stated_;  ///< nullopt until a value is set.
};

bool apply(const KeyValue& setting, std::optional<double> fps, std::vector<SetFile>& files, Diagnostics& diagnostics) {
  const auto has_key = [&setting](const SetFile& file) { return file.has_key(setting.key); };
  const auto may_add_key = [&setting](const SetFile& file) { return file.may_add_key(setting.key); };
  const bool nowhere = std::ranges::none_of(files, has_key);
  const bool comes = nowhere && std::ranges::any_of(files, may_add_key);
  return std::ranges::all_of(files, [&](SetFile& file) {
    const bool is_meant = comes ? may_add_key(file) : nowhere || has_key(file);
    return !is_meant || file.set(setting, fps, diagnostics);
  });
}

}  // namespace

bool apply_settings(const ConvertRequest& request, const Format& format, Written& written, Diagnostics& diagnostics) {
  if (request.settings.empty()) return true;
  ReadOptions options = read_options(request.inputs);
  options.join = false;           // each file is read alone
  options.length_unit_m.reset();  // written files are in metres
  std::vector<SetFile> files;
  files.reserve(written.files.size());
  for (Written::File& file : written.files) files.emplace_back(format, options, file);
  return std::ranges::all_of(request.settings, [&](const KeyValue& setting) {
    if (!apply(setting, request.frame_rate_hz, files, diagnostics)) return false;
    std::erase_if(written.defaults, [&setting](const DefaultedValue& value) { return value.key == setting.key; });
    return true;
  });
}

}  // namespace fca
