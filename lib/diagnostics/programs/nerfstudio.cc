// SPDX-License-Identifier: BSD-3-Clause
// What nerfstudio, instant-ngp and those who read a transforms.json like them say to one.
#include "../rows.h"
#include "../topics.h"

#include <array>

namespace fca::diagnostics {

std::span<const CodeInfo> nerf_program_codes() {
  static constexpr std::array kRows = {
      refusal(Code::kNerfSaysNotParsed, "not JSON at byte {0}: {1}"),
      refusal(Code::kNerfSaysNoObject, "the file is not a JSON object"),
      refusal(Code::kNerfSaysNoFrames, "there is no image: frames is missing, empty or not a list",
              "write an object with file_path and transform_matrix for each image"),
      refusal(Code::kNerfSaysFrameLacks, "frame {1} has no {0}", kAddTheKey),
      refusal(Code::kNerfSaysLacks, "{0} is neither at the top nor in frame {1}", kAddTheKey),
      refusal(Code::kNerfSaysNoNumber, "{0} is not a number"),
      refusal(Code::kNerfSaysNoList, "distortion_params is not a list of six numbers: k1, k2, k3, k4, p1, p2"),
      misreading(Code::kNerfSaysListNotRead, "distortion_params is not read: the lens has no distortion",
                 "write k1, k2, p1 and p2; for a fisheye k1 to k4"),
      refusal(Code::kNerfSaysNoMatrix, "transform_matrix of frame {0} is not a matrix of 4 columns"),
      refusal(Code::kNerfSaysUnknownModel, "camera_model is {0}, which it does not know"),
      misreading(Code::kNerfSaysTakenForPerspective, "{0} is not read: the lens is not taken for a fisheye", "write {1}"),
      refusal(Code::kNerfSaysNoFieldOfView, "there is no focal length at the top or in frame {0}", "write fl_x and fl_y"),
      refusal(Code::kNerfSaysCentreAlone, "{0} is given without {1} in the same object", "repeat {1} next to it"),
      misreading(Code::kNerfSaysSlots, "p1 and p2 take the places of k3 and k4, which are lost",
                 "remove p1 and p2: a fisheye has none"),
      misreading(Code::kNerfSaysNoLens, "a fisheye whose coefficients are all 0 becomes a pinhole", "write 1e-12 for k1"),
      refusal(Code::kNerfSaysNotSquare, "there is no fl_y and no camera_angle_y, and the image is not square",
              "write fl_x and fl_y"),
      misreading(Code::kNerfSaysTopOnly, "{0} of frames is not read, only {0} at the top"),
      misreading(Code::kNerfSaysPinhole, "neither is_fisheye nor camera_model is read: the lens is not taken for a fisheye",
                 "undistort the images"),
      misreading(Code::kNerfSaysAngleOnly,
                 "it reads only camera_angle_x: it takes fl_x for fl_y, the middle for the principal point, and no distortion",
                 "undistort the images to a pinhole with its centre in the middle"),
      misreading(Code::kNerfSaysAngleFirst, "{0} is read in place of {1}", "remove {0}"),
      misreading(Code::kNerfSaysColmapPinhole,
                 "its colmap2nerf.py does not know {0} and uses a pinhole whose centre is the middle of the image",
                 "write OPENCV or OPENCV_FISHEYE"),
  };
  return kRows;
}

}  // namespace fca::diagnostics
