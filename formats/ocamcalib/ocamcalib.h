// SPDX-License-Identifier: BSD-3-Clause
// OCamCalib: calib_results.txt, as the toolbox's exportData2TXT.m writes and ocam_functions.cpp's get_ocam_model reads it. Five
// blocks with exactly one line of comment before each, which the program skips whatever stands in it:
//
//   n a0 .. a(n-1)     direct polynomial: z = f(rho), z to the back of the lens, so a0 < 0; cam2world
//   m b0 .. b(m-1)     inverse polynomial: rho = sum b_i theta^i, theta = atan(z / rho); world2cam. A separate fit.
//   row column         centre, from 0
//   c d e              affine part: row' = c x + d y, column' = e x + y
//   height width       whole numbers
//
// The direct polynomial is the camera (lib's model ocamcalib, which projects by its exact inverse). The file's inverse
// polynomial is kept as read, compared with that, and rebuilt where it does not belong to the direct one.
#pragma once

#include <fca/formats/format.h>

namespace fca::ocamcalib {

extern const Format kFormat;

/// What read() calls the file's own inverse polynomial among a camera's extra fields.
inline constexpr std::string_view kInverse = "inverse polynomial";

[[nodiscard]] std::optional<Rig> read(std::span<const text::Document> documents, const ReadOptions& options,
                                      Diagnostics& diagnostics);
[[nodiscard]] std::optional<Written> write(const text::Document* base, const Rig& rig, const WriteOptions& options,
                                           Diagnostics& diagnostics);

}  // namespace fca::ocamcalib
