// SPDX-License-Identifier: BSD-3-Clause
// The programs that read with cv::FileStorage, asked in a module that is loaded with the first question: half of the command's
// start was OpenCV's, and most commands ask none of them.
#include <dlfcn.h>

#include "fca/formats/consumers/missing_module.h"
#include "storage_programs.h"

namespace fca::consumers {
namespace {

/// Never unloaded: what it returned holds functions of it.
const StoragePrograms& load_module() {
  // Lazily: OpenCV's libraries have ten thousands of symbols. Found by the command's run path: beside it in the build tree, in
  // a folder of the libraries where it is installed.
  void* module = dlopen(FCA_STORAGE_MODULE, RTLD_LAZY | RTLD_LOCAL);
  void* function = module != nullptr ? dlsym(module, kStorageProgramsFunction) : nullptr;
  if (function == nullptr) {
    const char* why = dlerror();
    throw MissingModule("a part of the installation cannot be loaded, which asks the programs that use OpenCV's reader: " +
                        std::string(why != nullptr ? why : FCA_STORAGE_MODULE));
  }
  return *reinterpret_cast<const StoragePrograms* (*)()>(function)();
}

const StoragePrograms& programs() {
  static const StoragePrograms& loaded = load_module();
  return loaded;
}

}  // namespace

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

}  // namespace fca::consumers
