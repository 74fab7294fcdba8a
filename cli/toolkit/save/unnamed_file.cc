// SPDX-License-Identifier: BSD-3-Clause
#include "unnamed_file.h"

#include <cstdlib>
#include <filesystem>

#include <fcntl.h>

namespace fca {

Descriptor unnamed_file_in(const std::string& folder) {
  constexpr mode_t kOwnerOnly = 0600;
  Descriptor file(::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, kOwnerOnly));
  if (file.get() >= 0) return file;
  // Not every file system supports files without names: create a named file and remove its name.
  constexpr const char* kDigits = "XXXXXX";  // mkostemp() replaces these letters
  std::string name = (std::filesystem::path(folder) / (std::string(kTemporaryFile) + kDigits)).string();
  file = Descriptor(::mkostemp(name.data(), O_CLOEXEC));
  if (file.get() >= 0) ::unlink(name.c_str());
  return file;
}

}  // namespace fca
