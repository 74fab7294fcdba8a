// SPDX-License-Identifier: BSD-3-Clause
// All documents of the repository: their links lead somewhere, their pictures have words, what they name is there, and the
// commands and options that they mention exist. That examples print what is shown is readme_test.cc's.
#include "cli/run_program.h"

#include <algorithm>
#include <map>
#include <regex>

namespace fca::test {
namespace {

const fs::path& root() {
  static const fs::path folder = fs::path(FCA_EXAMPLES_DIR).parent_path();
  return folder;
}

/// *.md where git's files are.
std::vector<fs::path> documents() {
  std::vector<fs::path> paths;
  for (const fs::directory_entry& entry : fs::directory_iterator(root())) {
    if (entry.path().extension() == ".md") paths.push_back(entry.path());
  }
  for (const char* folder : {"cli", "examples", "formats", "lib", "tests"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root() / folder)) {
      if (entry.path().extension() == ".md") paths.push_back(entry.path());
    }
  }
  return paths;
}

std::string name_of(const fs::path& document) { return fs::relative(document, root()).string(); }

/// All that the pattern's first group matches.
std::vector<std::string> matches(const std::string& text, const char* pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), regex); at != std::sregex_iterator(); ++at) found.push_back((*at)[1]);
  return found;
}

/// The anchor that a heading gets: "Why not ...?" -> "why-not-".
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    if (c == ' ') anchor += '-';
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_')
      anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return anchor;
}

std::set<std::string> anchors_in(const std::string& text) {
  std::set<std::string> anchors;
  for (const std::string& line : lines_of(text)) {
    const std::size_t level = line.find_first_not_of('#');
    if (level != 0 && level != std::string::npos && line[level] == ' ') anchors.insert(anchor_of(line.substr(level + 1)));
  }
  return anchors;
}

TEST(AllDocuments, LeadToFilesAndHeadingsThatAreThere) {
  std::size_t links = 0;
  for (const fs::path& document : documents()) {
    const std::string text = read_file(document);
    for (const std::string& link : matches(text, R"(\]\(([^)]*)\))")) {
      if (contains(link, "://")) continue;
      ++links;
      const std::string path = link.substr(0, link.find('#'));
      const fs::path target = path.empty() ? document : document.parent_path() / path;
      EXPECT_TRUE(fs::exists(target)) << name_of(document) << " leads to " << link;
      if (!contains(link, "#") || !fs::is_regular_file(target)) continue;
      EXPECT_TRUE(anchors_in(read_file(target)).contains(link.substr(link.find('#') + 1)))
          << name_of(document) << " leads to " << link;
    }
  }
  EXPECT_GT(links, 100U);
}

TEST(AllDocuments, HavePicturesWithWordsForThoseWhoDoNotSeeThem) {
  std::size_t pictures = 0;
  for (const fs::path& document : documents()) {
    const std::string text = read_file(document);
    EXPECT_FALSE(contains(text, "<img")) << name_of(document);
    for (const std::string& words : matches(text, R"(!\[([^\]]*)\]\()")) {
      ++pictures;
      EXPECT_GE(words.size(), 20U) << name_of(document) << ": " << words;
    }
  }
  EXPECT_GE(pictures, 1U);
}

// A path from the top of the repository in a document's code.
TEST(AllDocuments, NameFilesThatAreThere) {
  std::size_t files = 0;
  for (const fs::path& document : documents()) {
    if (document.filename() == "CHANGELOG.md") continue;  // history
    for (const std::string& path :
         matches(read_file(document), R"(`((?:\.ci|cli|examples|formats|lib|testdata|tests)/[\w./-]*\w)[` ])")) {
      if (path.starts_with("lib/python3/")) continue;  // where packages install
      ++files;
      EXPECT_TRUE(fs::exists(root() / path) || fs::exists(document.parent_path() / path)) << name_of(document) << ": " << path;
    }
  }
  EXPECT_GT(files, 50U);
}

/// What the help of a command lists.
const std::set<std::string>& options_of(const std::string& command) {
  static std::map<std::string, std::set<std::string>> known;
  const auto found = known.find(command);
  if (found != known.end()) return found->second;
  const RunResult run = run_program({command, "--help"});
  std::set<std::string>& options = known[command];
  if (run.code != 0) return options;
  for (const std::string& option : matches(run.out, R"((--[a-z][a-z0-9-]*))")) options.insert(option);
  return options;
}

/// Documents for users, in which what looks like an option is one of the command's.
bool is_for_users(const fs::path& document) {
  const std::string name = name_of(document);
  return name == "README.md" || name == "cli/README.md" || name.starts_with("examples/") ||
         name.starts_with("formats/programs/") || name == "formats/README.md";
}

// `fca-io convert FILE --to FORMAT`, in the text or in code.
TEST(AllDocuments, MentionCommandsAndOptionsThatExist) {
  std::size_t commands = 0;
  for (const fs::path& document : documents()) {
    if (document.filename() == "CHANGELOG.md") continue;
    const std::string text = read_file(document);
    std::vector<std::string> lines = matches(text, R"(`fca-io ([^`\n]*)`)");
    for (const std::string& line : matches(text, R"(\n\$ fca-io ([^\n]*))")) lines.push_back(line);
    for (const std::string& line : lines) {
      const std::string command = line.substr(0, line.find(' '));
      const bool of_a_file = command == "FILE" || command.starts_with('-');  // fca-io FILE shows it
      const std::set<std::string>& options = options_of(of_a_file ? "convert" : command == "help" ? "show" : command);
      EXPECT_FALSE(options.empty()) << name_of(document) << ": fca-io " << line;
      ++commands;
      for (const std::string& option : matches(line.substr(0, line.find(" #")), R"((--[a-z][a-z0-9-]*))"))
        EXPECT_TRUE(options.contains(option) || option == "--version") << name_of(document) << ": fca-io " << line;
    }
  }
  EXPECT_GT(commands, 100U);
}

TEST(AllDocuments, ForUsersMentionOptionsThatExist) {
  std::set<std::string> all;
  for (const std::string command : {"convert", "show", "check", "compare", "report", "remap", "rectify", "project", "unproject",
                                    "formats", "models", "programs", "evaluate", "version"}) {
    EXPECT_FALSE(options_of(command).empty()) << command;
    all.insert(options_of(command).begin(), options_of(command).end());
  }
  std::size_t options = 0;
  for (const fs::path& document : documents()) {
    if (!is_for_users(document)) continue;
    for (const std::string& option : matches(read_file(document), R"(`(--[a-z][a-z0-9-]*))")) {
      ++options;
      EXPECT_TRUE(all.contains(option) || option == "--help") << name_of(document) << ": " << option;
    }
  }
  EXPECT_GT(options, 100U);
}

// Only these documents are run (readme_test.cc).
TEST(AllDocuments, ShowExamplesWhereTheyAreRun) {
  for (const fs::path& document : documents()) {
    const std::string name = name_of(document);
    const bool is_run = name == "README.md" || name == "cli/README.md" || name == "lib/convert/paper.md" ||
                        name.starts_with("examples/") || name.starts_with("formats/programs/");
    EXPECT_TRUE(is_run || !contains(read_file(document), "\n$ fca-io")) << name;
  }
}

TEST(AllDocuments, AreShortWhereReadersBegin) {
  for (const char* path : {"README.md", "CONTRIBUTING.md"}) EXPECT_LE(lines_of(read_file(root() / path)).size(), 150U) << path;
  EXPECT_LE(fs::file_size(root() / "examples/tumvi/page.png"), 150'000U);
}

}  // namespace
}  // namespace fca::test
