// SPDX-License-Identifier: BSD-3-Clause
// What the documents show is what the program prints: every block that begins with "$ fca-io" is run beside the files of
// examples/. A line "..." stands for any number of lines. Numbers may differ in their last digits, from machine to machine.
#include "cli/run_program.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace fca::test {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

struct Example {
  std::string command;
  std::vector<std::string> output;
};

std::vector<Example> examples_in(const std::string& readme) {
  std::vector<Example> examples;
  bool inside = false;
  for (const std::string& line : lines_of(readme)) {
    if (line.starts_with("```")) {
      inside = false;
    } else if (line.starts_with("$ fca-io ")) {
      inside = true;
      examples.push_back({line.substr(2), {}});
    } else if (inside) {
      examples.back().output.push_back(line);
    }
  }
  return examples;
}

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// The same words; numbers within 1e-3, those that are rounding themselves (below 1e-3) within a tenth.
bool same(const std::string& expected, const std::string& printed) {
  const std::vector<std::string> a = words_of(expected);
  const std::vector<std::string> b = words_of(printed);
  const auto number = [](std::string word) {
    std::erase_if(word, [](char c) { return c == ',' || c == '(' || c == ')'; });
    return text::parse_real(word);
  };
  return std::ranges::equal(a, b, [&number](const std::string& x, const std::string& y) {
    const std::optional<double> u = number(x);
    const std::optional<double> v = number(y);
    if (!u || !v) return x == y;
    const double tolerance = std::abs(*u) < 1e-12 ? 1e-12 : (std::abs(*u) < 1e-3 ? 0.1 : 1e-3) * std::abs(*u);
    return std::abs(*u - *v) <= tolerance;
  });
}

/// The first expected line that does not come; empty: all come.
std::string missing_from(const std::vector<std::string>& printed, const std::vector<std::string>& expected) {
  auto at = printed.begin();
  bool skip = false;
  for (const std::string& line : expected) {
    if (words_of(line) == std::vector<std::string>{"..."}) {
      skip = true;
      continue;
    }
    const auto found = skip ? std::find_if(at, printed.end(), [&line](const std::string& p) { return same(line, p); }) : at;
    if (found == printed.end() || !same(line, *found)) return line;
    at = found + 1;
    skip = false;
  }
  return "";
}

/// Each with the number of its examples, at least.
struct Document {
  const char* path;
  std::size_t examples;
};

class Documents : public testing::TestWithParam<Document> {};

INSTANTIATE_TEST_SUITE_P(All, Documents,
                         testing::Values(Document{"README.md", 5}, Document{"cli/README.md", 30},
                                         Document{"lib/convert/paper.md", 1}),
                         [](const auto& document) {
                           std::string name = document.param.path;
                           std::ranges::replace_if(
                               name, [](char c) { return c == '/' || c == '.'; }, '_');
                           return name;
                         });

TEST_P(Documents, ShowWhatTheProgramPrints) {
  const fs::path root = fs::path(FCA_EXAMPLES_DIR).parent_path();
  const TemporaryFolder folder;
  for (const fs::path& from : {fs::path(FCA_EXAMPLES_DIR) / "tumvi", fs::path(FCA_EXAMPLES_DIR)}) {
    for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
      if (entry.is_regular_file() && entry.path().extension() != "") fs::copy(entry.path(), folder.path());
    }
  }
  const std::vector<Example> examples = examples_in(read_file(root / GetParam().path));
  EXPECT_GE(examples.size(), GetParam().examples);
  for (const Example& example : examples) {
    SCOPED_TRACE(example.command);
    std::vector<std::string> words = words_of(example.command.substr(0, example.command.find(" #")));
    words.erase(words.begin());
    // An example may use what an earlier one wrote, or write it again.
    if (std::ranges::find(words, "-o") != words.end()) words.emplace_back("--force");
    const RunResult run = run_program(words, {.folder = folder.path().string(), .in_full = false});
    const std::vector<std::string> printed = lines_of(run.out + run.err);
    EXPECT_EQ(missing_from(printed, example.output), "") << run.out << run.err;
  }
}

// The tables of formats are printed from the registry.
TEST(Documents, HaveTheTablesOfTheRegistry) {
  const fs::path root = fs::path(FCA_EXAMPLES_DIR).parent_path();
  for (const auto& [path, table] : {std::pair("README.md", "--markdown"), {"formats/README.md", "--ledger"}}) {
    const RunResult run = run_program({"formats", table});
    EXPECT_TRUE(contains(read_file(root / path), run.out)) << "fca-io formats " << table << " prints\n" << run.out;
  }
}

/// The targets of links, "[text](target)", that are no addresses.
std::vector<std::string> links_in(const std::string& text) {
  std::vector<std::string> links;
  for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](", at + 1)) {
    std::string link = text.substr(at + 2, text.find(')', at) - at - 2);
    if (link.find("://") == std::string::npos && !link.starts_with('#')) links.push_back(link.substr(0, link.find('#')));
  }
  return links;
}

// Documents stand beside what they describe, and lead to each other.
TEST(Documents, LeadToFilesThatAreThere) {
  const fs::path root = fs::path(FCA_EXAMPLES_DIR).parent_path();
  std::size_t links = 0;
  for (const char* path : {"README.md", "CONTRIBUTING.md", "CHANGELOG.md", "cli/README.md", "cli/python/README.md",
                           "examples/cpp/README.md", "formats/README.md", "formats/verdicts.md", "lib/convert/paper.md"}) {
    for (const std::string& link : links_in(read_file(root / path))) {
      ++links;
      EXPECT_TRUE(fs::exists((root / path).parent_path() / link)) << path << " leads to " << link;
    }
  }
  EXPECT_GT(links, 8U);
}

TEST(Documents, AreShortWhereReadersBegin) {
  const fs::path root = fs::path(FCA_EXAMPLES_DIR).parent_path();
  EXPECT_LE(lines_of(read_file(root / "README.md")).size(), 150U);
  EXPECT_LE(fs::file_size(root / "examples/tumvi/page.png"), 150'000U);
}

}  // namespace
}  // namespace fca::test
