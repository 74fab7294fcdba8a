// SPDX-License-Identifier: BSD-3-Clause
#include "npy.h"

#include <bit>

namespace fca::cli {

std::string npy(const ImageMap& map) {
  constexpr std::size_t kBefore = 10;  // magic, version, length of the header
  constexpr std::size_t kAlignment = 64;
  std::string header = std::string("{'descr': '") + (std::endian::native == std::endian::little ? "<" : ">") +
                       "f4', 'fortran_order': False, 'shape': (" + std::to_string(map.size.height) + ", " +
                       std::to_string(map.size.width) + ", 2), }";
  while ((kBefore + header.size() + 1) % kAlignment != 0) header += ' ';
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(header.size() % 256);
  bytes += static_cast<char>(header.size() / 256);
  bytes += header;
  bytes.append(reinterpret_cast<const char*>(map.uv.data()), map.uv.size() * sizeof(float));
  return bytes;
}

}  // namespace fca::cli
