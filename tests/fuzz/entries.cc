// SPDX-License-Identifier: BSD-3-Clause
#include "entries.h"

#include "formats/corpus_folders.h"

#include <fca/formats/text/numbers.h>
#include <fca/formats/text/read_document.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>
#include <set>

namespace fca::fuzz {

namespace {

namespace fs = std::filesystem;

struct SyntaxRow {
  std::string_view name;
  text::Syntax syntax;
  std::string_view extension;  ///< Of a file that holds it.
};

constexpr std::array kSyntaxes = {SyntaxRow{"yaml", text::Syntax::kYaml, ".yaml"},
                                  SyntaxRow{"opencv-yaml", text::Syntax::kOpenCvYaml, ".yml"},
                                  SyntaxRow{"xml", text::Syntax::kXml, ".xml"},
                                  SyntaxRow{"json", text::Syntax::kJson, ".json"},
                                  SyntaxRow{"python", text::Syntax::kPython, ".cameramodel"},
                                  SyntaxRow{"words", text::Syntax::kWords, ".txt"},
                                  SyntaxRow{"ini", text::Syntax::kWords, ".ini"},
                                  SyntaxRow{"binary", text::Syntax::kBinary, ".bin"}};

/// Besides the parser alone, the file as whatever format it is taken for: what sections, lines and keys are is decided there.
Complaints run_syntax(const SyntaxRow& row, std::string_view bytes) {
  Complaints complaints = parse_promises(row.syntax, bytes);
  const Complaints read = read_promises(nullptr, bytes, "fuzz" + std::string(row.extension), Depth::kRead);
  complaints.insert(complaints.end(), read.begin(), read.end());
  return complaints;
}

std::vector<std::string> all_format_ids() {
  std::vector<std::string> ids;
  for (const Format& format : all_formats()) ids.emplace_back(format.id);
  return ids;
}

/// One input in eight is checked, and another is converted: both take a hundred times as long as reading does, and inputs that
/// differ little take the same ways there.
Depth depth_for(std::string_view bytes) {
  switch (std::hash<std::string_view>()(bytes) % 8) {
    case 0:
      return Depth::kChecked;
    case 1:
      return Depth::kRoundTrip;
    default:
      return Depth::kRead;
  }
}

std::vector<Entry> make_entries() {
  std::vector<Entry> entries;
  for (const SyntaxRow& row : kSyntaxes) {
    entries.push_back({"syntax-" + std::string(row.name), [&row](std::string_view bytes) { return run_syntax(row, bytes); },
                       all_format_ids()});
  }
  for (const Format& format : all_formats()) {
    const std::string id(format.id);
    const std::string name = "fuzz" + std::string(format.extension);
    std::vector<std::string> seeds = {id};
    if (!format.layout_of.empty()) seeds.emplace_back(format.layout_of);
    entries.push_back(
        {id, [&format, name](std::string_view bytes) { return read_promises(&format, bytes, name, depth_for(bytes)); }, seeds});
  }
  return entries;
}

/// Larger ones only say the same more often.
constexpr std::uintmax_t kLargestSeed = 16384;

void add_files(const fs::path& folder, std::vector<fs::path>& files) {
  if (!fs::exists(folder)) return;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().extension() != ".expected" && entry.file_size() <= kLargestSeed)
      files.push_back(entry.path());
  }
}

std::string content_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Keys, and values that are no numbers.
// NOLINTNEXTLINE(misc-no-recursion)
void collect_words(const text::Node& node, std::set<std::string>& words) {
  if (node.is_scalar() && !text::parse_real(node.value)) words.insert(node.value);
  if (!node.tag.empty()) words.insert(node.tag);
  for (const text::Node& item : node.items) collect_words(item, words);
  for (const text::Entry& entry : node.entries) {
    collect_words(entry.key, words);
    collect_words(entry.value, words);
  }
}

bool fits_a_dictionary(const std::string& word) {
  constexpr std::size_t kLongest = 48;
  return !word.empty() && word.size() <= kLongest && std::ranges::all_of(word, [](char c) {
    return std::isprint(static_cast<unsigned char>(c)) != 0 && c != '"' && c != '\\';
  });
}

}  // namespace

const std::vector<Entry>& all_entries() {
  static const std::vector<Entry> entries = make_entries();
  return entries;
}

const Entry* find_entry(std::string_view name) {
  const auto found = std::ranges::find(all_entries(), name, &Entry::name);
  return found == all_entries().end() ? nullptr : &*found;
}

std::vector<fs::path> seeds_of(const Entry& entry) {
  std::vector<fs::path> files;
  for (const std::string& format : entry.seeds_of) {
    const fs::path own = fs::path(FCA_TESTDATA_DIR) / "formats" / format;
    add_files(own / "good", files);
    add_files(own / "bad", files);
    for (const fs::path& folder : test::corpus_folders(FCA_SHARED_DIR, format)) add_files(folder, files);
  }
  add_files(fs::path(FCA_TESTDATA_DIR) / "crashes", files);
  std::ranges::sort(files);
  return files;
}

std::string dictionary_of(const Entry& entry) {
  std::set<std::string> words = {"1e308", "-1e308",      "1e-320", "-0.0", ".nan",
                                 ".inf",  "99999999999", "017",    "0x10", "%YAML:1.0"};
  for (const std::string& format : entry.seeds_of) {
    std::vector<fs::path> files;
    add_files(fs::path(FCA_TESTDATA_DIR) / "formats" / format / "good", files);
    for (const fs::path& path : files) {
      Diagnostics ignored;
      const std::optional<text::Document> document =
          text::parse_document({path.filename().string(), content_of(path)}, ignored);
      if (document) collect_words(document->root(), words);
    }
    const Format* row = find_format(format);
    if (row == nullptr) continue;
    for (const StoredModel& stored : row->models) words.emplace(stored.file_name);
  }
  std::string text;
  for (const std::string& word : words) {
    if (fits_a_dictionary(word)) text += "\"" + word + "\"\n";
  }
  return text;
}

}  // namespace fca::fuzz
