// SPDX-License-Identifier: BSD-3-Clause
// What the README shows is what the program prints: every block that begins with "$ fca-io" is run beside the files of
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

TEST(Readme, ShowsWhatTheProgramPrints) {
  const fs::path root = fs::path(FCA_EXAMPLES_DIR).parent_path();
  const TemporaryFolder folder;
  for (const fs::path& from : {fs::path(FCA_EXAMPLES_DIR) / "tumvi", fs::path(FCA_EXAMPLES_DIR)}) {
    for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
      if (entry.is_regular_file() && entry.path().extension() != "") fs::copy(entry.path(), folder.path());
    }
  }
  const std::vector<Example> examples = examples_in(read_file(root / "README.md"));
  EXPECT_GE(examples.size(), 5U);
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
TEST(Readme, HasTheTablesOfTheRegistry) {
  const std::string readme = read_file(fs::path(FCA_EXAMPLES_DIR).parent_path() / "README.md");
  for (const char* table : {"--markdown", "--ledger"}) {
    const RunResult run = run_program({"formats", table});
    EXPECT_TRUE(contains(readme, run.out)) << "fca-io formats " << table << " prints\n" << run.out;
  }
}

}  // namespace
}  // namespace fca::test
