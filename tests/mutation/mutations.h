// SPDX-License-Identifier: BSD-3-Clause
// A document with its structure broken at one place: what a hand or a program that writes such files gets wrong.
#pragma once

#include <fca/formats/text/document.h>

#include <random>
#include <string>

namespace fca::test {

struct Mutation {
  std::string what;  ///< For people: "a key misspelt".
  std::string bytes;
};

/// One of: a key misspelt, an entry, item or line doubled, lost or moved, two values exchanged, a value turned into another
/// kind.
[[nodiscard]] Mutation mutated_structure(const text::Document& document, std::mt19937& random);

}  // namespace fca::test
