// SPDX-License-Identifier: BSD-3-Clause
// Words that users do not read: fca-io says it in the field's terms. Strings of the sources, documents and schemas are
// searched, and public headers for names that were replaced. The table is that of design/TERMS.md, as far as it is about words
// and not names of code.
#include "cli/run_program.h"

#include <algorithm>
#include <cctype>
#include <regex>
#include <span>

namespace fca::test {
namespace {

struct Term {
  const char* pattern;  ///< Of text in lower case.
  const char* instead;
};

constexpr Term kWords[] = {
    {R"(\bjudg(?:e[sd]?|ing)\b)", "evaluate"},
    {R"(\bmend(?:s|ed|ing)?\b)", "fix"},
    {R"(\banew\b)", "rewrite, again, fresh"},
    {R"(\blit circle\b)", "image circle"},
    {R"(\bslips?(?: of the pen)?\b)", "common mistake"},
    {R"(\b(?:is|are|be) (?:said|told|asked)\b|\b(?:was|were) (?:said|told)\b)", "reports, asks"},
    {R"(\bwhat (?:\w+ ){1,3}makes? of\b)", "reads as"},
    {R"(\bsays? nothing\b)", "reports nothing, without a warning"},
    {R"(\b(?:files?|inputs?) says?\b)", "contains, specifies"},
    {R"(\bstate[sd]\b)", "contains, gives"},
    {R"(\bstands? (?:here|there|in|under|before|twice)\b)", "is in the file, is there, appears"},
    {R"(\b(?:is|are) wanted\b)", "must be, is needed"},
    {R"(\bis no (?:list|number|object|matrix|map|mapping|string|int)\b)", "is not a"},
    {R"(\bbeside\b)", "next to, with"},
    {R"(\bbehind (?:it|its|every|each|--\w+|\{|the (?:last|colon|closing|key|value|name))\b)", "after"},
};

/// Words of the code that are not for users. Documents for maintainers have some of them, so only strings are searched.
constexpr Term kWordsOfCode[] = {
    {R"(\bjudge?ments?\b)", "error statistics"}, {R"(\bdomains?\b)", "field of view"},
    {R"(\bcones?\b)", "maximum angle"},          {R"(\bslopes?\b)", "derivative"},
    {R"(\blineari[sz]\w*)", "Jacobian"},         {R"(\bbasins?\b)", "local minimum"},
    {R"(\borthonormal\b)", "rotation"},          {R"(\blens circle\b)", "image circle"},
};

/// Names that were replaced: no public header brings them back.
constexpr Term kNames[] = {
    {R"(\bas_read\b|\basread\b)", "ExtraField"},
    {R"(\blit_steps\b)", "image circle"},
    {R"(\bat_once\b)", "parallel_for"},
    {R"(\btold_once\b|\bhave_place\b|\btell_of_kept\b|\bsay_aside\b|\bunheard\b)", "validate, report, print"},
    {R"(\borthonormal\b)", "QR"},
    {R"(\bcomposedyaml\b)", "fresh file"},
};

fs::path root() { return fs::path(FCA_EXAMPLES_DIR).parent_path(); }

std::vector<fs::path> files_in(const std::vector<const char*>& folders, const std::set<std::string>& extensions) {
  std::vector<fs::path> paths;
  for (const char* folder : folders) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root() / folder)) {
      if (entry.is_regular_file() && extensions.contains(entry.path().extension())) paths.push_back(entry.path());
    }
  }
  return paths;
}

/// The texts between quotes with a blank in them (others are ids and keys), without those of comments and #include.
std::vector<std::string> strings_of(const std::string& source) {
  std::vector<std::string> strings;
  for (std::size_t at = 0; at < source.size(); ++at) {
    std::string text;
    if (source.compare(at, 2, "//") == 0 || source.compare(at, 8, "#include") == 0) {
      at = std::min(source.find('\n', at), source.size());
    } else if (source.compare(at, 3, "R\"(") == 0) {
      const std::size_t end = std::min(source.find(")\"", at), source.size());
      text = source.substr(at + 3, end - at - 3);
      at = end + 1;
    } else if (source.compare(at, 3, "'\"'") == 0) {
      at += 2;
    } else if (source[at] == '"') {
      for (++at; at < source.size() && source[at] != '"'; ++at) {
        if (source[at] == '\\') ++at;
        if (at < source.size()) text += source[at];
      }
    }
    if (contains(text, " ")) strings.push_back(text);
  }
  return strings;
}

/// Text without what stands for code and file contents.
std::string prose_of(const std::string& document) {
  std::string prose;
  for (const std::string& line : lines_of(document)) {
    const bool is_of_codes = contains(line, "units-not-stated") || contains(line, "stated-twice");  // public ids
    if (!is_of_codes) prose += line + "\n";
  }
  static const std::regex kCode("`[^`\n]*`");
  return std::regex_replace(prose, kCode, "");
}

/// A table with its patterns compiled.
class Search {
 public:
  explicit Search(std::span<const Term> terms) : terms_(terms) {
    for (const Term& term : terms) patterns_.emplace_back(term.pattern, std::regex::optimize);
  }

  void expect_none(const std::string& text, const fs::path& where) const {
    // Patterns that ignore case take a multiple of the time.
    std::string lower = text;
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      for (std::sregex_iterator at(lower.begin(), lower.end(), patterns_[i]); at != std::sregex_iterator(); ++at) {
        const auto place = static_cast<std::size_t>(at->position());
        const std::size_t line = text.rfind('\n', place) + 1;  // npos + 1: 0
        ADD_FAILURE() << fs::relative(where, root()).string() << ": \"" << at->str() << "\" in \""
                      << text.substr(line, text.find('\n', place) - line) << "\"; write: " << terms_[i].instead;
      }
    }
  }

 private:
  std::span<const Term> terms_;
  std::vector<std::regex> patterns_;
};

TEST(Terms, OfSentences) {
  const Search words(kWords);
  const Search words_of_code(kWordsOfCode);
  std::size_t strings = 0;
  for (const fs::path& source : files_in({"lib", "formats", "cli"}, {".cc", ".h"})) {
    for (const std::string& text : strings_of(read_file(source))) {
      ++strings;
      words.expect_none(text, source);
      words_of_code.expect_none(text, source);
    }
  }
  EXPECT_GT(strings, 3000U);
}

TEST(Terms, OfDocuments) {
  const Search words(kWords);
  std::vector<fs::path> documents = files_in({"cli", "examples", "formats", "lib", "tests"}, {".md"});
  documents.push_back(root() / "README.md");
  documents.push_back(root() / "CONTRIBUTING.md");
  for (const fs::path& document : documents) words.expect_none(prose_of(read_file(document)), document);
}

TEST(Terms, OfSchemas) {
  const Search words(kWords);
  for (const fs::path& schema : files_in({"cli/schemas"}, {".json"})) {
    for (const std::string& text : strings_of(read_file(schema))) words.expect_none(text, schema);
  }
}

TEST(Terms, OfPublicHeaders) {
  const Search names(kNames);
  std::size_t headers = 0;
  for (const fs::path& header : files_in({"lib/include", "formats/include", "cli/toolkit/include"}, {".h"})) {
    ++headers;
    names.expect_none(read_file(header), header);
  }
  EXPECT_GT(headers, 80U);
}

}  // namespace
}  // namespace fca::test
