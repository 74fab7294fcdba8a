// SPDX-License-Identifier: BSD-3-Clause
// What the commands say, word for word: golden/COMMAND.txt, the one place where sentences are compared (golden/README.md).
#include "cli/lit_image.h"
#include "cli/run_program.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>

namespace fca::test {
namespace {

/// "a 'b c'" -> a, b c
std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  bool inside = false;
  bool quoted = false;
  for (const char c : line) {
    if (c == '\'') {
      quoted = !quoted;
    } else if (c == ' ' && !quoted) {
      inside = false;
      continue;
    }
    if (!inside) words.emplace_back();
    inside = true;
    if (c != '\'') words.back() += c;
  }
  return words;
}

/// A command of a golden file, with what is written to its standard input and the files that are made for it.
struct Case {
  std::string line;
  std::string input;
  std::vector<std::string> files;
};

std::vector<Case> cases_of(const std::string& golden) {
  std::vector<Case> cases;
  std::istringstream stream(golden);
  bool asked = false;  // what follows is not yet what was printed
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("$ fca-io")) {
      cases.push_back({line, "", {}});
      asked = true;
    } else if (asked && line.starts_with("< ")) {
      cases.back().input += line.substr(2) + "\n";
    } else if (asked && line.starts_with("+ ")) {
      cases.back().files.push_back(line);
    } else {
      asked = false;
    }
  }
  return cases;
}

/// "\n" as the two characters that a golden file has for it.
std::string with_line_breaks(std::string text) {
  for (std::size_t at = text.find("\\n"); at != std::string::npos; at = text.find("\\n")) text.replace(at, 2, "\n");
  return text;
}

/// "+ NAME SOURCE [FROM TO]...": a copy of a file of testdata, with these replaced.
void make_file(const std::string& line, const TemporaryFolder& folder) {
  const std::vector<std::string> words = words_of(line);
  ASSERT_GE(words.size(), 3U) << line;
  std::string bytes = read_file(folder / words[2]);
  ASSERT_FALSE(bytes.empty()) << line;
  for (std::size_t i = 3; i + 1 < words.size(); i += 2)
    bytes = with_replaced(bytes, with_line_breaks(words[i]), with_line_breaks(words[i + 1]));
  folder.write(words[1], bytes);
}

/// Numbers as far as another compiler gives the same ones: four digits, and nothing of what is rounding, of floats too, alone.
std::string rounded(const std::string& number) {
  constexpr double kRounding = 1e-4;
  const double value = std::strtod(number.c_str(), nullptr);
  if (value != 0.0 && std::abs(value) < kRounding) return "TINY";
  if (std::ranges::count_if(number, [](char c) { return c >= '0' && c <= '9'; }) <= 4) return number;
  std::ostringstream text;
  text.precision(4);
  text << value;
  return text.str();
}

/// Without what differs from run to run, or from build to build.
std::string masked(const std::string& text) {
  static const std::regex kVersion("fca-io [0-9]+\\.[0-9]+\\.[0-9]+");
  static const std::regex kNumber("-?[0-9]+\\.[0-9]+(e[-+][0-9]+)?|-?[0-9]+e[-+][0-9]+");
  // Of `evaluate`: how long the fits took.
  static const std::regex kTime(
      "(ours on this one:)(\n    [A-Z]+-[A-Z]+ [^\n]*)+|(fits in ms, in their order:)[0-9 .,\n]*and [0-9.]+|"
      "(in this run on this machine:)(\n    [^\n]*)+");
  // Of several pixels that are as bad as each other.
  static const std::regex kWorst("at \\([0-9.]+, [0-9.]+\\)");
  static const std::regex kPicture("data:image/png;base64,[A-Za-z0-9+/=]*");
  std::string rest = std::regex_replace(text, kVersion, "fca-io VERSION");
  rest = std::regex_replace(std::regex_replace(rest, kPicture, "PICTURE"), kTime, "$1$3$4 TIME");
  rest = std::regex_replace(rest, kWorst, "at (U, V)");
  std::string result;
  auto at = rest.cbegin();
  for (std::sregex_iterator number(rest.begin(), rest.end(), kNumber), end; number != end; ++number) {
    result.append(at, (*number)[0].first);
    result += rounded(number->str());
    at = (*number)[0].second;
  }
  result.append(at, rest.cend());
  static const std::regex kColumn("TINY +");  // as wide as the number that it was
  return std::regex_replace(result, kColumn, "TINY ");
}

/// What a page says: its text, element by element.
std::string text_of_page(std::string page) {
  for (const char* const element : {"style", "svg"}) {
    const std::string close = std::string("</") + element + ">";
    for (std::size_t from = page.find(std::string("<") + element); from != std::string::npos;
         from = page.find(std::string("<") + element, from)) {
      const std::size_t end = page.find(close, from);
      page.erase(from, end == std::string::npos ? end : end + close.size() - from);
    }
  }
  static const std::regex kTag("<[^>]*>");
  static const std::regex kBlank("\\s*\n\\s*");
  return std::regex_replace(std::regex_replace(page, kTag, "\n"), kBlank, "\n");
}

/// The command's part of the golden file, as it is now.
std::string said(const Case& command) {
  const TemporaryFolder fresh;
  const std::string folder = fresh.path().string();
  fs::create_directory_symlink(FCA_TESTDATA_DIR, fresh / "testdata");
  fresh.write("lens.yaml", kChain);
  fresh.write("lit.pgm", Lit{}.file());
  for (const std::string& file : command.files) make_file(file, fresh);
  std::vector<std::string> words = words_of(command.line.substr(std::string("$ fca-io").size()));
  const RunResult run =
      run_program(words, {.input = command.input, .folder = folder, .limit_seconds = 600.0, .in_full = false});
  std::string text = command.line + "\n";
  for (const std::string& file : command.files) text += file + "\n";
  std::istringstream input(command.input);
  for (std::string line; std::getline(input, line);) text += "< " + line + "\n";
  text += "exit code " + std::to_string(run.code) + "\n";
  const auto add = [&text](const std::string& where, const std::string& bytes) {
    if (bytes.empty()) return;
    text += "--- " + where + "\n" + bytes + (bytes.ends_with("\n") ? "" : "\n");
  };
  add("stdout", masked(run.out));
  add("stderr", masked(run.err));
  if (const std::string page = folder + "/page.html"; fs::exists(page)) {
    add("page", masked(text_of_page(read_file(page))));
    fs::remove(page);
  }
  return text + "\n";
}

fs::path golden_file(const std::string& command) {
  return fs::path(FCA_TESTDATA_DIR).parent_path() / "tests/cli/golden" / (command + ".txt");
}

class Golden : public testing::TestWithParam<std::string> {};

TEST_P(Golden, SaysWhatItSaid) {
  const std::string golden = read_file(golden_file(GetParam()));
  const std::vector<Case> cases = cases_of(golden);
  ASSERT_FALSE(cases.empty()) << "no command in " << golden_file(GetParam());
  std::string now = golden.substr(0, golden.find("$ fca-io"));
  for (const Case& command : cases) {
    const std::string part = said(command);
    EXPECT_TRUE(golden.find(part) != std::string::npos || std::getenv("FCA_WRITE_GOLDEN") != nullptr)
        << "golden/" << GetParam() << ".txt has other words; now it is\n"
        << part;
    now += part;
  }
  if (std::getenv("FCA_WRITE_GOLDEN") != nullptr) std::ofstream(golden_file(GetParam()), std::ios::binary) << now;
}

INSTANTIATE_TEST_SUITE_P(Commands, Golden,
                         testing::Values("check", "compare", "convert", "evaluate", "formats", "models", "programs", "project",
                                         "rectify", "remap", "report", "show"),
                         [](const auto& name) { return name.param; });

}  // namespace
}  // namespace fca::test
