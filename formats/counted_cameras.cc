// SPDX-License-Identifier: BSD-3-Clause
#include <fca/formats/counted_cameras.h>

#include <algorithm>
#include <array>

namespace fca {

std::map<std::string, std::string> counted_cameras(const Written& written) {
  std::map<std::string, std::string> cameras;
  for (const Written::File& file : written.files) {
    for (const std::string& name : file.cameras) cameras.emplace("cam" + std::to_string(cameras.size()), name);
  }
  return cameras;
}

Rig with_counted_cameras(Rig rig, const Written& written) {
  const std::map<std::string, std::string> cameras = counted_cameras(written);
  const auto find_counted = [&cameras](const std::string& frame) {
    return std::ranges::find(cameras, frame, &std::pair<const std::string, std::string>::second);
  };
  std::erase_if(rig.poses, [&](const PoseEdge& pose) {
    return std::ranges::any_of(std::array{pose.a, pose.b}, [&](const std::string& frame) {
      return cameras.contains(frame) && find_counted(frame) == cameras.end();
    });
  });
  for (PoseEdge& pose : rig.poses) {
    for (std::string* frame : {&pose.a, &pose.b}) {
      const auto counted = find_counted(*frame);
      if (counted != cameras.end()) *frame = counted->first;
    }
  }
  return rig;
}

}  // namespace fca
