// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fca/diagnostics.h>
#include <fca/formats/text/document.h>

#include <optional>
#include <string>

namespace fca::text {

/// Bytes to Document: of COLMAP's binary files (Source::is_binary), else of text, the syntax chosen by the first lines and then
/// by the name's extension (formats/text/syntax.h has the rule). Nothing, with an error at line and column, where they are no
/// document: empty, over kMaxFileBytes, nested deeper than kMaxDepth, anchors or aliases, several YAML documents, XML with a
/// document type or another root than <opencv_storage>, syntax errors.
[[nodiscard]] std::optional<Document> parse_document(Source source, Diagnostics& diagnostics);

/// The document as its edits left it: its tree says what its bytes do now, not what stood there before. Nothing where they are
/// no document any more.
[[nodiscard]] std::optional<Document> as_edited(const Document& document);

/// Parses what the edits left and keeps it in the document: as_edited() then has it at hand until the next edit.
void keep_edited(Document& document);

/// Reads and parses a file. A missing, unreadable or non-regular file is an error "cannot-read".
[[nodiscard]] std::optional<Document> read_document(const std::string& path, Diagnostics& diagnostics);

/// What a Source of standard input is called.
inline constexpr const char* kStandardInput = "<stdin>";

/// The bytes of a file.
[[nodiscard]] std::optional<Source> read_source(const std::string& path, Diagnostics& diagnostics);

}  // namespace fca::text
