// SPDX-License-Identifier: BSD-3-Clause
// Tries other ways to write a calibration that has been written and proven: the program may read another layout or model with
// smaller errors. Each way is written and proven too, and the best result replaces the first one.
#pragma once

#include "start.h"

namespace fca {

/// The rms distance [px], over the image, between the calibrated camera and the camera that the program reads from the file. Of
/// several cameras, the largest value. 0 if no program was asked.
[[nodiscard]] double worst_rms_px(const ConvertResult& result);
/// The same for the largest distance [px] at any pixel.
[[nodiscard]] double worst_max_px(const ConvertResult& result);

/// If the program misreads a camera, also writes the other layouts with the models that the cameras have. If that does not
/// suffice and the request names no model, also tries each model that the other layouts hold. If the request names no layout,
/// the best of these results for that program replaces `result`. ConvertResult::others lists the remaining ones. `before`: the
/// result before anything was written. Does nothing for an edit of a text that the program reads.
void try_other_layouts(const ConvertRequest& request, const Start& start, const ConvertResult& before, ConvertResult& result);

/// Some programs ignore rays that the model of a fitted camera has, for example 3dgrut at the border of a wide lens. In this
/// case, also writes the other models that may be chosen. The result whose program ignores the smallest share of the images
/// replaces `result`, if its errors are small. Does nothing if the request names a model or a file to write into.
void try_other_models(const ConvertRequest& request, const Start& start, const ConvertResult& before, ConvertResult& result);

/// If the program reads a fitted wide lens with large errors, also fits the cameras only up to the largest angle that the
/// inscribed circles of their images show. If that is much better, puts the angle and the error of that fit into
/// ConvertResult::nearer. The written files remain those of the fit to the whole lens. Does nothing if the request limits the
/// lens.
void try_fit_in_circle(const ConvertRequest& request, const Start& start, const ConvertResult& before, ConvertResult& result);

}  // namespace fca
