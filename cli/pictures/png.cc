// SPDX-License-Identifier: BSD-3-Clause
#include "png.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include <zlib.h>

namespace fca::cli {

namespace {

void put_number(std::string& file, std::size_t number) {
  for (const unsigned shift : {24U, 16U, 8U, 0U}) file += static_cast<char>(number >> shift & 0xFFU);
}

/// A chunk: length, type, data, and the checksum of the last two.
void put_chunk(std::string& file, std::string_view type, std::string_view data) {
  put_number(file, data.size());
  const std::size_t from = file.size();
  file += type;
  file += data;
  const std::string_view checked = std::string_view(file).substr(from);
  put_number(file, ::crc32_z(0, reinterpret_cast<const Bytef*>(checked.data()), checked.size()));
}

std::string header_of(const Picture& picture) {
  constexpr std::string_view kPaletteOf8Bits("\x08\x03\0\0\0", 5);  // depth, colour type, deflate, filters, not interlaced
  std::string header;
  put_number(header, static_cast<std::size_t>(picture.width));
  put_number(header, static_cast<std::size_t>(picture.height));
  return header.append(kPaletteOf8Bits);
}

/// Rows without a filter, which places in a palette gain nothing from.
std::string rows_of(const Picture& picture) {
  constexpr char kNoFilter = 0;
  const auto width = static_cast<std::size_t>(picture.width);
  std::string rows;
  rows.reserve((width + 1) * static_cast<std::size_t>(picture.height));
  for (auto row = picture.colours.begin(); row != picture.colours.end(); row += picture.width) {
    rows += kNoFilter;
    rows.append(row, row + picture.width);
  }
  return rows;
}

std::string compressed(std::string_view data) {
  constexpr int kLevel = 4;  // 6 makes a page hardly smaller in twice the time
  uLongf size = ::compressBound(data.size());
  std::string result(size, '\0');
  // Into a buffer of that size nothing fails.
  ::compress2(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(data.data()), data.size(), kLevel);
  result.resize(size);
  return result;
}

}  // namespace

std::string png(const Picture& picture) {
  std::string colours;
  std::string opacities;
  for (const auto& [red, green, blue, opacity] : picture.palette) {
    for (const std::uint8_t part : {red, green, blue}) colours += static_cast<char>(part);
    opacities += static_cast<char>(opacity);
  }
  std::string file("\x89PNG\r\n\x1a\n");
  put_chunk(file, "IHDR", header_of(picture));
  put_chunk(file, "PLTE", colours);
  if (std::ranges::any_of(opacities, [](char opacity) { return opacity != '\xFF'; })) put_chunk(file, "tRNS", opacities);
  put_chunk(file, "IDAT", compressed(rows_of(picture)));
  put_chunk(file, "IEND", "");
  return file;
}

}  // namespace fca::cli
