// SPDX-License-Identifier: BSD-3-Clause
// What the documents show is what the program prints: every command "$ fca-io ..." is run, that of a recipe
// (examples/*/README.md) in the recipe's folder, that of another document next to the files of examples/. "$ echo $?" is the
// exit code of the command before it. A line "..." stands for any number of lines. Numbers may differ in their last digits,
// from machine to machine.
#include "cli/run_program.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace fca::test {
namespace {

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
    } else if (line.starts_with("$ ")) {
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

/// The first expected line that does not come, or the first line beyond the expected ones; empty: all is as expected.
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
  return skip || at == printed.end() ? "" : "(not shown) " + *at;
}

/// Runs a document's examples in `folder`, one after the other, and compares what they print.
void expect_shown(const std::vector<Example>& examples, const fs::path& folder) {
  int code = 0;
  for (const Example& example : examples) {
    SCOPED_TRACE(example.command);
    if (example.command == "echo $?") {
      EXPECT_EQ(example.output, std::vector<std::string>{std::to_string(code)});
      continue;
    }
    std::vector<std::string> words = words_of(example.command.substr(0, example.command.find(" #")));
    ASSERT_EQ(words.front(), "fca-io") << "no other program can be called";
    words.erase(words.begin());
    // An example may use what an earlier one wrote, or write it again.
    if (std::ranges::find(words, "-o") != words.end()) words.emplace_back("--force");
    const RunResult run = run_program(words, {.folder = folder.string(), .in_full = false});
    const std::vector<std::string> printed = lines_of(run.out + run.err);
    EXPECT_EQ(missing_from(printed, example.output), "") << run.out << run.err;
    code = run.code;
  }
}

/// Each with the number of its examples, at least.
struct Document {
  std::string path;
  std::size_t examples;
};

/// Documents with examples but for the recipes: pages of programs (formats/programs) have one or more each.
std::vector<Document> documents_with_examples() {
  std::vector<Document> documents = {{"README.md", 5}, {"cli/README.md", 30}, {"lib/convert/paper.md", 1}};
  const fs::path root = fs::path(FCA_EXAMPLES_DIR).parent_path();
  for (const fs::directory_entry& entry : fs::directory_iterator(root / "formats/programs"))
    documents.push_back({fs::relative(entry.path(), root).string(), entry.path().filename() == "README.md" ? 0U : 1U});
  return documents;
}

class Documents : public testing::TestWithParam<Document> {};

INSTANTIATE_TEST_SUITE_P(All, Documents, testing::ValuesIn(documents_with_examples()), [](const auto& document) {
  std::string name = document.param.path;
  std::ranges::replace_if(
      name, [](char c) { return c == '/' || c == '.' || c == '-'; }, '_');
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
  expect_shown(examples, folder.path());
}

/// Folders of examples/ that have a README.md, by name.
std::set<std::string> recipes() {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(FCA_EXAMPLES_DIR)) {
    if (fs::exists(entry.path() / "README.md")) names.insert(entry.path().filename().string());
  }
  return names;
}

class Recipes : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(All, Recipes, testing::ValuesIn(recipes()), [](const auto& recipe) {
  std::string name = recipe.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST_P(Recipes, ShowWhatTheProgramPrints) {
  const TemporaryFolder copy;
  fs::copy(FCA_EXAMPLES_DIR, copy.path(), fs::copy_options::recursive);
  const fs::path folder = copy.path() / GetParam();
  const std::string readme = read_file(folder / "README.md");
  EXPECT_LE(lines_of(readme).size(), 60U);
  expect_shown(examples_in(readme), folder);
}

// Inputs that a recipe is not about to find fault with are ready.
TEST_P(Recipes, HaveInputsThatAreReady) {
  // A table of rays is not looked for in folders; programs are no calibrations.
  const std::set<std::string> without = {"check-a-file", "cpp", "measured-rays", "openvins_simulation"};
  if (without.contains(GetParam())) return;
  const fs::path folder = fs::path(FCA_EXAMPLES_DIR) / GetParam();
  const RunResult run = run_program({"check", "--fail-on", "warning", folder.string()});
  // 2: no calibration is there, since the input is another folder's.
  const bool has_inputs = std::distance(fs::directory_iterator(folder), fs::directory_iterator()) > 1;  // next to README.md
  EXPECT_EQ(run.code, has_inputs ? 0 : 2) << run.out << run.err;
}

// The C++ that a recipe shows is that of the programs next to it, which tests/package builds and runs.
TEST(RecipesList, ShowsProgramsThatAreBuilt) {
  const fs::path folder = fs::path(FCA_EXAMPLES_DIR) / "cpp";
  const std::string readme = read_file(folder / "README.md");
  const std::string programs = read_file(folder / "settings.cc") + read_file(folder / "main.cc");
  const std::string fence = "```cpp\n";
  int shown = 0;
  for (std::size_t at = readme.find(fence); at != std::string::npos; at = readme.find(fence, at)) {
    at += fence.size();
    const std::string code = readme.substr(at, readme.find("```", at) - at);
    EXPECT_TRUE(contains(programs, code)) << code;
    ++shown;
  }
  EXPECT_EQ(shown, 2);
}

TEST(RecipesList, HasEveryRecipe) {
  const std::string list = read_file(fs::path(FCA_EXAMPLES_DIR) / "README.md");
  EXPECT_GE(recipes().size(), 10U);
  for (const std::string& recipe : recipes()) EXPECT_TRUE(contains(list, "](" + recipe + "/README.md)")) << recipe;
}

// The tables of formats are printed from the registry.
TEST(Documents, HaveTheTablesOfTheRegistry) {
  const fs::path root = fs::path(FCA_EXAMPLES_DIR).parent_path();
  for (const auto& [path, table] : {std::pair("README.md", "--markdown"), {"formats/README.md", "--ledger"}}) {
    const RunResult run = run_program({"formats", table});
    EXPECT_TRUE(contains(read_file(root / path), run.out)) << "fca-io formats " << table << " prints\n" << run.out;
  }
}

}  // namespace
}  // namespace fca::test
