// SPDX-License-Identifier: BSD-3-Clause
// The older syntax of a camera_info: an .ini of Videre's cameras (parse_ini.cpp), which the calibrator prints as ost.txt.
//
//   # oST version 5.0 parameters
//   [image]
//   width            a key is a line, its value the next ones
//   640
//   height
//   480
//   [narrow_stereo/left]
//   camera matrix    3 x 3
//   distortion       5 or 8 numbers
//   rectification    3 x 3
//   projection       3 x 4
#pragma once

#include "rectification.h"

#include <fca/formats/text/document.h>

#include <string>

namespace fca::ros {

/// Does a document of words begin as one: with a section?
[[nodiscard]] bool looks_like_ini(const text::Document& document);

/// Can its lines say that model?
[[nodiscard]] bool ini_holds(std::string_view model);

/// What a camera of that name is called in an .ini: sections are known by their brackets, and two are no camera's.
[[nodiscard]] std::string section_of(std::string name);

[[nodiscard]] std::string compose_ini(const Camera& camera, const Rectified& rectified);

}  // namespace fca::ros
