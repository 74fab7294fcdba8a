// SPDX-License-Identifier: BSD-3-Clause
// Single values of a written file that no calibration specifies: a program's tuning, a topic, a frame rate.
#pragma once

#include <fca/formats/format.h>

#include <optional>
#include <string>

namespace fca {

/// A key, with '/' between the levels of nested ones ("cam0/rostopic"), and what it is to say: in words, as its type is the
/// format's.
struct KeyValue {
  std::string key;
  std::string value;
};

/// Is there such a scalar in the document?
[[nodiscard]] bool has_value(const text::Document& document, const std::string& key);

/// Does the document of that format lack the value, and may it be added (Format::optional_value)?
[[nodiscard]] bool may_add_value(const Format& format, const text::Document& document, const std::string& key);

/// A document without edits, and the rig that it specifies; nothing where its format does not read it.
struct StatedRig {
  text::Document document;
  std::optional<Rig> rig;
};

/// What a document of that format is with its edits; nothing with an error where that is no document.
[[nodiscard]] std::optional<StatedRig> as_stated(const Format& format, const text::Document& document,
                                                 const ReadOptions& options, Diagnostics& diagnostics);

/// The document of that format with the scalar of a key saying something else, in the spelling of what stands there: quotes
/// stay, a real stays a real ("30" becomes "30.0"), and our comment that the value is a default goes. A value that may be added
/// is, after the others of its group. Nothing with an error where there is no such key, where a word would replace a number or
/// a number of another type an int, and where the rig that the file specifies would be another: calibrations are not corrected
/// here.
[[nodiscard]] std::optional<StatedRig> set_value(const Format& format, const StatedRig& before, const KeyValue& setting,
                                                 const ReadOptions& options, Diagnostics& diagnostics);

/// The names a key may have in a document, for messages.
[[nodiscard]] std::vector<std::string> scalar_keys(const text::Document& document);

}  // namespace fca
