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

/// The frame rate [Hz] of the first camera of the rig; nullopt if there is none.
std::optional<double> frame_rate(const std::optional<Rig>& rig) {
  return rig && !rig->cameras.empty() ? rig->cameras.front().frame_rate_hz : std::nullopt;
}

/// A written file to which settings are applied.
class EditableFile {
 public:
  EditableFile(const Format& format, const ReadOptions& options, Written::File& file)
      : format_(format), options_(options), file_(file) {
    text::keep_edited(file_.document);
  }

  [[nodiscard]] bool has_key(const std::string& key) const {
    const text::Document* document = edited();
    return document != nullptr && has_value(*document, key);
  }

  [[nodiscard]] bool may_add_key(const std::string& key) const {
    const text::Document* document = edited();
    return document != nullptr && may_add_value(format_, *document, key);
  }

  /// Sets the value of a key. Returns false, with an error, if that fails or if it would change the frame rate although the
  /// request gives that rate [Hz] as `fps`.
  [[nodiscard]] bool set(const KeyValue& setting, std::optional<double> fps, Diagnostics& diagnostics) {
    if (!current_) current_ = as_stated(format_, file_.document, options_, diagnostics);
    if (!current_) return false;
    std::optional<StatedRig> after = set_value(format_, *current_, setting, options_, diagnostics);
    if (!after) return false;
    if (fps && frame_rate(after->rig) != frame_rate(current_->rig)) {
      diagnostics.add(Code::kSettingContradictsRate, {setting.key, setting.value, *fps});
      return false;
    }
    current_ = *std::move(after);
    file_.document = current_->document;
    return true;
  }

 private:
  /// The document with its edits; null if the edited text cannot be parsed.
  [[nodiscard]] const text::Document* edited() const {
    return file_.document.edited() ? file_.document.kept_edited() : &file_.document;
  }

  const Format& format_;
  const ReadOptions& options_;
  Written::File& file_;
  std::optional<StatedRig> current_;  ///< The edited document and its rig; nullopt until a value is set.
};

/// Sets the value in every file that has the key. If none has it, adds it to every file that may get it. If no file may get it,
/// tries to set it nevertheless: this adds the error that the key is unknown. Returns false after an error.
bool apply(const KeyValue& setting, std::optional<double> fps, std::vector<EditableFile>& files, Diagnostics& diagnostics) {
  const auto has_key = [&setting](const EditableFile& file) { return file.has_key(setting.key); };
  const auto may_add_key = [&setting](const EditableFile& file) { return file.may_add_key(setting.key); };
  const bool is_in_no_file = std::ranges::none_of(files, has_key);
  const bool is_added = is_in_no_file && std::ranges::any_of(files, may_add_key);
  return std::ranges::all_of(files, [&](EditableFile& file) {
    const bool takes_key = is_added ? may_add_key(file) : is_in_no_file || has_key(file);
    return !takes_key || file.set(setting, fps, diagnostics);
  });
}

}  // namespace

bool apply_settings(const ConvertRequest& request, const Format& format, Written& written, Diagnostics& diagnostics) {
  if (request.settings.empty()) return true;
  ReadOptions options = read_options(request.inputs);
  options.join = false;           // each file is read alone
  options.length_unit_m.reset();  // written files are in metres
  std::vector<EditableFile> files;
  files.reserve(written.files.size());
  for (Written::File& file : written.files) files.emplace_back(format, options, file);
  return std::ranges::all_of(request.settings, [&](const KeyValue& setting) {
    if (!apply(setting, request.frame_rate_hz, files, diagnostics)) return false;
    std::erase_if(written.defaults, [&setting](const DefaultedValue& value) { return value.key == setting.key; });
    return true;
  });
}

}  // namespace fca
