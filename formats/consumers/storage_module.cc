// SPDX-License-Identifier: BSD-3-Clause
// The module's one door.
#include "storage_programs.h"

#include <module_build.h>

extern "C" __attribute__((visibility("default"))) const char* fca_module_build() { return fca::kModuleBuild; }

extern "C" __attribute__((visibility("default"))) const void* fca_storage_programs() {
  namespace consumers = fca::consumers;
  static constexpr consumers::StoragePrograms kPrograms = {.kimera = &consumers::load_kimera,
                                                           .kimera_imu = &consumers::load_kimera_imu,

                                                           .okvis = &consumers::load_okvis,
                                                           .okvis2 = &consumers::load_okvis2,
                                                           .okvis2_x = &consumers::load_okvis2_x,
                                                           .openvins = &consumers::load_openvins,
                                                           .openvins_imu = &consumers::load_openvins_imu,
                                                           .orbslam3 = &consumers::load_orbslam3,
                                                           .orbslam2 = &consumers::load_orbslam2,
                                                           .slam_no_opt = &consumers::load_slam_no_opt,
                                                           .urbste = &consumers::load_urbste,
                                                           .opencv = &consumers::load_opencv,
                                                           .vins = &consumers::load_vins};
  return &kPrograms;
}
