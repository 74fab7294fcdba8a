// SPDX-License-Identifier: BSD-3-Clause
// What once broke a promise keeps all of them, read as whatever it may be taken for.
#include "entries.h"

#include "formats/test_files.h"

namespace fca::fuzz {
namespace {

class Crashes : public testing::TestWithParam<test::fs::path> {};

TEST_P(Crashes, AreNone) {
  const std::string bytes = test::read_file(GetParam());
  Complaints complaints = read_promises(nullptr, bytes, GetParam().filename().string(), Depth::kChecked);
  for (const Format& format : all_formats()) {
    for (std::string& complaint : read_promises(&format, bytes, GetParam().filename().string(), Depth::kChecked))
      complaints.push_back(std::string(format.id) + ": " + std::move(complaint));
  }
  for (const std::string& complaint : complaints) ADD_FAILURE() << complaint;
  for (const Entry& entry : all_entries()) {
    for (const std::string& complaint : entry.run(bytes)) ADD_FAILURE() << entry.name << ": " << complaint;
  }
}

std::string test_name(const testing::TestParamInfo<test::fs::path>& info) {
  std::string name = info.param.filename().string();
  std::ranges::replace_if(
      name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Files, Crashes, testing::ValuesIn(test::files_in(test::fs::path(FCA_TESTDATA_DIR) / "crashes")),
                         test_name);

}  // namespace
}  // namespace fca::fuzz
