// SPDX-License-Identifier: BSD-3-Clause
// Where ../shared has real files of each format, and the tables of what its program computes from them.
#pragma once

#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

namespace fca::test {

struct SharedFolders {
  std::string_view format;
  std::string_view files;            ///< Below shared/corpus.
  std::string_view tables;           ///< Below shared/oracles; empty: there are none.
  std::string_view more_files = {};  ///< As files; may be empty.
};

inline constexpr std::array kSharedFolders = {
    SharedFolders{"kalibr", "kalibr", "kalibr"},
    SharedFolders{"opencv", "opencv", "opencv"},
    SharedFolders{"ocamcalib", "ocamcalib", "ocamcalib"},
    SharedFolders{"tumvi", "tumvi", "tumvi"},
    SharedFolders{"orbslam3", "orbslam3", "orbslam3"},
    SharedFolders{"woodscape", "woodscape", "woodscape"},
    SharedFolders{"basalt", "extra/basalt", "basalt"},
    SharedFolders{"vins", "extra/camodocal", "camodocal", "extra/vins_config"},
    SharedFolders{"ros", "extra/ros_camera_info", "ros_camera_info"},
    SharedFolders{"euroc", "extra/euroc_sensor", "", "extra/cuvslam_rig"},
    SharedFolders{"kimera", "extra/kimera", ""},
    SharedFolders{"mrcal", "extra/mrcal", ""},
    SharedFolders{"colmap", "extra/colmap", "", "extra/colmap_rig"},
    SharedFolders{"nerfstudio", "extra/transforms_json", ""},
    SharedFolders{"dso", "extra/dso_camera_txt", ""},
    SharedFolders{"stella", "extra/stella_vslam", ""},
    SharedFolders{"fast-livo", "extra/fast_livo", ""},
    SharedFolders{"mast3r", "extra/mast3r_intrinsics", ""},
    SharedFolders{"metashape", "extra/metashape_xml", ""},
    SharedFolders{"ncore", "extra/ncore_json", ""},
    SharedFolders{"depthai", "extra/depthai", ""},
    SharedFolders{"openicc", "extra/openicc", ""},
    SharedFolders{"zed", "extra/zed_conf", ""},
    SharedFolders{"realsense", "extra/realsense", ""},
    SharedFolders{"okvis", "extra/okvis", ""},
    SharedFolders{"ncamera", "extra/vikit_svo", "", "extra/maplab_ncamera"},
};

/// Those of a format that are there: OpenVINS' files lie among Kalibr's.
inline std::vector<std::filesystem::path> corpus_folders(const std::filesystem::path& shared, std::string_view format) {
  std::vector<std::filesystem::path> folders;
  for (const SharedFolders& row : kSharedFolders) {
    if (row.format != format) continue;
    for (const std::string_view files : {row.files, row.more_files}) {
      if (!files.empty() && std::filesystem::exists(shared / "corpus" / files)) folders.push_back(shared / "corpus" / files);
    }
  }
  return folders;
}

}  // namespace fca::test
