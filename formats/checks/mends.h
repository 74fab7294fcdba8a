// SPDX-License-Identifier: BSD-3-Clause
// Why a program stumbles over a place, found by trying: a spelling that takes its refusal away is the mend.
#pragma once

#include <fca/formats/consumers/consumer.h>
#include <fca/formats/format.h>
#include <fca/formats/text/document.h>

#include <optional>
#include <string>

namespace fca::checks {

/// A replacement of bytes after which the program no longer says that sentence.
struct Mend {
  std::string code;  ///< What was wrong: "int-for-real", "real-for-int", "number-as-text", "unquoted-text", "opencv-header",
                     ///< "yaml-layout", "yaml-tab", "byte-order-mark".
  text::Span span;
  std::string text;
  std::string fix;  ///< What to do, in words.
};

/// The part of the document that a program's sentence names by its first words ("cam0/intrinsics: fu is ...", "Camera.fps is
/// ..."); null if it names none.
[[nodiscard]] const text::Node* named_in(const text::Document& document, std::string_view sentence);

/// What takes a refusal or warning of the program away; nothing where no single other spelling does.
[[nodiscard]] std::optional<Mend> find_mend(const text::Document& document, const consumers::Consumer& program,
                                            const consumers::LoadOptions& options, const std::string& complaint);

/// The neighbour in its list with which the number at `offset` is to be exchanged so that the format reads the document; null
/// if there is none.
[[nodiscard]] const text::Node* exchanged_with(const text::Document& document, const Format& format, const ReadOptions& options,
                                               std::size_t offset);

}  // namespace fca::checks
