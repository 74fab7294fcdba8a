// SPDX-License-Identifier: BSD-3-Clause
#include "blocks.h"

#include "inverse.h"

#include <fca/formats/text/numbers.h>

#include <algorithm>
#include <string>

namespace fca::ocamcalib {

using text::Node;

bool is_whole(const Node& word) { return text::parse_int(word.value).has_value(); }
bool is_number(const Node& word) { return text::parse_real(word.value).has_value(); }

namespace {

/// The model's polynomial has degree 8 (lib's ocamcalib.h).
constexpr int kMostDirect = 9;
/// CMV_MAX_BUF of ocam_functions.h, with the terminating zero.
constexpr std::size_t kLongestComment = 1023;

class BlockFinder {
 public:
  BlockFinder(const text::Document& document, Diagnostics& diagnostics)
      : document_(document), lines_(document.root().items), diagnostics_(diagnostics) {}

  std::optional<Blocks> run() {
    Blocks blocks;
    if (!skip_comment("direct polynomial") || !polynomial(blocks.direct, "direct polynomial", kMostDirect)) return {};
    if (!inverse_left_out()) {
      if (!skip_comment("inverse polynomial") ||
          !polynomial(blocks.inverse, "inverse polynomial", static_cast<int>(kMostCoefficients)))
        return {};
    }
    if (!skip_comment("centre") || !numbers(blocks.centre, "centre (row, column)")) return {};
    if (!skip_comment("affine parameters") || !numbers(blocks.affine, "affine parameters (c, d, e)")) return {};
    if (!skip_comment("image size") || !numbers(blocks.size, "image size (height, width)")) return {};
    bool good = true;
    for (const Node* side : blocks.size) good = whole(*side, "image size (height, width)") && good;
    if (!good) return {};
    return blocks;
  }

 private:
  /// The next word, on whatever line; null at the end.
  const Node* peek() {
    while (line_ < lines_.size() && word_ >= lines_[line_].items.size()) {
      ++line_;
      word_ = 0;
    }
    return line_ < lines_.size() ? &lines_[line_].items[word_] : nullptr;
  }
  const Node* next() {
    const Node* word = peek();
    if (word != nullptr) ++word_;
    return word;
  }

  /// Four blocks instead of five: behind the direct polynomial come a centre, three affine parameters and a size, and no more.
  bool inverse_left_out() const {
    std::vector<std::size_t> lengths;
    for (std::size_t i = line_ + 1; i < lines_.size(); ++i) {
      if (!lines_[i].items.empty() && std::ranges::all_of(lines_[i].items, is_number))
        lengths.push_back(lines_[i].items.size());
    }
    return lengths == std::vector<std::size_t>{2, 3, 2};
  }

  void error(const Node& word, std::string code, std::string message, std::string fix) {
    diagnostics_.error(std::move(code), std::move(message), document_.range(word), std::move(fix));
  }
  bool ended_before(const std::string& what) {
    const std::size_t size = document_.source().bytes.size();
    diagnostics_.error("missing-block", "the file ends before the " + what, document_.source().range({size, 0}),
                       "five blocks are wanted: direct polynomial, inverse polynomial, centre, affine parameters, image size");
    return false;
  }
  static std::string shown(const Node& word) { return "'" + word.value.substr(0, 40) + "'"; }

  /// The one line before a block. Behind a block the program goes on where its last number ended: what else stands on that line
  /// is the comment.
  bool skip_comment(const std::string& block) {
    const bool first = block == "direct polynomial";
    const bool rest_of_line = !first && line_ < lines_.size() && word_ < lines_[line_].items.size();
    if (!first && peek() == nullptr) return ended_before(block);
    const Node& line = lines_[line_];
    if (rest_of_line && is_number(line.items[word_])) {
      error(line.items[word_], "wrong-count",
            "more numbers than announced: OCamCalib's reader takes the rest of this line for the comment before the " + block,
            "correct the number of coefficients, or remove what is too many");
      return false;
    }
    if (!rest_of_line && !line.items.empty() && std::ranges::all_of(line.items, is_number)) {
      error(line.items.front(), "comment-missing",
            "no comment line before the " + block + ": OCamCalib's reader skips one line there, these numbers with it",
            "put one line of text before them, such as  #" + block);
      return false;
    }
    if (line.span.end() - document_.source().line_at(line.span.offset).offset > kLongestComment) {
      error(line.items.front(), "comment-too-long",
            "the comment before the " + block + " has more than 1023 characters, which OCamCalib's reader does not skip whole",
            "shorten it");
      return false;
    }
    const bool blank = line.items.empty();
    ++line_;
    word_ = 0;
    const Node* word = peek();
    if (word == nullptr) return ended_before(block);
    if (is_number(*word)) return true;
    if (meant_as_number(*word)) return not_a_number(*word, block);
    if (blank) {
      error(*word, "comment-lines",
            "a blank line before the first comment: OCamCalib's reader skips that one instead and takes " + shown(*word) +
                " for a number",
            "remove the blank line");
    } else {
      error(*word, "comment-lines",
            "OCamCalib's reader skips exactly one line before the " + block +
                (rest_of_line ? ", the rest of the one above" : "") + ", and takes " + shown(*word) + " for a number",
            "leave one line of comment");
    }
    return false;
  }

  /// "1,5", "nan", "1.5px"
  static bool meant_as_number(const Node& word) {
    const char first = word.value.front();
    return (first >= '0' && first <= '9') || first == '-' || first == '+' || first == '.' || word.value == "nan" ||
           word.value == "NaN" || word.value == "inf" || word.value == "Inf";
  }
  bool not_a_number(const Node& word, const std::string& what) {
    const bool comma = word.value.find(',') != std::string::npos;
    error(word, "not-a-number", what + ": " + shown(word) + " is no finite number", comma ? "write a decimal point" : "");
    return false;
  }

  bool whole(const Node& word, const std::string& what) {
    if (is_whole(word)) return true;
    error(word, "not-an-integer", what + ": " + shown(word) + "; OCamCalib's reader takes whole numbers only here",
          is_number(word) ? "write it without a point" : "");
    return false;
  }

  bool polynomial(PolynomialNodes& nodes, const std::string& what, int most) {
    nodes.count = next();
    if (!whole(*nodes.count, "number of coefficients of the " + what)) return false;
    const int count = *text::parse_int(nodes.count->value);
    const int most_of_reader = static_cast<int>(kMostCoefficients);
    const int fewest = what == "inverse polynomial" ? 0 : 1;  // a missing one can be rebuilt
    if (count < fewest || count > most_of_reader) {
      error(*nodes.count, "wrong-count",
            "the " + what + " announces " + nodes.count->value + " coefficients; OCamCalib's reader has places for 1 to 64 " +
                "and does not check",
            "");
      return false;
    }
    if (count > most) {
      error(*nodes.count, "degree-too-high",
            "the " + what + " has degree " + std::to_string(count - 1) + "; fca-io's model ends at degree " +
                std::to_string(most - 1) + " (the toolbox's default is 4)",
            "calibrate with a lower degree");
      return false;
    }
    for (int i = 0; i < count; ++i) {
      const Node* word = next();
      if (word == nullptr) return ended_before("last of the " + std::to_string(count) + " coefficients of the " + what);
      if (!is_number(*word)) return too_few(*word, what, count, i);
      nodes.coefficients.push_back(word);
    }
    return true;
  }

  template <std::size_t kCount>
  bool numbers(std::array<const Node*, kCount>& nodes, const std::string& what) {
    for (std::size_t i = 0; i < kCount; ++i) {
      nodes[i] = next();
      if (nodes[i] == nullptr) return ended_before("last number of the " + what);
      if (!is_number(*nodes[i])) return too_few(*nodes[i], what, static_cast<int>(kCount), static_cast<int>(i));
    }
    return true;
  }

  bool too_few(const Node& word, const std::string& what, int wanted, int found) {
    if (meant_as_number(word)) return not_a_number(word, what);
    error(word, "wrong-count",
          shown(word) + " stands where number " + std::to_string(found + 1) + " of " + std::to_string(wanted) + " of the " +
              what + " is wanted",
          "");
    return false;
  }

  const text::Document& document_;
  const std::vector<Node>& lines_;
  Diagnostics& diagnostics_;
  std::size_t line_ = 0;
  std::size_t word_ = 0;
};

}  // namespace

std::optional<Blocks> find_blocks(const text::Document& document, Diagnostics& diagnostics) {
  if (document.syntax() != text::Syntax::kWords) {
    diagnostics.error("wrong-syntax", "a calib_results.txt is lines of numbers; this is none", {document.source().name, 0, 0});
    return std::nullopt;
  }
  return BlockFinder(document, diagnostics).run();
}

}  // namespace fca::ocamcalib
