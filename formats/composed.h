// SPDX-License-Identifier: BSD-3-Clause
// A fresh YAML file and its tree at once. Parsing takes longer than fitting a camera, and who composes a file knows what each
// byte is.
#pragma once

#include "fields.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fca {

/// Fields and comments, line by line, in block style.
class ComposedYaml {
 public:
  /// `head`: what stands above the fields, with its line breaks: "%YAML:1.0" for cv::FileStorage, "---", comments, nothing.
  explicit ComposedYaml(std::string head) : bytes_(std::move(head)) {}

  /// Blank lines and lines of comments, with their line breaks.
  void add_comments(std::string_view lines) { bytes_ += lines; }
  void add(const fields::Field& field) { add_to(root_, field, 0); }
  /// A key whose value is a mapping of these fields, `indentation` blanks deeper than it.
  void add_mapping(const std::string& key, const std::vector<fields::Field>& fields, std::size_t indentation);

  /// What text::parse_document returns for the bytes, node by node and span by span. Where a key or value is no plain word,
  /// number or text (quotes in quotes, "null", other alphabets) it is asked, and this takes as long.
  [[nodiscard]] std::optional<text::Document> document(std::string name, Diagnostics& diagnostics) &&;

 private:
  void add_to(text::Node& mapping, const fields::Field& field, std::size_t indentation);

  std::string bytes_;
  text::Node root_;
  bool plain_ = true;
};

}  // namespace fca
