// SPDX-License-Identifier: BSD-3-Clause
// Where the numbers of calib_results.txt stand.
#pragma once

#include <fca/diagnostics.h>
#include <fca/formats/text/document.h>

#include <array>
#include <optional>
#include <vector>

namespace fca::ocamcalib {

/// A polynomial's number of coefficients and the coefficients.
struct PolynomialNodes {
  const text::Node* count = nullptr;  ///< Null: the block is not there at all (the inverse polynomial may be left out).
  std::vector<const text::Node*> coefficients;
};

/// The five blocks, as words of the document they were found in.
struct Blocks {
  PolynomialNodes direct;
  PolynomialNodes inverse;
  std::array<const text::Node*, 2> centre{};  ///< row, column
  std::array<const text::Node*, 3> affine{};  ///< c, d, e
  std::array<const text::Node*, 2> size{};    ///< height, width
};

/// Finds the blocks as get_ocam_model does, which skips one line before each, and says where that program would lose its way.
[[nodiscard]] std::optional<Blocks> find_blocks(const text::Document& document, Diagnostics& diagnostics);

/// A whole number as scanf's %d takes it from a word all of whose characters it uses.
[[nodiscard]] bool is_whole(const text::Node& word);
[[nodiscard]] bool is_number(const text::Node& word);

}  // namespace fca::ocamcalib
