// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/set_value.h>

#include "default_comment.h"

#include <fca/formats/text/dialect.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/prose.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fca {

namespace {

using text::Node;
using text::ScalarType;

text::Dialect dialect_of(const text::Document& document) {
  return document.syntax() == text::Syntax::kYaml ? text::Dialect::kPyYaml : text::Dialect::kOpenCv;
}

/// The entry of a key such as "cam0/rostopic"; null if there is none or it holds no scalar.
const text::Entry* find_scalar(const text::Document& document, std::string_view key) {
  const Node* mapping = &document.root();
  while (true) {
    const std::size_t slash = std::min(key.find('/'), key.size());
    const text::Entry* entry =
        mapping->is_mapping() ? text::find_entry(*mapping, key.substr(0, slash), dialect_of(document)) : nullptr;
    if (entry == nullptr) return nullptr;
    if (slash == key.size()) return entry->value.is_scalar() ? entry : nullptr;
    mapping = &entry->value;
    key.remove_prefix(slash + 1);
  }
}

void collect(const Node& mapping, const std::string& owner, std::vector<std::string>& keys) {
  for (const text::Entry& entry : mapping.entries) {
    if (entry.value.is_scalar()) keys.push_back(owner + entry.key.value);
    if (entry.value.is_mapping()) collect(entry.value, owner + entry.key.value + "/", keys);
  }
}

/// Letters, digits and signs that mean themselves in every syntax, quoted or not.
bool is_plain(std::string_view value) {
  constexpr std::string_view kSigns = "._-+/~";
  return !value.empty() && std::ranges::all_of(value, [kSigns](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           kSigns.find(c) != std::string_view::npos;
  });
}

/// `value` as what stands there is spelled; nothing with an error if it is of another type.
std::optional<std::string> spelled_like(const text::Document& document, const Node& there, const KeyValue& setting,
                                        Diagnostics& diagnostics) {
  const auto refuse = [&](const std::string& wanted) {
    diagnostics.error("set-wrong-type", "--set " + setting.key + " wants " + wanted + ", not '" + setting.value + "'",
                      document.range(there));
    return std::nullopt;
  };
  const bool whole = text::parse_int(setting.value).has_value();
  const std::optional<double> number = text::parse_real(setting.value);
  if (number && !std::isfinite(*number)) return refuse("a number that a double can hold");
  switch (text::scalar_type(there, dialect_of(document))) {
    case ScalarType::kInteger:
      return whole ? std::optional(setting.value) : refuse("a whole number");
    case ScalarType::kReal:
      return number ? std::optional(text::format_real(*number)) : refuse("a number");
    case ScalarType::kText:
      break;
  }
  if (!is_plain(setting.value)) return refuse("letters, digits and ._-+/~ only");
  if (!there.quoted) return number ? refuse("a word") : std::optional(setting.value);
  const char quote = document.source().bytes[there.span.offset];
  return quote + setting.value + quote;
}

/// The rig a document states.
std::optional<Rig> rig_of(const Format& format, const text::Document& document, const ReadOptions& options) {
  Diagnostics ignored;
  return format.read(std::span(&document, 1), options, ignored);
}

/// The same without what --set may change.
std::optional<Rig> without_settings(std::optional<Rig> rig) {
  if (!rig) return std::nullopt;
  for (Camera& camera : rig->cameras) {
    camera.frame_rate_hz.reset();
    camera.topic.clear();
  }
  for (Imu& imu : rig->imus) imu.topic.clear();
  rig->as_read.clear();
  return rig;
}

/// Is the number one that the key's program can use? Else an error.
bool in_range(const Format& format, const Rig& rig, const KeyValue& setting, const SourceRange& where,
              Diagnostics& diagnostics) {
  const std::optional<ValueRange> range = format.range_of != nullptr ? format.range_of(setting.key, rig) : std::nullopt;
  const std::optional<double> number = text::parse_real(setting.value);
  if (!range || !number) return true;
  const auto [lowest, highest] = *range;
  if (*number >= lowest && *number <= highest) return true;
  const std::string wanted = lowest == std::numeric_limits<double>::min()
                                 ? "a number above 0"
                                 : "a number from " + text::format_short(lowest) + " to " + text::format_short(highest);
  diagnostics.error("set-out-of-range", "--set " + setting.key + " wants " + wanted + ", not " + setting.value, where);
  return false;
}

/// Does a key say how its matrix is laid out?
bool is_of_layout(const text::Document& document, const std::string& key) {
  const std::size_t slash = key.rfind('/');
  if (slash == std::string::npos) return false;
  const std::string name = key.substr(slash + 1);
  return (name == "rows" || name == "cols" || name == "dt") &&
         find_scalar(document, key.substr(0, slash + 1) + "dt") != nullptr;
}

/// Removes the line above the entry where it is our comment that the value is a default.
void remove_default_comment(const text::Entry& entry, text::Document& document) {
  const std::string& bytes = document.source().bytes;
  const std::size_t line = bytes.rfind('\n', entry.key.span.offset);
  if (line == std::string::npos || line == 0) return;
  const std::size_t above = bytes.rfind('\n', line - 1);
  const std::size_t begin = above == std::string::npos ? 0 : above + 1;
  if (std::string_view(bytes).substr(begin).starts_with(kDefaultComment)) document.replace({begin, line + 1 - begin}, "");
}

}  // namespace

std::vector<std::string> scalar_keys(const text::Document& document) {
  std::vector<std::string> keys;
  collect(document.root(), "", keys);
  return keys;
}

bool has_value(const text::Document& document, const std::string& key) { return find_scalar(document, key) != nullptr; }

std::optional<text::Document> set_value(const Format& format, const text::Document& document, const KeyValue& setting,
                                        const ReadOptions& options, Diagnostics& diagnostics) {
  const auto parsed = [&](std::string bytes) {
    return text::parse_document({document.source().name, std::move(bytes)}, diagnostics);
  };
  std::optional<text::Document> before = parsed(document.bytes());
  if (!before) return std::nullopt;
  const text::Entry* entry = find_scalar(*before, setting.key);
  if (entry == nullptr) {
    const std::vector<std::string> near = text::nearest(setting.key, scalar_keys(*before));
    diagnostics.error("set-unknown-key", "--set: the file written has no value under '" + setting.key + "'" +
                                             (near.empty() ? "" : "; did you mean " + text::enumerated(near, "or") + "?"));
    return std::nullopt;
  }
  const std::optional<std::string> spelling = spelled_like(*before, entry->value, setting, diagnostics);
  if (!spelling) return std::nullopt;
  const std::optional<Rig> rig = rig_of(format, *before, options);
  if (rig && !in_range(format, *rig, setting, before->range(entry->value), diagnostics)) return std::nullopt;
  text::Document edited = *before;
  edited.replace(entry->value.span, *spelling);
  remove_default_comment(*entry, edited);
  std::optional<text::Document> after = parsed(edited.bytes());
  if (!after) return std::nullopt;
  const std::optional<Rig> changed = rig_of(format, *after, options);
  if (is_of_layout(*before, setting.key) || (rig && !changed)) {
    diagnostics.error("set-contradicts",
                      "--set: " + setting.key + " is how the file states its calibration, which would be lost", {}, "leave it");
    return std::nullopt;
  }
  if (without_settings(rig) != without_settings(changed)) {
    diagnostics.error("set-contradicts", "--set: " + setting.key + " is a part of the calibration, which says otherwise", {},
                      "change the input; --resize, --crop and --binning are for other images");
    return std::nullopt;
  }
  return after;
}

}  // namespace fca
