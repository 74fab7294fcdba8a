// SPDX-License-Identifier: BSD-3-Clause
#include "output_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fca::cli {

namespace {

namespace fs = std::filesystem;

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int get() const { return fd_; }
  /// Errors of a delayed write appear here.
  [[nodiscard]] bool close() {
    const int fd = fd_;
    fd_ = -1;
    return ::close(fd) == 0;
  }

 private:
  int fd_;
};

bool write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

std::string failure(const std::string& what, const std::string& path) {
  return what + " " + path + ": " + std::strerror(errno);
}

std::optional<std::string> write_directly(const std::string& path, std::string_view bytes) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (file.get() < 0) return failure("cannot open", path);
  if (!write_all(file.get(), bytes) || !file.close()) return failure("cannot write", path);
  return std::nullopt;
}

std::optional<std::string> replace(const std::string& path, std::string_view bytes, mode_t mode, bool sync) {
  std::string pattern = (fs::path(path).parent_path() / (".fca-io-XXXXXX")).string();
  if (!fs::path(path).has_parent_path()) pattern = ".fca-io-XXXXXX";
  std::vector<char> name(pattern.begin(), pattern.end());
  name.push_back('\0');
  Descriptor file(::mkostemp(name.data(), O_CLOEXEC));
  if (file.get() < 0) return failure("cannot create a file beside", path);
  const bool good = write_all(file.get(), bytes) && ::fchmod(file.get(), mode) == 0 && (!sync || ::fsync(file.get()) == 0) &&
                    file.close() && ::rename(name.data(), path.c_str()) == 0;
  if (good) return std::nullopt;
  std::string message = failure("cannot write", path);
  ::unlink(name.data());
  return message;
}

}  // namespace

std::optional<std::string> write_file(const std::string& path, std::string_view bytes, bool overwrite, bool sync) {
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) return failure("cannot write", path);
  if (exists && S_ISDIR(status.st_mode)) return path + " is a directory";
  if (exists && !S_ISREG(status.st_mode)) return write_directly(path, bytes);
  if (exists && !overwrite) return path + " exists; --force overwrites it";
  const mode_t mask = ::umask(0);
  ::umask(mask);
  std::error_code error;
  // Written through a symbolic link, also one whose target is yet to come.
  fs::path target = exists ? fs::canonical(path, error) : fs::path(path);
  if (!exists && fs::is_symlink(path)) target = fs::path(path).parent_path() / fs::read_symlink(path, error);
  if (error) return path + ": " + error.message();
  return replace(target.string(), bytes, exists ? status.st_mode & 07777 : 0666 & ~mask, sync);
}

}  // namespace fca::cli
