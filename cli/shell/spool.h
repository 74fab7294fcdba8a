// SPDX-License-Identifier: BSD-3-Clause
// What is needed later and would be too much for memory, until then in a file.
#pragma once

#include "toolkit/save/descriptor.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>

namespace fca::cli {

/// What was spooled cannot be read again: the disk is broken, or gone.
class SpoolFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Pieces of bytes, each to be taken back once. The first few stay in memory; the others lie in a file without a name, of which
/// nothing is left when the program ends, however it does. It takes no more than half of the room on its disk, since what is
/// made of the pieces may go there, too: the rest stays in memory. May be used from several threads.
class Spool {
 public:
  /// Where a piece lies.
  struct Piece {
    std::uint64_t offset = 0;
    std::uint32_t size = 0;
  };

  /// `folder`: where the file is to be; where it cannot be there, it is where temporary files are.
  explicit Spool(std::string folder) : folder_(std::move(folder)) {}

  [[nodiscard]] Piece put(std::string_view bytes);
  /// The bytes, which stay. Throws SpoolFailure.
  [[nodiscard]] std::string look(const Piece& piece) const;
  /// The bytes, which are then gone: their room is given back. Throws SpoolFailure.
  [[nodiscard]] std::string take(const Piece& piece);

 private:
  [[nodiscard]] std::string read(const Piece& piece) const;
  [[nodiscard]] bool has_room_for(std::size_t bytes) const;
  [[nodiscard]] bool write(std::uint64_t offset, std::string_view bytes);
  void free(const Piece& piece);

  std::string folder_;
  mutable std::mutex mutex_;
  bool is_opened_ = false;
  Descriptor file_{-1};
  std::uint64_t size_ = 0;                             ///< Of all pieces that there ever were.
  std::uint64_t on_disk_ = 0;                          ///< Of those that are in the file.
  std::map<std::uint64_t, std::string> in_memory_;     ///< By the offset.
  std::map<std::uint64_t, std::uint64_t> bytes_left_;  ///< Of each block of the file: what is yet to be taken.
};

}  // namespace fca::cli
