// SPDX-License-Identifier: BSD-3-Clause
// The module's one door.
#include "storage_programs.h"

extern "C" __attribute__((visibility("default"))) const fca::consumers::StoragePrograms* fca_storage_programs() {
  using namespace fca::consumers;
  static constexpr StoragePrograms kPrograms = {.openvins = &load_openvins,
                                                .openvins_imu = &load_openvins_imu,
                                                .orbslam3 = &load_orbslam3,
                                                .orbslam2 = &load_orbslam2,
                                                .slam_no_opt = &load_slam_no_opt,
                                                .urbste = &load_urbste,
                                                .opencv = &load_opencv};
  return &kPrograms;
}
