// SPDX-License-Identifier: BSD-3-Clause
// The only user of yaml-cpp in the text layer. Its event handler builds our tree directly, so that what is too deep or too long
// is refused before a tree exists.
#include "yaml.h"

#include "../yaml_directive.h"
#include "opencv_prepass.h"
#include "refusal.h"
#include "yaml_copies.h"

#include <fca/formats/text/limits.h>

#include <algorithm>
#include <array>
#include <optional>
#include <regex>
#include <sstream>
#include <vector>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

namespace fca::text {

namespace {

/// Where a quoted scalar that opens at `open` ends (after the closing quote). yaml-cpp forgives a quote that the file's end
/// cuts off.
std::size_t end_of_quotes(std::string_view bytes, std::size_t open) {
  const char quote = bytes[open];
  for (std::size_t i = open + 1; i < bytes.size(); ++i) {
    if (quote == '"' && bytes[i] == '\\') {
      ++i;
    } else if (bytes[i] == quote) {
      if (quote == '\'' && i + 1 < bytes.size() && bytes[i + 1] == '\'') {
        ++i;
      } else {
        return i + 1;
      }
    }
  }
  throw Refusal{{Code::kYamlQuoteOpen}, open};
}

Refusal alias_at(std::size_t offset) { return {{Code::kYamlAlias}, offset}; }

/// Where a flow collection that opens at `open` ends (after its bracket).
std::size_t end_of_flow(std::string_view bytes, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < bytes.size(); ++i) {
    const char c = bytes[i];
    const bool opens_token = i == open || std::string_view(" \t\r\n,[{:").find(bytes[i - 1]) != std::string_view::npos;
    if ((c == '"' || c == '\'') && opens_token) {
      i = end_of_quotes(bytes, i) - 1;
    } else if (c == '#' && opens_token) {
      const std::size_t newline = bytes.find('\n', i);
      if (newline == std::string_view::npos) return bytes.size();
      i = newline;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      if (--depth == 0) return i + 1;
    }
  }
  return bytes.size();
}

class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(const Source& source, const SpacedText& spaced, std::size_t skipped, bool has_anchors)
      : source_(source), spaced_(spaced), skipped_(skipped), has_anchors_(has_anchors) {}

  Node take_root() { return std::move(root_); }
  [[nodiscard]] const YamlCopies& copies() const { return copies_; }
  [[nodiscard]] bool has_content() const { return has_content_; }
  [[nodiscard]] std::size_t document_start() const { return document_start_; }

  void OnDocumentStart(const YAML::Mark& mark) override { document_start_ = offset(mark); }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    refuse_anchor(mark, anchor);
    Node node;
    node.span = {offset(mark), 0};
    add(std::move(node), anchor);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const std::size_t at = offset(mark);
    std::optional<Node> node = copies_.copy(anchor, at);
    if (!node) throw alias_at(at);
    const std::size_t end = source_.bytes.find_first_of(" \t\r\n,]}", at);
    node->span = {at, std::min(end, source_.bytes.size()) - at};
    add(*std::move(node));
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, const std::string& value) override {
    refuse_anchor(mark, anchor);
    Node node;
    node.kind = NodeKind::kScalar;
    node.value = value;
    node.quoted = tag == "!";  // yaml-cpp's mark of a scalar that is not plain
    if (tag != "!" && tag != "?") node.tag = tag;
    node.span = scalar_span(offset(mark), value);
    has_content_ = true;
    add(std::move(node), anchor);
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value style) override {
    open(NodeKind::kSequence, mark, tag, anchor, style);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value style) override {
    open(NodeKind::kMapping, mark, tag, anchor, style);
  }
  void OnMapEnd() override { close(); }

 private:
  struct Open {
    Node node;
    Node key;
    bool has_key = false;
    YAML::anchor_t anchor = 0;
  };

  [[nodiscard]] std::size_t offset(const YAML::Mark& mark) const {
    const std::size_t in_text = mark.pos < 0 ? 0 : static_cast<std::size_t>(mark.pos);
    return std::min(skipped_ + spaced_.original_offset(in_text), source_.bytes.size());
  }

  void refuse_anchor(const YAML::Mark& mark, YAML::anchor_t anchor) const {
    if (anchor != 0 && !has_anchors_) throw Refusal{{Code::kYamlAnchor}, offset(mark)};
  }

  /// Where a value begins after its anchor and tag, from where those begin. `kinds`: "&" of anchors, "!" of tags.
  [[nodiscard]] std::size_t behind_properties(std::size_t at, std::string_view kinds) const {
    const std::string_view bytes = source_.bytes;
    while (at < bytes.size() && kinds.find(bytes[at]) != std::string_view::npos) {
      const std::size_t end = std::min(bytes.find_first_of(" \t\r\n", at), bytes.size());
      at = std::min(bytes.find_first_not_of(" \t\r\n", end), bytes.size());
    }
    return at;
  }

  /// Plain scalars on one line stand there letter by letter; of others (several lines, block scalars) only the start is known.
  [[nodiscard]] Span scalar_span(std::size_t begin, const std::string& value) const {
    const std::string_view bytes = source_.bytes;
    const std::size_t at = behind_properties(begin, "&!");
    if (value.empty() && bytes.substr(at, 1) != "\"" && bytes.substr(at, 1) != "'") return {begin, 0};
    if (at < bytes.size() && (bytes[at] == '"' || bytes[at] == '\'')) return {at, end_of_quotes(bytes, at) - at};
    if (bytes.substr(at, value.size()) == value) return {at, value.size()};
    return {at, 0};
  }

  void open(NodeKind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
            YAML::EmitterStyle::value style) {
    refuse_anchor(mark, anchor);
    if (stack_.size() >= kMaxDepth) throw too_deep(offset(mark));
    Open opened;
    opened.node.kind = kind;
    opened.node.flow = style == YAML::EmitterStyle::Flow;
    if (tag != "?" && tag != "!") opened.node.tag = tag;
    opened.node.span = {behind_properties(offset(mark), "&"), 0};
    opened.anchor = anchor;
    has_content_ = true;
    stack_.push_back(std::move(opened));
  }

  /// A single key and value in a list, [a: 1], are a mapping without brackets.
  [[nodiscard]] bool is_bracketed(const Node& node) const {
    return node.span.offset < source_.bytes.size() &&
           std::string_view("[{!").find(source_.bytes[node.span.offset]) != std::string_view::npos;
  }

  void close() {
    Node node = std::move(stack_.back().node);
    const YAML::anchor_t anchor = stack_.back().anchor;
    stack_.pop_back();
    std::size_t end = node.span.offset;
    if (node.flow && is_bracketed(node)) {
      const std::size_t bracket = source_.bytes.find_first_of("[{", node.span.offset);  // after a tag
      if (bracket != std::string::npos) end = end_of_flow(source_.bytes, bracket);
    } else {
      if (!node.items.empty()) end = std::max(end, node.items.back().span.end());
      if (!node.entries.empty()) {
        end = std::max({end, node.entries.back().value.span.end(), node.entries.back().key.span.end()});
      }
    }
    node.span.length = end - node.span.offset;
    if (has_anchors_) copies_.merge(node);
    add(std::move(node), anchor);
  }

  void add(Node node, YAML::anchor_t anchor = 0) {
    if (anchor != 0) copies_.keep(anchor, node);
    if (stack_.empty()) {
      root_ = std::move(node);
      return;
    }
    Open& parent = stack_.back();
    if (std::max(parent.node.entries.size(), parent.node.items.size()) == kLongestList) throw too_long(node.span.offset);
    if (parent.node.is_sequence()) {
      parent.node.items.push_back(std::move(node));
    } else if (!parent.has_key) {
      refuse_odd_key(node, parent.node.flow);
      parent.key = std::move(node);
      parent.has_key = true;
    } else {
      // A missing value is reported at the next token: its place is after the key's colon.
      if (node.kind == NodeKind::kNull) node.span = {std::min(parent.key.span.end() + 1, source_.bytes.size()), 0};
      parent.node.entries.push_back({std::move(parent.key), std::move(node)});
      parent.has_key = false;
    }
  }

  /// A key is a name. yaml-cpp also takes lists for keys, no key at all, and, on the last line of a file, a name without a
  /// colon.
  void refuse_odd_key(const Node& key, bool flow) const {
    if (key.copied) throw alias_at(key.span.offset);
    if (!key.is_scalar()) throw Refusal{{Code::kYamlKeyIsNoName}, key.span.offset};
    if (flow || key.span.length == 0) return;
    const std::size_t next = source_.bytes.find_first_not_of(" \t", key.span.end());
    if (next != std::string::npos && source_.bytes[next] == ':') return;
    throw Refusal{{Code::kYamlKeyWithoutColon}, key.span.offset};
  }

  const Source& source_;
  const SpacedText& spaced_;
  std::size_t skipped_;
  bool has_anchors_;  ///< OpenCV's YAML has none.
  YamlCopies copies_;
  std::size_t document_start_ = 0;
  std::vector<Open> stack_;
  Node root_;
  bool has_content_ = false;
};

/// The last key up to `offset` that has its value right after the colon: OpenCV's reader takes it, to YAML it is one word.
/// Where it stands in a line that is valid all the same (a list of such words) nobody asks.
std::optional<Refusal> blank_missing(const Source& source, std::size_t offset) {
  static const std::regex kUnspaced(R"(^[ ]*(?:- +)?[A-Za-z_][A-Za-z0-9_.]*:(?=[^\s:/]|/[^/]))");
  std::optional<Refusal> last;
  for (std::size_t at = 0; at <= offset && at < source.bytes.size();) {
    const Span line = source.line_at(at);
    std::cmatch match;
    constexpr std::size_t kLongestKey = 200;  // std::regex recurses with every character
    const std::string_view text = source.text(line).substr(0, kLongestKey);
    if (std::regex_search(text.data(), text.data() + text.size(), match, kUnspaced)) {
      last = {{Code::kYamlBlankMissing}, line.offset + static_cast<std::size_t>(match.length())};
    }
    const std::size_t end = source.bytes.find('\n', line.offset);
    if (end == std::string::npos) break;
    at = end + 1;
  }
  return last;
}

/// Is it about what the end of the file cuts off?
bool is_about_end(const Refusal& refusal, const Source& source) {
  const std::string_view rest = std::string_view(source.bytes).substr(std::min(refusal.offset, source.bytes.size()));
  switch (refusal.message.code) {
    case Code::kYamlKeyWithoutColon:
      // Several words lack a colon.
      return rest.find_first_of(" \n") == std::string_view::npos;
    case Code::kYamlQuoteOpen:
      return rest.find('\n') == std::string_view::npos;
    case Code::kYamlSyntax: {
      if (rest.find_first_not_of(" \t\r\n-") != std::string_view::npos) return false;
      if (refusal.message.arguments.front() != Argument(YAML::ErrorMsg::EOF_IN_SCALAR)) return true;
      // The parser is at the end whichever quote is open: one of the last line?
      const std::string_view line = source.text(source.line_at(source.bytes.size()));
      return (std::ranges::count(line, '"') + std::ranges::count(line, '\'')) % 2 != 0;
    }
    default:
      return false;
  }
}

/// What is behind an error of structure: a blank that is missing before it, or an end that comes too early.
Refusal explained(const Refusal& refusal, const Source& source) {
  constexpr std::array kOfStructure = {Code::kYamlSyntax, Code::kYamlKeyIsNoName, Code::kYamlDocuments, Code::kYamlMessages};
  if (!same_id(refusal.message.code, kOfStructure)) return refusal;
  const std::optional<Refusal> blank = blank_missing(source, refusal.offset);
  if (!is_about_end(refusal, source)) return blank.value_or(refusal);
  const bool is_of_last_line = blank && blank->offset >= source.line_at(source.bytes.size()).offset;
  return is_of_last_line ? *blank : Refusal{{Code::kYamlEndsEarly}, refusal.offset};
}

/// What often goes wrong, better than a parser says it.
Refusal describe(const YAML::ParserException& error, const Source& source, std::size_t offset) {
  const Span line = source.line_at(offset);
  const std::string_view text = source.text(line);
  const std::size_t content = text.find_first_not_of(" \t");
  const std::size_t tab = text.substr(0, content == std::string_view::npos ? text.size() : content).find('\t');
  if (tab != std::string_view::npos) return {{Code::kYamlTab}, line.offset + tab};
  if (error.msg.starts_with(YAML::ErrorMsg::UNKNOWN_ANCHOR)) return alias_at(offset);
  if (error.msg == YAML::ErrorMsg::MAP_VALUE) return {{Code::kYamlMapValue}, offset};
  return {{Code::kYamlSyntax, {error.msg}}, offset};
}

/// What a parameter file of ROS 2 holds, `/**: ros__parameters: {...}`, if it is of one node; else null.
Node* ros_parameters(Node& root) {
  if (root.entries.size() != 1) return nullptr;
  Node& node = root.entries.front().value;
  if (node.entries.size() != 1 || node.entries.front().key.value != "ros__parameters") return nullptr;
  Node& parameters = node.entries.front().value;
  return parameters.is_mapping() ? &parameters : nullptr;
}

/// A message as rostopic echo and ros2 topic echo print it.
bool is_message(const Node& root) {
  const auto has = [&root](std::string_view key) {
    return std::ranges::any_of(root.entries, [key](const Entry& each) { return each.key.value == key; });
  };
  return has("header") && (has("K") || has("k")) && (has("D") || has("d"));
}

}  // namespace

std::optional<Node> parse_yaml(const Source& source, Syntax syntax, Diagnostics& diagnostics) {
  const std::size_t skipped = source.byte_order_mark();
  // Bad bytes (Latin-1 in a comment) would shift yaml-cpp's offsets.
  const std::string clean = valid_utf8(std::string_view(source.bytes).substr(skipped));
  const SpacedText spaced = syntax == Syntax::kOpenCvYaml ? space_after_keys(clean) : SpacedText{clean, {}};
  try {
    if (const std::optional<Refusal> conflict = find_conflict_marker(source)) throw *conflict;
    std::istringstream stream(without_version(spaced.text));
    YAML::Parser parser(stream);
    const bool has_anchors = syntax == Syntax::kYaml;
    TreeBuilder builder(source, spaced, skipped, has_anchors);
    parser.HandleNextDocument(builder);
    TreeBuilder further(source, spaced, skipped, has_anchors);
    std::size_t last_start = builder.document_start();
    while (parser.HandleNextDocument(further)) {
      if (further.has_content()) {
        const Code code = is_message(builder.take_root()) ? Code::kYamlMessages : Code::kYamlDocuments;
        throw Refusal{{code}, further.take_root().span.offset};
      }
      // On a token that begins nothing yaml-cpp reports empty documents without end.
      if (further.document_start() <= last_start) throw Refusal{{Code::kYamlNothingBegins}, further.document_start()};
      last_start = further.document_start();
    }
    if (const std::optional<std::size_t> at = builder.copies().first()) report({{Code::kYamlCopies}, *at}, source, diagnostics);
    Node root = builder.take_root();
    Node* inner = syntax == Syntax::kYaml ? ros_parameters(root) : nullptr;
    if (inner == nullptr) return root;
    report({{Code::kYamlRosParameters}, root.span.offset}, source, diagnostics);
    return std::move(*inner);
  } catch (const Refusal& refusal) {
    report(explained(refusal, source), source, diagnostics);
  } catch (const YAML::ParserException& error) {
    const std::size_t in_text = error.mark.pos < 0 ? 0 : static_cast<std::size_t>(error.mark.pos);
    const std::size_t offset = std::min(skipped + spaced.original_offset(in_text), source.bytes.size());
    report(explained(describe(error, source, offset), source), source, diagnostics);
  } catch (const YAML::Exception& error) {
    diagnostics.add(Code::kYamlError, {error.msg}, source.range({}));
  }
  return std::nullopt;
}

}  // namespace fca::text
