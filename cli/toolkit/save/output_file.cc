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

bool write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// A message with {0} the path and {1} the system's reason.
Message failure(Code what, const std::string& path) { return {what, {path, std::strerror(errno)}}; }

std::optional<Message> write_directly(const std::string& path, std::string_view bytes) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (file.get() < 0) return failure(Code::kCannotOpen, path);
  if (!write_all(file.get(), bytes) || !file.close()) return failure(Code::kCannotWrite, path);
  return std::nullopt;
}

constexpr const char* kOwnFiles = "/proc/self/fd";

std::uint64_t seed() {
  std::random_device device;
  return std::uint64_t{device()} << 32U | device();
}

/// A random name for a temporary file in that folder.
std::string temporary_name(const fs::path& folder) {
  thread_local std::mt19937_64 random(seed());  // the random device takes longer than writing a file
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(random()));
  return (folder / (std::string(kTemporaryFile) + digits.data())).string();
}

/// The new content of a path. It is written to a file without a name if possible (a killed program then leaves nothing),
/// otherwise to a temporary file next to the target. The file is locked as long as its writer runs.
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

  /// Writes the bytes. `mode`: the permissions of the existing file; nullopt: those of a new file.
  [[nodiscard]] std::optional<Message> write(const std::string& target, std::string_view bytes, std::optional<mode_t> mode) {
    target_ = target;
    const fs::path folder = folder_of_target();
    constexpr mode_t kMine = 0600;
    constexpr mode_t kNew = 0666;  // less the process's mask
    const mode_t first = mode ? kMine : kNew;
    if (::access(kOwnFiles, X_OK) == 0) file_ = Descriptor(::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, first));
    if (file_.get() < 0) {  // not every file system has files without names, and without /proc they cannot be linked
      const std::string name = temporary_name(folder);
      file_ = Descriptor(::open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, first));
      if (file_.get() < 0) return failure(Code::kCannotCreateNextTo, target);
      temporary_ = name;
    }
    ::flock(file_.get(), LOCK_EX | LOCK_NB);
    if (write_all(file_.get(), bytes) && (!mode || ::fchmod(file_.get(), *mode) == 0)) return std::nullopt;
    return failure(Code::kCannotWrite, target);
  }

  [[nodiscard]] bool force_to_disk() const { return ::fsync(file_.get()) == 0; }

  /// Moves the file to its path. Without `overwrite`, fails if a file has appeared there meanwhile.
  [[nodiscard]] std::optional<Message> put(bool overwrite) {
    if (temporary_.empty()) {
      if (!overwrite) return link(target_) ? std::nullopt : std::optional(failure(Code::kCannotWrite, target_));
      const std::string name = temporary_name(folder_of_target());
      if (!link(name)) return failure(Code::kCannotWrite, target_);
      temporary_ = name;
    }
    const unsigned flags = overwrite ? 0 : RENAME_NOREPLACE;
    int result = ::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target_.c_str(), flags);
    // Some file systems do not support that flag.
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
  [[nodiscard]] bool link(const std::string& name) const {
    const std::string unnamed = kOwnFiles + std::string("/") + std::to_string(file_.get());
    return ::linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
  }

  std::string target_;
  std::string temporary_;
  Descriptor file_{-1};
};

/// The target of a path, and what exists there.
struct Place {
  std::string target;
  bool exists = false;
  bool device = false;
  std::optional<mode_t> mode = {};  ///< Permissions of the existing file.
};

std::optional<Message> find_place(const std::string& path, bool overwrite, Place& place) {
  struct stat status {};
  place.exists = ::stat(path.c_str(), &status) == 0;
  if (!place.exists && errno != ENOENT) return failure(Code::kCannotWrite, path);
  if (place.exists && S_ISDIR(status.st_mode)) return Message{Code::kIsFolder, {path}};
  place.device = place.exists && !S_ISREG(status.st_mode);
  if (place.exists && !place.device && !overwrite) return Message{Code::kFileExists, {path}};
  // A rename needs write permission for the folder only. A user who write-protects a file means its content.
  const auto may_write = [&] { return (status.st_mode & 0222) != 0 && ::access(path.c_str(), W_OK) == 0; };
  if (place.exists && !place.device && !may_write()) return Message{Code::kFileProtected, {path}};
  if (place.exists) place.mode = status.st_mode & 07777;
  place.target = path;
  // A symbolic link is followed, even if its target does not exist yet.
  std::error_code error;
  if (place.exists && !place.device) {
    place.target = fs::canonical(path, error).string();
  } else if (!place.exists && fs::is_symlink(fs::symlink_status(path, error))) {
    place.target = (fs::path(path).parent_path() / fs::read_symlink(path, error)).string();
  } else {
    error.clear();  // symlink_status of what does not exist
  }
  if (error) return Message{Code::kPathFails, {path, error.message()}};
  const fs::path folder = fs::path(place.target).parent_path();
  if (!place.exists && !folder.empty() && !fs::exists(folder, error))
    return Message{Code::kFolderMissing, {path, folder.string()}};
  return std::nullopt;
}

/// A set of files that are all written or not at all.
struct StagedSet {
  std::vector<Place> places;
  std::vector<StagedFile> files;
  std::optional<Message> problem;
};

StagedSet stage(std::span<const OutputFile> files, bool overwrite) {
  StagedSet set;
  for (const OutputFile& file : files) {
    set.problem = find_place(file.path, overwrite, set.places.emplace_back());
    if (set.problem) return set;
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    const Place& place = set.places[i];
    if (place.device) continue;
    set.problem = set.files.emplace_back().write(place.target, files[i].bytes, place.mode);
    if (set.problem) break;
  }
  if (set.problem) set.files.clear();
  return set;
}

std::set<fs::path> folders_of(std::span<const StagedSet> sets) {
  std::set<fs::path> folders;
  for (const StagedSet& set : sets) {
    for (const StagedFile& file : set.files) folders.insert(file.folder_of_target());
  }
  return folders;
}

/// Opens each folder and calls `action` on its descriptor; false if one fails.
bool in_each_folder(const std::set<fs::path>& folders, int (*action)(int)) {
  return std::ranges::all_of(folders, [action](const fs::path& folder) {
    const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    return opened.get() >= 0 && action(opened.get()) == 0;
  });
}

/// Makes the files' bytes reach the disk before their names do. A single file is synced by itself; for several, their file
/// systems are synced once.
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

std::optional<Message> put_into_place(StagedSet& set, std::span<const OutputFile> files, bool overwrite) {
  for (StagedFile& file : set.files) {
    if (std::optional<Message> problem = file.put(overwrite)) return problem;
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (!set.places[i].device) continue;
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
    const bool dead = file.get() >= 0 && ::fstat(file.get(), &status) == 0 && S_ISREG(status.st_mode) &&
                      ::flock(file.get(), LOCK_EX | LOCK_NB) == 0;
    if (dead) ::unlink(at->path().c_str());
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
    problems[i] = set.problem ? set.problem : put_into_place(set, sets[i], overwrite);
    set.files.clear();
  });
  // Syncs the new names. If a file system cannot sync a folder, there is no other way, so that the result is ignored.
  if (sync) static_cast<void>(in_each_folder(folders, ::fsync));
  return problems;
}

std::optional<Message> write_files(std::span<const OutputFile> files, bool overwrite, bool sync) {
  return write_sets(std::span(&files, 1), overwrite, sync, 1).front();
}

}  // namespace fca
