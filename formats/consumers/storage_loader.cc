// SPDX-License-Identifier: BSD-3-Clause
// The programs that read with cv::FileStorage, asked in a module that is loaded with the first question: half of the command's
// start was OpenCV's, and most commands ask none of them.
#include "fca/code.h"
#include "fca/formats/consumers/load_module.h"
#include "storage_programs.h"

namespace fca::consumers {
namespace {

const StoragePrograms& programs() {
  // What it returned holds functions of the module.
  static const auto* kLoaded = static_cast<const StoragePrograms*>(
      load_module(FCA_STORAGE_MODULE, kStorageProgramsFunction, Message{Code::kModuleOfPrograms}));
  return *kLoaded;
}

}  // namespace

void prepare_storage_programs() {
  try {
    static_cast<void>(programs());
  } catch (const MissingModule&) {
    // Whoever asks a program is told.
  }
}

ConsumerView load_kimera(std::string_view bytes, const LoadOptions& options) { return programs().kimera(bytes, options); }
ConsumerView load_kimera_imu(std::string_view bytes, const LoadOptions& options) {
  return programs().kimera_imu(bytes, options);
}
ConsumerView load_okvis(std::string_view bytes, const LoadOptions& options) { return programs().okvis(bytes, options); }
ConsumerView load_okvis2(std::string_view bytes, const LoadOptions& options) { return programs().okvis2(bytes, options); }
ConsumerView load_okvis2_x(std::string_view bytes, const LoadOptions& options) { return programs().okvis2_x(bytes, options); }
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
