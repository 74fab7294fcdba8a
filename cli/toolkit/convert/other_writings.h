// SPDX-License-Identifier: BSD-3-Clause
// After a file was written and proven: tries other ways to write the same calibration, which the program may read with smaller
// errors. Each one is written and proven too, and the best becomes the result.
#pragma once

#include "start.h"

namespace fca {

/// The rms distance [px] over the image between the converted camera and the camera that the target program sees in the file,
/// for the camera with the largest one; 0 if no program was asked.
[[nodiscard]] double worst_rms_px(const ConvertResult& result);
/// The largest distance [px] at any pixel of any camera.
[[nodiscard]] double worst_max_px(const ConvertResult& result);

/// If the program misreads a camera, also writes the other layouts: with the cameras' models or, if a layout does not hold
/// these, with the best models that it holds. The best result for that program becomes the result, unless the request names a
/// layout or a model; the others are listed in ConvertResult::others. `before`: the result before anything was written.
void try_other_layouts(const ConvertRequest& request, const Start& start, const ConvertResult& before, ConvertResult& result);

/// If the program ignores rays that the model of a fitted camera has (3dgrut those at the border of a wide lens), also writes
/// the other models that may be chosen. The one with which the program ignores the smallest share of the images becomes the
/// result, if its errors are small. Does nothing if the request names a model or a file to write into.
void try_other_models(const ConvertRequest& request, const Start& start, const ConvertResult& before, ConvertResult& result);

/// If cameras with wide lenses are fitted and the program's pixels are wrong, also fits them to the inscribed circles of their
/// images and puts the resulting error into ConvertResult::nearer. The result remains the fit to the whole lens.
void try_fit_in_circle(const ConvertRequest& request, const Start& start, const ConvertResult& before, ConvertResult& result);

}  // namespace fca
