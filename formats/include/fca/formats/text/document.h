// SPDX-License-Identifier: BSD-3-Clause
// A parsed file with edits on its bytes. No edit, no changed byte: comments, order, quotes, CRLF, number spelling and byte
// order mark survive because nothing rewrites them.
#pragma once

#include <fca/formats/text/node.h>
#include <fca/formats/text/source.h>

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
};

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
  /// Removes an entry of a mapping: in block style the lines it stands on, in flow style it and one of its commas.
  void remove_entry(const Node& mapping, const Entry& entry);
  /// Adds `key: value` behind `entry` of a mapping: in block style as lines of their own at its key's indentation (`lines`,
  /// without a last line break), in flow style behind a comma.
  void insert_after(const Node& mapping, const Entry& entry, const std::string& lines);

  [[nodiscard]] bool edited() const { return !edits_.empty(); }
  /// The bytes with all edits applied.
  [[nodiscard]] std::string bytes() const;

 private:
  struct Edit {
    Span span;
    std::string text;
  };
  Source source_;
  Syntax syntax_ = Syntax::kYaml;
  Node root_;
  std::vector<Edit> edits_;
};

}  // namespace fca::text
