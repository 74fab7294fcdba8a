// SPDX-License-Identifier: BSD-3-Clause
// Scripts read --json: what version 0.1 wrote is still there (keys_of_version_0.1.txt, from that version's source). A key may
// be added; one that goes needs a line in the CHANGELOG and a new version.
#include "cli/run_program.h"

#include <set>
#include <sstream>

#include <rapidjson/document.h>

namespace fca::test {
namespace {

void collect(const rapidjson::Value& value, const std::string& path, std::set<std::string>& keys) {
  if (value.IsObject()) {
    for (const auto& member : value.GetObject()) {
      const std::string key = path + "/" + member.name.GetString();
      keys.insert(key);
      collect(member.value, key, keys);
    }
  } else if (value.IsArray()) {
    for (const auto& item : value.GetArray()) collect(item, path + "[]", keys);
  }
}

/// "fca-io's words with testdata's files", as they stand after "$ ".
std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    words.push_back(word.starts_with("testdata/") ? testdata(word.substr(std::string("testdata/").size())) : word);
  return words;
}

TEST(Schema, KeysOfVersion01AreStillWritten) {
  std::istringstream lines(read_file(fs::path(FCA_TESTDATA_DIR).parent_path() / "tests/cli/keys_of_version_0.1.txt"));
  std::set<std::string> written;
  std::string command;
  std::size_t commands = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("$ ")) {
      EXPECT_TRUE(written.contains(line)) << command << ": " << line;
      continue;
    }
    command = line.substr(2);
    ++commands;
    written.clear();
    rapidjson::Document document;
    const RunResult run = run_program(words_of(command));
    document.Parse(run.out.c_str());
    ASSERT_FALSE(document.HasParseError()) << command << run.err;
    collect(document, "", written);
  }
  EXPECT_EQ(commands, 8U);
}

}  // namespace
}  // namespace fca::test
