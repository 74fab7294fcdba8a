// SPDX-License-Identifier: BSD-3-Clause
// Private: the programs that read with cv::FileStorage, as the module and its loader see them.
#pragma once

#include "programs.h"

namespace fca::consumers {

struct StoragePrograms {
  using Load = ConsumerView (*)(std::string_view bytes, const LoadOptions& options);
  Load kimera;
  Load kimera_imu;
  Load okvis;
  Load okvis2;
  Load okvis2_x;
  Load openvins;
  Load openvins_imu;
  Load orbslam3;
  Load orbslam2;
  Load slam_no_opt;
  Load urbste;
  Load opencv;
  Load vins;
};

/// What the module exports: a function without arguments that returns a pointer to its StoragePrograms.
inline constexpr const char* kStorageProgramsFunction = "fca_storage_programs";

}  // namespace fca::consumers
