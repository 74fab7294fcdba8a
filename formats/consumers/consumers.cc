// SPDX-License-Identifier: BSD-3-Clause
// The table of consumers. A new one is a load function in programs.h and a row here.
#include <algorithm>
#include <array>

#include "classic_locale.h"
#include "fca/formats/consumers/consumer.h"
#include "programs.h"

namespace fca::consumers {
namespace {

/// Programs run in the locale that every C program begins in: what the one around fca-io has set (decimal commas) is not
/// theirs.
template <ConsumerView (*kLoad)(std::string_view, const LoadOptions&)>
ConsumerView in_own_locale(std::string_view bytes, const LoadOptions& options) {
  const ClassicLocale locale;
  return kLoad(bytes, options);
}

constexpr double kDoublePrecisionPx = 1e-9;
constexpr double kFloatPrecisionPx = 2e-4;

/// It has four places for coefficients.
constexpr std::array kUnreadByInstantNgp = {UnreadParameter{"radtan", "k3"}};

constexpr std::array kConsumers{
    Consumer{.id = "kalibr",
             .program = "Kalibr",
             .format = "kalibr",
             .tolerance_px = kDoublePrecisionPx,
             .load = &in_own_locale<&load_kalibr>,
             .second_format = "tumvi"},
    Consumer{.id = "kalibr-imu",
             .program = "Kalibr (imu.yaml)",
             .format = "kalibr",
             .tolerance_px = kDoublePrecisionPx,
             .load = &in_own_locale<&load_kalibr_imu>,
             .cameras = false,
             .second_format = "tumvi"},
    Consumer{.id = "openvins",
             .program = "OpenVINS",
             .format = "openvins",
             .tolerance_px = kFloatPrecisionPx,
             .load = &in_own_locale<&load_openvins>,
             .second_format = "kalibr",
             .other_syntax = true,
             .prepare = &prepare_storage_programs},
    Consumer{.id = "openvins-imu",
             .program = "OpenVINS (kalibr_imu_chain.yaml)",
             .format = "openvins",
             .tolerance_px = kFloatPrecisionPx,
             .load = &in_own_locale<&load_openvins_imu>,
             .cameras = false,
             .second_format = "kalibr",
             .other_syntax = true,
             .prepare = &prepare_storage_programs},
    Consumer{.id = "orbslam3",
             .program = "ORB-SLAM3 V1.0",
             .format = "orbslam3",
             .tolerance_px = kFloatPrecisionPx,
             .load = &in_own_locale<&load_orbslam3>,
             .prepare = &prepare_storage_programs},
    Consumer{.id = "orbslam2",
             .program = "ORB-SLAM2",
             .format = "orbslam3",
             .tolerance_px = kFloatPrecisionPx,
             .load = &in_own_locale<&load_orbslam2>,
             .writing = {.layout = "orbslam2"},
             .prepare = &prepare_storage_programs},
    Consumer{.id = "slam_no_opt",
             .program = "ns15417/slam_no_opt",
             .format = "orbslam3",
             .tolerance_px = kFloatPrecisionPx,
             .load = &in_own_locale<&load_slam_no_opt>,
             .writing = {.model = "eucm"},
             .prepare = &prepare_storage_programs},
    Consumer{.id = "urbste",
             .program = "urbste/ORB_SLAM3 (feature/gopro_slam)",
             .format = "orbslam3",
             .tolerance_px = kFloatPrecisionPx,
             .load = &in_own_locale<&load_urbste>,
             .writing = {.model = "ds"},
             .prepare = &prepare_storage_programs},
    Consumer{.id = "opencv",
             .program = "OpenCV",
             .format = "opencv",
             .tolerance_px = kDoublePrecisionPx,
             .load = &in_own_locale<&load_opencv>,
             .prepare = &prepare_storage_programs},
    Consumer{.id = "ocamcalib",
             .program = "OCamCalib's C functions (ocam_functions)",
             .format = "ocamcalib",
             .tolerance_px = kDoublePrecisionPx,
             .load = &in_own_locale<&load_ocamcalib>,
             .by_inverse = true},
    Consumer{"woodscape", "WoodScape's projection.py", "woodscape", kDoublePrecisionPx, &in_own_locale<&load_woodscape>},
    Consumer{"woodscape-omnidet", "WoodScape's omnidet", "woodscape", kFloatPrecisionPx,
             &in_own_locale<&load_woodscape_omnidet>},
    Consumer{"basalt", "Basalt", "basalt", kDoublePrecisionPx, &in_own_locale<&load_basalt>},
    Consumer{.id = "vins",
             .program = "VINS-Fusion",
             .format = "vins",
             .tolerance_px = kDoublePrecisionPx,
             .load = &in_own_locale<&load_vins>,
             .prepare = &prepare_storage_programs},
    Consumer{.id = "vins-config",
             .program = "VINS-Fusion (configuration)",
             .format = "vins",
             .tolerance_px = kDoublePrecisionPx,
             .load = &in_own_locale<&load_vins>,
             .cameras = false,
             .prepare = &prepare_storage_programs},
    Consumer{"ros", "ROS", "ros", kDoublePrecisionPx, &in_own_locale<&load_ros>},
    Consumer{.id = "dso",
             .program = "DSO (camera.txt)",
             .format = "tumvi",
             .tolerance_px = kFloatPrecisionPx,
             .load = &in_own_locale<&load_dso>,
             .writing = {.file_name = "camera.txt"}},
    Consumer{.id = "cuvslam",
             .program = "cuVSLAM (EuRoC example)",
             .format = "euroc",
             .tolerance_px = kDoublePrecisionPx,
             .load = &in_own_locale<&load_cuvslam>,
             .writing = {.equidistant_file_name = "sensor_recalibrated.yaml"}},
    Consumer{.id = "cuvslam-imu",
             .program = "cuVSLAM (EuRoC example, IMU)",
             .format = "euroc",
             .tolerance_px = kDoublePrecisionPx,
             .load = &in_own_locale<&load_cuvslam_imu>,
             .cameras = false},
    Consumer{.id = "kimera",
             .program = "Kimera-VIO",
             .format = "kimera",
             .tolerance_px = kDoublePrecisionPx,
             .load = &in_own_locale<&load_kimera>,
             .prepare = &prepare_storage_programs},
    Consumer{.id = "kimera-imu",
             .program = "Kimera-VIO (ImuParams.yaml)",
             .format = "kimera",
             .tolerance_px = kDoublePrecisionPx,
             .load = &in_own_locale<&load_kimera_imu>,
             .cameras = false,
             .prepare = &prepare_storage_programs},
    Consumer{"colmap", "COLMAP", "colmap", kDoublePrecisionPx, &in_own_locale<&load_colmap>},
    Consumer{.id = "colmap-rig",
             .program = "COLMAP (rigs)",
             .format = "colmap",
             .tolerance_px = kDoublePrecisionPx,
             .load = &in_own_locale<&load_colmap>,
             .cameras = false},
    Consumer{"nerfstudio", "nerfstudio", "nerfstudio", kFloatPrecisionPx, &in_own_locale<&load_nerfstudio>},
    Consumer{.id = "instant-ngp",
             .program = "instant-ngp",
             .format = "nerfstudio",
             .tolerance_px = kFloatPrecisionPx,
             .load = &in_own_locale<&load_instant_ngp>,
             .writing = {.unread = kUnreadByInstantNgp}},
    Consumer{.id = "gsplat",
             .program = "gsplat",
             .format = "colmap",
             .tolerance_px = kFloatPrecisionPx,
             .load = &in_own_locale<&load_gsplat>,
             .writing = {.models_taken = kTakenByGsplat, .lenses_alone = true}},
    Consumer{.id = "3dgrut",
             .program = "3dgrut",
             .format = "colmap",
             .tolerance_px = kFloatPrecisionPx,
             .load = &in_own_locale<&load_3dgrut>,
             .second_format = "nerfstudio",
             .writing = {.models_taken = kTakenBy3dgrut, .lenses_alone = true}},
    Consumer{.id = "lichtfeld",
             .program = "LichtFeld Studio",
             .format = "colmap",
             .tolerance_px = kFloatPrecisionPx,
             .load = &in_own_locale<&load_lichtfeld>,
             .second_format = "nerfstudio",
             .writing = {.models_taken = kTakenByLichtfeld, .lenses_alone = true}},
};

}  // namespace

std::span<const Consumer> all_consumers() { return kConsumers; }

const Consumer* find_consumer(std::string_view id) {
  const auto found = std::find_if(kConsumers.begin(), kConsumers.end(), [id](const Consumer& row) { return row.id == id; });
  return found == kConsumers.end() ? nullptr : &*found;
}

const Consumer* own_program(std::string_view format, bool cameras) {
  const auto found =
      std::ranges::find_if(kConsumers, [&](const Consumer& row) { return row.format == format && row.cameras == cameras; });
  return found == kConsumers.end() ? nullptr : &*found;
}

}  // namespace fca::consumers
