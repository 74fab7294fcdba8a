// SPDX-License-Identifier: BSD-3-Clause
// DSO's camera.txt (JakobEngel/dso@1469e1e, src/util/Undistort.cpp), by which TUM-VI's sequences run in DSO and DM-VIO:
//
//   1  [name] fx fy cx cy ...   EquiDistant or KannalaBrandt k1 k2 k3 k4, RadTan k1 k2 p1 p2, FOV omega, Pinhole 0; without a
//                               name 8 numbers are RadTan, 5 are FOV, or Pinhole if the fifth is 0
//   2  w h
//   3  crop | none | five numbers: how DSO rectifies, which is no part of the camera
//   4  w h of the image that DSO computes from it
//
// If cx < 1 and cy < 1, all four are relative: fx w, fy h, cx w - 0.5, cy h - 0.5.
#pragma once

#include <fca/formats/format.h>

namespace fca::dso {

/// Words that are such a file, whatever is wrong with it.
[[nodiscard]] ProbeResult probe_camera_txt(const text::Document& document);

[[nodiscard]] std::optional<Rig> read_camera_txt(const text::Document& document, Diagnostics& diagnostics);

/// Has DSO a lens of that model?
[[nodiscard]] bool camera_txt_holds(std::string_view model);

/// Why a camera.txt cannot say this rig (several cameras, another model, a centre that DSO would take for a relative one, no
/// image size), a clause; none if one can.
[[nodiscard]] Message problem_with_camera_txt(const Rig& rig);

/// The base with the camera's numbers in place of its own, and the lens's name where the model is another one; nothing if it
/// cannot say them, in the form (pixels or shares) that it has.
[[nodiscard]] std::optional<text::Document> edited_camera_txt(const text::Document& base, const Camera& camera);

/// A fresh camera.txt of a camera that one can say: DSO crops to a rectified image of the camera's own size.
[[nodiscard]] std::string fresh_camera_txt(const Camera& camera);

}  // namespace fca::dso
