// SPDX-License-Identifier: BSD-3-Clause
// The objects of conversions, which are texts by now, in one document.
#include "conversion_json.h"
#include "shell/compact_json.h"
#include "shell/diagnostics_json.h"

#include <string_view>
#include <utility>

#include <rapidjson/document.h>

namespace fca::cli {

namespace {

constexpr std::string_view kListBegins = "{\n \"fca_io\": \"" FCA_VERSION "\",\n \"conversions\": [";

/// As deep as it stands in the list of the document. Line breaks of values are escaped.
std::string in_list(const std::string& conversion) {
  constexpr std::string_view kDeeper = "  ";
  std::string text;
  for (const char c : conversion) {
    text += c;
    if (c == '\n') text += kDeeper;
  }
  return text;
}

/// With the program's version in front.
std::string as_document(const std::string& conversion) {
  constexpr std::string_view kOpen = "{\n";
  std::string text = conversion;
  return text.insert(kOpen.size(), " \"fca_io\": \"" FCA_VERSION "\",\n");
}

}  // namespace

std::string unwritten_json(const std::string& conversion, ExitCode code, const Diagnostics& why) {
  constexpr unsigned kAsItStands = rapidjson::kParseFullPrecisionFlag;
  rapidjson::Document said;
  Json diagnostics;
  diagnostics.object([&] { put_diagnostics(diagnostics, why, {}); });
  said.Parse<kAsItStands>(diagnostics.text().c_str());
  rapidjson::Document document(&said.GetAllocator());
  document.Parse<kAsItStands>(conversion.c_str());
  document["outputs"].SetArray();
  document["exit_code"].SetInt(static_cast<int>(code));
  for (rapidjson::Value& each : said["diagnostics"].GetArray()) document["diagnostics"].PushBack(each, document.GetAllocator());
  return Json::text_of(document);
}

std::string ConversionsJson::next(const std::string& conversion, std::size_t conversions) {
  if (conversions == 1) return as_document(conversion);
  return std::string(std::exchange(is_begun_, true) ? ", " : kListBegins) + in_list(conversion);
}

std::string ConversionsJson::end(std::size_t conversions) const {
  if (conversions == 1) return "\n";
  return std::string(is_begun_ ? "" : kListBegins) + "]\n}\n";
}

std::string conversion_line(const std::string& conversion) { return compact(as_document(conversion)) + "\n"; }

}  // namespace fca::cli
