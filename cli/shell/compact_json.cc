// SPDX-License-Identifier: BSD-3-Clause
#include "compact_json.h"

#include <rapidjson/reader.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

namespace fca::cli {

namespace {

/// Numbers keep their digits. (RapidJSON's own writer puts such numbers into quotes.)
class LineWriter : public rapidjson::Writer<rapidjson::StringBuffer> {
 public:
  using Writer::Writer;
  // As rapidjson::Reader calls it.
  bool RawNumber(const char* digits, rapidjson::SizeType size, bool /*copy*/) {  // NOLINT(readability-identifier-naming)
    return RawValue(digits, size, rapidjson::kNumberType);
  }
};

}  // namespace

std::string compact(const std::string& document) {
  rapidjson::StringBuffer line;
  LineWriter writer(line);
  rapidjson::StringStream stream(document.c_str());
  rapidjson::Reader reader;
  reader.Parse<rapidjson::kParseNumbersAsStringsFlag>(stream, writer);
  return {line.GetString(), line.GetSize()};
}

}  // namespace fca::cli
