// SPDX-License-Identifier: BSD-3-Clause
#include "words.h"

#include "toolkit/words.h"

namespace fca::cli {

namespace {

std::vector<std::string> format_ids() {
  std::vector<std::string> names;
  for (const Format& format : all_formats()) names.emplace_back(format.id);
  return names;
}

}  // namespace

std::string format_names() { return enumerated(format_ids()); }

std::string unknown_format(std::string_view typed) { return unknown_word("format", typed, format_ids()); }

std::string unknown_model(std::string_view typed) {
  std::vector<std::string> names;
  for (const ModelInfo& model : all_models()) names.emplace_back(model.id);
  return unknown_word("camera model", typed, names);
}

std::vector<std::string> split(std::string_view list) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t end = std::min(list.find(',', at), list.size());
    parts.emplace_back(list.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

std::optional<std::string> take_format(const std::string& word, const Format*& target) {
  target = find_format(word);
  return target != nullptr ? std::nullopt : std::optional(unknown_format(word));
}

std::optional<std::string> take_model(const std::string& word, const ModelInfo*& target) {
  target = find_model(word);
  return target != nullptr ? std::nullopt : std::optional(unknown_model(word));
}

std::optional<std::string> take_size(const std::string& option, const std::string& word, std::optional<ImageSize>& target) {
  target = parse_size(word);
  if (target) return std::nullopt;
  return option + " wants WIDTHxHEIGHT in whole pixels, such as 640x480; got '" + word + "'";
}

}  // namespace fca::cli
