// SPDX-License-Identifier: BSD-3-Clause
// The memory of a batch does not grow with the number of its inputs, but for their names: whether they are written, wrong, or
// told as JSON.
#include "bench/child.h"
#include "sanitized.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace fca::test {
namespace {

namespace fs = std::filesystem;

struct Kind {
  const char* name;
  bool is_wrong;  ///< The inputs are no calibrations.
  int code;
  std::vector<std::string> options;
};

void PrintTo(const Kind& kind, std::ostream* stream) { *stream << kind.name; }

class BatchMemory : public testing::TestWithParam<Kind> {
 protected:
  BatchMemory() {
    std::string pattern = (fs::temp_directory_path() / "fca-io-test-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    std::ostringstream text;
    text << std::ifstream(fs::path(FCA_TESTDATA_DIR) / "formats/kalibr/good/tumvi.yaml").rdbuf();
    chain_ = text.str();
    if (GetParam().is_wrong) chain_.insert(chain_.find("intrinsics: [") + std::string("intrinsics: [").size(), "x");
  }
  ~BatchMemory() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  /// In bytes, the most that was resident while so many were converted.
  [[nodiscard]] double peak(int inputs) const {
    const fs::path in = folder_ / ("in" + std::to_string(inputs));
    fs::create_directories(in);
    for (int i = 0; i < inputs; ++i) std::ofstream(in / (std::to_string(i) + ".yaml")) << chain_;
    std::vector<std::string> words = {executable(), "convert", in.string(), "--to", "basalt", "--no-verify", "--jobs", "2"};
    for (const std::string& option : GetParam().options)
      words.push_back(option == "-o" ? "-o" + in.string() + ".out/" : option);
    const bench::Run run = bench::run(words);
    EXPECT_EQ(run.code, GetParam().code);
    return run.megabytes * 1024.0 * 1024.0;
  }

 private:
  /// That of the build whose tests run, also where their objects are another's.
  static std::string executable() {
    const char* path = std::getenv("FCA_IO");
    return path != nullptr ? path : FCA_IO;
  }

  fs::path folder_;
  std::string chain_;
};

TEST_P(BatchMemory, GrowsByNoMoreThanNames) {
  if (is_sanitized()) GTEST_SKIP() << "freed memory is kept, to find who uses it";
  constexpr int kFew = 200;
  constexpr int kMany = 1500;
  constexpr double kMost = 2048.0;  // bytes an input; a chain and its result take 4,000, and its JSON more
  const double few = peak(kFew);
  const double many = peak(kMany);
  std::printf("%s: %.1f MB, %.1f MB\n", GetParam().name, few / 1024 / 1024, many / 1024 / 1024);
  EXPECT_LT((many - few) / (kMany - kFew), kMost) << few << " bytes, then " << many;
}

INSTANTIATE_TEST_SUITE_P(All, BatchMemory,
                         testing::Values(Kind{"written", false, 0, {"-o"}}, Kind{"wrong", true, 2, {"-o"}},
                                         Kind{"json", false, 0, {"-o", "--json"}}, Kind{"lines", false, 0, {"--json-lines"}}),
                         [](const testing::TestParamInfo<Kind>& kind) { return std::string(kind.param.name); });

}  // namespace
}  // namespace fca::test
