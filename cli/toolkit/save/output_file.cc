// SPDX-License-Identifier: BSD-3-Clause
#include "output_file.h"

#include "parallel_for.h"
#include "unnamed_file.h"

#include <fca/code.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fca {

namespace {

namespace fs = std::filesystem;

/// Writes all bytes. After an error returns false and leaves the reason in errno.
bool write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// Returns a message with the path as its argument {0} and the text of errno as {1}.
Message failure(Code what, const std::string& path) { return {what, {path, std::strerror(errno)}}; }

/// Writes to an existing device or pipe, which cannot be replaced by a rename. Returns an error message or nullopt.
std::optional<Message> write_directly(const std::string& path, std::string_view bytes) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (file.get() < 0) return failure(Code::kCannotOpen, path);
  if (!write_all(file.get(), bytes) || !file.close()) return failure(Code::kCannotWrite, path);
  return std::nullopt;
}

// The folder in which Linux lists the open files of this process. Its entries can be linked to a name.
constexpr const char* kOwnOpenFiles = "/proc/self/fd";

std::uint64_t random_seed() {
  std::random_device device;
  return std::uint64_t{device()} << 32U | device();
}

/// Returns the path of a temporary file in the folder: kTemporaryFile and 16 random hexadecimal digits.
std::string temporary_name(const fs::path& folder) {
  thread_local std::mt19937_64 random(random_seed());  // one seed per thread: the device is slower than writing a file
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(random()));
  return (folder / (std::string(kTemporaryFile) + digits.data())).string();
}

/// The new content of one target path, before it replaces the old content. If the file system can do it, the content is in a
/// file without a name, which disappears if the program is killed. Otherwise it is in a temporary file next to the target. The
/// file is locked as long as its writer runs, so that remove_leftovers() does not remove it.
class StagedFile {
 public:
  StagedFile() = default;
  ~StagedFile() {
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
  }
  StagedFile(StagedFile&& other) noexcept
      : target_(std::move(other.target_)), temporary_(std::exchange(other.temporary_, {})), file_(std::move(other.file_)) {}
  StagedFile(const StagedFile&) = delete;
  StagedFile& operator=(const StagedFile&) = delete;
  StagedFile& operator=(StagedFile&&) = delete;

  /// Writes the bytes for the path `target`. `permissions`: of the existing file at the target; nullopt if there is none.
  /// Returns an error message or nullopt.
  [[nodiscard]] std::optional<Message> write(const std::string& target, std::string_view bytes,
                                             std::optional<mode_t> permissions) {
    target_ = target;
    const fs::path folder = folder_of_target();
    constexpr mode_t kOwnerOnly = 0600;  // until the file has the permissions of the existing one
    constexpr mode_t kNewFile = 0666;    // the system removes the bits of the process's umask
    const mode_t initial = permissions ? kOwnerOnly : kNewFile;
    if (::access(kOwnOpenFiles, X_OK) == 0)
      file_ = Descriptor(::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, initial));
    if (file_.get() < 0) {  // not every file system supports files without names; only /proc can give them a name
      const std::string name = temporary_name(folder);
      file_ = Descriptor(::open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, initial));
      if (file_.get() < 0) return failure(Code::kCannotCreateNextTo, target);
      temporary_ = name;
    }
    ::flock(file_.get(), LOCK_EX | LOCK_NB);
    if (write_all(file_.get(), bytes) && (!permissions || ::fchmod(file_.get(), *permissions) == 0)) return std::nullopt;
    return failure(Code::kCannotWrite, target);
  }

  /// Waits until the content is on the disk. False, with errno, after an error.
  [[nodiscard]] bool force_to_disk() const { return ::fsync(file_.get()) == 0; }

  /// Moves the file to its target. Without `overwrite`, fails if another program has created a file there meanwhile. Returns an
  /// error message or nullopt.
  [[nodiscard]] std::optional<Message> move_to_target(bool overwrite) {
    if (temporary_.empty()) {
      if (!overwrite) return give_name(target_) ? std::nullopt : std::optional(failure(Code::kCannotWrite, target_));
      const std::string name = temporary_name(folder_of_target());
      if (!give_name(name)) return failure(Code::kCannotWrite, target_);
      temporary_ = name;
    }
    const unsigned flags = overwrite ? 0 : RENAME_NOREPLACE;
    int result = ::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target_.c_str(), flags);
    // Some file systems do not support RENAME_NOREPLACE.
    if (result != 0 && errno == EINVAL) result = ::rename(temporary_.c_str(), target_.c_str());
    if (result != 0) return failure(Code::kCannotWrite, target_);
    temporary_.clear();
    return file_.close() ? std::nullopt : std::optional(failure(Code::kCannotWrite, target_));
  }

  [[nodiscard]] fs::path folder_of_target() const {
    const fs::path folder = fs::path(target_).parent_path();
    return folder.empty() ? fs::path(".") : folder;
  }

 private:
  /// Gives the file without a name this path. False, with errno, after an error.
  [[nodiscard]] bool give_name(const std::string& name) const {
    const std::string unnamed = kOwnOpenFiles + std::string("/") + std::to_string(file_.get());
    return ::linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
  }

  std::string target_;
  std::string temporary_;  ///< The path of the temporary file; empty if the file has no name or is at its target.
  Descriptor file_{-1};
};

/// Where the bytes for a path go, and what exists there.
struct Place {
  std::string target;  ///< The path after following symbolic links; for a device, the path itself.
  bool exists = false;
  bool is_device = false;                  ///< The existing file is a device or a pipe.
  std::optional<mode_t> permissions = {};  ///< Of the existing file; nullopt if there is none.
};

/// Fills `place` for the path. Returns an error message if the path cannot be written, or must not be (without `overwrite`, a
/// file exists there), otherwise nullopt.
std::optional<Message> find_place(const std::string& path, bool overwrite, Place& place) {
  struct stat status {};
  place.exists = ::stat(path.c_str(), &status) == 0;
  if (!place.exists && errno != ENOENT) return failure(Code::kCannotWrite, path);
  if (place.exists && S_ISDIR(status.st_mode)) return Message{Code::kIsFolder, {path}};
  place.is_device = place.exists && !S_ISREG(status.st_mode);
  if (place.exists && !place.is_device && !overwrite) return Message{Code::kFileExists, {path}};
  // A rename would need write permission for the folder only, but write protection is meant to keep the content of the file.
  const auto may_write = [&] { return (status.st_mode & 0222) != 0 && ::access(path.c_str(), W_OK) == 0; };
  if (place.exists && !place.is_device && !may_write()) return Message{Code::kFileProtected, {path}};
  if (place.exists) place.permissions = status.st_mode & 07777;
  place.target = path;
  // Follow a symbolic link, even if its target does not exist yet.
  std::error_code error;
  if (place.exists && !place.is_device) {
    place.target = fs::canonical(path, error).string();
  } else if (!place.exists && fs::is_symlink(fs::symlink_status(path, error))) {
    place.target = (fs::path(path).parent_path() / fs::read_symlink(path, error)).string();
  } else {
    error.clear();  // symlink_status() sets an error if nothing exists at the path
  }
  if (error) return Message{Code::kPathFails, {path, error.message()}};
  const fs::path folder = fs::path(place.target).parent_path();
  if (!place.exists && !folder.empty() && !fs::exists(folder, error))
    return Message{Code::kFolderMissing, {path, folder.string()}};
  return std::nullopt;
}

/// Files that are either all written or not at all, before they are moved to their targets.
struct StagedSet {
  std::vector<Place> places;       ///< One per output file.
  std::vector<StagedFile> files;   ///< One per output file that is no device. Empty after an error.
  std::optional<Message> problem;  ///< The first error; nullopt if there is none.
};

/// Writes the content of all files, except those of devices, without changing the targets.
StagedSet stage(std::span<const OutputFile> files, bool overwrite) {
  StagedSet set;
  for (const OutputFile& file : files) {
    set.problem = find_place(file.path, overwrite, set.places.emplace_back());
    if (set.problem) return set;
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    const Place& place = set.places[i];
    if (place.is_device) continue;
    set.problem = set.files.emplace_back().write(place.target, files[i].bytes, place.permissions);
    if (set.problem) break;
  }
  if (set.problem) set.files.clear();
  return set;
}

/// The folders of the targets.
std::set<fs::path> folders_of(std::span<const StagedSet> sets) {
  std::set<fs::path> folders;
  for (const StagedSet& set : sets) {
    for (const StagedFile& file : set.files) folders.insert(file.folder_of_target());
  }
  return folders;
}

/// Opens each folder and calls `action` with its descriptor. Stops and returns false at the first failure.
bool in_each_folder(const std::set<fs::path>& folders, int (*action)(int)) {
  return std::ranges::all_of(folders, [action](const fs::path& folder) {
    const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    return opened.get() >= 0 && action(opened.get()) == 0;
  });
}

/// Waits until the content of the files is on the disk, so that a name never refers to a file without content after a power
/// failure. Syncs a single file by itself, and several files by one sync of their file systems. After an error, sets the
/// problem of each set that has files.
void force_to_disk(std::vector<StagedSet>& sets) {
  std::size_t files = 0;
  const StagedFile* last = nullptr;
  for (const StagedSet& set : sets) {
    files += set.files.size();
    if (!set.files.empty()) last = &set.files.back();
  }
  if (files == 0 || (files == 1 ? last->force_to_disk() : in_each_folder(folders_of(sets), ::syncfs))) return;
  const Message problem = {Code::kCannotForceToDisk, {std::strerror(errno)}};
  for (StagedSet& set : sets) {
    if (!set.problem && !set.files.empty()) set.problem = problem;
  }
}

/// Moves the staged files to their targets, then writes to the devices. Returns the first error or nullopt.
std::optional<Message> move_to_targets(StagedSet& set, std::span<const OutputFile> files, bool overwrite) {
  for (StagedFile& file : set.files) {
    if (std::optional<Message> problem = file.move_to_target(overwrite)) return problem;
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (!set.places[i].is_device) continue;
    if (std::optional<Message> problem = write_directly(files[i].path, files[i].bytes)) return problem;
  }
  return std::nullopt;
}

}  // namespace

void remove_leftovers(const std::string& folder) {
  std::error_code error;
  for (fs::directory_iterator at(folder.empty() ? "." : folder, error); !error && at != fs::directory_iterator();
       at.increment(error)) {
    if (!at->path().filename().string().starts_with(kTemporaryFile)) continue;
    const Descriptor file(::open(at->path().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat status {};
    // The lock of a writer that still runs makes flock() fail.
    const bool is_abandoned = file.get() >= 0 && ::fstat(file.get(), &status) == 0 && S_ISREG(status.st_mode) &&
                              ::flock(file.get(), LOCK_EX | LOCK_NB) == 0;
    if (is_abandoned) ::unlink(at->path().c_str());
  }
}

std::vector<std::optional<Message>> write_sets(std::span<const std::span<const OutputFile>> sets, bool overwrite, bool sync,
                                               std::size_t jobs) {
  std::vector<StagedSet> staged(sets.size());
  parallel_for(sets.size(), jobs, [&](std::size_t i) { staged[i] = stage(sets[i], overwrite); });
  const std::set<fs::path> folders = folders_of(staged);
  if (sync) force_to_disk(staged);
  std::vector<std::optional<Message>> problems(sets.size());
  parallel_for(sets.size(), jobs, [&](std::size_t i) {
    StagedSet& set = staged[i];
    problems[i] = set.problem ? set.problem : move_to_targets(set, sets[i], overwrite);
    set.files.clear();
  });
  // Sync the new names. The result is ignored: if a file system cannot sync a folder, there is no other way to do it.
  if (sync) static_cast<void>(in_each_folder(folders, ::fsync));
  return problems;
}

std::optional<Message> write_files(std::span<const OutputFile> files, bool overwrite, bool sync) {
  return write_sets(std::span(&files, 1), overwrite, sync, 1).front();
}

}  // namespace fca
