// SPDX-License-Identifier: BSD-3-Clause
// Reads the files of a request.
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

/// True if the path means standard input.
[[nodiscard]] constexpr bool is_standard_input(std::string_view path) { return path == "-"; }

/// Reads the files of one request from the disk. A derived class that overrides the two virtual functions can read them from
/// another place. The object keeps all texts that it has read, because diagnostics point into them. It is not thread-safe.
class Files {
 public:
  Files() = default;
  virtual ~Files() = default;
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;

  /// Reads a calibration file. nullopt, with an error "cannot-read", if that fails. Standard input ("-", if fetch() supports
  /// it) is read only once; later calls return the same text.
  [[nodiscard]] std::optional<text::Source> read(const std::string& path, Diagnostics& diagnostics);
  /// Reads and decodes an image. nullopt, with an error, if that fails.
  [[nodiscard]] virtual std::optional<Image> read_image(const std::string& path, Diagnostics& diagnostics);

  /// Parses a text. nullopt, with errors, if that fails. A text that this object or one known to it has already parsed is not
  /// parsed again.
  [[nodiscard]] std::optional<text::Document> parse(text::Source source, Diagnostics& diagnostics);
  /// Copies the parsed documents of another object, so that parse() does not parse them again.
  void know_documents_of(const Files& others) { parsed_ = others.parsed_; }

  /// Keeps a text that was read by other means, since diagnostics point into it.
  void remember(text::Source source) { sources_.push_back(std::move(source)); }
  /// All texts, in the order in which they were read.
  [[nodiscard]] const std::vector<text::Source>& sources() const { return sources_; }

 protected:
  /// Returns the contents of a file; by default it reads the disk. nullopt, with an error, if that fails.
  [[nodiscard]] virtual std::optional<text::Source> fetch(const std::string& path, Diagnostics& diagnostics) const;

 private:
  struct Parsed {
    text::Document document;
    Diagnostics found;  ///< What the parser reported.
  };

  std::vector<text::Source> sources_;
  std::vector<std::shared_ptr<const Parsed>> parsed_;
};

}  // namespace fca
