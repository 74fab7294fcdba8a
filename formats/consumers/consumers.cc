// SPDX-License-Identifier: BSD-3-Clause
// The table of consumers. A new one is a load function in programs.h and a row here.
#include <algorithm>
#include <array>

#include "fca/formats/consumers/consumer.h"
#include "programs.h"

namespace fca::consumers {
namespace {

constexpr double kDoublePrecisionPx = 1e-9;
constexpr double kFloatPrecisionPx = 2e-4;

constexpr Writing kForOpenVins = {.output = "camchain.yaml", .then = "fca-io check camchain.yaml --for openvins --fix --write"};
constexpr Writing kForOpenVinsImu = {.output = "imu.yaml", .then = "fca-io check imu.yaml --for openvins-imu --fix --write"};

constexpr std::array kConsumers{
    Consumer{"kalibr", "Kalibr", "kalibr", kDoublePrecisionPx, &load_kalibr, true, "tumvi"},
    Consumer{"kalibr-imu", "Kalibr (imu.yaml)", "kalibr", kDoublePrecisionPx, &load_kalibr_imu, false, "tumvi"},
    Consumer{"openvins", "OpenVINS", "kalibr", kFloatPrecisionPx, &load_openvins, true, {}, true, kForOpenVins},
    Consumer{"openvins-imu",
             "OpenVINS (kalibr_imu_chain.yaml)",
             "kalibr",
             kFloatPrecisionPx,
             &load_openvins_imu,
             false,
             {},
             true,
             kForOpenVinsImu},
    Consumer{"orbslam3", "ORB-SLAM3 V1.0", "orbslam3", kFloatPrecisionPx, &load_orbslam3},
    Consumer{"orbslam2", "ORB-SLAM2", "orbslam3", kFloatPrecisionPx, &load_orbslam2, true, {}, false, {.layout = "orbslam2"}},
    Consumer{"slam_no_opt",
             "ns15417/slam_no_opt",
             "orbslam3",
             kFloatPrecisionPx,
             &load_slam_no_opt,
             true,
             {},
             false,
             {.model = "eucm"}},
    Consumer{"urbste",
             "urbste/ORB_SLAM3 (feature/gopro_slam)",
             "orbslam3",
             kFloatPrecisionPx,
             &load_urbste,
             true,
             {},
             false,
             {.model = "ds"}},
    Consumer{"opencv", "OpenCV", "opencv", kDoublePrecisionPx, &load_opencv},
    Consumer{"ocamcalib", "OCamCalib's C functions (ocam_functions)", "ocamcalib", kDoublePrecisionPx, &load_ocamcalib},
    Consumer{"woodscape", "WoodScape's projection.py", "woodscape", kDoublePrecisionPx, &load_woodscape},
    Consumer{"woodscape-omnidet", "WoodScape's omnidet", "woodscape", kFloatPrecisionPx, &load_woodscape_omnidet},
    Consumer{"dso", "DSO (camera.txt)", "tumvi", kFloatPrecisionPx, &load_dso, true, {}, false, {.output = "camera.txt"}},
};

}  // namespace

std::span<const Consumer> all_consumers() { return kConsumers; }

const Consumer* find_consumer(std::string_view id) {
  const auto found = std::find_if(kConsumers.begin(), kConsumers.end(), [id](const Consumer& row) { return row.id == id; });
  return found == kConsumers.end() ? nullptr : &*found;
}

}  // namespace fca::consumers
