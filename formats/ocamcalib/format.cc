// SPDX-License-Identifier: BSD-3-Clause
#include "blocks.h"
#include "ocamcalib.h"

#include <fca/code.h>

#include <algorithm>
#include <array>

namespace fca::ocamcalib {

using text::Node;

namespace {

constexpr std::array kModels = {StoredModel{"ocamcalib", "direct polynomial", true, "OCamCalib", {}}};
constexpr std::array kOwnFacts = {OwnFact{"the inverse polynomial"}};
constexpr std::array kDemands = {
    Demand{.name = "inverse polynomial (fitted)", .key = "inverse polynomial", .of_model = "ocamcalib"}};

bool mentions(const Node& line, std::string_view lower_case) {
  return std::ranges::any_of(line.items, [lower_case](const Node& word) {
    std::string text = word.value;
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text.find(lower_case) != std::string::npos;
  });
}

bool is_numbers(const Node& line) { return !line.items.empty() && std::ranges::all_of(line.items, is_number); }

/// The shape alone, comments or not, so that a file that lost a comment is still known: the lines of numbers begin with a
/// counted polynomial and end with 2, 3 and 2 numbers.
bool has_shape(const std::vector<Node>& lines) {
  std::vector<const Node*> numbers;
  for (const Node& line : lines) {
    if (is_numbers(line)) numbers.push_back(&line);
  }
  const std::size_t count = numbers.size();
  return count >= 5 && is_whole(numbers.front()->items.front()) && numbers[count - 3]->items.size() == 2 &&
         numbers[count - 2]->items.size() == 3 && numbers[count - 1]->items.size() == 2;
}

/// A README that speaks of such files: more words than a file with its comments has besides its numbers.
bool is_prose(const std::vector<Node>& lines) {
  const auto numbers = std::ranges::count_if(lines, is_numbers);
  const auto words = std::ranges::count_if(lines, [](const Node& line) { return !line.items.empty() && !is_numbers(line); });
  constexpr auto kMostComments = 10;
  return words > kMostComments + 3 * numbers;
}

ProbeResult probe(const text::Document& document) {
  if (document.syntax() != text::Syntax::kWords) return {};
  const std::vector<Node>& lines = document.root().items;
  if (std::ranges::none_of(lines, is_numbers) || (!has_shape(lines) && is_prose(lines))) return {};
  for (const Node& line : lines) {
    if (!is_numbers(line) && mentions(line, "direct") && mentions(line, "mapping"))
      return {95, Message{Code::kCalibResultsDirectComment}};
  }
  Diagnostics ignored;
  if (find_blocks(document, ignored)) return {90, Message{Code::kCalibResultsBlocks}};
  if (has_shape(lines)) return {70, Message{Code::kCalibResultsShape}};
  const auto comment = std::ranges::find_if(
      lines, [](const Node& line) { return !is_numbers(line) && (mentions(line, "polynomial") || mentions(line, "affine")); });
  if (comment != lines.end()) return {50, Message{Code::kCalibResultsComment}};
  return {};
}

}  // namespace

const Format kFormat = {
    .id = "ocamcalib",
    .title = "OCamCalib calib_results.txt",
    .group = FormatGroup::kCalibration,
    .syntaxes = "text",
    .extension = ".txt",
    .program = "OCamCalib",
    .reader_warns = true,
    .many_cameras = false,
    .extrinsics = false,
    .imu = false,
    .image_size = true,
    .own_facts = kOwnFacts,
    .demands = kDemands,
    .models = kModels,
    .probe = probe,
    .read = read,
    .write = write,
};

}  // namespace fca::ocamcalib
