// SPDX-License-Identifier: BSD-3-Clause
// Where a request's files come from.
#pragma once

#include <fca/diagnostics.h>
#include <fca/formats/text/document.h>
#include <fca/formats/text/source.h>
#include <fca/toolkit/image.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fca {

/// Does a path stand for standard input?
[[nodiscard]] constexpr bool is_standard_input(std::string_view path) { return path == "-"; }

/// The files of one request, from the disk or, where the two virtual functions are overridden, from elsewhere. It keeps what
/// was read: diagnostics point into it. Not to be used by two threads at once.
class Files {
 public:
  Files() = default;
  virtual ~Files() = default;
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;

  /// A calibration file. "-" is read once, however often it is asked for: where fetch() takes it for standard input, as the
  /// command's does. Nothing with an error "cannot-read".
  [[nodiscard]] std::optional<text::Source> read(const std::string& path, Diagnostics& diagnostics);
  /// An image, decoded. Nothing with an error.
  [[nodiscard]] virtual std::optional<Image> read_image(const std::string& path, Diagnostics& diagnostics);

  /// The document that such a text is. What is parsed once, here or in those that this knows of, is not parsed again.
  [[nodiscard]] std::optional<text::Document> parse(text::Source source, Diagnostics& diagnostics);
  /// Takes over what the others have parsed.
  void know_documents_of(const Files& others) { parsed_ = others.parsed_; }

  /// A text that was read otherwise, and into which diagnostics point, too.
  void remember(text::Source source) { sources_.push_back(std::move(source)); }
  /// All that was read, in its order.
  [[nodiscard]] const std::vector<text::Source>& sources() const { return sources_; }

 protected:
  /// The bytes of a file. By default those on the disk.
  [[nodiscard]] virtual std::optional<text::Source> fetch(const std::string& path, Diagnostics& diagnostics) const;

 private:
  struct Parsed {
    text::Document document;
    Diagnostics said;
  };

  std::vector<text::Source> sources_;
  std::vector<std::shared_ptr<const Parsed>> parsed_;
};

}  // namespace fca
