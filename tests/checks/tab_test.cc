// SPDX-License-Identifier: BSD-3-Clause
// TABs where YAML wants blanks: fixed the file says what it said before somebody's editor put them in.
#include "check_files.h"

#include <cstdio>
#include <functional>

namespace fca::test {
namespace {

std::string by_lines(const std::string& bytes, const std::function<std::string(const std::string&)>& change) {
  std::string result;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size() - 1) + 1;
    result += change(bytes.substr(at, end - at));
    at = end;
  }
  return result;
}

/// Every two blanks of an indentation are a TAB.
std::string indented(const std::string& bytes) {
  return by_lines(bytes, [](const std::string& line) {
    const std::size_t first = std::min(line.find_first_not_of(' '), line.size());
    return std::string(first / 2, '\t') + line.substr(first);
  });
}

/// The blank after a key's colon is a TAB.
std::string spaced(const std::string& bytes) {
  return by_lines(bytes, [](std::string line) {
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos && line.find_first_of("#\"'") > colon) line[colon + 1] = '\t';
    return line;
  });
}

/// The last key of the first camera alone.
std::string one_line(const std::string& bytes) {
  const std::size_t at = bytes.find("\n  r");
  return at == std::string::npos ? bytes : std::string(bytes).replace(at + 1, 2, "\t");
}

TEST(Tabs, AreBlanksAgain) {
  std::vector<fs::path> files = files_in(testdata_dir() / "kalibr" / "good");
  const std::vector<fs::path> settings = files_in(testdata_dir() / "orbslam3" / "good");
  files.insert(files.end(), settings.begin(), settings.end());
  int planted = 0;
  int fixed_files = 0;
  for (const fs::path& path : files) {
    const text::Source good{path.filename().string(), read_file(path)};
    if (checked(good).has(Severity::kError) || good.bytes.find('\t') != std::string::npos) continue;
    for (const auto& plant : {&indented, &spaced, &one_line}) {
      const text::Source wrong{good.name, plant(good.bytes)};
      if (wrong.bytes == good.bytes || !checked(wrong).has(Severity::kError)) continue;
      ++planted;
      const std::optional<text::Source> after = fixed_source(wrong, {});
      if (!after) {
        std::printf("not fixed: %s\n", good.name.c_str());
        continue;
      }
      ++fixed_files;
      EXPECT_EQ(after->bytes.find('\t'), std::string::npos) << good.name;
      EXPECT_FALSE(checked(*after).has(Severity::kError)) << good.name << "\n" << after->bytes;
      EXPECT_EQ(rig_of(*after), rig_of(good)) << good.name;
    }
  }
  std::printf("%d of %d files with TABs fixed\n", fixed_files, planted);
  EXPECT_GE(fixed_files, 0.9 * planted);
  EXPECT_GE(planted, 20);
}

// Which of two keys is the line next to? Nobody knows.
TEST(Tabs, AreLeftWhereTheDepthIsNotCertain) {
  const std::string nested =
      "cam0:\n  camera_model: pinhole\n  distortion_model: none\n  distortion_coeffs: []\n"
      "  intrinsics: [200.0, 200.0, 320.0, 240.0]\n  more:\n    deep: 1\n\trostopic: /cam0\n  resolution: [640, 480]\n";
  EXPECT_FALSE(fixed_source({"camchain.yaml", nested}, {}));
}

// In quotes and comments they are text.
TEST(Tabs, OfTextsStay) {
  const std::string chain =
      "cam0:\n  camera_model: pinhole\n  distortion_model: radtan\t# a\tcomment\n  distortion_coeffs: [0.1,\t0.0, 0.0, 0.0]\n"
      "  intrinsics: [200.0, 200.0, 320.0, 240.0]\n  resolution: [640, 480]\n  rostopic: \"/a\tb\"\n";
  const std::optional<text::Source> after = fixed_source({"camchain.yaml", chain}, {});
  ASSERT_TRUE(after);
  EXPECT_EQ(after->bytes, with_replaced(with_replaced(chain, "radtan\t#", "radtan #"), ",\t0.0", ", 0.0"));
}

}  // namespace
}  // namespace fca::test
