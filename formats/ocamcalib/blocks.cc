// SPDX-License-Identifier: BSD-3-Clause
#include "blocks.h"

#include "inverse.h"

#include <fca/code.h>
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
    if (!inverse_missing()) {
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

  /// Four blocks instead of five: after the direct polynomial come a centre, three affine parameters and a size, and no more.
  bool inverse_missing() const {
    std::vector<std::size_t> lengths;
    for (std::size_t i = line_ + 1; i < lines_.size(); ++i) {
      if (!lines_[i].items.empty() && std::ranges::all_of(lines_[i].items, is_number))
        lengths.push_back(lines_[i].items.size());
    }
    return lengths == std::vector<std::size_t>{2, 3, 2};
  }

  /// Always false.
  bool error(const Node& word, Code code, std::vector<Argument> arguments) {
    diagnostics_.add(code, std::move(arguments), document_.range(word));
    return false;
  }
  bool ended_before(Argument what) {
    const std::size_t size = document_.source().bytes.size();
    diagnostics_.add(Code::kCalibResultsEndsBefore, {std::move(what)}, document_.source().range({size, 0}));
    return false;
  }
  static std::string shown(const Node& word) { return word.value.substr(0, 40); }

  /// The one line before a block. After a block the program goes on where its last number ended: what else stands on that line
  /// is the comment.
  bool skip_comment(const std::string& block) {
    const bool first = block == "direct polynomial";
    const bool rest_of_line = !first && line_ < lines_.size() && word_ < lines_[line_].items.size();
    if (!first && peek() == nullptr) return ended_before(block);
    const Node& line = lines_[line_];
    if (rest_of_line && is_number(line.items[word_])) {
      return error(line.items[word_], Code::kCalibResultsMoreNumbers, {block});
    }
    if (!rest_of_line && !line.items.empty() && std::ranges::all_of(line.items, is_number)) {
      return error(line.items.front(), Code::kCalibResultsCommentMissing, {block});
    }
    if (line.span.end() - document_.source().line_at(line.span.offset).offset > kLongestComment) {
      return error(line.items.front(), Code::kCalibResultsCommentTooLong, {block});
    }
    const bool blank = line.items.empty();
    ++line_;
    word_ = 0;
    const Node* word = peek();
    if (word == nullptr) return ended_before(block);
    if (is_number(*word)) return true;
    if (meant_as_number(*word)) return not_a_number(*word, block);
    if (blank) return error(*word, Code::kCalibResultsBlankLine, {shown(*word)});
    std::vector<Message> above;
    if (rest_of_line) above = {{Code::kCalibResultsRestOfLine}};
    return error(*word, Code::kCalibResultsCommentLines, {block, above, shown(*word)});
  }

  /// "1,5", "nan", "1.5px"
  static bool meant_as_number(const Node& word) {
    const char first = word.value.front();
    return (first >= '0' && first <= '9') || first == '-' || first == '+' || first == '.' || word.value == "nan" ||
           word.value == "NaN" || word.value == "inf" || word.value == "Inf";
  }
  bool not_a_number(const Node& word, const std::string& what) {
    std::vector<Message> fix;
    if (word.value.find(',') != std::string::npos) fix = {{Code::kCalibResultsDecimalPoint}};
    return error(word, Code::kCalibResultsNotFinite, {what, shown(word), fix});
  }

  bool whole(const Node& word, Argument what) {
    if (is_whole(word)) return true;
    std::vector<Message> fix;
    if (is_number(word)) fix = {{Code::kCalibResultsWithoutPoint}};
    return error(word, Code::kCalibResultsNotWhole, {std::move(what), shown(word), fix});
  }

  bool polynomial(PolynomialNodes& nodes, const std::string& what, int most) {
    nodes.count = next();
    if (!whole(*nodes.count, Message{Code::kCalibResultsCountOf, {what}})) return false;
    const int count = *text::parse_int(nodes.count->value);
    const int most_of_reader = static_cast<int>(kMostCoefficients);
    const int fewest = what == "inverse polynomial" ? 0 : 1;  // a missing one can be rebuilt
    if (count < fewest || count > most_of_reader) {
      return error(*nodes.count, Code::kCalibResultsCountOutside, {what, nodes.count->value});
    }
    if (count > most) return error(*nodes.count, Code::kCalibResultsDegreeTooHigh, {what, count - 1, most - 1});
    for (int i = 0; i < count; ++i) {
      const Node* word = next();
      if (word == nullptr) return ended_before(Message{Code::kCalibResultsLastCoefficient, {count, what}});
      if (!is_number(*word)) return too_few(*word, what, count, i);
      nodes.coefficients.push_back(word);
    }
    return true;
  }

  template <std::size_t kCount>
  bool numbers(std::array<const Node*, kCount>& nodes, const std::string& what) {
    for (std::size_t i = 0; i < kCount; ++i) {
      nodes[i] = next();
      if (nodes[i] == nullptr) return ended_before(Message{Code::kCalibResultsLastNumber, {what}});
      if (!is_number(*nodes[i])) return too_few(*nodes[i], what, static_cast<int>(kCount), static_cast<int>(i));
    }
    return true;
  }

  bool too_few(const Node& word, const std::string& what, int wanted, int found) {
    if (meant_as_number(word)) return not_a_number(word, what);
    return error(word, Code::kCalibResultsTooFewNumbers, {shown(word), found + 1, wanted, what});
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
    diagnostics.add(Code::kCalibResultsNoLines, {}, {document.source().name, 0, 0});
    return std::nullopt;
  }
  return BlockFinder(document, diagnostics).run();
}

}  // namespace fca::ocamcalib
