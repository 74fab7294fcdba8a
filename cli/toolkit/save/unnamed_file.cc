// SPDX-License-Identifier: BSD-3-Clause
#include "unnamed_file.h"

#include <cstdlib>
#include <filesystem>

#include <fcntl.h>

namespace fca {

Descriptor unnamed_file_in(const std::string& folder) {
  constexpr mode_t kMine = 0600;
  Descriptor file(::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, kMine));
  if (file.get() >= 0) return file;
  // Not every file system has files without names.
  constexpr const char* kDigits = "XXXXXX";  // mkostemp() replaces them
  std::string name = (std::filesystem::path(folder) / (std::string(kTemporaryFile) + kDigits)).string();
  file = Descriptor(::mkostemp(name.data(), O_CLOEXEC));
  if (file.get() >= 0) ::unlink(name.c_str());
  return file;
}

}  // namespace fca
