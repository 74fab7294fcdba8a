// SPDX-License-Identifier: BSD-3-Clause
#include "stale_facts.h"

#include "words.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace fca::cli {

namespace {

/// Keys whose values count pixels or rows of the calibrated images: projection matrices and regions of cv::stereoRectify in
/// OpenCV's files and ORB-SLAM2's, Kalibr's time per row, DSO's output image.
constexpr std::array<std::string_view, 15> kOfTheImages = {
    "P",           "P1",     "P2",      "Q",       "validPixROI1",      "validPixROI2", "projection_matrix",
    "LEFT.P",      "LEFT.K", "RIGHT.P", "RIGHT.K", "new_camera_matrix", "line_delay",   "DSO's rectified image",
    "image_points"};

bool of_the_images(const AsRead& extra) {
  return std::ranges::any_of(
      kOfTheImages, [&extra](std::string_view key) { return extra.key == key || extra.key.ends_with(" " + std::string(key)); });
}

}  // namespace

void warn_of_stale_facts(const Rig& rig, const Written& written, Diagnostics& diagnostics) {
  std::vector<std::string> stale;
  for (const AsRead& extra : rig.as_read) {
    const bool lost =
        std::ranges::any_of(written.losses, [&extra](const Loss& loss) { return loss.what.starts_with(extra.key); });
    if (of_the_images(extra) && !lost) stale.push_back(extra.key);
  }
  if (stale.empty()) return;
  diagnostics.warning("stale-facts",
                      enumerated(stale, "and") + " in the file: of the images as they were calibrated, and still as it was", {},
                      "compute it anew (cv::stereoRectify) or --anew leaves it out");
}

}  // namespace fca::cli
