// SPDX-License-Identifier: BSD-3-Clause
// What the tests of the formats share: files, parsing with its diagnostics, and the leaves of a tree.
#pragma once

#include "corpus_folders.h"

#include <fca/formats/calibration.h>
#include <fca/formats/text/numbers.h>
#include <fca/formats/text/read_document.h>
#include <fca/formats/text/render.h>
#include <fca/formats/wording.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace fca::test {

namespace fs = std::filesystem;

inline fs::path shared_dir() { return FCA_SHARED_DIR; }
inline fs::path testdata_dir() { return fs::path(FCA_TESTDATA_DIR) / "formats"; }

inline std::string read_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The regular files of a folder with that extension ("" for all), sorted by name.
inline std::vector<fs::path> files_in(const fs::path& folder, const std::string& extension = "") {
  std::vector<fs::path> result;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file() && (extension.empty() || entry.path().extension() == extension)) result.push_back(entry.path());
  }
  std::ranges::sort(result);
  return result;
}

/// The corpus' files of a format; none where there is no such folder.
inline std::vector<fs::path> corpus_files_of(std::string_view format) {
  std::vector<fs::path> files;
  for (const fs::path& folder : corpus_folders(shared_dir(), format))
    std::ranges::copy(files_in(folder), std::back_inserter(files));
  return files;
}

/// The files of testdata/formats/*/good (or bad), without the expected texts.
inline std::vector<fs::path> files_of_all_formats(const std::string& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& format : fs::directory_iterator(testdata_dir())) {
    if (!fs::exists(format.path() / folder)) continue;
    const std::vector<fs::path> found = files_in(format.path() / folder);
    std::ranges::copy_if(found, std::back_inserter(files),
                         [](const fs::path& path) { return path.extension() != ".expected"; });
  }
  std::ranges::sort(files);
  return files;
}

inline std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

inline std::string severity_word(Severity severity) {
  return severity == Severity::kError ? "error" : severity == Severity::kWarning ? "warning" : "note";
}

/// "3:11": line and column of where it begins; "byte 24" of a binary file; "-" of the whole file.
inline std::string place_of(const SourceRange& where, const text::Source& source) {
  if (where.offset == 0 && where.length == 0) return "-";
  if (source.is_binary()) return "byte " + std::to_string(where.offset);
  const text::Position position = source.position(where.offset);
  return std::to_string(position.line) + ":" + std::to_string(position.column);
}

/// What parsing (and reading) came to, with everything that was said.
struct Parsed {
  std::optional<text::Document> document;
  Diagnostics diagnostics;
  text::Source source;

  [[nodiscard]] std::string codes() const {
    std::string result;
    for (const Diagnostic& entry : diagnostics.entries()) result += (result.empty() ? "" : " ") + id_of(entry);
    return result;
  }
  [[nodiscard]] std::string rendered() const {
    std::string result;
    for (const Diagnostic& entry : diagnostics.entries()) result += text::render(entry, std::span(&source, 1));
    return result;
  }
};

inline Parsed parse(const std::string& bytes, const std::string& name = "file.yaml") {
  Parsed parsed;
  parsed.source = {name, bytes};
  parsed.document = text::parse_document(parsed.source, parsed.diagnostics);
  return parsed;
}

/// A document that is known to parse.
inline text::Document document_of(const std::string& bytes, const std::string& name = "file.yaml") {
  Parsed parsed = parse(bytes, name);
  EXPECT_TRUE(parsed.document) << parsed.rendered() << bytes;
  return parsed.document ? *std::move(parsed.document) : text::Document();
}

/// The rig of bytes that are known to be a calibration.
inline Calibration calibration_of(const std::string& bytes, const std::string& name = "file.yaml") {
  Diagnostics diagnostics;
  std::optional<Calibration> calibration = read_calibration({document_of(bytes, name)}, nullptr, {}, diagnostics);
  EXPECT_TRUE(calibration) << (diagnostics.entries().empty() ? "" : message_of(diagnostics.entries().front())) << "\n" << bytes;
  return calibration ? *std::move(calibration) : Calibration();
}

/// Every scalar of a tree, keys included, in file order.
inline void collect_scalars(const text::Node& node, std::vector<const text::Node*>& scalars) {
  if (node.is_scalar()) scalars.push_back(&node);
  for (const text::Node& item : node.items) collect_scalars(item, scalars);
  for (const text::Entry& entry : node.entries) {
    collect_scalars(entry.key, scalars);
    collect_scalars(entry.value, scalars);
  }
}

inline std::vector<const text::Node*> scalars_of(const text::Document& document) {
  std::vector<const text::Node*> scalars;
  collect_scalars(document.root(), scalars);
  return scalars;
}

/// Numbers are parts of words, "fx=700.5" or "640,", or of whole lines, as KITTI's are, and hardly one stands alone.
inline bool has_numbers_inside_words(const text::Document& document) {
  const std::string& bytes = document.source().bytes;
  const bool is_of_words = document.syntax() == text::Syntax::kWords &&
                           (bytes.find("\nfx=") != std::string::npos || bytes.find("rs2_intrinsics") != std::string::npos);
  constexpr int kFew = 3;
  return is_of_words || std::ranges::count_if(scalars_of(document), [](const text::Node* scalar) {
                          return text::parse_real(scalar->value).has_value();
                        }) <= kFew;
}

/// The node under "cam0/intrinsics/2": keys of mappings (the first of that name) and indices of sequences.
inline const text::Node& at(const text::Document& document, const std::string& path) {
  static const text::Node kMissing;
  const text::Node* node = &document.root();
  for (const std::string& step : split(path, '/')) {
    const text::Node* next = nullptr;
    if (node->is_sequence()) {
      const std::size_t index = std::stoul(step);
      if (index < node->items.size()) next = &node->items[index];
    } else {
      for (const text::Entry& entry : node->entries) {
        if (next == nullptr && entry.key.value == step) next = &entry.value;
      }
    }
    if (next == nullptr) {
      ADD_FAILURE() << "no " << path;
      return kMissing;
    }
    node = next;
  }
  return *node;
}

inline const text::Entry& entry_at(const text::Node& mapping, const std::string& key) {
  static const text::Entry kMissing;
  const auto found = std::ranges::find_if(mapping.entries, [&key](const text::Entry& entry) { return entry.key.value == key; });
  EXPECT_NE(found, mapping.entries.end()) << key;
  return found == mapping.entries.end() ? kMissing : *found;
}

/// `text` with the one occurrence of `from` replaced by `to`.
inline std::string with_replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  EXPECT_EQ(text.find(from, place + 1), std::string::npos) << from << " stands twice";
  return place == std::string::npos ? text : text.replace(place, from.size(), to);
}

}  // namespace fca::test
