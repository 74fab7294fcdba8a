// SPDX-License-Identifier: BSD-3-Clause
// A parsed file with edits on its bytes. No edit, no changed byte: comments, order, quotes, CRLF, number spelling and byte
// order mark survive because nothing rewrites them.
#pragma once

#include <fca/formats/text/node.h>
#include <fca/formats/text/source.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace fca::text {

/// How a document is written.
enum class Syntax {
  kYaml,        ///< Plain YAML (Kalibr).
  kOpenCvYaml,  ///< YAML of cv::FileStorage: first line %YAML:1.0, "key:value" without a blank allowed.
  kXml,         ///< XML of cv::FileStorage; the root is what stands in <opencv_storage>.
  kJson,        ///< Strict JSON. All collections are flow collections.
  kWords,       ///< Lines of words: a sequence of sequences, one for every physical line (OCamCalib, DSO).
  kBinary,      ///< COLMAP's cameras.bin and rigs.bin, as the lines of words that cameras.txt and rigs.txt have; NumPy's .npy.
  kPython,      ///< A literal of Python (mrcal): JSON's brackets and commas, and Python's quotes, numbers and comments.
};

/// Do brackets enclose every list and mapping, with commas between their values and a key in quotes before each of these?
[[nodiscard]] constexpr bool is_in_brackets(Syntax syntax) { return syntax == Syntax::kJson || syntax == Syntax::kPython; }

class Document {
 public:
  Document() = default;
  Document(Source source, Syntax syntax, Node root) : source_(std::move(source)), syntax_(syntax), root_(std::move(root)) {}

  [[nodiscard]] const Source& source() const { return source_; }
  [[nodiscard]] Syntax syntax() const { return syntax_; }
  [[nodiscard]] const Node& root() const { return root_; }
  [[nodiscard]] SourceRange range(const Node& node) const { return source_.range(node.span); }

  /// Replaces the bytes of `span`. Spans of several edits must not overlap; insertions at one place keep their order.
  void replace(const Span& span, std::string text);
  /// Inserts before byte `offset`.
  void insert(std::size_t offset, std::string text) { replace({offset, 0}, std::move(text)); }
  /// Removes an entry of a mapping: in block style the lines it stands on, in flow style it and one of its commas, in XML the
  /// element (with its lines, where nothing else stands there).
  void remove_entry(const Node& mapping, const Entry& entry);
  /// Adds `lines` (without a last line break; spelled in the document's syntax) after `entry` of a mapping. In block style,
  /// and in JSON and XML where `entry` begins its line, as lines of their own with the same indentation; else on the same line.
  /// Commas are the document's affair.
  void insert_after(const Node& mapping, const Entry& entry, const std::string& lines);

  /// Nothing but blanks stands before the entry on its line.
  [[nodiscard]] bool begins_line(const Entry& entry) const;
  /// The blanks at the beginning of the line that holds `offset`.
  [[nodiscard]] std::string_view indentation_at(std::size_t offset) const;
  /// All bytes of an entry: in XML from its opening to its closing tag, else from its key to the end of its value.
  [[nodiscard]] Span extent(const Entry& entry) const;

  [[nodiscard]] bool edited() const { return !edits_.empty(); }
  /// The bytes that edits replace, in the order of the edits.
  [[nodiscard]] std::vector<Span> edited_spans() const;
  /// The bytes with all edits applied.
  [[nodiscard]] std::string bytes() const;

  /// Keeps what the edits left, parsed (keep_edited(), read_document.h), until the next edit.
  void keep_edited(std::shared_ptr<const Document> edited) { kept_ = std::move(edited); }
  /// What was kept; null after another edit.
  [[nodiscard]] const Document* kept_edited() const { return kept_.get(); }

 private:
  static constexpr std::size_t kNoOwner = static_cast<std::size_t>(-1);
  struct Edit {
    Span span;
    std::string text;
    std::size_t owner = kNoOwner;  ///< Offset of the flow mapping whose entries the edit removes or adds.
    std::size_t separator = 0;     ///< Of an added entry: how much of `text` separates it from the one before.
  };
  void add_edit(Edit edit);
  void remove_from_flow(const Node& mapping, const Entry& entry);
  void remove_element(const Entry& entry);
  void insert_in_flow(const Node& mapping, const Entry& entry, const std::string& lines);
  void insert_element_after(const Entry& entry, const std::string& lines);
  /// `lines` with the document's line breaks, each after a break followed by `indentation`.
  [[nodiscard]] std::string laid_out(std::string_view lines, std::string_view indentation) const;

  Source source_;
  Syntax syntax_ = Syntax::kYaml;
  Node root_;
  std::vector<Edit> edits_;
  std::vector<std::size_t> removed_;  ///< Offsets of the keys of entries removed from flow mappings.
  std::vector<std::size_t> emptied_;  ///< Offsets of the flow mappings of which no entry is left.
  std::shared_ptr<const Document> kept_;
};

}  // namespace fca::text
