// SPDX-License-Identifier: BSD-3-Clause
#include "pyyaml.h"

#include "../yaml_directive.h"
#include "pyyaml_scalars.h"

#include "fca/code.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <sstream>

namespace fca::consumers::pyyaml {
namespace {

// yaml-cpp needs 0.14 s for half a megabyte of a flow list; the largest real calibration has 193 kB.
constexpr std::size_t kMaxBytes = 2U << 20U;
// Python's recursion limit stops PyYAML somewhat later; no calibration comes near.
constexpr int kMaxDepth = 64;

Message at_line(std::size_t line, Message clause) { return {Code::kPyYamlAtLine, {line, std::move(clause)}}; }

bool is_continuation_byte(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// Length of the well-formed UTF-8 character at the front, 0 if there is none. `code` is its code point.
std::size_t decode_utf8(std::string_view text, std::uint32_t& code) {
  const auto first = static_cast<unsigned char>(text.front());
  const std::size_t length = first < 0x80 ? 1 : first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
  if (length == 0 || length > text.size()) return 0;
  code = length == 1 ? first : first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if (!is_continuation_byte(text[i])) return 0;
    code = (code << 6U) | (static_cast<unsigned char>(text[i]) & 0x3FU);
  }
  constexpr std::array<std::uint32_t, 5> kSmallest = {0, 0, 0x80, 0x800, 0x10000};
  if (code < kSmallest.at(length) || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return 0;
  return length;
}

// PyYAML 6, yaml/reader.py, NON_PRINTABLE.
bool is_printable(std::uint32_t code) {
  return code == '\t' || code == '\n' || code == '\r' || (code >= 0x20 && code <= 0x7E) || code == 0x85 ||
         (code >= 0xA0 && code != 0xFFFE && code != 0xFFFF);
}

Message check_characters(std::string_view text) {
  std::size_t line = 1;
  while (!text.empty()) {
    std::uint32_t code = 0;
    const std::size_t length = decode_utf8(text, code);
    if (length == 0) return at_line(line, {Code::kPyYamlNotUtf8});
    if (!is_printable(code)) return at_line(line, {Code::kPyYamlControlCharacter});
    // yaml/scanner.py: '\0\r\n\x85\u2028\u2029'. The parser below knows none of these; what they would cut is not checked.
    if (code == 0x85 || code == 0x2028 || code == 0x2029) return at_line(line, {Code::kPyYamlLineEnd});
    if (code == '\n') ++line;
    text.remove_prefix(length);
  }
  return {};
}

// Conservative on purpose (brackets in comments count too): it protects the stack of the parser, it does not check the syntax.
Message check_nesting(std::string_view text) {
  int depth = 0;
  int dashes_in_line = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '[' || c == '{') ++depth;
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if (c == '\n') dashes_in_line = 0;
    if ((c == '-' || c == '?') && i + 1 < text.size() && text[i + 1] == ' ') ++dashes_in_line;
    if (depth > kMaxDepth || dashes_in_line > kMaxDepth) return {Code::kPyYamlNestedTooDeep};
  }
  return {};
}

bool is_blank_or_comment(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \r");
  return first == std::string_view::npos || line[first] == '#';
}

// PyYAML 6, yaml/scanner.py, scan_yaml_directive_value: a space, then 1.x.
Message check_directive(std::string_view line) {
  if (!line.starts_with("%YAML")) return {};  // other directives only warn
  std::string_view rest = line.substr(5);
  if (skip(rest, " ") == 0) {
    return {Code::kPyYamlOpenCvHeader, {line.substr(0, std::min<std::size_t>(line.find('\r'), 40))}};
  }
  const bool version_1 = rest.starts_with("1.");
  if (!version_1 || rest.size() < 3 || !is_digit(rest[2])) return {Code::kPyYamlVersion};
  return {};
}

Message check_header(std::string_view text) {
  constexpr std::string_view kBom = "\xEF\xBB\xBF";
  if (text.starts_with(kBom)) text.remove_prefix(kBom.size());
  bool has_directive = false;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (is_blank_or_comment(line)) continue;
    if (!line.starts_with('%'))
      return has_directive && !line.starts_with("---") ? Message{Code::kPyYamlDirectiveAlone} : Message{};
    has_directive = true;
    if (Message error = check_directive(line); error.is_said()) return error;
  }
  return has_directive ? Message{Code::kPyYamlDirectiveAlone} : Message{};
}

/// Follows quotes, comments and block scalars just far enough to tell a TAB that PyYAML refuses from one inside them.
class TabScanner {
 public:
  Message check(std::string_view text) {
    std::size_t number = 0;
    while (!text.empty()) {
      ++number;
      const std::size_t end = std::min(text.find('\n'), text.size());
      const std::string_view line = text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
      if (has_bad_tab(line)) return at_line(number, {Code::kPyYamlTab});
    }
    if (quote_ != 0) return {Code::kPyYamlOpenQuote};
    return {};
  }

 private:
  bool has_bad_tab(std::string_view line) {
    if (inside_block_scalar(line)) return false;
    bool token_start = true;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const char c = line[i];
      if (quote_ != 0) {
        if (quote_ == '"' && c == '\\') ++i;
        if (c == quote_) quote_ = 0;
        token_start = false;
        continue;
      }
      if (c == '#' && (i == 0 || line[i - 1] == ' ')) return false;
      if (c == '\t') return true;
      if (token_start && (c == '"' || c == '\'')) quote_ = c;
      token_start = c == ' ' ? token_start : is_indicator(line, i);
    }
    begin_block_scalar(line);
    return false;
  }

  static bool is_indicator(std::string_view line, std::size_t i) {
    const char c = line[i];
    if (c == '[' || c == '{' || c == ',') return true;
    return (c == ':' || c == '-' || c == '?') && (i + 1 == line.size() || line[i + 1] == ' ');
  }

  void begin_block_scalar(std::string_view line) {
    const std::size_t last = line.find_last_not_of(" \r");
    if (last == std::string_view::npos) return;
    std::string_view head = line.substr(0, last + 1);
    while (!head.empty() && (is_digit(head.back()) || head.back() == '+' || head.back() == '-')) head.remove_suffix(1);
    if (head.size() < 2 || (head.back() != '|' && head.back() != '>') || head[head.size() - 2] != ' ') return;
    block_indent_ = line.find_first_not_of(' ');
  }

  bool inside_block_scalar(std::string_view line) {
    if (!block_indent_) return false;
    const std::size_t first = line.find_first_not_of(" \r");
    if (first == std::string_view::npos || first > *block_indent_) return true;
    block_indent_.reset();
    return false;
  }

  char quote_ = 0;
  std::optional<std::size_t> block_indent_;
};

Message at_mark(const YAML::Mark& mark, Message clause) {
  return at_line(static_cast<std::size_t>(mark.line + 1), std::move(clause));
}

/// What PyYAML raises where yaml-cpp does not.
struct Refusal {
  Message message;
};

[[noreturn]] void refuse(const YAML::Mark& mark, Code code, std::vector<Argument> arguments = {}) {
  throw Refusal{at_mark(mark, {code, std::move(arguments)})};
}

/// Builds the values from yaml-cpp's events. Problems are thrown as a Refusal, which safe_load catches.
class Builder final : public YAML::EventHandler {
 public:
  explicit Builder(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      lines_.push_back(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  }

  [[nodiscard]] std::shared_ptr<Value> root() const { return root_; }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (root_) refuse(mark, Code::kPyYamlSecondDocument);
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const bool written =
        !source_at(mark).empty() && std::string_view("~nN").find(source_at(mark).front()) != std::string_view::npos;
    if (!written && !frames_.empty() && frames_.back().flow_list) refuse(mark, Code::kPyYamlEmptyPlace);
    add(mark, std::make_shared<Value>(), anchor);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end()) refuse(mark, Code::kPyYamlAliasOfItself);
    add(mark, found->second, 0);
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, const std::string& text) override {
    add(mark, std::make_shared<Value>(typed_scalar(mark, tag, text)), anchor);
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value style) override {
    if (!is_one_of(tag, {"?", "!", "", "tag:yaml.org,2002:seq"})) refuse_tag(mark, tag);
    push(mark, Kind::kList, anchor);
    frames_.back().flow_list = style == YAML::EmitterStyle::Flow;
  }
  void OnSequenceEnd() override { pop(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, YAML::EmitterStyle::value) override {
    if (!is_one_of(tag, {"?", "!", "", "tag:yaml.org,2002:map"})) refuse_tag(mark, tag);
    push(mark, Kind::kMap, anchor);
  }
  void OnMapEnd() override { pop(); }

 private:
  struct Frame {
    std::shared_ptr<Value> value;
    YAML::anchor_t anchor = 0;
    YAML::Mark mark;
    std::shared_ptr<Value> key;  // of a map, waiting for its value
    YAML::Mark key_mark;
    bool flow_list = false;
    std::vector<ValuePtr> merged;
  };

  [[noreturn]] static void refuse_tag(const YAML::Mark& mark, const std::string& tag) {
    refuse(mark, Code::kPyYamlUnknownTag, {tag});
  }

  static Value typed_scalar(const YAML::Mark& mark, const std::string& tag, const std::string& text) {
    if (tag == "?" || tag.empty()) return resolve_plain_scalar(text);
    Value value;
    value.kind = Kind::kString;
    value.text = text;
    if (tag == "!" || tag == "tag:yaml.org,2002:str") return value;
    if (tag == "tag:yaml.org,2002:float" || tag == "tag:yaml.org,2002:int") {
      value.kind = tag.ends_with("int") ? Kind::kInt : Kind::kFloat;
      if (!matches_int(text) && !(value.kind == Kind::kFloat && matches_float(text))) {
        refuse(mark, Code::kPyYamlTagOfOthers, {text});
      }
      value.number = parse_number(text, value.kind);
      return value;
    }
    refuse_tag(mark, tag);
  }

  void push(const YAML::Mark& mark, Kind kind, YAML::anchor_t anchor) {
    if (frames_.size() >= static_cast<std::size_t>(kMaxDepth)) refuse(mark, Code::kPyYamlNestedTooDeep);
    auto value = std::make_shared<Value>();
    value->kind = kind;
    Frame frame;
    frame.value = std::move(value);
    frame.anchor = anchor;
    frame.mark = mark;
    frames_.push_back(std::move(frame));
  }

  void pop() {
    Frame frame = std::move(frames_.back());
    frames_.pop_back();
    merge(frame);
    add(frame.mark, frame.value, frame.anchor);
  }

  void add(const YAML::Mark& mark, const std::shared_ptr<Value>& value, YAML::anchor_t anchor) {
    if (anchor != 0) anchors_[anchor] = value;
    if (frames_.empty()) {
      root_ = value;
      return;
    }
    Frame& frame = frames_.back();
    if (frame.value->kind == Kind::kList) {
      frame.value->items.push_back(value);
    } else if (!frame.key) {
      if (value->kind == Kind::kList || value->kind == Kind::kMap) refuse(mark, Code::kPyYamlKeyNoScalar);
      frame.key = value;
      frame.key_mark = mark;
    } else {
      check_colon(frame, *value);
      add_entry(frame, value);
    }
  }

  /// What the file says from a mark to the end of the line; empty if yaml-cpp's mark points elsewhere.
  [[nodiscard]] std::string_view source_at(const YAML::Mark& mark) const {
    const auto line = static_cast<std::size_t>(mark.line);
    const auto column = static_cast<std::size_t>(mark.column);
    return mark.line >= 0 && line < lines_.size() && mark.column >= 0 && column < lines_[line].size()
               ? lines_[line].substr(column)
               : std::string_view();
  }

  /// yaml-cpp takes a last line `key:2` or `key` for a key without a value; PyYAML misses the colon.
  void check_colon(const Frame& frame, const Value& value) const {
    std::string_view source = source_at(frame.key_mark);
    if (value.kind != Kind::kNull || !source.starts_with(frame.key->text)) return;
    source.remove_prefix(frame.key->text.size());
    skip(source, " ");
    if (source.empty() || source.front() == '\r' || source.front() == '#') {
      refuse(frame.key_mark, Code::kPyYamlNoColon, {frame.key->text.substr(0, 80)});
    }
  }

  static void add_entry(Frame& frame, const std::shared_ptr<Value>& value) {
    const std::shared_ptr<Value> key = std::move(frame.key);
    frame.key = nullptr;
    if (key->kind == Kind::kString && key->text == "<<") {
      frame.merged.push_back(value);
    } else {
      set_entry(*frame.value, key, value, true);
    }
  }

  static void set_entry(Value& map, const ValuePtr& key, const ValuePtr& value, bool replace) {
    for (auto& [old_key, old_value] : map.entries) {
      if (old_key->kind != key->kind || old_key->text != key->text) continue;
      if (replace) old_value = value;
      return;
    }
    map.entries.emplace_back(key, value);
  }

  static void merge(Frame& frame) {
    std::ranges::reverse(frame.merged);  // the last one counts
    for (const ValuePtr& source : frame.merged) {
      const std::vector<ValuePtr> maps = source->kind == Kind::kList ? source->items : std::vector<ValuePtr>{source};
      for (const ValuePtr& map : maps) {
        if (map->kind != Kind::kMap) refuse(frame.mark, Code::kPyYamlMergeOfNoMap);
        for (const auto& [key, value] : map->entries) set_entry(*frame.value, key, value, false);
      }
    }
  }

  std::vector<std::string_view> lines_;
  std::shared_ptr<Value> root_;
  std::vector<Frame> frames_;
  std::map<YAML::anchor_t, std::shared_ptr<Value>> anchors_;
};

Message check_text(std::string_view text) {
  if (text.size() > kMaxBytes) return {Code::kPyYamlTooLarge};
  for (const Message& error : {check_nesting(text), check_characters(text), check_header(text), TabScanner().check(text)}) {
    if (error.is_said()) return error;
  }
  return {};
}

}  // namespace

const Value* Value::find(std::string_view key) const {
  for (const auto& [name, value] : entries) {
    if (name->kind == Kind::kString && name->text == key) return value.get();
  }
  return nullptr;
}

Message describe(const Value& value) {
  constexpr std::size_t kShown = 80;
  switch (value.kind) {
    case Kind::kNull:
      break;
    case Kind::kBool:
      return {Code::kPyYamlScalar, {"bool", value.text}};
    case Kind::kInt:
      return {Code::kPyYamlScalar, {"int", value.text}};
    case Kind::kFloat:
      return {Code::kPyYamlScalar, {"float", value.text}};
    case Kind::kString:
      return {Code::kPyYamlString, {value.text.substr(0, kShown)}};
    case Kind::kList:
      return {Code::kPyYamlList, {value.items.size()}};
    case Kind::kMap:
      return {Code::kValueMap};
  }
  return {Code::kValueEmpty};
}

Loaded safe_load(std::string_view text) {
  Loaded loaded;
  loaded.error = check_text(text);
  if (loaded.error.is_said()) return loaded;
  try {
    std::istringstream stream(without_version(std::string(text)));
    YAML::Parser parser(stream);
    Builder builder(text);
    while (parser.HandleNextDocument(builder)) {
    }
    loaded.root = builder.root() ? builder.root() : std::make_shared<Value>();
  } catch (const Refusal& refusal) {
    loaded.error = refusal.message;
  } catch (const YAML::Exception& error) {
    loaded.error = at_mark(error.mark, {Code::kPyYamlInItsWords, {error.msg}});
  } catch (const std::exception& error) {
    loaded.error = {Code::kPyYamlInItsWords, {error.what()}};
  }
  return loaded;
}

}  // namespace fca::consumers::pyyaml
