// SPDX-License-Identifier: BSD-3-Clause
#include "fca/formats/consumers/load_module.h"
#include "fca/code.h"

#include <dlfcn.h>
#include <module_build.h>

#include <filesystem>
#include <string_view>
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
  // What it offers has the layout of the headers that it was compiled with.
  void* const build = module != nullptr ? dlsym(module, "fca_module_build") : nullptr;
  if (build != nullptr && std::string_view(reinterpret_cast<const char* (*)()>(build)()) != kModuleBuild)
    throw MissingModule({Code::kModuleMissing, {what, Message{Code::kModuleOfAnotherBuild, {whole.string()}}}});
  void* found = build != nullptr ? dlsym(module, function) : nullptr;
  if (found == nullptr) {
    const char* why = dlerror();
    throw MissingModule({Code::kModuleMissing, {what, why != nullptr ? std::string(why) : whole.string()}});
  }
  return reinterpret_cast<const void* (*)()>(found)();
}

}  // namespace fca::consumers
