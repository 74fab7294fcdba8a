// SPDX-License-Identifier: BSD-3-Clause
#include "storage.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

namespace fca::consumers::storage {
namespace {

constexpr std::size_t kMaxBytes = 2U << 20U;
constexpr int kMaxDepth = 64;
constexpr int kMaxOpenings = 512;
constexpr std::size_t kMaxIndent = 200;

/// YAML and JSON. Counts brackets without looking at quotes and comments: it may refuse a strange file, but it cannot be talked
/// out of it. JSON nests by brackets only, so there the "- " and ": " of a line say nothing.
bool is_nested_too_deep(std::string_view text, bool is_json) {
  int depth = 0;
  int openings = 0;
  std::size_t column = 0;
  bool at_indent = true;
  int indicators = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    column = c == '\n' ? 0 : column + 1;
    if (c == '\n') indicators = 0;
    at_indent = c == '\n' || (at_indent && c == ' ');
    if (at_indent && column > kMaxIndent && !is_json) return true;
    if (c == '[' || c == '{') {
      ++depth;
      ++openings;
    }
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if (!is_json && (c == '-' || c == ':') && i + 1 < text.size() && text[i + 1] == ' ') ++indicators;
    if (depth > kMaxDepth || openings > kMaxOpenings || indicators > kMaxDepth) return true;
  }
  return false;
}

/// XML. Elements in comments count, too, for the same reason; what is left open or opened in all is bounded.
bool has_too_many_elements(std::string_view text) {
  int depth = 0;
  int openings = 0;
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    if (text[i] != '<') continue;
    const char next = text[i + 1];
    if (next == '/') {
      if (depth > 0) --depth;
    } else if (next != '!' && next != '?') {
      ++depth;
      ++openings;
    }
    if (depth > kMaxDepth || openings > kMaxOpenings) return true;
  }
  return false;
}

/// The beginning of a text of the file, on one line.
std::string shown(const std::string& text) {
  std::string result;
  for (const char c : text.substr(0, 80)) result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  return result;
}

/// Of a matrix that OpenCV is not asked to read.
struct MatrixFault : cv::Exception {
  explicit MatrixFault(Message clause)
      : cv::Exception(cv::Error::StsParseError, "", "read_matrix", __FILE__, __LINE__), message(std::move(clause)) {}
  Message message;
};

std::int64_t length_of(const cv::FileNode& matrix, const char* side) {
  constexpr int kMaxSide = 1 << 20;
  const cv::FileNode length = matrix[side];
  if (length.isInt() && static_cast<int>(length) >= 0 && static_cast<int>(length) <= kMaxSide) return static_cast<int>(length);
  throw MatrixFault({Code::kStorageNoCount, {side}});
}

/// The 3 of `dt: 3f`; OpenCV's own limit (CV_CN_MAX) is 512.
std::int64_t channels_of(const cv::FileNode& matrix) {
  const cv::FileNode type = matrix["dt"];
  const std::string word = type.isString() ? type.string() : std::string();
  int channels = 1;
  std::from_chars(word.data(), word.data() + word.size(), channels);
  return std::clamp(channels, 1, CV_CN_MAX);
}

}  // namespace

Code obstacle_of(std::string_view bytes) {
  if (bytes.empty()) return Code::kProgramFileEmpty;
  if (bytes.size() > kMaxBytes) return Code::kProgramFileTooLarge;
  if (bytes.find('\0') != std::string_view::npos) return Code::kStorageZeroByte;
  constexpr std::string_view kBlanksAndBom = " \t\r\n\xEF\xBB\xBF";
  const std::size_t first = bytes.find_first_not_of(kBlanksAndBom);
  const std::string_view head = first == std::string_view::npos ? std::string_view() : bytes.substr(first);
  if (head.starts_with("<")) return has_too_many_elements(bytes) ? Code::kStorageTooManyElements : Code::kNone;
  return is_nested_too_deep(bytes, head.starts_with("{")) ? Code::kStorageNestedTooDeep : Code::kNone;
}

ConsumerView read(std::string_view bytes, std::string_view program, const Argument& reader,
                  const std::function<void(const cv::FileStorage&, ConsumerView&)>& body) {
  ConsumerView view;
  Code obstacle = obstacle_of(bytes);
  // From memory it skips the mark, from a file its parsers meet it and throw (persistence_yml.cpp:824, OpenCV 4.6).
  if (obstacle == Code::kNone && bytes.starts_with("\xEF\xBB\xBF")) obstacle = Code::kStorageByteOrderMark;
  if (obstacle != Code::kNone) {
    view.refusals.emplace_back(obstacle, "");
    return view;
  }
  const auto refuse = [&view](Code code, std::vector<Argument> arguments) {
    view.refusals.emplace_back(code, "", std::move(arguments));
  };
  try {
    const cv::FileStorage storage(std::string(bytes), cv::FileStorage::READ | cv::FileStorage::MEMORY);
    if (storage.isOpened()) {
      body(storage, view);
    } else {
      refuse(Code::kStorageNoDocument, {});
    }
  } catch (const cv::Exception& error) {
    refuse(Code::kStorageNotTaken, {reader, fault_of(error)});
  } catch (const std::exception& error) {
    refuse(Code::kStorageProgramStops, {program, one_line(error.what())});
  }
  if (!view.loads()) {
    view.cameras.clear();
    view.poses.clear();
  }
  return view;
}

bool is_number(const cv::FileNode& node) { return node.isInt() || node.isReal(); }

Argument description_of(const cv::FileNode& node) {
  if (node.isInt()) return static_cast<int>(node);
  if (node.isReal()) return Message{Code::kValueReal, {node.real()}};
  if (node.isString()) return Message{Code::kValueString, {shown(node.string())}};
  if (node.isSeq()) return Message{Code::kValueList};
  return Message{node.isMap() ? Code::kValueMap : Code::kValueNothing};
}

cv::Mat read_matrix(const cv::FileNode& node) {
  const std::int64_t stated = length_of(node, "rows") * length_of(node, "cols") * channels_of(node);
  const auto given = static_cast<std::int64_t>(node["data"].size());
  if (stated > given) throw MatrixFault({Code::kStorageTooFewNumbers, {given, stated}});
  return node.mat();
}

Argument fault_of(const cv::Exception& error) {
  if (const auto* const fault = dynamic_cast<const MatrixFault*>(&error)) return fault->message;
  return one_line(error.err);
}

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (text.ends_with(' ')) text.pop_back();
  return text;
}

}  // namespace fca::consumers::storage
