// SPDX-License-Identifier: BSD-3-Clause
// A thin hand on RapidJSON's writer: no way to forget a key's value, NaN becomes null.
#pragma once

#include <fca/formats/text/source.h>

#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rapidjson/prettywriter.h>
#include <rapidjson/stringbuffer.h>

namespace fca::cli {

class Json {
 public:
  Json() : writer_(buffer_) {
    writer_.SetIndent(' ', 1);
    writer_.SetFormatOptions(rapidjson::kFormatSingleLineArray);
  }

  void object(const std::function<void()>& members) {
    writer_.StartObject();
    members();
    writer_.EndObject();
  }
  void object(std::string_view key, const std::function<void()>& members) {
    name(key);
    object(members);
  }
  template <class Range, class F>
  void array(std::string_view key, const Range& range, F&& element) {
    name(key);
    writer_.StartArray();
    for (const auto& each : range) element(each);
    writer_.EndArray();
  }

  void put(std::string_view key, std::string_view v) { name(key), value(v); }
  void put(std::string_view key, const char* v) { name(key), value(std::string_view(v)); }
  void put(std::string_view key, double v) { name(key), value(v); }
  void put(std::string_view key, int v) { name(key), writer_.Int(v); }
  void put(std::string_view key, long long v) { name(key), writer_.Int64(v); }
  void put(std::string_view key, bool v) { name(key), writer_.Bool(v); }
  void put(std::string_view key, const std::optional<double>& v) {
    name(key);
    v ? value(*v) : static_cast<void>(writer_.Null());
  }
  void put(std::string_view key, std::span<const std::string> strings) {
    array(key, strings, [this](const std::string& s) { value(s); });
  }
  void put(std::string_view key, std::span<const double> numbers) {
    array(key, numbers, [this](double v) { value(v); });
  }
  void null(std::string_view key) {
    name(key);
    writer_.Null();
  }

  /// JSON is UTF-8; bytes of a file that are not become '?'.
  void value(std::string_view v) {
    const std::string text = text::valid_utf8(v);
    writer_.String(text.data(), static_cast<rapidjson::SizeType>(text.size()));
  }
  void value(double v) {
    if (std::isfinite(v)) {
      writer_.Double(v);
    } else {
      writer_.Null();
    }
  }

  /// A value of RapidJSON's.
  template <class Value>
  [[nodiscard]] static std::string text_of(const Value& value) {
    Json json;
    value.Accept(json.writer_);
    return json.text();
  }
  [[nodiscard]] std::string text() const { return {buffer_.GetString(), buffer_.GetSize()}; }
  [[nodiscard]] std::string document() const { return text() + "\n"; }

 private:
  void name(std::string_view key) { writer_.Key(key.data(), static_cast<rapidjson::SizeType>(key.size())); }

  rapidjson::StringBuffer buffer_;
  rapidjson::PrettyWriter<rapidjson::StringBuffer> writer_;
};

}  // namespace fca::cli
