// SPDX-License-Identifier: BSD-3-Clause
// The blocks of what a RealSense camera's tools print, each number at its place. Three texts have them:
//
//   rs-enumerate-devices -c (tools/enumerate-devices/rs-enumerate-devices.cpp)
//      Intrinsic of "Color" / 640x480 / {YUYV/RGB8}      for each stream and size; older: Intrinsic of "Color"   640x480   YUYV
//       Width: Height: PPX: PPY: Fx: Fy: Distortion: Coeffs:
//     Motion Intrinsic of "Gyro"  MOTION_XYZ32F
//      Bias Variances: Noise Variances: Sensitivity :    and three rows of four
//     Extrinsic from "Depth"  To  "Color" :
//      Rotation Matrix:                                  and three rows
//      Translation Vector: x y z
//   realsense-rust's structures, as Rust prints them for debugging
//     depth Ok(Rs2Intrinsics(rs2_intrinsics { width: 640, ..., model: 4, coeffs: [..] }))
//     depth to rgb: Ok(Rs2Extrinsics(rs2_extrinsics { rotation: [..], translation: [..] }))    column by column
//   rs2.intrinsics and rs2.extrinsics of Python, as scripts save them in JSON
//     {"color": {"width": 640, ..., "ppx": .., "model": "distortion.brown_conrady", "coeffs": [..]},
//      "depth_to_color": {"rotation": [..], "translation": [..]}}                            column by column
#pragma once

#include "../ini_sections.h"

#include <fca/formats/text/document.h>

#include <map>
#include <string>
#include <vector>

namespace fca::realsense {

/// A block and what it specifies: numbers and words by the names of rs-enumerate-devices, without colons ("PPX").
struct Block {
  enum class Kind { kStream, kMotion, kPose };
  Kind kind = Kind::kStream;
  const text::Node* place = nullptr;  ///< Its first line.
  std::string name;                   ///< "Infrared 1"; of a pose: from it.
  std::string to = {};
  std::map<std::string, std::vector<text::Node>> values = {};  ///< A rotation's row by row.

  const text::Node* twice = nullptr;  ///< The line of a name that stands there already; null: there is none.

  [[nodiscard]] const std::vector<text::Node>* find(const std::string& key) const {
    const auto found = values.find(key);
    return found == values.end() || found->second.empty() ? nullptr : &found->second;
  }
};

/// In the order of the text. Empty: it is none of these.
[[nodiscard]] std::vector<Block> blocks_of(const text::Document& document);

}  // namespace fca::realsense
