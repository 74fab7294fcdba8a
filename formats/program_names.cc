// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/program_names.h>
#include <fca/normalised_id.h>

#include <algorithm>
#include <array>

namespace fca {

namespace {

using Name = std::string_view;

// Served by a format.
constexpr std::array kKalibr = {Name("camchain")};
constexpr std::array kDso = {Name("ldso"), Name("stereo-dso"), Name("dm-vio"), Name("vi-dso"), Name("tandem")};
constexpr std::array kVins = {Name("vins-mono"), Name("vins-fusion"), Name("camodocal"),        Name("gvins"),
                              Name("d2slam"),    Name("lvi-sam"),     Name("kitti-360-fisheye")};
constexpr std::array kOrbslam3 = {Name("orbslam"), Name("orb-slam"), Name("orb_slam3_ros"), Name("visual-sgraphs")};
constexpr std::array kOrbslam2 = {Name("orbslam2"), Name("orb-slam2")};
constexpr std::array kSlamNoOpt = {Name("slam_no_opt")};
constexpr std::array kOpenvins = {Name("ov_msckf"), Name("sqrtvins")};
constexpr std::array kBasalt = {Name("monado"), Name("xrtslam"), Name("granite"), Name("basalt-vio")};
constexpr std::array kRos = {Name("ros1"),         Name("ros2"),       Name("camera_info"), Name("rtabmap"), Name("isaac-ros"),
                             Name("apriltag_ros"), Name("image_proc"), Name("autoware"),    Name("rovio")};
constexpr std::array kOpencv = {Name("cv2"),      Name("filestorage"), Name("uco-slam"),   Name("lensboy"),
                                Name("mc-calib"), Name("omnidir"),     Name("cv-fisheye"), Name("opencv-fisheye")};
constexpr std::array kOcamcalib = {Name("ocam"), Name("scaramuzza"), Name("py-ocamcalib"), Name("multicol-slam")};
constexpr std::array kWoodscape = {Name("synwoodscape")};
constexpr std::array kEuroc = {Name("asl"), Name("mav0"), Name("tum-vi-mav0"), Name("euroc-mav")};
constexpr std::array kCuvslam = {Name("cuvslam"), Name("pycuvslam"), Name("pycuvslam-euroc")};
constexpr std::array kKimera = {Name("kimera-vio"), Name("kimera-multi"), Name("hydra")};
constexpr std::array kSvo = {Name("svo"), Name("svo-pro"), Name("vikit"), Name("rpg"), Name("ultimate-slam")};
constexpr std::array kMaplab = {Name("maplab"), Name("rovioli")};
constexpr std::array kOkvis2 = {Name("okvis2")};
constexpr std::array kOkvis1 = {Name("okvis1")};
constexpr std::array kOkvis2X = {Name("okvis2-x")};
constexpr std::array kColmap = {Name("pycolmap"),
                                Name("glomap"),
                                Name("hloc"),
                                Name("postshot"),
                                Name("brush"),
                                Name("opensplat"),
                                Name("realitycapture-colmap"),
                                Name("realitycapture")};
constexpr std::array kStella = {Name("stella_vslam"), Name("plp-slam"), Name("360vslam")};
constexpr std::array kOpenvslam = {Name("openvslam")};
constexpr std::array kFastLivo = {Name("fast-livo2")};

constexpr std::array kGraphdeco = {Name("3dgs"), Name("inria-gs"), Name("gaussian-splatting"), Name("graphdeco")};
constexpr std::array kGsplat = {Name("gsplat")};
constexpr std::array k3dgrut = {Name("3dgrut"), Name("3dgut")};
constexpr std::array kLichtfeld = {Name("lichtfeld"), Name("lichtfeld-studio")};
constexpr std::array kNerfstudio = {Name("splatfacto"), Name("nerfacto"), Name("torch-ngp"), Name("transforms.json"),
                                    Name("luma")};
constexpr std::array kInstantNgp = {Name("instant-ngp"), Name("ngp"), Name("ingp")};

// Served by a format that is only read.
constexpr std::array kDepthai = {Name("oak"), Name("oakd"), Name("luxonis")};
constexpr std::array kRealsense = {Name("d435"), Name("d435i"), Name("d455"), Name("t265"), Name("rs2"), Name("librealsense")};
constexpr std::array kZed = {Name("zed2"), Name("zedmini"), Name("zedx"), Name("stereolabs")};
constexpr std::array kOpenicc = {Name("gopro"), Name("umi"), Name("openimucameracalibrator")};

// Not written: what they read.

constexpr std::array kMsckfVio = {Name("msckf_vio"), Name("msckf")};
constexpr std::array kMrcal = {Name("deltacamera")};
constexpr std::array kOpensfm = {Name("odm"), Name("webodm"), Name("opendronemap")};
constexpr std::array kAria = {Name("aria"), Name("project-aria"), Name("fisheye624"), Name("vrs")};
constexpr std::array kNcore = {Name("ftheta"), Name("alpamayo"), Name("nvidia-ncore")};
constexpr std::array kFtheta = {Name("driveworks"), Name("isaac-sim"), Name("omniverse"), Name("usd"), Name("rig.json")};
constexpr std::array kIsaac = {Name("isaac")};
constexpr std::array kTheia = {Name("theia"), Name("pytheiasfm")};
constexpr std::array kCarla = {Name("carla")};
constexpr std::array kArkit = {Name("arkit"), Name("polycam"), Name("record3d")};
constexpr std::array kPhotonvision = {Name("photonvision")};
constexpr std::array kR3live = {Name("r3live")};
constexpr std::array kOmnidso = {Name("omnidso")};
constexpr std::array kMetashape = {Name("photoscan"), Name("agisoft")};
constexpr std::array kKitti = {Name("kitti-odom"), Name("kitti-raw"), Name("kitti-360")};
constexpr std::array kMast3r = {Name("mast3r-slam")};
constexpr std::array kTagslam = {Name("tagslam")};
constexpr std::array kAirslam = {Name("airslam"), Name("airvo")};
constexpr std::array kOpenmvg = {Name("openmvg")};
constexpr std::array kGtsam = {Name("gtsam")};
constexpr std::array kMatlab = {Name("matlab")};
constexpr std::array kDroidSlam = {Name("droid-slam"), Name("droid")};
constexpr std::array kMeshroom = {Name("meshroom"), Name("alicevision")};
constexpr std::array kSpectacular = {Name("spectacularai"), Name("sai")};

constexpr std::array kNames = {
    ProgramName{kKalibr, "Kalibr", "kalibr"},
    ProgramName{kDso, "DSO", "dso"},
    ProgramName{kVins, "VINS", "vins"},
    ProgramName{kOrbslam3, "ORB-SLAM3", "orbslam3"},
    ProgramName{kOrbslam2, "ORB-SLAM2", "orbslam3", "orbslam2"},
    ProgramName{kSlamNoOpt, "ns15417/slam_no_opt", "orbslam3", "slam_no_opt"},
    ProgramName{kOpenvins, "OpenVINS", "openvins"},
    ProgramName{kBasalt, "Basalt", "basalt"},
    ProgramName{kRos, "ROS", "ros"},
    ProgramName{kOpencv, "OpenCV", "opencv"},
    ProgramName{kOcamcalib, "OCamCalib", "ocamcalib"},
    ProgramName{kWoodscape, "WoodScape", "woodscape"},
    ProgramName{kEuroc, "EuRoC", "euroc"},
    ProgramName{kCuvslam, "cuVSLAM", "euroc", "", "", "", "cuvslam"},
    ProgramName{kKimera, "Kimera", "kimera"},
    ProgramName{.names = kOkvis2, .title = "OKVIS2", .format = "okvis", .consumer = "okvis2"},
    ProgramName{.names = kOkvis1, .title = "OKVIS", .format = "okvis", .layout = "okvis1", .consumer = "okvis"},
    ProgramName{.names = kOkvis2X, .title = "OKVIS2-X", .format = "okvis", .consumer = "okvis2-x"},
    ProgramName{kSvo, "SVO", "ncamera"},
    ProgramName{.names = kMaplab, .title = "maplab", .format = "ncamera", .consumer = "maplab"},
    ProgramName{kColmap, "COLMAP", "colmap"},
    ProgramName{.names = kGsplat, .title = "gsplat", .format = "colmap", .consumer = "gsplat"},
    ProgramName{.names = k3dgrut, .title = "3dgrut", .format = "colmap", .consumer = "3dgrut"},
    ProgramName{.names = kLichtfeld, .title = "LichtFeld Studio", .format = "colmap", .consumer = "lichtfeld"},
    ProgramName{kNerfstudio, "nerfstudio", "nerfstudio"},
    ProgramName{.names = kInstantNgp, .title = "instant-ngp", .format = "nerfstudio", .consumer = "instant-ngp"},
    ProgramName{kStella, "stella_vslam", "stella"},
    ProgramName{.names = kOpenvslam, .title = "OpenVSLAM", .format = "stella", .layout = "openvslam", .consumer = "openvslam"},
    ProgramName{kFastLivo, "FAST-LIVO", "fast-livo"},
    ProgramName{kDepthai, "DepthAI", "depthai"},
    ProgramName{kOpenicc, "OpenImuCameraCalibrator", "openicc"},
    ProgramName{kZed, "ZED", "zed"},
    ProgramName{kRealsense, "RealSense", "realsense"},
    ProgramName{kGraphdeco, "gaussian-splatting", "colmap", "", "",
                "undistorted images, with the cameras that colmap image_undistorter writes for them"},
    ProgramName{kMsckfVio, "MSCKF-VIO", "kalibr", "", "", "Kalibr's keys with flat lists for its poses"},
    ProgramName{kMrcal, "mrcal", "mrcal"},
    ProgramName{kOpensfm, "OpenSfM", "opensfm"},
    ProgramName{kAria, "Project Aria", "colmap", "", "", "a JSON of its own, with the model Fisheye624"},
    ProgramName{kNcore, "NCore", "ncore"},
    ProgramName{kFtheta, "NVIDIA's f-theta", "ocamcalib", "", "", "a rig.json, or a USD, with polynomials of its own"},
    ProgramName{kMetashape, "Metashape", "metashape"},
    ProgramName{kKitti, "KITTI", "kitti"},
    ProgramName{.names = kIsaac,
                .title = "Isaac",
                .format = "ros",
                .reads = "a USD as Isaac Sim (isaac-sim)",
                .served_part = "Isaac ROS, which reads camera_info"},
    ProgramName{kTheia, "Theia", "opencv", "", "", "a JSON of priors of its own"},
    ProgramName{kCarla, "CARLA", "opencv", "", "", "attributes of its sensors, a pinhole without distortion"},
    ProgramName{kArkit, "ARKit", "opencv", "", "", "a JSON per frame, a pinhole without distortion"},
    ProgramName{kPhotonvision, "PhotonVision", "opencv", "", "", "a JSON of its own"},
    ProgramName{kR3live, "R3LIVE", "vins", "", "", "keys of its own in its configuration"},
    ProgramName{kOmnidso, "omniDSO", "dso", "", "", "camera.txt with a line of the unified model"},
    ProgramName{kMast3r, "MASt3R-SLAM", "mast3r"},
    ProgramName{kTagslam, "TagSLAM", "kalibr", "", "",
                "cameras.yaml, Kalibr's keys with a tagtopic and a rig_body for each camera"},
    ProgramName{kAirslam, "AirSLAM", "kalibr", "", "", "a YAML of its own"},
    ProgramName{kOpenmvg, "openMVG", "opencv", "", "", "sfm_data.json"},
    ProgramName{kGtsam, "GTSAM", "opencv", "", "", "arguments of its Cal3 classes"},
    ProgramName{kMatlab, "MATLAB", "opencv", "", "", "objects of its own (cameraIntrinsicsKB, fisheyeIntrinsics)"},
    ProgramName{kDroidSlam, "DROID-SLAM", "opencv", "", "", "a line of fx fy cx cy k1 k2 p1 p2"},
    ProgramName{kMeshroom, "Meshroom", "opencv", "", "", "an SfM JSON of its own (.sfm)"},
    ProgramName{kSpectacular, "SpectacularAI", "opencv", "", "", "calibration.json"},
};

}  // namespace

std::span<const ProgramName> all_program_names() { return kNames; }

const ProgramName* find_program_name(std::string_view typed) {
  const std::string wanted = normalised_id(typed);
  const auto found = std::ranges::find_if(kNames, [&wanted](const ProgramName& row) {
    return std::ranges::any_of(row.names, [&wanted](Name name) { return normalised_id(name) == wanted; });
  });
  return found == kNames.end() ? nullptr : &*found;
}

}  // namespace fca
