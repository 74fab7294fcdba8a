// SPDX-License-Identifier: BSD-3-Clause
// Why a program stumbles over a place, found by trying: a spelling that takes its refusal away is the fix.
#pragma once

#include <fca/formats/consumers/consumer.h>
#include <fca/formats/text/document.h>
#include <fca/message.h>

#include <functional>
#include <optional>
#include <string>

namespace fca {

/// A replacement of bytes after which the program no longer says that sentence. It changes a spelling, never a value.
struct Fix {
  /// What to do. Its id is what was wrong: "int-for-real", "real-for-int", "number-as-text", "unquoted-text", "opencv-header",
  /// "yaml-layout", "yaml-tab", "byte-order-mark".
  Message remedy;
  text::Span span;  ///< Of the document's source.
  std::string text;
};

/// What a program reads from bytes.
using AskProgram = std::function<consumers::ConsumerView(const std::string& bytes)>;

/// What takes a complaint of the program, one of those that it has about the document (`view`), away; nothing where no single
/// other spelling does. The document may have edits: the view is of its bytes with them, and they are never part of a fix. The
/// last bytes that the program is asked about are those with the fix in them.
[[nodiscard]] std::optional<Fix> find_fix(const text::Document& document, const consumers::ConsumerView& view,
                                          const consumers::Complaint& complaint, const AskProgram& ask);

/// Does the complaint say itself how it is fixed?
[[nodiscard]] bool names_fix(const Message& complaint, const Fix& fix);

}  // namespace fca
