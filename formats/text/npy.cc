// SPDX-License-Identifier: BSD-3-Clause
#include "npy.h"

#include "refusal.h"

#include <fca/code.h>
#include <fca/formats/text/limits.h>
#include <fca/formats/text/numbers.h>

#include <bit>
#include <charconv>
#include <cstdint>
#include <utility>

namespace fca::text {

namespace {

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::size_t kVersionAt = 6;
constexpr std::size_t kLengthAt = 8;

std::uint64_t little_endian(std::string_view bytes) {
  std::uint64_t number = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) number = (number << 8U) | static_cast<unsigned char>(bytes[i]);
  return number;
}

/// What the header, a dictionary of Python's, says.
struct Header {
  std::size_t size = 0;  ///< Of an element, in bytes: 4 or 8.
  std::size_t rows = 0;
  std::size_t columns = 0;
};

/// What stands after a key, without blanks; empty where the key is not there.
std::string_view behind(std::string_view header, std::string_view key) {
  const std::size_t at = header.find(key);
  if (at == std::string_view::npos) return {};
  const std::size_t value = header.find_first_not_of(" :", at + key.size());
  return value == std::string_view::npos ? std::string_view() : header.substr(value);
}

std::optional<std::size_t> count_at(std::string_view& text) {
  std::size_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  text.remove_prefix(std::min(text.find_first_not_of(" ,"), text.size()));
  return count;
}

/// Nothing where the array is not one of rows of floating-point numbers.
std::optional<Header> parse_header(std::string_view text) {
  Header header;
  const std::string_view type = behind(text, "'descr'");
  if (type.starts_with("'<f8'")) header.size = sizeof(double);
  if (type.starts_with("'<f4'")) header.size = sizeof(float);
  std::string_view shape = behind(text, "'shape'");
  if (header.size == 0 || !behind(text, "'fortran_order'").starts_with("False") || !shape.starts_with('(')) return std::nullopt;
  shape.remove_prefix(1);
  const std::optional<std::size_t> rows = count_at(shape);
  const std::optional<std::size_t> columns = rows ? count_at(shape) : std::nullopt;
  if (!columns || !shape.starts_with(')')) return std::nullopt;
  header.rows = *rows;
  header.columns = *columns;
  return header;
}

std::string number_at(std::string_view bytes) {
  if (bytes.size() == sizeof(double)) return format_real(std::bit_cast<double>(little_endian(bytes)));
  return format_real(std::bit_cast<float>(static_cast<std::uint32_t>(little_endian(bytes))));
}

}  // namespace

bool begins_as_npy(std::string_view bytes) { return bytes.starts_with(kMagic); }

std::optional<Node> parse_npy(const Source& source, Diagnostics& diagnostics) {
  const std::string_view bytes = source.bytes;
  const auto refuse = [&](Code code, std::vector<Argument> arguments = {}) {
    diagnostics.add(code, std::move(arguments), source.range({0, std::min(kMagic.size(), bytes.size())}));
    return std::nullopt;
  };
  const std::size_t of_length = bytes.size() > kVersionAt && bytes[kVersionAt] == '\1' ? 2 : 4;
  if (bytes.size() < kLengthAt + of_length) return refuse(Code::kNpyTruncated);
  const std::size_t begin = kLengthAt + of_length;
  const std::uint64_t length = little_endian(bytes.substr(kLengthAt, of_length));
  if (length > bytes.size() - begin) return refuse(Code::kNpyTruncated);
  const std::optional<Header> header = parse_header(bytes.substr(begin, length));
  if (!header) return refuse(Code::kNpyOtherArray);
  std::size_t at = begin + length;
  const std::size_t elements = (bytes.size() - at) / header->size;
  if (header->columns == 0 || header->rows > elements / header->columns) return refuse(Code::kNpyTruncated);
  if (elements != header->rows * header->columns) return refuse(Code::kNpyLonger);
  if (header->rows > kLongestList || header->columns > kLongestList) return refuse(Code::kNpyOtherArray);

  Node root;
  root.kind = NodeKind::kSequence;
  root.tag = kNpyTag;
  root.span = {0, bytes.size()};
  root.items.reserve(header->rows);
  for (std::size_t i = 0; i < header->rows; ++i) {
    Node& row = root.items.emplace_back();
    row.kind = NodeKind::kSequence;
    row.span = {at, header->columns * header->size};
    row.items.reserve(header->columns);
    for (std::size_t j = 0; j < header->columns; ++j, at += header->size) {
      Node& number = row.items.emplace_back();
      number.kind = NodeKind::kScalar;
      number.span = {at, header->size};
      number.value = number_at(bytes.substr(at, header->size));
    }
  }
  return root;
}

}  // namespace fca::text
