// SPDX-License-Identifier: BSD-3-Clause
// The programs that read with cv::FileStorage, asked in a module that is loaded with the first question: half of the command's
// start was OpenCV's, and most commands ask none of them.
#include <dlfcn.h>

#include <filesystem>
#include <string>
#include <system_error>

#include "fca/formats/consumers/missing_module.h"
#include "storage_programs.h"

namespace fca::consumers {
namespace {

/// Never unloaded: what it returned holds functions of it.
const StoragePrograms& load_module() {
  // From where the command lies, and from nowhere else: a run path is not asked under AddressSanitizer, and a dataset's folder
  // must not bring a module.
  std::error_code ignored;
  const std::filesystem::path command = std::filesystem::read_symlink("/proc/self/exe", ignored);
  const std::filesystem::path path = command.parent_path() / FCA_STORAGE_MODULE;
  // Lazily: OpenCV's libraries have ten thousands of symbols.
  void* module = path.is_absolute() ? dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL) : nullptr;
  void* function = module != nullptr ? dlsym(module, kStorageProgramsFunction) : nullptr;
  if (function == nullptr) {
    const char* why = dlerror();
    throw MissingModule("a part of the installation cannot be loaded, which asks the programs that use OpenCV's reader: " +
                        (why != nullptr ? std::string(why) : path.string()));
  }
  return *reinterpret_cast<const StoragePrograms* (*)()>(function)();
}

const StoragePrograms& programs() {
  static const StoragePrograms& loaded = load_module();
  return loaded;
}

}  // namespace

void prepare_storage_programs() {
  try {
    static_cast<void>(programs());
  } catch (const MissingModule&) {
    // Whoever asks a program is told.
  }
}

ConsumerView load_openvins(std::string_view bytes, const LoadOptions& options) { return programs().openvins(bytes, options); }
ConsumerView load_openvins_imu(std::string_view bytes, const LoadOptions& options) {
  return programs().openvins_imu(bytes, options);
}
ConsumerView load_orbslam3(std::string_view bytes, const LoadOptions& options) { return programs().orbslam3(bytes, options); }
ConsumerView load_orbslam2(std::string_view bytes, const LoadOptions& options) { return programs().orbslam2(bytes, options); }
ConsumerView load_slam_no_opt(std::string_view bytes, const LoadOptions& options) {
  return programs().slam_no_opt(bytes, options);
}
ConsumerView load_urbste(std::string_view bytes, const LoadOptions& options) { return programs().urbste(bytes, options); }
ConsumerView load_opencv(std::string_view bytes, const LoadOptions& options) { return programs().opencv(bytes, options); }
ConsumerView load_vins(std::string_view bytes, const LoadOptions& options) { return programs().vins(bytes, options); }

}  // namespace fca::consumers
