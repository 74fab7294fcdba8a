// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/set_value.h>

#include "default_comment.h"
#include "fields.h"

#include <fca/code.h>
#include <fca/formats/text/dialect.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/prose.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fca {

namespace {

using text::Node;
using text::ScalarType;

text::Dialect dialect_of(const text::Document& document) {
  const bool last_counts = document.syntax() == text::Syntax::kYaml || document.syntax() == text::Syntax::kPython;
  return last_counts ? text::Dialect::kPyYaml : text::Dialect::kOpenCv;
}

/// The entry of a key such as "cam0/rostopic"; null if there is none.
const text::Entry* find_nested(const text::Document& document, std::string_view key) {
  const Node* mapping = &document.root();
  while (true) {
    const std::size_t slash = std::min(key.find('/'), key.size());
    const text::Entry* entry =
        mapping->is_mapping() ? text::find_entry(*mapping, key.substr(0, slash), dialect_of(document)) : nullptr;
    if (entry == nullptr || slash == key.size()) return entry;
    mapping = &entry->value;
    key.remove_prefix(slash + 1);
  }
}

/// The same; null, too, if it holds no scalar.
const text::Entry* find_scalar(const text::Document& document, std::string_view key) {
  const text::Entry* entry = find_nested(document, key);
  return entry != nullptr && entry->value.is_scalar() ? entry : nullptr;
}

/// The mapping in which the last part of a key belongs; null if it is not there.
const Node* owner_of(const text::Document& document, std::string_view key) {
  const std::size_t slash = key.rfind('/');
  if (slash == std::string_view::npos) return &document.root();
  const text::Entry* owner = find_nested(document, key.substr(0, slash));
  return owner != nullptr && owner->value.is_mapping() ? &owner->value : nullptr;
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

/// An error; `wanted`: a clause.
std::nullopt_t refuse_type(const KeyValue& setting, Code wanted, SourceRange where, Diagnostics& diagnostics) {
  diagnostics.add(Code::kSetWrongType, {setting.key, Message{wanted}, setting.value}, std::move(where));
  return std::nullopt;
}

/// `value` as what stands there is spelled; nothing with an error if it is of another type.
std::optional<std::string> spelled_like(const text::Document& document, const Node& there, const KeyValue& setting,
                                        Diagnostics& diagnostics) {
  const auto refuse = [&](Code wanted) { return refuse_type(setting, wanted, document.range(there), diagnostics); };
  const bool whole = text::parse_int(setting.value).has_value();
  const std::optional<double> number = text::parse_real(setting.value);
  if (number && !std::isfinite(*number)) return refuse(Code::kWantsFiniteNumber);
  switch (text::scalar_type(there, dialect_of(document))) {
    case ScalarType::kInteger:
      return whole ? std::optional(setting.value) : refuse(Code::kWantsWholeNumber);
    case ScalarType::kReal:
      return number ? std::optional(text::format_real(*number)) : refuse(Code::kWantsNumber);
    case ScalarType::kText:
      break;
  }
  if (!is_plain(setting.value)) return refuse(Code::kWantsPlainText);
  if (!there.quoted) return number ? refuse(Code::kWantsWord) : std::optional(setting.value);
  const char quote = document.source().bytes[there.span.offset];
  return quote + setting.value + quote;
}

/// The document with a value that it lacked, after the last entry of its group ("Viewer." of Viewer.imageViewScale), else of
/// its mapping. Nothing with an error if the value is of another type.
std::optional<text::Document> with_added(const text::Document& document, ValueType type, const KeyValue& setting,
                                         Diagnostics& diagnostics) {
  const auto refuse = [&](Code wanted) { return refuse_type(setting, wanted, {}, diagnostics); };
  const std::optional<double> number = text::parse_real(setting.value);
  std::string token = setting.value;
  switch (type) {
    case ValueType::kInteger:
      if (!text::parse_int(setting.value)) return refuse(Code::kWantsWholeNumber);
      break;
    case ValueType::kReal:
      if (!number || !std::isfinite(*number)) return refuse(Code::kWantsNumber);
      token = text::format_real(*number);
      break;
    case ValueType::kText:
      if (number || !is_plain(setting.value)) return refuse(Code::kWantsPlainWord);
      // As Kalibr writes topics; cv::FileStorage takes only what is quoted for text whatever it is.
      if (dialect_of(document) == text::Dialect::kOpenCv || !setting.value.starts_with('/'))
        token = fields::quote(setting.value);
      break;
  }
  const Node& owner = *owner_of(document, setting.key);
  const std::string key = setting.key.substr(setting.key.rfind('/') + 1);
  const std::string group = key.substr(0, key.find('.') + 1);
  const auto is_of_group = [&group](const text::Entry& entry) { return entry.key.value.starts_with(group); };
  const auto last = std::ranges::find_if(owner.entries.rbegin(), owner.entries.rend(), is_of_group);
  text::Document edited = document;
  edited.insert_after(owner, last != owner.entries.rend() ? *last : owner.entries.back(),
                      fields::spell(fields::scalar(key, token), 0, document.syntax()));
  return edited;
}

/// The rig a document specifies.
std::optional<Rig> rig_of(const Format& format, const text::Document& document, const ReadOptions& options) {
  Diagnostics ignored;
  return format.read(std::span(&document, 1), options, ignored);
}

/// The same without what may be set: `before` says where a time offset is one that it added.
std::optional<Rig> without_settings(std::optional<Rig> rig, const std::optional<Rig>& before) {
  if (!rig) return std::nullopt;
  for (Camera& camera : rig->cameras) {
    camera.frame_rate_hz.reset();
    camera.topic.clear();
    const Camera* as_it_was = before ? before->find_camera(camera.name) : nullptr;
    if (as_it_was != nullptr && !as_it_was->time_offset_s) camera.time_offset_s.reset();
  }
  for (Imu& imu : rig->imus) imu.topic.clear();
  rig->extra_fields.clear();
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
  const Message wanted = lowest == std::numeric_limits<double>::min() ? Message{Code::kWantsNumberAboveZero}
                                                                      : Message{Code::kWantsNumberBetween, {lowest, highest}};
  diagnostics.add(Code::kSetOutOfRange, {setting.key, wanted, setting.value}, where);
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

/// The document with another value in an entry; nothing with an error if it is of another type.
std::optional<text::Document> with_other_value(const text::Document& document, const text::Entry& entry,
                                               const KeyValue& setting, Diagnostics& diagnostics) {
  const std::optional<std::string> spelling = spelled_like(document, entry.value, setting, diagnostics);
  if (!spelling) return std::nullopt;
  text::Document edited = document;
  edited.replace(entry.value.span, *spelling);
  remove_default_comment(entry, edited);
  return edited;
}

/// An error: there is no such key, or what stands there is no single value.
void refuse_key(const text::Document& document, const std::string& key, Diagnostics& diagnostics) {
  if (const text::Entry* entry = find_nested(document, key)) {
    const Message what{entry->value.is_sequence() ? Code::kValueList : Code::kValueIsGroup};
    diagnostics.add(Code::kSetNoSingleValue, {key, what}, document.range(entry->value));
    return;
  }
  const std::vector<std::string> near = text::nearest(key, scalar_keys(document));
  std::vector<Message> meant;
  if (!near.empty()) meant.push_back({Code::kSetDidYouMean, {near}});
  diagnostics.add(Code::kSetUnknownKey, {key, meant});
}

}  // namespace

std::vector<std::string> scalar_keys(const text::Document& document) {
  std::vector<std::string> keys;
  collect(document.root(), "", keys);
  return keys;
}

bool has_value(const text::Document& document, const std::string& key) { return find_scalar(document, key) != nullptr; }

bool may_add_value(const Format& format, const text::Document& document, const std::string& key) {
  if (format.optional_value == nullptr || find_nested(document, key) != nullptr) return false;
  const Node* owner = owner_of(document, key);
  return owner != nullptr && !owner->entries.empty() && format.optional_value(document, key).has_value();
}

std::optional<StatedRig> as_stated(const Format& format, const text::Document& document, const ReadOptions& options,
                                   Diagnostics& diagnostics) {
  const text::Document* parsed = document.edited() ? document.kept_edited() : &document;
  std::optional<text::Document> now =
      parsed != nullptr ? *parsed : text::parse_document({document.source().name, document.bytes()}, diagnostics);
  if (!now) return std::nullopt;
  std::optional<Rig> rig = rig_of(format, *now, options);
  return StatedRig{*std::move(now), std::move(rig)};
}

std::optional<StatedRig> set_value(const Format& format, const StatedRig& before, const KeyValue& setting,
                                   const ReadOptions& options, Diagnostics& diagnostics) {
  const text::Document& document = before.document;
  const std::optional<Rig>& rig = before.rig;
  if (const Node* copy = text::first_copy(document.root())) {
    diagnostics.add(Code::kYamlCopiesNotEdited, {}, document.range(*copy));
    return std::nullopt;
  }
  const text::Entry* entry = find_scalar(document, setting.key);
  const bool added = may_add_value(format, document, setting.key);
  if (entry == nullptr && !added) {
    refuse_key(document, setting.key, diagnostics);
    return std::nullopt;
  }
  std::optional<text::Document> edited =
      added ? with_added(document, *format.optional_value(document, setting.key), setting, diagnostics)
            : with_other_value(document, *entry, setting, diagnostics);
  if (!edited) return std::nullopt;
  const SourceRange where = added ? SourceRange{} : document.range(entry->value);
  if (rig && !in_range(format, *rig, setting, where, diagnostics)) return std::nullopt;
  std::optional<text::Document> after = text::parse_document({document.source().name, edited->bytes()}, diagnostics);
  if (!after) return std::nullopt;
  std::optional<Rig> changed = rig_of(format, *after, options);
  if (is_of_layout(document, setting.key) || (rig && !changed)) {
    diagnostics.add(Code::kSetLayout, {setting.key});
    return std::nullopt;
  }
  if (without_settings(rig, rig) != without_settings(changed, rig)) {
    diagnostics.add(Code::kSetCalibration, {setting.key});
    return std::nullopt;
  }
  return StatedRig{*std::move(after), std::move(changed)};
}

}  // namespace fca
