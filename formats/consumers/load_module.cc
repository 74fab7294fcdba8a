// SPDX-License-Identifier: BSD-3-Clause
#include "fca/formats/consumers/load_module.h"
#include "fca/code.h"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>

namespace fca::consumers {

const void* load_module(const std::string& path, const char* function, const Message& what) {
  // From where the command lies, and from nowhere else: a run path is not asked under AddressSanitizer, and a dataset's folder
  // must not bring a module.
  std::error_code ignored;
  const std::filesystem::path command = std::filesystem::read_symlink("/proc/self/exe", ignored);
  const std::filesystem::path whole = command.parent_path() / path;
  // Lazily: OpenCV's libraries have ten thousands of symbols.
  void* module = whole.is_absolute() ? dlopen(whole.c_str(), RTLD_LAZY | RTLD_LOCAL) : nullptr;
  void* found = module != nullptr ? dlsym(module, function) : nullptr;
  if (found == nullptr) {
    const char* why = dlerror();
    throw MissingModule({Code::kModuleMissing, {what, why != nullptr ? std::string(why) : whole.string()}});
  }
  return reinterpret_cast<const void* (*)()>(found)();
}

}  // namespace fca::consumers
