// SPDX-License-Identifier: BSD-3-Clause
#include "spool.h"

#include "toolkit/save/unnamed_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>

namespace fca::cli {

namespace {

constexpr std::uint64_t kInMemory = 64U << 10U;  // a few conversions need no file
constexpr std::uint64_t kBlock = 64U << 10U;     // given back to the disk at once; whole blocks of any file system

std::string temporary_folder() {
  std::error_code error;  // then there is none
  return std::filesystem::temp_directory_path(error).string();
}

}  // namespace

Spool::Piece Spool::put(std::string_view bytes) {
  const std::scoped_lock lock(mutex_);
  if (bytes.empty()) return {};
  if (bytes.size() > std::numeric_limits<std::uint32_t>::max()) throw std::length_error("a piece of more than 4 GB");
  const Piece piece = {size_, static_cast<std::uint32_t>(bytes.size())};
  size_ += bytes.size();
  if (size_ <= kInMemory || !write(piece.offset, bytes)) {
    in_memory_.emplace(piece.offset, bytes);
    return piece;
  }
  on_disk_ += bytes.size();
  for (std::uint64_t at = piece.offset; at < size_;) {
    const std::uint64_t end = std::min(size_, (at / kBlock + 1) * kBlock);
    bytes_left_[at / kBlock] += end - at;
    at = end;
  }
  return piece;
}

std::string Spool::look(const Piece& piece) const {
  const std::scoped_lock lock(mutex_);
  return read(piece);
}

std::string Spool::take(const Piece& piece) {
  const std::scoped_lock lock(mutex_);
  std::string bytes = read(piece);
  if (in_memory_.erase(piece.offset) == 0) free(piece);
  return bytes;
}

std::string Spool::read(const Piece& piece) const {
  if (piece.size == 0) return {};
  if (const auto kept = in_memory_.find(piece.offset); kept != in_memory_.end()) return kept->second;
  std::string bytes(piece.size, '\0');
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t got = ::pread(file_.get(), bytes.data() + done, bytes.size() - done, static_cast<off_t>(piece.offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) throw SpoolFailure(got < 0 ? std::strerror(errno) : "the file is shorter than it was");
    done += static_cast<std::size_t>(got);
  }
  return bytes;
}

bool Spool::has_room_for(std::size_t bytes) const {
  struct statvfs disk {};
  return ::fstatvfs(file_.get(), &disk) == 0 && disk.f_bavail * disk.f_frsize >= 2 * bytes + on_disk_;
}

bool Spool::write(std::uint64_t offset, std::string_view bytes) {
  if (!is_opened_) {
    is_opened_ = true;
    file_ = unnamed_file_in(folder_);
    if (const std::string other = temporary_folder(); file_.get() < 0 && !other.empty()) file_ = unnamed_file_in(other);
  }
  if (file_.get() < 0 || !has_room_for(bytes.size())) return false;
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(file_.get(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
    offset += static_cast<std::uint64_t>(written);
  }
  return true;
}

/// A file system that does not know holes keeps the room until the end.
void Spool::free(const Piece& piece) {
  on_disk_ -= piece.size;
  const std::uint64_t end = piece.offset + piece.size;
  for (std::uint64_t at = piece.offset; at < end;) {
    const auto block = bytes_left_.find(at / kBlock);
    const std::uint64_t next = std::min(end, (at / kBlock + 1) * kBlock);
    block->second -= next - at;
    at = next;
    const std::uint64_t start = block->first * kBlock;
    if (block->second > 0 || start + kBlock > size_) continue;
    static_cast<void>(::fallocate(file_.get(), FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, static_cast<off_t>(start),
                                  static_cast<off_t>(kBlock)));
    bytes_left_.erase(block);
  }
}

}  // namespace fca::cli
