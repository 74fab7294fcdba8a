// SPDX-License-Identifier: BSD-3-Clause
#include "realsense_text.h"

#include <fca/formats/text/dialect.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>
#include <utility>

namespace fca::realsense {

using text::Node;

namespace {

constexpr std::string_view kSpaces = " \t\r";

/// What readers ask for. Other names may stand in a list of several devices more than once.
constexpr std::array<std::string_view, 10> kRead = {
    "Width", "Height", "PPX", "PPY", "Fx", "Fy", "Distortion", "Coeffs", "Rotation Matrix", "Translation Vector"};

/// Part of a line as a node.
Node node_of(const IniLine& line, std::size_t begin, std::size_t end) {
  Node node;
  node.kind = text::NodeKind::kScalar;
  node.value = line.text.substr(begin, end - begin);
  node.span = {line.node->span.offset + begin, end - begin};
  return node;
}

/// What stands between quotes in a line.
std::vector<std::string> quoted_in(const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t open = text.find('"'); open != std::string::npos;) {
    const std::size_t close = text.find('"', open + 1);
    if (close == std::string::npos) break;
    names.push_back(text.substr(open + 1, close - open - 1));
    open = text.find('"', close + 1);
  }
  return names;
}

/// The words of a line after its first colon.
std::vector<Node> words_behind_colon(const IniLine& line) {
  const std::size_t colon = line.node->span.offset + line.text.find(':');
  std::vector<Node> words;
  std::ranges::copy_if(line.node->items, std::back_inserter(words),
                       [colon](const Node& word) { return word.span.offset > colon; });
  return words;
}

/// One block of rs-enumerate-devices after the other.
class Printed {
 public:
  std::vector<Block> run(const std::vector<IniLine>& lines) {
    for (const IniLine& line : lines) {
      if (!begin_block(line)) add_to_block(line);
    }
    return std::move(blocks_);
  }

 private:
  bool begin_block(const IniLine& line) {
    struct Head {
      std::string_view words;
      Block::Kind kind;
      std::size_t names;
    };
    constexpr std::array kHeads = {Head{"Intrinsic of \"", Block::Kind::kStream, 1},
                                   Head{"Motion Intrinsic of \"", Block::Kind::kMotion, 1},
                                   Head{"Extrinsic from \"", Block::Kind::kPose, 2}};
    for (const Head& head : kHeads) {
      if (!line.text.starts_with(head.words)) continue;
      const std::vector<std::string> names = quoted_in(line.text);
      if (names.size() < head.names) return false;
      blocks_.push_back({head.kind, line.node, names.front(), head.names > 1 ? names[1] : ""});
      rows_.clear();
      return true;
    }
    return false;
  }

  void add_to_block(const IniLine& line) {
    if (blocks_.empty()) return;
    const std::size_t colon = line.text.find(':');
    auto& values = blocks_.back().values;
    if (colon == std::string::npos) {  // a row of a matrix
      if (!rows_.empty()) std::ranges::copy(line.node->items, std::back_inserter(values[rows_]));
      return;
    }
    std::string key = line.text.substr(0, colon);
    key.erase(key.find_last_not_of(kSpaces) + 1);
    std::vector<Node> words = words_behind_colon(line);
    rows_ = words.empty() ? key : "";
    const bool is_read = std::ranges::find(kRead, key) != kRead.end();
    if (is_read && values.contains(key) && blocks_.back().twice == nullptr) blocks_.back().twice = line.node;
    values.emplace(key, std::move(words));
  }

  std::vector<Block> blocks_ = {};
  std::string rows_ = {};  ///< The key whose rows follow; empty: none.
};

/// After "width: " up to a comma, a bracket or a brace; of "[1.0, 2.0]" each number.
std::vector<Node> values_behind(const IniLine& line, const std::string& key) {
  std::vector<Node> values;
  const std::size_t at = line.text.find(" " + key + ": ");
  if (at == std::string::npos) return values;
  std::size_t begin = at + key.size() + 3;
  const bool is_list = line.text[begin] == '[';
  if (is_list) ++begin;
  const std::size_t list_end = std::min(line.text.find_first_of(is_list ? "]" : ",}", begin), line.text.size());
  while (begin < list_end) {
    const std::size_t end = std::min(line.text.find(',', begin), list_end);
    const std::size_t first = line.text.find_first_not_of(kSpaces, begin);
    const std::size_t last = end == 0 ? 0 : line.text.find_last_not_of(kSpaces, end - 1);
    if (first < end && last != std::string::npos && last >= first) values.push_back(node_of(line, first, last + 1));
    begin = end + 1;
  }
  return values;
}

constexpr std::string_view kRustIntrinsics = "(rs2_intrinsics {";
constexpr std::string_view kRustExtrinsics = "(rs2_extrinsics {";

/// Names of a structure's members there and in rs-enumerate-devices.
constexpr std::array<std::pair<const char*, const char*>, 8> kMembers = {{{"width", "Width"},
                                                                          {"height", "Height"},
                                                                          {"ppx", "PPX"},
                                                                          {"ppy", "PPY"},
                                                                          {"fx", "Fx"},
                                                                          {"fy", "Fy"},
                                                                          {"model", "Distortion"},
                                                                          {"coeffs", "Coeffs"}}};

Block intrinsics_of_rust(const IniLine& line, std::string name) {
  Block block{Block::Kind::kStream, line.node, std::move(name)};
  for (const auto& [rust, printed] : kMembers) block.values[printed] = values_behind(line, rust);
  return block;
}

/// Of a matrix column by column.
std::vector<Node> by_rows(std::vector<Node> R) {
  constexpr std::size_t kElements = 9;
  if (R.size() == kElements) {
    std::swap(R[1], R[3]);
    std::swap(R[2], R[6]);
    std::swap(R[5], R[7]);
  }
  return R;
}

std::optional<Block> extrinsics_of_rust(const IniLine& line, const std::string& names) {
  constexpr std::string_view kTo = " to ";
  const std::size_t to = names.find(kTo);
  if (to == std::string::npos) return std::nullopt;
  Block block{Block::Kind::kPose, line.node, names.substr(0, to), names.substr(to + kTo.size())};
  block.values["Rotation Matrix"] = by_rows(values_behind(line, "rotation"));
  block.values["Translation Vector"] = values_behind(line, "translation");
  return block;
}

std::optional<Block> block_of_rust(const IniLine& line) {
  const std::size_t structure = std::min(line.text.find(kRustIntrinsics), line.text.find(kRustExtrinsics));
  if (structure == std::string::npos) return std::nullopt;
  // What is printed before "Ok(".
  std::string name = line.text.substr(0, line.text.rfind(' ', line.text.find('(')));
  name.erase(name.find_last_not_of(" \t:") + 1);
  if (line.text.find(kRustIntrinsics) == structure) return intrinsics_of_rust(line, std::move(name));
  return extrinsics_of_rust(line, name);
}

/// A member's value or values.
std::vector<Node> values_of(const Node& structure, std::string_view key) {
  const Node* value = text::find(structure, key, text::Dialect::kPyYaml);
  if (value == nullptr) return {};
  return value->is_sequence() ? value->items : std::vector<Node>{*value};
}

/// "distortion.inverse_brown_conrady", or without the prefix, as "Inverse Brown Conrady".
void name_as_printed(Node& distortion) {
  constexpr std::string_view kPrefix = "distortion.";
  std::string name = distortion.value;
  if (name.starts_with(kPrefix)) name.erase(0, kPrefix.size());
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (i == 0 || name[i - 1] == ' ') name[i] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[i])));
    if (name[i] == '_') name[i] = ' ';
  }
  distortion.value = name;
}

std::vector<Block> blocks_of_python(const Node& root) {
  std::vector<Block> blocks;
  for (const text::Entry& entry : root.entries) {
    const auto has = [&entry](std::string_view key) { return !values_of(entry.value, key).empty(); };
    const std::size_t to = entry.key.value.find("_to_");
    if (has("ppx") && has("coeffs")) {
      Block& block = blocks.emplace_back(Block{Block::Kind::kStream, &entry.value, entry.key.value});
      for (const auto& [member, printed] : kMembers) block.values[printed] = values_of(entry.value, member);
      for (Node& word : block.values["Distortion"]) name_as_printed(word);
    } else if (to != std::string::npos && has("rotation") && has("translation")) {
      constexpr std::size_t kTo = 4;
      Block& block = blocks.emplace_back(
          Block{Block::Kind::kPose, &entry.value, entry.key.value.substr(0, to), entry.key.value.substr(to + kTo)});
      block.values["Rotation Matrix"] = by_rows(values_of(entry.value, "rotation"));
      block.values["Translation Vector"] = values_of(entry.value, "translation");
    }
  }
  return blocks;
}

}  // namespace

std::vector<Block> blocks_of(const text::Document& document) {
  if (document.syntax() == text::Syntax::kJson) return blocks_of_python(document.root());
  if (document.syntax() != text::Syntax::kWords) return {};
  const std::vector<IniLine> lines = ini_lines_of(document);
  std::vector<Block> blocks;
  for (const IniLine& line : lines) {
    if (std::optional<Block> block = block_of_rust(line)) blocks.push_back(*std::move(block));
  }
  return blocks.empty() ? Printed().run(lines) : blocks;
}

}  // namespace fca::realsense
