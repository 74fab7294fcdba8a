// SPDX-License-Identifier: BSD-3-Clause
#include "pixels_basalt.h"
#include "pixels_colmap.h"
#include "pixels_depthai.h"
#include "pixels_euroc.h"
#include "pixels_fast_livo.h"
#include "pixels_kalibr.h"
#include "pixels_kimera.h"
#include "pixels_kitti.h"
#include "pixels_mast3r.h"
#include "pixels_metashape.h"
#include "pixels_mrcal.h"
#include "pixels_ncamera.h"
#include "pixels_ncore.h"
#include "pixels_nerfstudio.h"
#include "pixels_ocamcalib.h"
#include "pixels_okvis.h"
#include "pixels_opencv.h"
#include "pixels_openicc.h"
#include "pixels_opensfm.h"
#include "pixels_openvins.h"
#include "pixels_orbslam3.h"
#include "pixels_realsense.h"
#include "pixels_ros.h"
#include "pixels_stella.h"
#include "pixels_tumvi.h"
#include "pixels_vins.h"
#include "pixels_woodscape.h"
#include "pixels_zed.h"

namespace fca::matrix {

const FormatReader* find_reader(const std::string& id) {
  static const std::vector<FormatReader> readers = {
      {"kalibr", kalibr::camera, kalibr::relative_poses},
      {"opencv", opencv::camera, opencv::relative_poses},
      {"ocamcalib", ocamcalib::camera, ocamcalib::relative_poses},
      {"tumvi", tumvi::camera, tumvi::relative_poses},
      {"orbslam3", orbslam3::camera, orbslam3::relative_poses},
      {"woodscape", woodscape::camera, woodscape::relative_poses},
      {"basalt", basalt::camera, basalt::relative_poses},
      {"openvins", openvins::camera, openvins::relative_poses},
      {"vins", vins::camera, vins::relative_poses},
      {"ros", ros::camera, ros::relative_poses},
      {"euroc", euroc::camera, euroc::relative_poses},
      {"kimera", kimera::camera, kimera::relative_poses},
      {"mrcal", mrcal::camera, mrcal::relative_poses},
      {"colmap", colmap::camera, colmap::relative_poses},
      {"nerfstudio", nerfstudio::camera, nerfstudio::relative_poses},
      {"dso", tumvi::camera, tumvi::relative_poses},
      {"stella", stella::camera, stella::relative_poses},
      {"fast-livo", fast_livo::camera, fast_livo::relative_poses},
      {"mast3r", mast3r::camera, mast3r::relative_poses},
      {"opensfm", opensfm::camera, opensfm::relative_poses},
      {"metashape", metashape::camera, metashape::relative_poses},
      {"kitti", kitti::camera, kitti::relative_poses},
      {"ncore", ncore::camera, ncore::relative_poses},
      {"depthai", depthai::camera, depthai::relative_poses},
      {"openicc", openicc::camera, openicc::relative_poses},
      {"zed", zed::camera, zed::relative_poses},
      {"realsense", realsense::camera, realsense::relative_poses},
      {"okvis", okvis::camera, okvis::relative_poses},
      {"ncamera", ncamera::camera, ncamera::relative_poses},
  };
  for (const FormatReader& reader : readers) {
    if (reader.id == id) return &reader;
  }
  return nullptr;
}

}  // namespace fca::matrix
